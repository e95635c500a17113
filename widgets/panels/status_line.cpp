#include "widgets/panels/status_line.h"

#include <cmath>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

// "about 2 min left", once there is something to go by.
QString time_left(double fraction, qint64 elapsed_ms) {
  if (fraction < 0.05 || elapsed_ms < 3000) return {};
  const int left_s = static_cast<int>(std::ceil(static_cast<double>(elapsed_ms) / 1000 * (1 - fraction) / fraction));
  return left_s < 60 ? StatusLine::tr("about %1 s left").arg(left_s)
                     : StatusLine::tr("about %1 min left").arg((left_s + 30) / 60);
}

}  // namespace

StatusLine::StatusLine(BackgroundWork& work, QWidget* parent) : QStatusBar(parent), work_(work) {
  since_.start();
  text_ = new QLabel;
  text_->setIndent(10);
  progress_ = new QProgressBar;
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(220);
  progress_->hide();
  cancel_ = named_button("cancel");
  cancel_->hide();
  auto* standing = new QLabel;
  standing->setObjectName("faint");
  standing->setContentsMargins(0, 0, 8, 0);
  addWidget(text_, 1);
  for (QWidget* each : std::initializer_list<QWidget*>{progress_, cancel_, standing}) addPermanentWidget(each);
  setSizeGripEnabled(false);
  connect(&work_, &BackgroundWork::started, this, &StatusLine::begin);
  connect(&work_, &BackgroundWork::progressed, this, &StatusLine::show_progress);
  connect(&work_, &BackgroundWork::finished, this, &StatusLine::end);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    cancel_->setEnabled(false);
    work_.cancel();
  });
  keep_translated(this, [=, this] {
    cancel_->setText(tr("Cancel"));
    standing->setText(tr("Not a medical device"));
    text_->clear();  // it told of a moment
  });
}

void StatusLine::begin(const QString& title) {
  since_.start();
  say(title);
  progress_->setValue(0);
  progress_->show();
  cancel_->setEnabled(true);
  cancel_->show();
}

void StatusLine::show_progress(double fraction, const QString& stage) {
  progress_->setValue(static_cast<int>(1000 * fraction));
  if (stage.isEmpty()) return;
  const QString left = time_left(fraction, since_.elapsed());
  say(left.isEmpty() ? translated_stage(stage) : tr("%1, %2").arg(translated_stage(stage), left));
}

void StatusLine::end() {
  text_->clear();
  progress_->hide();
  cancel_->hide();
}

}  // namespace glisson::widgets
