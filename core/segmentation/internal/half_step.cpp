#include "segmentation/internal/half_step.h"

#include <array>
#include <cmath>
#include <limits>

#include "imaging/filters.h"
#include "segmentation/grid_part.h"
#include "segmentation/signed_distance.h"
#include "segmentation/working_grid.h"

namespace glisson::segmentation {

std::vector<float> local_mean(const imaging::Image<float>& image, const std::vector<float>& counts, double sd_mm) {
  // Means over much more than a voxel are smooth: they are worked out in blocks.
  const std::array<int, 3> block = blocks_of(image.grid, sd_mm / 2);
  std::vector<float> counted(counts.size());
  for (std::size_t voxel = 0; voxel < counted.size(); ++voxel) {
    counted[voxel] = counts[voxel] > 0 ? counts[voxel] * image.values[voxel] : 0.0F;
  }
  imaging::Image<float> sum = block_means(image.grid, counted, block);
  std::vector<float> weight = block_means(image.grid, counts, block).values;
  sum.values = imaging::gaussian_blur(std::move(sum.values), sum.grid, sd_mm);
  weight = imaging::gaussian_blur(std::move(weight), sum.grid, sd_mm);
  for (std::size_t voxel = 0; voxel < weight.size(); ++voxel) {
    float& value = sum.values[voxel];
    value = weight[voxel] > 1e-4F ? value / weight[voxel] : std::numeric_limits<float>::quiet_NaN();
  }
  return interpolated(sum, image.grid, block);
}

imaging::Mask at_half_step(imaging::Mask outline, const imaging::Volume& image, double organ_sd) {
  constexpr double far_mm = 12, minimum_contrast_sd = 6;
  const double voxel_mm = image.grid.spacing_mm.maxCoeff();
  const Part part = part_around(outline, static_cast<int>(std::ceil(far_mm / image.grid.spacing_mm.minCoeff())));
  imaging::Mask mask = cut_out(outline, part);
  imaging::Image<float> seen = cut_out<float>(image, part);
  const std::vector<float> border_mm = signed_distances_mm(mask);
  std::vector<float> inner(border_mm.size()), outer(border_mm.size());
  const auto clear = static_cast<float>(1.2 * voxel_mm), distant = static_cast<float>(far_mm + voxel_mm);
  for (std::size_t voxel = 0; voxel < border_mm.size(); ++voxel) {
    if (!std::isfinite(seen.values[voxel])) continue;
    inner[voxel] = border_mm[voxel] < -clear && border_mm[voxel] > -distant ? 1.0F : 0.0F;
    outer[voxel] = border_mm[voxel] > clear && border_mm[voxel] < distant ? 1.0F : 0.0F;
  }
  const std::vector<float> own = local_mean(seen, inner, far_mm / 3), other = local_mean(seen, outer, far_mm / 3);
  const auto minimum = static_cast<float>(minimum_contrast_sd * organ_sd),
             at_border = static_cast<float>(1.01 * voxel_mm);
  for (std::size_t voxel = 0; voxel < border_mm.size(); ++voxel) {
    if (std::abs(border_mm[voxel]) > at_border || !(std::abs(own[voxel] - other[voxel]) > minimum)) continue;
    const float value = seen.values[voxel];
    if (std::isfinite(value)) mask.values[voxel] = std::abs(value - own[voxel]) < std::abs(value - other[voxel]);
  }
  put_back(mask, part, outline);
  return outline;
}

}  // namespace glisson::segmentation
