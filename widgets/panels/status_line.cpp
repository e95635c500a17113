#include "widgets/panels/status_line.h"

#include <cmath>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

QString time_left(double left_ms) {
  const int left_s = static_cast<int>(std::ceil(1e-3 * left_ms));
  if (left_s <= 0) return {};
  return left_s < 60 ? StatusLine::tr("about %1 s left").arg(left_s)
                     : StatusLine::tr("about %1 min left").arg((left_s + 30) / 60);
}

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
  every_second_.setInterval(1000);
  connect(&every_second_, &QTimer::timeout, this, &StatusLine::tell_stage);
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
  every_second_.start();
  stage_.clear();
  takes_ms_.reset();
  say(title);
  progress_->setValue(0);
  progress_->show();
  cancel_->setEnabled(true);
  cancel_->show();
}

void StatusLine::show_progress(double fraction, const QString& stage) {
  progress_->setValue(static_cast<int>(1000 * fraction));
  if (!stage.isEmpty()) stage_ = stage;
  // Once there is something to go by.
  const auto elapsed_ms = static_cast<double>(since_.elapsed());
  if (fraction >= 0.15 && elapsed_ms >= 3000) takes_ms_ = elapsed_ms / fraction;
  tell_stage();
}

void StatusLine::tell_stage() {
  if (stage_.isEmpty()) return;
  const QString left = takes_ms_ ? time_left(*takes_ms_ - static_cast<double>(since_.elapsed())) : QString();
  say(left.isEmpty() ? translated_stage(stage_) : tr("%1, %2").arg(translated_stage(stage_), left));
}

void StatusLine::end() {
  every_second_.stop();
  text_->clear();
  progress_->hide();
  cancel_->hide();
}

}  // namespace glisson::widgets
