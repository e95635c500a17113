#pragma once
// What came on the way from a video to a sequence, to look at while it is made and afterwards: how well the camera is
// calibrated, what stereo sees of a pair, how many landmarks are followed.

#include <array>
#include <QImage>
#include <QLabel>
#include <QWidget>

#include "widgets/sequence/video_order.h"

namespace glisson::widgets {

// A picture as large as there is room.
class FittedPicture : public QWidget {
  Q_OBJECT

 public:
  explicit FittedPicture(QWidget* parent = nullptr);
  void show_picture(const QImage& picture);
  [[nodiscard]] const QImage& picture() const { return picture_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage picture_;
};

class SequenceReportView : public QWidget {
  Q_OBJECT

 public:
  explicit SequenceReportView(QWidget* parent = nullptr);
  void show_report(const SequenceReport& report);

 private:
  void update_text();

  SequenceReport report_;
  QLabel* nothing_;
  std::array<QLabel*, 4> lines_{};
  QLabel* doubt_;
  FittedPicture* picture_;
  QLabel* caption_;
};

// In the language of now, for who comes to the sequence: the same in one line.
[[nodiscard]] QString summary_of(const SequenceReport& report);

}  // namespace glisson::widgets
