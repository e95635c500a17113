#include "widgets/sequence/from_video.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPointer>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

FromVideo::FromVideo(BackgroundWork& work, QWidget* parent) : QWidget(parent), work_(work) {
  setObjectName("from_video");
  auto* across = new QHBoxLayout(this);
  across->setContentsMargins(0, 0, 0, 0);
  across->setSpacing(0);
  across->addWidget(make_order());
  view_ = new SequenceReportView;
  view_->setObjectName("sequence_told");
  across->addWidget(view_, 1);
  connect_work();
  connect(form_, &VideoForm::changed, this, [this] {
    said_ = {};  // it was of another order
    cancelled_ = false;
    update_text();
  });
  connect(make_, &QPushButton::clicked, this, &FromVideo::make);
  connect(cancel_, &QPushButton::clicked, &work_, &BackgroundWork::cancel);
  connect(back_, &QPushButton::clicked, this, &FromVideo::left);
  keep_translated(this, [this] {
    back_->setText(tr("Back"));
    back_->setToolTip(tr("What is chosen here stays"));
    make_->setText(tr("Make the sequence"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Stops, and leaves nothing behind"));
    progress_->setAccessibleName(tr("Progress"));
    update_text();
  });
}

QWidget* FromVideo::make_order() {
  constexpr int width_px = 470;
  auto* panel = new QWidget;
  panel->setObjectName("panel");
  panel->setFixedWidth(width_px);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(0, 0, 0, 14);
  column->setSpacing(8);
  form_ = new VideoForm;
  column->addWidget(scrolled(form_), 1);
  auto* below = new QVBoxLayout;
  below->setContentsMargins(14, 0, 14, 0);
  below->setSpacing(8);
  hint_ = wrapped_label("from_video_hint");
  says_ = wrapped_label("from_video_says");
  stage_ = wrapped_label("faint");
  progress_ = new QProgressBar;
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  cancel_ = named_button("cancel_sequence");
  back_ = named_button("leave_from_video");
  make_ = named_button("primary");
  auto* under_way = new QHBoxLayout;
  under_way->addWidget(progress_, 1);
  under_way->addWidget(cancel_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(back_);
  buttons->addStretch(1);
  buttons->addWidget(make_);
  below->addWidget(says_);
  below->addWidget(hint_);
  below->addWidget(stage_);
  below->addLayout(under_way);
  below->addLayout(buttons);
  column->addLayout(below);
  return panel;
}

void FromVideo::connect_work() {
  connect(&work_, &BackgroundWork::progressed, this, [this](double fraction, const QString& stage) {
    if (!working_) return;
    progress_->setValue(static_cast<int>(1000 * fraction));
    stage_->setText(translated_stage(stage));
  });
  connect(&work_, &BackgroundWork::finished, this, [this] {
    working_ = false;
    update_text();
  });
}

void FromVideo::make() {
  // Told on the worker's thread, taken on ours, as long as this page is there.
  const auto handed_over = [page = QPointer(this)](auto member, const auto& told) {
    QMetaObject::invokeMethod(
        QCoreApplication::instance(),
        [page, member, told] {
          if (!page.isNull()) (page.data()->*member)(told);
        },
        Qt::QueuedConnection);
  };
  const SequenceHeard heard{
      [handed_over](const CalibrationReport& told) { handed_over(&FromVideo::take_calibration, told); },
      [handed_over](const FrameReport& told) { handed_over(&FromVideo::take_frame, told); }};
  const bool started = work_.start(
      tr("Making a sequence from the video"),
      [page = QPointer(this), order = form_->order(), heard](const Progress& progress) -> BackgroundWork::Then {
        auto made = make_from_video(order, progress, heard);
        return [page, made = std::move(made)] {
          if (!page.isNull()) page->end(made);
        };
      });
  if (!started) return;
  working_ = true;
  report_ = {};
  said_ = {};
  cancelled_ = false;
  progress_->setValue(0);
  stage_->clear();
  view_->show_report(report_);
  update_text();
}

void FromVideo::take_calibration(const CalibrationReport& told) {
  report_.calibration = told;
  view_->show_report(report_);
}

void FromVideo::take_frame(const FrameReport& told) {
  if (!report_.first) report_.first = told;
  report_.latest = told;
  view_->show_report(report_);
}

void FromVideo::end(const Result<registration_quality::VideoSequence>& made) {
  if (!made) {
    cancelled_ = made.error().code == "cancelled";
    if (cancelled_) return update_text();
    return say([error = made.error()] { return translated(error); });
  }
  report_.made = *made;
  view_->show_report(report_);
  form_->propose_folder();
  update_text();
  Q_EMIT this->made(made->file, [told = report_] { return summary_of(told); });
}

void FromVideo::say(std::function<QString()> words) {
  said_ = std::move(words);
  update_text();
}

void FromVideo::update_text() {
  const QString missing = form_->missing();
  const QString said = said_ ? said_() : QString();
  form_->setEnabled(!working_);
  make_->setEnabled(!working_ && missing.isEmpty());
  make_->setToolTip(working_            ? tr("It is being computed")
                    : missing.isEmpty() ? tr("Makes clouds and tracks of the frames, and opens them")
                                        : missing);
  show_text(says_, working_ ? QString() : said);
  show_text(hint_, working_ || !said.isEmpty() ? QString()
                   : cancelled_                ? tr("Cancelled. Nothing was left behind.")
                                               : missing);
  for (QWidget* part : std::initializer_list<QWidget*>{stage_, progress_, cancel_}) part->setVisible(working_);
}

}  // namespace glisson::widgets
