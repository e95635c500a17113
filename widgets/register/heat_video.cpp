#include "widgets/register/heat_video.h"

#include <algorithm>
#include <cmath>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

namespace glisson::widgets {
namespace {

constexpr int margin = 8;

QPointF point(const Eigen::Vector2d& pixel) { return {pixel.x(), pixel.y()}; }

QPolygonF outline(const scene::SeenTriangle& triangle) {
  return QPolygonF({point(triangle.corners_px[0]), point(triangle.corners_px[1]), point(triangle.corners_px[2])});
}

}  // namespace

HeatVideo::HeatVideo(QWidget* parent) : QWidget(parent) {
  setMinimumSize(240, 200);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::ClickFocus);
}

void HeatVideo::set_words(const QString& title, const QString& remark) {
  title_ = title;
  remark_ = remark;
  setAccessibleName(title);
  setAccessibleDescription(remark);
  update();
}

void HeatVideo::show_frame(const QImage& frame, QSize size_px) {
  frame_ = frame;
  size_px_ = frame.isNull() ? size_px : frame.size();
  update();
}

void HeatVideo::show_mesh(const scene::HeatMesh& mesh, const vision::Camera& camera, const scene::HeatScale& scale) {
  mesh_ = mesh;
  scale_ = scale;
  seen_ = scene::seen_triangles(camera, mesh);
  update();
}

void HeatVideo::show_no_mesh() {
  seen_.clear();
  chosen_.reset();
  update();
}

void HeatVideo::choose(std::optional<std::size_t> triangle) {
  chosen_ = triangle;
  update();
}

std::optional<std::size_t> HeatVideo::triangle_at(const QPointF& pixel) const {
  const auto found = std::find_if(seen_.rbegin(), seen_.rend(), [&](const scene::SeenTriangle& triangle) {
    return outline(triangle).containsPoint(pixel, Qt::OddEvenFill);
  });
  return found != seen_.rend() ? std::optional(found->triangle) : std::nullopt;
}

std::optional<QPointF> HeatVideo::middle_of(std::size_t triangle) const {
  for (const scene::SeenTriangle& seen : seen_) {
    if (seen.triangle == triangle) return point((seen.corners_px[0] + seen.corners_px[1] + seen.corners_px[2]) / 3);
  }
  return std::nullopt;
}

QRectF HeatVideo::place() const {
  const int title_height = fontMetrics().height() + margin;
  const QRectF room(margin, title_height + margin / 2.0, width() - 2 * margin, height() - title_height - 1.5 * margin);
  const QSizeF size = QSizeF(size_px_).scaled(room.size(), Qt::KeepAspectRatio);
  return {room.center().x() - size.width() / 2, room.top() + (room.height() - size.height()) / 2, size.width(),
          size.height()};
}

QPointF HeatVideo::on_widget(const QPointF& pixel) const {
  const QRectF at = place();
  return {at.left() + pixel.x() * at.width() / size_px_.width(),
          at.top() + pixel.y() * at.height() / size_px_.height()};
}

QPointF HeatVideo::on_frame(const QPointF& widget) const {
  const QRectF at = place();
  return {(widget.x() - at.left()) * size_px_.width() / at.width(),
          (widget.y() - at.top()) * size_px_.height() / at.height()};
}

void HeatVideo::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRect(margin, margin / 2, width() - 2 * margin, fontMetrics().height() + 4),
                   Qt::AlignLeft | Qt::AlignVCenter, title_);
  painter.setFont(font());
  if (!size_px_.isEmpty()) {
    const QRectF at = place();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (frame_.isNull()) {
      painter.fillRect(at, Qt::black);
    } else {
      painter.drawImage(at, frame_);
    }
    painter.setClipRect(at);
    draw_mesh(painter);
    painter.setClipping(false);
  }
  if (remark_.isEmpty()) return;
  // Over the picture, which is dark in every theme.
  QRect band(margin, height() - margin - 3 * fontMetrics().height(), width() - 2 * margin, 3 * fontMetrics().height());
  if (!size_px_.isEmpty()) {
    const QRect picture = place().toRect();
    band.setLeft(picture.left());
    band.setRight(picture.right());
    band.moveBottom(picture.bottom());
  }
  painter.fillRect(band, QColor(20, 23, 28, 215));
  painter.setPen(QColor(233, 237, 242));
  painter.drawText(band, static_cast<int>(Qt::AlignCenter) | static_cast<int>(Qt::TextWordWrap), remark_);
}

void HeatVideo::draw_mesh(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  std::optional<QPolygonF> rim;
  for (const scene::SeenTriangle& triangle : seen_) {
    QPolygonF shape;
    for (const QPointF& corner : outline(triangle)) shape << on_widget(corner);
    const bool rejected = mesh_.verdicts[triangle.triangle] == scene::HeatMesh::Verdict::rejected;
    const scene::Colour heat = scene::heat_colour(scale_, mesh_.values[triangle.triangle]);
    QColor fill = rejected ? QColor(150, 150, 150)
                           : QColor::fromRgbF(static_cast<float>(heat.red), static_cast<float>(heat.green),
                                              static_cast<float>(heat.blue));
    fill.setAlphaF(static_cast<float>(scale_.opacity));
    painter.setPen(QPen(QColor(10, 12, 16, 150), 1));
    painter.setBrush(fill);
    painter.drawPolygon(shape);
    if (rejected) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(QBrush(QColor(20, 22, 26, 190), Qt::BDiagPattern));
      painter.drawPolygon(shape);
    }
    if (chosen_ == triangle.triangle) rim = shape;
  }
  if (!rim) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolygon(*rim);
  painter.setPen(QPen(Qt::white, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolygon(*rim);
}

void HeatVideo::mousePressEvent(QMouseEvent* event) {
  QWidget::mousePressEvent(event);
  if (event->button() == Qt::LeftButton && !size_px_.isEmpty()) Q_EMIT clicked(on_frame(event->position()));
}

bool HeatVideo::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || size_px_.isEmpty()) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto triangle = triangle_at(on_frame(help->pos()));
  const QString words = triangle && hint_ ? hint_(*triangle) : toolTip();
  words.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), words, this);
  return true;
}

}  // namespace glisson::widgets
