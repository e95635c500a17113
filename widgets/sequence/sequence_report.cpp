#include "widgets/sequence/sequence_report.h"

#include <QCoreApplication>
#include <QPainter>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/numbers.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

QString calibrated(const CalibrationReport& calibration) {
  const QString apart = number(calibration.baseline_mm);
  if (!calibration.from_board) {
    return SequenceReportView::tr("Calibration: read; the eyes are %1 mm apart.").arg(apart);
  }
  return SequenceReportView::tr(
             "Calibration: reprojection error %1 px; the board is seen in %2 of %3 pairs; the eyes are %4 mm apart.")
      .arg(number(calibration.rms_px, 2))
      .arg(calibration.pairs)
      .arg(calibration.looked_at)
      .arg(apart);
}

QString matched(const QString& sentence, const FrameReport& frame) {
  return sentence.arg(frame.number + 1)
      .arg(number(static_cast<double>(frame.points), 0), number(100 * frame.valid_fraction, 0));
}

QString made(const registration_quality::VideoSequence& sequence) {
  QString words = SequenceReportView::tr("Landmarks tracked: %1.").arg(sequence.landmarks);
  if (sequence.alignment_rms_mm) {
    words = SequenceReportView::tr("Landmarks tracked: %1; they agree within %2 mm once all frames are aligned.")
                .arg(sequence.landmarks)
                .arg(number(sequence.alignment_rms_mm->back(), 2));
  }
  return words;
}

// What a person should look into before trusting it.
QString doubts(const SequenceReport& report) {
  constexpr double good_px = 1, minimum_apart_mm = 2, maximum_apart_mm = 15;
  QStringList words;
  if (const auto& calibration = report.calibration) {
    if (2 * calibration->pairs < calibration->looked_at) {
      words << SequenceReportView::tr("Most pairs do not show the board: check its kind, its columns and its rows.");
    }
    if (calibration->rms_px > good_px) {
      words << SequenceReportView::tr("More than 1 px: the board may not be flat, or it moved between the two eyes.");
    }
    if (calibration->baseline_mm < minimum_apart_mm || calibration->baseline_mm > maximum_apart_mm) {
      words << (calibration->from_board
                    ? SequenceReportView::tr(
                          "The eyes of a laparoscope are about 5 mm apart: is the board's size right?")
                    : SequenceReportView::tr(
                          "The eyes of a laparoscope are about 5 mm apart: is the calibration in mm?"));
    }
  }
  if (report.first && !report.first->may_be_of_size) {
    words << SequenceReportView::tr("The calibration's middle lies far from the pictures' middle: is it of this size?");
  }
  if (report.made && report.made->left_out > 0) {
    words << SequenceReportView::tr("Frames left out because they show hardly anything in depth: %1.")
                 .arg(report.made->left_out);
  }
  return words.join(" ");
}

}  // namespace

FittedPicture::FittedPicture(QWidget* parent) : QWidget(parent) { setMinimumSize(240, 90); }

void FittedPicture::show_picture(const QImage& picture) {
  picture_ = picture;
  update();
}

void FittedPicture::paintEvent(QPaintEvent* /*event*/) {
  if (picture_.isNull()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QSize size = picture_.size().scaled(this->size(), Qt::KeepAspectRatio);
  painter.drawImage(QRect({(width() - size.width()) / 2, 0}, size), picture_);
}

SequenceReportView::SequenceReportView(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(18, 14, 18, 14);
  column->setSpacing(8);
  QLabel* title = heading();
  column->addWidget(title);
  nothing_ = wrapped_label("faint");
  column->addWidget(nothing_);
  constexpr std::array names{"told_calibration", "told_first", "told_frames", "told_landmarks"};
  for (std::size_t i = 0; i < lines_.size(); ++i) column->addWidget(lines_[i] = wrapped_label(names[i]));
  doubt_ = wrapped_label("sequence_doubt");
  column->addWidget(doubt_);
  caption_ = wrapped_label("faint");
  column->addWidget(caption_);
  picture_ = new FittedPicture;
  picture_->setObjectName("told_picture");
  column->addWidget(picture_, 1);
  keep_translated(this, [this, title] {
    title->setText(tr("What comes on the way"));
    nothing_->setText(tr(
        "Here you will see how well the camera is calibrated, how much of each pair of pictures is seen in depth, and "
        "how many landmarks are followed. Then the sequence is opened."));
    picture_->setAccessibleName(tr("A frame beside its depths"));
    update_text();
  });
}

void SequenceReportView::show_report(const SequenceReport& report) {
  const QImage before = picture_->picture();
  report_ = report;
  const QImage& seen = report.latest ? report.latest->picture : QImage();
  picture_->show_picture(!report.latest ? QImage() : seen.isNull() ? before : seen);
  update_text();
}

void SequenceReportView::update_text() {
  nothing_->setVisible(!report_.calibration);
  show_text(lines_[0], report_.calibration ? calibrated(*report_.calibration) : QString());
  show_text(lines_[1], report_.first
                           ? matched(tr("First pair, frame %1: points %2; %3 % of what can be seen."), *report_.first)
                           : QString());
  QString frames;
  if (report_.made) {
    frames = tr("Frames: %1, with %2 points each on average; %3 % of what can be seen.")
                 .arg(report_.made->frames)
                 .arg(number(report_.made->mean_points, 0), number(100 * report_.made->mean_valid_fraction, 0));
  } else if (report_.latest) {
    frames =
        matched(tr("Frame %1: points %2; %3 % of what can be seen; landmarks known from before: %4."), *report_.latest)
            .arg(report_.latest->followed);
  }
  show_text(lines_[2], frames);
  show_text(lines_[3],
            report_.made ? made(*report_.made) + " " + tr("Kept in %1.").arg(text_of(report_.made->file.parent_path()))
                         : QString());
  show_text(doubt_, doubts(report_));
  show_text(caption_, report_.latest
                          ? tr("Rectified left picture; beside it what is seen in depth, near places bright.")
                          : QString());
}

QString summary_of(const SequenceReport& report) {
  if (!report.made) return {};
  QStringList words{SequenceReportView::tr("Made from the video.")};
  if (report.calibration) words << calibrated(*report.calibration);
  words << made(*report.made);
  const QString doubt = doubts(report);
  if (!doubt.isEmpty()) words << doubt;
  return words.join(" ");
}

}  // namespace glisson::widgets
