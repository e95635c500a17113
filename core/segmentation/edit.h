#pragma once
// Correcting a mask by hand. Each operation takes a mask and gives the edited one back on the same grid. A caller who
// no longer needs the old one moves it in: mask = paint(std::move(mask), ball). Lengths are mm in patient LPS, so that
// a ball is a ball on any grid.

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "base/result.h"
#include "imaging/filters.h"
#include "segmentation/brush.h"

namespace glisson::segmentation {

struct Ball {
  Eigen::Vector3d center_mm{0, 0, 0};
  double radius_mm = 5;
};

// Adds, or takes away, the voxels whose centre lies in the ball. A ball between voxel centres does nothing.
[[nodiscard]] imaging::Mask paint(imaging::Mask mask, const Ball& ball);
[[nodiscard]] imaging::Mask erase(imaging::Mask mask, const Ball& ball);

struct Plane {
  Eigen::Vector3d point_mm{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 1};  // any length but zero
};

// Takes away what lies on the side that the normal points to.
[[nodiscard]] imaging::Mask cut(imaging::Mask mask, const Plane& plane);

// A closed outline drawn on a view and pushed through the volume along the view's direction.
struct Outline {
  std::vector<Eigen::Vector3d> points_mm;  // at least three, in a plane; the last is joined to the first
  Eigen::Vector3d direction{0, 0, 1};      // any length but zero
  // How far along the direction, from the first point: what is cut has its centre between the two, in mm.
  double from_mm = -std::numeric_limits<double>::infinity();
  double to_mm = std::numeric_limits<double>::infinity();
};
enum class CutSide { inside, outside };

// Takes away what lies on that side of the outline. Where the outline crosses itself, even-odd rule.
[[nodiscard]] imaging::Mask cut(imaging::Mask mask, const Outline& outline, CutSide side);

// Fills every hole that no path through faces leads out of.
using imaging::fill_holes;

// Keeps the largest piece (26 neighbours); an empty mask stays empty.
[[nodiscard]] imaging::Mask keep_largest(imaging::Mask mask);

// Takes away the pieces (26 neighbours) of less than that volume.
[[nodiscard]] imaging::Mask without_small_pieces(imaging::Mask mask, double minimum_ml);

// The voxel of the mask that a place lies in. Fails with "edit-no-piece-there" where the mask does not hold it.
[[nodiscard]] Result<Eigen::Vector3i> voxel_held_at(const imaging::Mask& mask, const Eigen::Vector3d& place_mm);

// Keeps the piece (26 neighbours) that a place lies in. Fails with "edit-no-piece-there".
[[nodiscard]] Result<imaging::Mask> keep_piece_at(imaging::Mask mask, const Eigen::Vector3d& place_mm);

// Fills the layers along an axis of the grid (0, 1, 2) that hold nothing, between layers that do. The distances to the
// outlines in the layer before and the one after, negative inside, are mixed by how near each layer is. What is at most
// 0 is filled (shape-based interpolation: Raya and Udupa, IEEE Trans Med Imaging 9:32, 1990). Drawn layers stay as they
// are.
[[nodiscard]] imaging::Mask fill_between_layers(imaging::Mask mask, int axis);

// Rounds what is smaller than about radius_mm: the half level of the mask blurred with a Gaussian of that standard
// deviation. Volume is nearly kept where the surface is flat on that scale; thinner parts vanish.
[[nodiscard]] imaging::Mask smooth(imaging::Mask mask, double radius_mm);

// Grows (positive) or shrinks (negative) by a margin. A voxel joins whose centre is at most that far from the centre of
// one inside. A voxel leaves that lies so near to one outside. The image's border does not count as outside.
[[nodiscard]] imaging::Mask with_margin(imaging::Mask mask, double margin_mm);

// Voxel by voxel; the other mask must be on the same grid (asserts).
[[nodiscard]] imaging::Mask united(imaging::Mask mask, const imaging::Mask& other);
[[nodiscard]] imaging::Mask subtracted(imaging::Mask mask, const imaging::Mask& other);
[[nodiscard]] imaging::Mask intersected(imaging::Mask mask, const imaging::Mask& other);

// The voxels whose grey value lies in the range, of those of `within` alone where it is given (same grid: asserts).
// Values that are not finite are outside.
[[nodiscard]] imaging::Mask in_range(const imaging::Volume& image, const GreyRange& range,
                                     const imaging::Mask* within = nullptr);

}  // namespace glisson::segmentation
