#include "segmentation/outline_border.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "imaging/filters.h"
#include "segmentation/edit.h"
#include "segmentation/grid_part.h"
#include "segmentation/tissue_model.h"

namespace glisson::segmentation {
namespace {

using imaging::Mask;

// Signed, negative inside, in mm.
std::vector<float> distances_mm(const Mask& mask) {
  std::vector<float> distance = imaging::squared_distances_mm2(mask);
  const std::vector<float> depth = imaging::squared_depths_mm2(mask);
  for (std::size_t voxel = 0; voxel < distance.size(); ++voxel) {
    distance[voxel] = mask.values[voxel] != 0 ? -std::sqrt(depth[voxel]) : std::sqrt(distance[voxel]);
  }
  return distance;
}

// The mean of the values that count, in Gaussian surroundings; NaN where none is near.
std::vector<float> local_mean(const imaging::Image<float>& image, const std::vector<float>& counts, double sd_mm) {
  std::vector<float> sum(counts.size());
  for (std::size_t voxel = 0; voxel < sum.size(); ++voxel) {
    sum[voxel] = counts[voxel] > 0 ? counts[voxel] * image.values[voxel] : 0.0F;
  }
  sum = imaging::gaussian_blur(std::move(sum), image.grid, sd_mm);
  const std::vector<float> weight = imaging::gaussian_blur(counts, image.grid, sd_mm);
  for (std::size_t voxel = 0; voxel < sum.size(); ++voxel) {
    sum[voxel] = weight[voxel] > 1e-4F ? sum[voxel] / weight[voxel] : std::numeric_limits<float>::quiet_NaN();
  }
  return sum;
}

}  // namespace

RefinedBorder with_border_refined(Mask outline, const imaging::Volume& image, double tissue_mean, double tissue_sd,
                                  const BorderOptions& options) {
  const int rim =
      static_cast<int>(std::ceil((options.band_mm + 3 * options.local_mm) / image.grid.spacing_mm.minCoeff()));
  const Part part = part_around(outline, rim);
  Mask mask = cut_out(outline, part);
  imaging::Image<float> sharp = cut_out<float>(image, part);
  const std::vector<float> distance = distances_mm(mask);
  const std::size_t voxels = distance.size();
  std::vector<float> inner(voxels), outer(voxels);
  const auto clear_mm = static_cast<float>(options.clear_mm), far_mm = static_cast<float>(4 * options.local_mm);
  for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
    if (!std::isfinite(sharp.values[voxel])) continue;
    if (distance[voxel] < -clear_mm && distance[voxel] > -far_mm) inner[voxel] = 1;
    if (distance[voxel] > clear_mm && distance[voxel] < far_mm) outer[voxel] = 1;
  }
  const auto furthest = static_cast<float>(options.clamp_sd * tissue_sd), middle = static_cast<float>(tissue_mean);
  for (float& value : sharp.values) {
    if (std::isfinite(value)) value = std::clamp(value, middle - furthest, middle + furthest);
  }
  const std::vector<float> own = local_mean(sharp, inner, options.local_mm);
  const std::vector<float> other = local_mean(sharp, outer, options.local_mm);
  const std::vector<float> value = smoothed(sharp, options.noise_mm);
  const auto band_mm = static_cast<float>(options.band_mm);
  const auto at_border_mm = static_cast<float>(1.01 * image.grid.spacing_mm.maxCoeff());
  std::size_t border = 0, unsure = 0;
  const double minimum_contrast = options.minimum_contrast_sd * tissue_sd;
  for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
    if (std::abs(distance[voxel]) > band_mm || !std::isfinite(value[voxel])) continue;
    const double contrast = static_cast<double>(own[voxel]) - static_cast<double>(other[voxel]);
    const bool differs = std::abs(contrast) >= minimum_contrast;  // not where there is none: NaN
    if (std::abs(distance[voxel]) <= at_border_mm) {
      ++border;
      unsure += differs ? 0U : 1U;
    }
    if (!differs) continue;
    const double share = (static_cast<double>(value[voxel]) - static_cast<double>(other[voxel])) / contrast;
    mask.values[voxel] = share >= 0.5 ? 1 : 0;
  }
  mask = smooth(std::move(mask), options.noise_mm);
  put_back(imaging::fill_holes(mask), part, outline);
  return {std::move(outline), static_cast<double>(unsure) / static_cast<double>(std::max<std::size_t>(border, 1))};
}

}  // namespace glisson::segmentation
