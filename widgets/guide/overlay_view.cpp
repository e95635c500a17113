#include "widgets/guide/overlay_view.h"

#include <cmath>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

namespace glisson::widgets {
namespace {

constexpr double degrees_per_px = 0.35;  // of the widget
constexpr double depth_per_notch = 0.03;
constexpr double degrees_per_notch = 2;
constexpr double key_px = 4, key_deg = 2;  // a key's step

}  // namespace

OverlayView::OverlayView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(320, 240);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::StrongFocus);
}

void OverlayView::show_frame(const QImage& frame, QSize size_px) {
  frame_ = frame;
  size_px_ = frame.isNull() ? size_px : frame.size();
  update();
}

void OverlayView::show_overlay(OverlayPicture picture) {
  overlay_ = std::move(picture);
  update();
}

void OverlayView::set_look(const OverlayLook& look) {
  look_ = look;
  update();
}

void OverlayView::say(const QString& words) {
  said_ = words;
  setAccessibleDescription(words);
  update();
}

void OverlayView::set_by_hand(bool by_hand) {
  by_hand_ = by_hand;
  held_at_.reset();
  setCursor(by_hand ? Qt::OpenHandCursor : Qt::ArrowCursor);
  update();
}

void OverlayView::set_marking(bool marking) {
  marking_ = marking;
  setCursor(marking ? Qt::CrossCursor : Qt::ArrowCursor);
  update();
}

void OverlayView::show_marks(std::vector<Mark> marks) {
  marks_ = std::move(marks);
  update();
}

QRectF OverlayView::place() const {
  const QSizeF size = QSizeF(size_px_).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  return {(width() - size.width()) / 2, (height() - size.height()) / 2, size.width(), size.height()};
}

QTransform OverlayView::from_frame() const {
  const QRectF at = place();
  const double scale = size_px_.isEmpty() ? 1 : at.width() / size_px_.width();
  // A pixel's middle lies at whole numbers.
  return QTransform::fromTranslate(0.5, 0.5) * QTransform::fromScale(scale, scale) *
         QTransform::fromTranslate(at.left(), at.top());
}

void OverlayView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  if (size_px_.isEmpty()) return;
  const QRectF at = place();
  painter.setClipRect(at);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (frame_.isNull()) {
    painter.fillRect(at, Qt::black);
  } else {
    painter.drawImage(at, frame_);
  }
  paint_overlay(painter, from_frame(), overlay_, look_);
  paint_marks(painter);
  if (!said_.isEmpty()) {
    const int line = fontMetrics().height();
    const QRect room = at.toRect().adjusted(12, 0, -12, 0);
    const QRect words =
        fontMetrics().boundingRect(QRect(0, 0, room.width(), 10 * line),
                                   static_cast<int>(Qt::AlignCenter) | static_cast<int>(Qt::TextWordWrap), said_);
    const QRect band(at.toRect().left(), at.toRect().bottom() - words.height() - line + 1, at.toRect().width(),
                     words.height() + line);
    painter.fillRect(band, QColor(20, 23, 28, 215));
    painter.setPen(QColor(233, 237, 242));
    painter.drawText(band.adjusted(12, 0, -12, 0),
                     static_cast<int>(Qt::AlignCenter) | static_cast<int>(Qt::TextWordWrap), said_);
  }
  painter.setClipping(false);
  if (!by_hand_ && !marking_) return;
  painter.setPen(QPen(palette().highlight(), 3));
  painter.drawRect(at.adjusted(1.5, 1.5, -1.5, -1.5));
}

void OverlayView::paint_marks(QPainter& painter) const {
  for (const Mark& mark : marks_) {
    const QPolygonF places = from_frame().map(mark.places_px);
    const QColor colour = mark.is_current ? QColor(255, 217, 51) : QColor(217, 179, 115);
    for (const auto& [ink, width] : {std::pair(QColor(8, 10, 12, 190), 5.0), std::pair(colour, 2.5)}) {
      painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPolyline(places);
    }
    painter.setPen(QPen(QColor(8, 10, 12, 190), 1.2));
    painter.setBrush(colour);
    for (const QPointF& place : places) painter.drawEllipse(place, 4, 4);
    painter.setBrush(Qt::NoBrush);
  }
}

void OverlayView::mousePressEvent(QMouseEvent* event) {
  QWidget::mousePressEvent(event);
  const bool left = event->button() == Qt::LeftButton;
  if (marking_ && left && place().contains(event->position())) {
    event->accept();
    Q_EMIT marked(from_frame().inverted().map(event->position()));
    return;
  }
  if (!by_hand_ || (!left && event->button() != Qt::RightButton)) return;
  event->accept();
  held_at_ = event->position();
  turning_ = !left || event->modifiers().testFlag(Qt::ShiftModifier);
  setCursor(Qt::ClosedHandCursor);
}

void OverlayView::mouseMoveEvent(QMouseEvent* event) {
  if (!held_at_) return;
  const QPointF by = event->position() - *held_at_;
  held_at_ = event->position();
  if (turning_) {
    Q_EMIT turned(degrees_per_px * by.x(), degrees_per_px * by.y());
  } else {
    Q_EMIT shifted(by / from_frame().m11());
  }
}

void OverlayView::mouseReleaseEvent(QMouseEvent* event) {
  QWidget::mouseReleaseEvent(event);
  if (!held_at_) return;
  held_at_.reset();
  setCursor(Qt::OpenHandCursor);
  Q_EMIT let_go();
}

void OverlayView::wheelEvent(QWheelEvent* event) {
  if (!by_hand_) return QWidget::wheelEvent(event);
  const double notches = event->angleDelta().y() / 120.0;
  if (event->modifiers().testFlag(Qt::ControlModifier)) {
    Q_EMIT rolled(degrees_per_notch * notches);
  } else {
    Q_EMIT moved_in_depth(std::exp(-depth_per_notch * notches));  // away from the hand is nearer, as zooming in
  }
  Q_EMIT let_go();
  event->accept();
}

void OverlayView::keyPressEvent(QKeyEvent* event) {
  if (!by_hand_) return QWidget::keyPressEvent(event);
  const bool turn = event->modifiers().testFlag(Qt::ShiftModifier);
  const auto step = [&](int right, int down) {
    if (turn) {
      Q_EMIT turned(key_deg * right, key_deg * down);
    } else {
      Q_EMIT shifted(QPointF(key_px * right, key_px * down));
    }
  };
  switch (event->key()) {
    case Qt::Key_Left: step(-1, 0); break;
    case Qt::Key_Right: step(1, 0); break;
    case Qt::Key_Up: step(0, -1); break;
    case Qt::Key_Down: step(0, 1); break;
    case Qt::Key_Plus: Q_EMIT moved_in_depth(std::exp(-depth_per_notch)); break;
    case Qt::Key_Minus: Q_EMIT moved_in_depth(std::exp(depth_per_notch)); break;
    default: return QWidget::keyPressEvent(event);
  }
  Q_EMIT let_go();
}

}  // namespace glisson::widgets
