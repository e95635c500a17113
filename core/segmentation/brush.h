#pragma once
// Drawing on a mask while a person watches: in place, and told which voxels may have changed.

#include <array>
#include <Eigen/Core>
#include <optional>

#include "imaging/image.h"

namespace glisson::segmentation {

// Voxels first..last along each axis, both included; empty where a last lies before its first.
struct IndexBox {
  std::array<int, 3> first{0, 0, 0};
  std::array<int, 3> last{-1, -1, -1};

  [[nodiscard]] bool empty() const { return last[0] < first[0] || last[1] < first[1] || last[2] < first[2]; }
  [[nodiscard]] IndexBox joined(const IndexBox& other) const;
};

// One movement of the brush from where it was to where it is. Lengths and places are mm, patient LPS.
struct Dab {
  Eigen::Vector3d from_mm{0, 0, 0};
  Eigen::Vector3d to_mm{0, 0, 0};
  double radius_mm = 5;
  // A ball reaches into the neighbouring slices. A disc stays in the layer of voxels that `to_mm` lies in, counted
  // along this axis of the grid.
  std::optional<int> layer_axis;
  // A disc in a slice that is tilted against the grid: round the voxels that the plane through `to_mm` with this unit
  // normal goes through. Instead of layer_axis.
  std::optional<Eigen::Vector3d> plane_normal = {};
};

// Grey values, both ends included.
struct GreyRange {
  double low = 0;
  double high = 0;
};

// The grey values that are like those under a click. Their middle is the median of the voxels within `around_mm` of it.
// They reach `spread` times the robust standard deviation of these both ways (1.4826 times the median deviation). They
// reach at least `minimum_share` of the image's own range from its 1st to its 99th hundredth. A dozen even voxels say
// little of an organ. Absent where the click is outside of the image.
struct LikenessOptions {
  double around_mm = 2.5;
  double spread = 2.5;
  double minimum_share = 0.04;
};
[[nodiscard]] std::optional<GreyRange> grey_range_at(const imaging::Volume& image, const Eigen::Vector3d& click_mm,
                                                     const LikenessOptions& options = {});

enum class Paint { add, take_away };

// How far from a plane the centre of a voxel may lie that the plane still goes through, in mm.
[[nodiscard]] double half_extent_mm(const imaging::Grid& grid, const Eigen::Vector3d& unit_normal);

// Sets or clears the voxels whose centre lies within the radius of the way from `from_mm` to `to_mm`. Returns the box
// of those looked at. With `only`, those of them alone whose grey value in `image` (same grid: asserts) lies in the
// range: the smart brush.
struct Only {
  const imaging::Volume& image;
  GreyRange range;
};
IndexBox draw(imaging::Mask& mask, const Dab& dab, Paint paint, const std::optional<Only>& only = std::nullopt);

// The axis of the grid that runs most along a direction: 0, 1 or 2.
[[nodiscard]] int axis_along(const imaging::Grid& grid, const Eigen::Vector3d& direction);

// The layer of voxels along an axis that a place lies in; it may lie outside of the grid.
[[nodiscard]] int layer_at(const imaging::Grid& grid, int axis, const Eigen::Vector3d& place_mm);

}  // namespace glisson::segmentation
