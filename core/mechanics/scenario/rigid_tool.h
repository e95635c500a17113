#pragma once
// Rigid tools as solids: rods with round ends, placed by a pose. A ball is a rod without a length.

#include <array>
#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/result.h"

namespace glisson::mechanics {

struct Rod {
  Eigen::Vector3d from_mm{0, 0, 0};
  Eigen::Vector3d to_mm{0, 0, 0};
  double radius_mm = 0;
};

// In the tool's own frame, whose +z is the way it is pushed or lifted; together they are one solid.
using ToolShape = std::vector<Rod>;

// A ball at the origin.
[[nodiscard]] ToolShape palpation_probe(double radius_mm = 5.0);

// The Nathanson retractor's blade: an open loop of a bent rod that lies under the liver in the tool's x-y plane and
// lifts along +z. No published drawing was found: a loop of 60 x 55 mm of a rod of 6 mm is our assumption.
[[nodiscard]] ToolShape nathanson_retractor();

struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // tool to patient
  Eigen::Vector3d position_mm{0, 0, 0};                    // of the tool's origin

  [[nodiscard]] Eigen::Vector3d forward() const { return rotation.col(2); }
  [[nodiscard]] Pose advanced(double mm) const { return {rotation, position_mm + mm * forward()}; }
};

// At that place, its +z along `direction`; how it is turned about that is chosen, the same for the same direction.
[[nodiscard]] Pose pose_towards(const Eigen::Vector3d& position_mm, const Eigen::Vector3d& direction);

[[nodiscard]] ToolShape placed(const ToolShape& shape, const Pose& pose);

// Failure: "tool-invalid" (no rod; a number that is not finite; a radius that is not positive; a pose that is not a
// rotation).
Result<void> check_tool(const ToolShape& shape, const Pose& pose);

// Where a rod's axis and a triangle come nearest.
struct Nearest {
  Eigen::Vector3d on_axis_mm;
  Eigen::Vector3d barycentric;  // of the triangle's corners
  double distance_mm;           // 0 where the axis pierces the triangle
};
[[nodiscard]] Nearest nearest_of(const Rod& rod, const std::array<Eigen::Vector3d, 3>& triangle_mm);

}  // namespace glisson::mechanics
