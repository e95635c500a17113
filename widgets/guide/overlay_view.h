#pragma once
// A frame of the laparoscope with outlines over it. Where the liver is placed by hand, a drag moves it, a right drag
// (or Shift) turns it, and the wheel is for depth. Ctrl and the wheel turn it in the picture's plane; arrow keys, plus
// and minus do the same. Where a line is marked, a click is its next place.

#include <optional>
#include <QImage>
#include <QPolygonF>
#include <QWidget>

#include "widgets/guide/overlay_painter.h"

namespace glisson::widgets {

class OverlayView : public QWidget {
  Q_OBJECT

 public:
  explicit OverlayView(QWidget* parent = nullptr);

  // A null image is drawn as an empty frame of its size in pixels.
  void show_frame(const QImage& frame, QSize size_px);
  void show_overlay(OverlayPicture picture);
  void set_look(const OverlayLook& look);
  // What is said over the picture's lower edge; empty for nothing.
  void say(const QString& words);
  void set_by_hand(bool by_hand);
  void set_marking(bool marking);
  struct Mark {
    QPolygonF places_px;  // of the frame
    bool is_current = false;
  };
  void show_marks(std::vector<Mark> marks);

  [[nodiscard]] const OverlayPicture& overlay() const { return overlay_; }
  [[nodiscard]] const OverlayLook& look() const { return look_; }
  [[nodiscard]] const QString& said() const { return said_; }
  [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
  // From the frame's pixels to the widget's.
  [[nodiscard]] QTransform from_frame() const;

  [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }

 Q_SIGNALS:
  void shifted(const QPointF& by_px);  // of the frame
  void turned(double right_deg, double down_deg);
  void rolled(double clockwise_deg);
  void moved_in_depth(double factor);
  void let_go();                      // a drag has ended
  void marked(const QPointF& at_px);  // of the frame

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QRectF place() const;  // of the frame on the widget
  void paint_marks(QPainter& painter) const;

  QImage frame_;
  QSize size_px_;
  OverlayPicture overlay_;
  OverlayLook look_;
  QString said_;
  std::vector<Mark> marks_;
  bool by_hand_ = false;
  bool marking_ = false;
  std::optional<QPointF> held_at_;
  bool turning_ = false;
};

}  // namespace glisson::widgets
