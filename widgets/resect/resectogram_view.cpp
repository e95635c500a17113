#include "widgets/resect/resectogram_view.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include "planning/cut.h"
#include "widgets/resect/plan_by_anatomy.h"
#include "widgets/theme.h"

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;

constexpr double edge_px = 18;  // for the letters

// Of a tumour, near one, less near, and clear: as in the report's drawing.
constexpr QRgb in_tumour = 0xff9b6cd0, near_tumour = 0xffe05a4a, not_far = 0xffe2a83a, clear = 0xff7f9c8a;

QRgb colour_at(double margin_mm) {
  if (std::isnan(margin_mm)) return 0;
  if (margin_mm <= 0) return in_tumour;
  return margin_mm < near_band_mm ? near_tumour : margin_mm < wide_band_mm ? not_far : clear;
}

// What points up and to the right when the map is seen upright.
struct Upright {
  Vector3d up, right;
};
Upright upright(const planning::Resectogram& map) {
  const Vector3d normal = map.along_row.cross(map.along_column).normalized();
  constexpr double nearly_from_head = 0.8;
  const Vector3d wanted = std::abs(normal.z()) < nearly_from_head ? Vector3d(0, 0, 1) : Vector3d(0, -1, 0);
  const Vector3d up = (wanted - wanted.dot(normal) * normal).normalized();
  Vector3d right = up.cross(normal);
  if (right.x() + right.y() < 0) right = -right;
  return {up, right};
}

// How a vessel that is cut is drawn around its place.
struct Sign {
  QColor colour;
  QPainterPath shape;
};
Sign sign_of(vasculature::System system, const QRectF& around) {
  QPainterPath shape;
  const QPointF top(around.center().x(), around.top());
  switch (system) {
    case vasculature::System::portal_vein: shape.addEllipse(around); return {Qt::white, shape};
    case vasculature::System::hepatic_vein: shape.addRect(around); return {QColor(0x7c, 0xc8, 0xff), shape};
    case vasculature::System::artery:
      shape.addPolygon(
          QPolygonF({top, QPointF(around.right(), around.center().y()), QPointF(around.center().x(), around.bottom()),
                     QPointF(around.left(), around.center().y()), top}));
      return {QColor(0xff, 0x8a, 0x80), shape};
    case vasculature::System::biliary_tract:
      shape.addPolygon(QPolygonF({top, around.bottomRight(), around.bottomLeft(), top}));
      return {QColor(0x9c, 0xe0, 0x8a), shape};
  }
  return {};
}

// The letter of the side that a direction points to the most: L, R, A, P, H or F.
QString side_seen_from(const Vector3d& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  constexpr const char* towards[] = {"L", "P", "H"};
  constexpr const char* away[] = {"R", "A", "F"};
  return QString(direction[axis] > 0 ? towards[axis] : away[axis]);
}

}  // namespace

ResectogramView::ResectogramView(QWidget* parent) : QWidget(parent) {
  setObjectName("resectogram");
  setMinimumSize(160, 150);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ResectogramView::show_map(const planning::Resectogram& map) {
  map_ = map;
  update();
}

QTransform ResectogramView::to_pixels() const {
  const Upright seen = upright(map_);
  const QTransform turn(map_.along_row.dot(seen.right), -map_.along_row.dot(seen.up),  // pixels go down
                        map_.along_column.dot(seen.right), -map_.along_column.dot(seen.up), 0, 0);
  const QRectF extent = turn.mapRect(QRectF(0, 0, std::max(1, map_.columns), std::max(1, map_.rows)));
  const QRectF room = QRectF(rect()).adjusted(edge_px, edge_px, -edge_px, -edge_px);
  const double scale = std::min(room.width() / extent.width(), room.height() / extent.height());
  const QPointF to = room.center() - scale * extent.center();
  return turn * QTransform::fromScale(scale, scale) * QTransform::fromTranslate(to.x(), to.y());
}

QPointF ResectogramView::drawn_at(double column, double row) const {
  return to_pixels().map(QPointF(column + 0.5, row + 0.5));
}

void ResectogramView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme_colour("view"));
  if (map_.columns <= 0 || map_.rows <= 0) return;
  QImage picture(map_.columns, map_.rows, QImage::Format_ARGB32);
  for (int row = 0; row < map_.rows; ++row) {
    for (int column = 0; column < map_.columns; ++column)
      picture.setPixel(column, row, colour_at(map_.at(column, row)));
  }
  const QTransform placed = to_pixels();
  painter.setTransform(placed);
  painter.drawImage(QPointF(0, 0), picture);
  painter.resetTransform();
  draw_vessels(painter, placed);
  draw_sides(painter);
}

