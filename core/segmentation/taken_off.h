#pragma once
// What a person clicks on to say that it is not the organ, taken off an outline.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::segmentation {

// What a person said by clicking (patient LPS, mm).
struct GivenPoints {
  std::vector<Eigen::Vector3d> inside_mm, outside_mm;  // in the organ; in what was taken for it
};

// Fails with grow-bad-image (an axis shorter than three voxels) and grow-seed-outside (which, how far).
[[nodiscard]] Result<void> check_points(const imaging::Volume& image, const GivenPoints& points);

// The outline without what lies around each point that it holds. A point in the middle of something is as far from the
// outline's border as from the organ. So a ball of 1.3 times that radius, 3 to 30 mm, goes: where brightness tells the
// point's tissue from the organ's, by the relaxed cut (internal/relaxed_cut.h), less of it or more, up to twice as far.
// Pieces that it cuts off go too, unless they hold a point inside. All else stays, voxel for voxel. The image lies on
// the outline's grid (asserts). Deterministic.
[[nodiscard]] imaging::Mask taken_off(imaging::Mask outline, const imaging::Volume& image, const GivenPoints& points);

}  // namespace glisson::segmentation
