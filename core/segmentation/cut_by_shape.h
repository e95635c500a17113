#pragma once
// An organ cut out of an image by what it looks like and by where a shape says that its border lies.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"
#include "segmentation/expected_border.h"
#include "segmentation/grow.h"

namespace glisson::segmentation {

struct ShapeCutOptions {
  double likelihood_per_mm = 0.2;  // how much a voxel's likelihood counts against the border's area
  double prior_per_mm = 0.15;      // the same of the shape's log-odds
  double reach_mm = 30;            // from a border what looks like the organ and what not is learnt
  double seed_radius_mm = 12;      // around a seed the shape is overruled
};

// The brightness of the organ around its seeds or, without one, of what the shape holds for sure; and the scatter about
// it of what the shape holds. Fails with "grow-seed-on-nothing" where there is no finite value.
struct OrganBrightness {
  double mean = 0, sd = 0;
};
Result<OrganBrightness> brightness_of(const imaging::Volume& image, const ExpectedBorder& expected,
                                      const std::vector<Eigen::Vector3d>& seeds_mm);

// The log-likelihood that each voxel lies outside over inside, by its brightness alone. With no outline it is judged by
// `organ`; with one, by what that holds and what lies around it, near by (internal/likelihood_ratio.h).
[[nodiscard]] imaging::Image<float> outside_ratio(const imaging::Volume& image, const OrganBrightness& organ,
                                                  const imaging::Mask* outline = nullptr,
                                                  const ShapeCutOptions& options = {});

// The relaxed cut (internal/relaxed_cut.h) of that and of the shape together. Seeds (patient LPS, mm) lie inside
// whatever the shape says. The voxels should be of about 3 mm. Deterministic.
[[nodiscard]] imaging::Mask cut_by_shape(const imaging::Image<float>& outside, const ExpectedBorder& expected,
                                         const std::vector<Eigen::Vector3d>& seeds_mm,
                                         const ShapeCutOptions& options = {});

// A coarse cut brought to the image's own grid. Its border is refined as a growth's is, with the shape counted in.
// What is doubtful is said as of a growth: borders that cannot be seen, and those that the shape does not expect.
[[nodiscard]] GrowResult finished_by_shape(const imaging::Mask& coarse, const imaging::Volume& image,
                                           const ExpectedBorder& expected, const OrganBrightness& organ,
                                           const std::vector<Eigen::Vector3d>& seeds_mm,
                                           const ShapeCutOptions& options = {});

}  // namespace glisson::segmentation
