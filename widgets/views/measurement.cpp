#include "widgets/views/measurement.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <QLocale>

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;

constexpr scene::Colour yellow{1.0, 0.86, 0.35};

std::vector<Vector3d> circle(const Vector3d& center_mm, const Vector3d& normal, double radius_mm) {
  constexpr int corners = 72;
  const Vector3d across = normal.unitOrthogonal();
  const Vector3d along = normal.cross(across);
  std::vector<Vector3d> points_mm;
  for (int k = 0; k <= corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points_mm.push_back(center_mm + radius_mm * (std::cos(angle) * across + std::sin(angle) * along));
  }
  return points_mm;
}

std::string label_of(const Measurement& measurement) {
  const bool whole = measurement.points_mm.size() == points_needed(measurement.kind);
  return whole ? value_text(measurement).toStdString() : std::string();
}

scene::LineItem plain_line(std::vector<Vector3d> points_mm) {
  return {std::move(points_mm), yellow, {}, scene::LineItem::Ends::plain};
}

}  // namespace

std::size_t points_needed(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::angle: return 3;
    case MeasureKind::structure: return 0;
    default: return 2;
  }
}

double value_of(const Measurement& measurement) {
  GLISSON_ASSERT(measurement.points_mm.size() == points_needed(measurement.kind));
  const auto& p = measurement.points_mm;
  switch (measurement.kind) {
    case MeasureKind::distance: return (p[1] - p[0]).norm();
    case MeasureKind::angle: {
      const Vector3d a = p[0] - p[1];
      const Vector3d b = p[2] - p[1];
      return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
    }
    case MeasureKind::ball: return 4e-3 / 3 * std::numbers::pi * std::pow((p[1] - p[0]).norm(), 3);
    case MeasureKind::structure: return measurement.structure_ml;
  }
  return 0;
}

QString value_text(const Measurement& measurement) {
  const double value = value_of(measurement);
  const char* unit = measurement.kind == MeasureKind::distance ? " mm"
                     : measurement.kind == MeasureKind::angle  ? "°"
                                                               : " ml";
  return QString::number(value, 'f', 1) + QString::fromUtf8(unit);
}

std::vector<scene::LineItem> lines_in_space(const Measurement& measurement) {
  const auto& points_mm = measurement.points_mm;
  if (points_mm.empty()) return {};
  std::vector<scene::LineItem> lines{{points_mm, yellow, label_of(measurement), scene::LineItem::Ends::marked}};
  if (measurement.kind == MeasureKind::ball && points_mm.size() == 2) {
    const double radius_mm = (points_mm[1] - points_mm[0]).norm();
    for (int axis = 0; axis < 3; ++axis) {
      lines.push_back(plain_line(circle(points_mm[0], Vector3d::Unit(axis), radius_mm)));
    }
  }
  return lines;
}

std::vector<scene::LineItem> lines_in_slice(const Measurement& measurement, const Vector3d& on_mm,
                                            const Vector3d& normal, double reach_mm) {
  const auto& points_mm = measurement.points_mm;
  std::vector<scene::LineItem> lines;
  const auto height_mm = [&](const Vector3d& point_mm) { return normal.dot(point_mm - on_mm); };
  const bool in_slice = !points_mm.empty() && std::all_of(points_mm.begin(), points_mm.end(), [&](const Vector3d& p) {
    return std::abs(height_mm(p)) <= reach_mm;
  });
  if (in_slice) lines.push_back({points_mm, yellow, label_of(measurement), scene::LineItem::Ends::marked});
  if (measurement.kind == MeasureKind::ball && points_mm.size() == 2) {
    const double radius_mm = (points_mm[1] - points_mm[0]).norm();
    const double away_mm = height_mm(points_mm[0]);
    if (std::abs(away_mm) < radius_mm) {
      lines.push_back(plain_line(
          circle(points_mm[0] - away_mm * normal, normal, std::sqrt(radius_mm * radius_mm - away_mm * away_mm))));
    }
  }
  return lines;
}

}  // namespace glisson::widgets
