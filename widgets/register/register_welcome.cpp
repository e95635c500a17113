#include "widgets/register/register_welcome.h"

#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

RegisterWelcome::RegisterWelcome(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->addStretch(2);
  auto* title = new QLabel;
  title->setObjectName("welcome_title");
  title->setAlignment(Qt::AlignCenter);
  QLabel* text = wrapped_label("register_about");
  QPushButton* video = named_button("register_from_video");
  QPushButton* open = named_button("open_sequence");
  QPushButton* make = named_button("primary");
  says_ = wrapped_label("register_says");
  column->addWidget(title);
  column->addSpacing(8);
  column->addLayout(in_the_middle(text));
  column->addSpacing(16);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(video);
  buttons->addWidget(open);
  buttons->addWidget(make);
  buttons->addStretch();
  column->addLayout(buttons);
  column->addSpacing(12);
  column->addLayout(in_the_middle(says_));
  column->addStretch(3);
  connect(video, &QPushButton::clicked, this, &RegisterWelcome::video_wanted);
  connect(open, &QPushButton::clicked, this, &RegisterWelcome::file_wanted);
  connect(make, &QPushButton::clicked, this, &RegisterWelcome::example_wanted);
  keep_translated(this, [=] {
    title->setText(tr("How good is a registration of a video?"));
    text->setText(tr(
        "Begin with the video of a stereo laparoscope and its calibration, or pictures of a board: a sequence is made "
        "of it, a cloud of points a frame and the tracks of landmarks. Or open a sequence that is there. Without a "
        "video, an example shows what it is about: the demo patient's liver, breathing and pressed by a tool, "
        "simulated."));
    video->setText(tr("From a video..."));
    video->setToolTip(tr("Two videos, or one that shows both eyes, become a sequence"));
    open->setText(tr("Open a sequence..."));
    open->setToolTip(tr("A sequence.json with its clouds, tracks and pictures beside it"));
    make->setText(tr("Make an example sequence"));
    make->setToolTip(tr("Simulates 40 frames in a few seconds and opens them; 7 MB"));
  });
}

}  // namespace glisson::widgets
