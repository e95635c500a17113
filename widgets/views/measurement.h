#pragma once
// A distance, an angle, a ball or a structure's volume: what was measured in the patient, and what came out.

#include <Eigen/Core>
#include <QString>
#include <vector>

#include "scene/scene.h"

namespace glisson::widgets {

enum class MeasureKind { distance, angle, ball, structure };

struct Measurement {
  MeasureKind kind = MeasureKind::distance;
  // Distance: its two ends. Angle: its vertex is the second of three. Ball: its centre and a point of its surface.
  std::vector<Eigen::Vector3d> points_mm;
  std::string structure;  // its name in the case
  double structure_ml = 0;
};

[[nodiscard]] std::size_t points_needed(MeasureKind kind);

// mm, degrees or ml. All its points must be there.
[[nodiscard]] double value_of(const Measurement& measurement);
// "12.3 mm", "45.0°", "8.2 ml".
[[nodiscard]] QString value_text(const Measurement& measurement);

// As lines in space, with the value; the points that are there so far are enough.
[[nodiscard]] std::vector<scene::LineItem> lines_in_space(const Measurement& measurement);
// The same in a slice: what lies within `reach_mm` of the plane, and the circle in which it cuts a ball.
[[nodiscard]] std::vector<scene::LineItem> lines_in_slice(const Measurement& measurement, const Eigen::Vector3d& on_mm,
                                                          const Eigen::Vector3d& normal, double reach_mm);

}  // namespace glisson::widgets
