#include "widgets/guide/guide_welcome.h"

#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

GuideWelcome::GuideWelcome(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  auto* title = new QLabel;
  title->setObjectName("welcome_title");
  title->setAlignment(Qt::AlignCenter);
  QLabel* text = wrapped_label("guide_about");
  video_ = named_button("guide_from_video");
  open_ = named_button("open_guide_sequence");
  make_ = named_button("primary");
  says_ = wrapped_label("guide_says");
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(video_);
  buttons->addWidget(open_);
  buttons->addWidget(make_);
  buttons->addStretch();
  column->addStretch(2);
  column->addWidget(title);
  column->addSpacing(8);
  column->addLayout(in_the_middle(text));
  column->addSpacing(16);
  column->addLayout(buttons);
  column->addSpacing(12);
  column->addLayout(in_the_middle(says_));
  column->addStretch(3);
  connect(video_, &QPushButton::clicked, this, &GuideWelcome::video_wanted);
  connect(open_, &QPushButton::clicked, this, &GuideWelcome::file_wanted);
  connect(make_, &QPushButton::clicked, this, &GuideWelcome::example_wanted);
  keep_translated(this, [=, this] {
    title->setText(tr("Where is the tumour in this picture?"));
    text->setText(
        tr("The liver of the open case is placed on a laparoscope's frames and follows them; its tumours and vessels "
           "are drawn where they are, with how far they may be off. Begin with the video of a stereo laparoscope and "
           "its calibration, or pictures of a board; or open a sequence that was made of one. The example is simulated "
           "and shows the demo patient's liver."));
    update_text();
  });
}

void GuideWelcome::show_missing(const QString& missing) {
  missing_ = missing;
  update_text();
}

void GuideWelcome::update_text() {
  video_->setText(tr("From a video..."));
  open_->setText(tr("Open a sequence..."));
  make_->setText(tr("Open the example"));
  video_->setToolTip(missing_.isEmpty() ? tr("Two videos, or one that shows both eyes, become a sequence") : missing_);
  open_->setToolTip(missing_.isEmpty() ? tr("A sequence.json with its clouds, tracks and pictures beside it")
                                       : missing_);
  make_->setToolTip(missing_.isEmpty() ? tr("40 simulated frames, made in a few seconds the first time; 7 MB")
                                       : missing_);
  for (QPushButton* button : {video_, open_, make_}) button->setEnabled(missing_.isEmpty());
}

}  // namespace glisson::widgets