void ResectogramView::draw_vessels(QPainter& painter, const QTransform& to_pixels) const {
  constexpr double smallest_px = 3;
  const double px_a_mm = std::sqrt(std::abs(to_pixels.determinant())) / map_.step_mm;
  for (const planning::Resectogram::Vessel& vessel : map_.vessels) {
    const double radius_px = std::max(smallest_px, px_a_mm * vessel.radius_mm);
    const QPointF at = drawn_at(vessel.column, vessel.row);
    const QRectF around(at.x() - radius_px, at.y() - radius_px, 2 * radius_px, 2 * radius_px);
    const Sign sign = sign_of(vessel.system, around);
    for (const QPen& pen : {QPen(QColor(10, 11, 14), 4), QPen(sign.colour, 2)}) {
      painter.setPen(pen);
      painter.drawPath(sign.shape);
    }
  }
  constexpr double bar_mm = 20;
  const QPointF from(edge_px, height() - 6);
  painter.setPen(QPen(QColor(0xe4, 0xe8, 0xee), 2));
  painter.drawLine(from, from + QPointF(bar_mm * px_a_mm, 0));
  painter.drawText(from + QPointF(bar_mm * px_a_mm + 6, 3), tr("20 mm"));
}

void ResectogramView::draw_sides(QPainter& painter) const {
  const Upright seen = upright(map_);
  painter.setPen(QColor(0xa8, 0xb2, 0xc0));
  const QRectF all(rect());
  painter.drawText(QRectF(0, 0, all.width(), edge_px), Qt::AlignCenter, side_seen_from(seen.up));
  painter.drawText(QRectF(0, all.height() - edge_px, all.width(), edge_px), Qt::AlignCenter, side_seen_from(-seen.up));
  painter.drawText(QRectF(0, 0, edge_px, all.height()), Qt::AlignCenter, side_seen_from(-seen.right));
  painter.drawText(QRectF(all.width() - edge_px, 0, edge_px, all.height()), Qt::AlignCenter,
                   side_seen_from(seen.right));
}

QString ResectogramView::told_at(const QPointF& pixel) const {
  bool invertible = false;
  const QPointF place = to_pixels().inverted(&invertible).map(pixel);
  const int column = static_cast<int>(std::floor(place.x())), row = static_cast<int>(std::floor(place.y()));
  if (!invertible || column < 0 || row < 0 || column >= map_.columns || row >= map_.rows) return {};
  QStringList told;
  constexpr double near_px = 8;
  for (const planning::Resectogram::Vessel& vessel : map_.vessels) {
    if (QLineF(drawn_at(vessel.column, vessel.row), pixel).length() > near_px) continue;
    told << tr("%1, %2 mm wide").arg(branch_label(vessel.name), QLocale().toString(2 * vessel.radius_mm, 'f', 1));
  }
  const double margin_mm = map_.at(column, row);
  if (std::isnan(margin_mm)) return told.join("\n");
  const QString mm = QLocale().toString(margin_mm, 'f', 1);
  told << (margin_mm <= 0                             ? tr("In a tumour")
           : margin_mm >= planning::largest_margin_mm ? tr("No tumour within %1 mm").arg(mm)
                                                      : tr("%1 mm from a tumour").arg(mm));
  return told.join("\n");
}

bool ResectogramView::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* asked = static_cast<QHelpEvent*>(event);
  const QString told = told_at(asked->pos());
  if (told.isEmpty())
    QToolTip::hideText();
  else
    QToolTip::showText(asked->globalPos(), told, this);
  return true;
}

std::optional<double> nearest_mm(const planning::Resectogram& map) {
  double nearest = planning::largest_margin_mm;
  for (const double margin_mm : map.margin_mm) {
    if (margin_mm < nearest) nearest = margin_mm;
  }
  return nearest < planning::largest_margin_mm ? std::optional(nearest) : std::nullopt;
}

QString resectogram_key() {
  const auto patch = [](QRgb colour, const QString& text) {
    return QString("<span style=\"color:%1\">■</span> %2").arg(QColor(colour).name(), text.toHtmlEscaped());
  };
  return QStringList{patch(in_tumour, ResectogramView::tr("tumour")),
                     patch(near_tumour, ResectogramView::tr("under %1 mm").arg(near_band_mm)),
                     patch(not_far, ResectogramView::tr("under %1 mm").arg(wide_band_mm)),
                     patch(clear, ResectogramView::tr("clear")),
                     ResectogramView::tr("○ portal, □ hepatic vein cut; ◇ artery, △ bile duct")}
      .join("  ");
}

}  // namespace glisson::widgets
