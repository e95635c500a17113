#include "widgets/sequence/sequence_told.h"

#include <QCoreApplication>
#include <QPainter>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/numbers.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

QString calibrated(const CalibrationTold& calibration) {
  const QString apart = number(calibration.baseline_mm);
  if (!calibration.from_board) {
    return SequenceToldView::tr("Calibration: read; the eyes are %1 mm apart.").arg(apart);
  }
  return SequenceToldView::tr(
             "Calibration: reprojection error %1 px; the board is seen in %2 of %3 pairs; the eyes are %4 mm apart.")
      .arg(number(calibration.rms_px, 2))
      .arg(calibration.pairs)
      .arg(calibration.looked_at)
      .arg(apart);
}

QString matched(const QString& sentence, const FrameTold& frame) {
  return sentence.arg(frame.number + 1)
      .arg(number(static_cast<double>(frame.points), 0), number(100 * frame.valid_fraction, 0));
}

QString made(const registration_quality::VideoSequence& sequence) {
  QString words = SequenceToldView::tr("Landmarks tracked: %1.").arg(sequence.landmarks);
  if (sequence.alignment_rms_mm) {
    words = SequenceToldView::tr("Landmarks tracked: %1; they agree within %2 mm once all frames are aligned.")
                .arg(sequence.landmarks)
                .arg(number(sequence.alignment_rms_mm->back(), 2));
  }
  return words;
}

// What a person should look into before trusting it.
QString doubts(const SequenceTold& told) {
  constexpr double good_px = 1, minimum_apart_mm = 2, maximum_apart_mm = 15;
  QStringList words;
  if (const auto& calibration = told.calibration) {
    if (2 * calibration->pairs < calibration->looked_at) {
      words << SequenceToldView::tr("Most pairs do not show the board: check its kind, its columns and its rows.");
    }
    if (calibration->rms_px > good_px) {
      words << SequenceToldView::tr("More than 1 px: the board may not be flat, or it moved between the two eyes.");
    }
    if (calibration->baseline_mm < minimum_apart_mm || calibration->baseline_mm > maximum_apart_mm) {
      words << (calibration->from_board
                    ? SequenceToldView::tr("The eyes of a laparoscope are about 5 mm apart: is the board's size right?")
                    : SequenceToldView::tr(
                          "The eyes of a laparoscope are about 5 mm apart: is the calibration in mm?"));
    }
  }
  if (told.first && !told.first->may_be_of_size) {
    words << SequenceToldView::tr("The calibration's middle lies far from the pictures' middle: is it of this size?");
  }
  if (told.made && told.made->left_out > 0) {
    words << SequenceToldView::tr("Frames left out because they show hardly anything in depth: %1.")
                 .arg(told.made->left_out);
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

SequenceToldView::SequenceToldView(QWidget* parent) : QWidget(parent) {
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
    word();
  });
}

void SequenceToldView::show_told(const SequenceTold& told) {
  const QImage before = picture_->picture();
  told_ = told;
  const QImage& seen = told.latest ? told.latest->picture : QImage();
  picture_->show_picture(!told.latest ? QImage() : seen.isNull() ? before : seen);
  word();
}

void SequenceToldView::word() {
  const auto show = [](QLabel* label, const QString& words) {
    label->setText(words);
    label->setVisible(!words.isEmpty());
  };
  nothing_->setVisible(!told_.calibration);
  show(lines_[0], told_.calibration ? calibrated(*told_.calibration) : QString());
  show(lines_[1], told_.first ? matched(tr("First pair, frame %1: points %2; %3 % of what can be seen."), *told_.first)
                              : QString());
  QString frames;
  if (told_.made) {
    frames = tr("Frames: %1, with %2 points each on average; %3 % of what can be seen.")
                 .arg(told_.made->frames)
                 .arg(number(told_.made->mean_points, 0), number(100 * told_.made->mean_valid_fraction, 0));
  } else if (told_.latest) {
    frames =
        matched(tr("Frame %1: points %2; %3 % of what can be seen; landmarks known from before: %4."), *told_.latest)
            .arg(told_.latest->followed);
  }
  show(lines_[2], frames);
  show(lines_[3], told_.made ? made(*told_.made) + " " + tr("Kept in %1.").arg(text_of(told_.made->file.parent_path()))
                             : QString());
  show(doubt_, doubts(told_));
  show(caption_,
       told_.latest ? tr("Rectified left picture; beside it what is seen in depth, near places bright.") : QString());
}

QString summary_of(const SequenceTold& told) {
  if (!told.made) return {};
  QStringList words{SequenceToldView::tr("Made from the video.")};
  if (told.calibration) words << calibrated(*told.calibration);
  words << made(*told.made);
  const QString doubt = doubts(told);
  if (!doubt.isEmpty()) words << doubt;
  return words.join(" ");
}

}  // namespace glisson::widgets
