// Learning a tissue and recognising it.

#include "segmentation/internal/tissue_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/upper_median.h"
#include "imaging/filters.h"
#include "segmentation/working_grid.h"

namespace glisson::segmentation {
namespace {

constexpr double sd_of_median_deviation = 1.4826;  // of a normal distribution

// sum(values) / sum(weights) in Gaussian surroundings; NaN where hardly any weight is near.
std::vector<float> weighted_mean(std::vector<float> values, std::vector<float> weights, const imaging::Grid& grid,
                                 double sd_mm);

// The mean brightness of the known voxels over a long distance. Worked out in coarse blocks: it is smooth.
std::vector<float> drifting_mean(const imaging::Image<float>& image, const imaging::Mask& known, double length_mm,
                                 float mean);

}  // namespace

double mode_of(std::vector<float> values) {
  std::sort(values.begin(), values.end());
  std::size_t first = 0, count = values.size();
  while (count > 3) {
    const std::size_t half = (count + 1) / 2;
    std::size_t tightest = first;
    for (std::size_t n = first; n + half <= first + count; ++n) {
      if (values[n + half - 1] - values[n] < values[tightest + half - 1] - values[tightest]) tightest = n;
    }
    first = tightest;
    count = half;
  }
  return static_cast<double>(values[first + count / 2]);
}

std::vector<float> smoothed(const imaging::Image<float>& image, double sd_mm) {
  std::vector<float> values = image.values;
  std::vector<float> weights(values.size());
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel) {
    const bool finite = std::isfinite(values[voxel]);
    weights[voxel] = finite ? 1.0F : 0.0F;
    if (!finite) values[voxel] = 0.0F;
  }
  return weighted_mean(std::move(values), std::move(weights), image.grid, sd_mm);
}

float TissueModel::residual(float value, std::size_t voxel) const {
  const float difference = value - expected[voxel];
  return drift == Drift::additive ? difference : difference * static_cast<float>(mean) / expected[voxel];
}

GreyContrast contrast_of_values(const std::vector<float>& values) {
  // Of a large image some two million tell its fiftieths; an odd step meets every column of it.
  constexpr std::size_t enough = 2'000'000;
  const std::size_t step = (values.size() / enough) | 1U;
  std::vector<float> some;
  some.reserve(values.size() / step + 1);
  float minimum = std::numeric_limits<float>::infinity(), maximum = -minimum;
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel) {
    const float value = values[voxel];
    if (!std::isfinite(value)) continue;
    minimum = std::min(minimum, value);
    maximum = std::max(maximum, value);
    if (voxel % step == 0) some.push_back(value);
  }
  const bool has_any = minimum < maximum;
  if (some.empty()) return {0, 0, has_any};
  const auto ranked = [&some](std::size_t rank) {
    const auto at = some.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(some.begin(), at, some.end());
    return static_cast<double>(*at);
  };
  const std::size_t tail = some.size() / 50;
  const double low = ranked(tail);
  return {low, ranked(some.size() - 1 - tail), has_any};
}

TissueKind tissue_kind(const std::string& unit, const GreyContrast& contrast, double brightness) {
  // Values well below zero are Hounsfield units, in which a drift adds; elsewhere it scales.
  const bool scales = unit != "HU" && brightness > 0 && contrast.low > -brightness;
  // However little noise is left, liver itself varies by fat and perfusion: a spread below 8 % of the brightness, or
  // 10 HU (a contrast range of 1,250 HU), is not believed.
  const double smallest_sd = scales ? 0.08 * brightness : 0.008 * (contrast.high - contrast.low);
  return {scales ? TissueModel::Drift::proportional : TissueModel::Drift::additive, std::max(smallest_sd, 1e-6)};
}

TissueModel learn_tissue(const imaging::Image<float>& image, const imaging::Mask& known, TissueModel::Drift drift,
                         double drift_length_mm, double smallest_sd) {
  TissueModel tissue;
  tissue.drift = drift;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t voxel = 0; voxel < known.values.size(); ++voxel) {
    if (known.values[voxel] == 0 || !std::isfinite(image.values[voxel])) continue;
    sum += static_cast<double>(image.values[voxel]);
    ++count;
  }
  tissue.mean = sum / static_cast<double>(count);
  tissue.expected = drifting_mean(image, known, drift_length_mm, static_cast<float>(tissue.mean));

  std::vector<float> deviations;
  deviations.reserve(count);
  for (std::size_t voxel = 0; voxel < known.values.size(); ++voxel) {
    if (known.values[voxel] == 0 || !std::isfinite(image.values[voxel])) continue;
    deviations.push_back(std::abs(tissue.residual(image.values[voxel], voxel)));
  }
  tissue.sd = std::max(sd_of_median_deviation * upper_median(std::move(deviations)), smallest_sd);
  return tissue;
}

imaging::Mask looks_like(const TissueModel& tissue, const imaging::Image<float>& image, const GrowOptions& options) {
  const std::size_t voxels = image.values.size();
  const auto limit = static_cast<float>(options.tolerance_sd * tissue.sd);
  const auto roughness_limit = static_cast<float>(options.roughness_sd * tissue.sd);
  std::vector<float> off(voxels), absolute(voxels);
  for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
    const float residual = tissue.residual(image.values[voxel], voxel);
    off[voxel] = std::isfinite(residual) ? std::clamp(residual, -2 * limit, 2 * limit) : 2 * limit;
    absolute[voxel] = std::abs(off[voxel]);
  }
  off = imaging::gaussian_blur(std::move(off), image.grid, options.smoothing_mm);
  absolute = imaging::gaussian_blur(std::move(absolute), image.grid, options.smoothing_mm);
  imaging::Mask mask{image.grid, std::vector<std::uint8_t>(voxels)};
  for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
    mask.values[voxel] = std::abs(off[voxel]) <= limit && absolute[voxel] <= roughness_limit ? 1 : 0;
  }
  return mask;
}

namespace {

std::vector<float> weighted_mean(std::vector<float> values, std::vector<float> weights, const imaging::Grid& grid,
                                 double sd_mm) {
  values = imaging::gaussian_blur(std::move(values), grid, sd_mm);
  weights = imaging::gaussian_blur(std::move(weights), grid, sd_mm);
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel) {
    values[voxel] = weights[voxel] > 1e-6F ? values[voxel] / weights[voxel] : std::numeric_limits<float>::quiet_NaN();
  }
  return values;
}

std::vector<float> drifting_mean(const imaging::Image<float>& image, const imaging::Mask& known, double length_mm,
                                 float mean) {
  std::vector<float> values(image.values.size(), std::numeric_limits<float>::quiet_NaN());
  std::vector<float> share(known.values.begin(), known.values.end());
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel) {
    if (known.values[voxel] == 0) continue;
    values[voxel] = image.values[voxel];
    if (!std::isfinite(values[voxel])) share[voxel] = 0.0F;
  }
  const std::array<int, 3> block = blocks_of(image.grid, length_mm / 5);
  imaging::Image<float> brightness = block_means(image.grid, values, block);
  imaging::Image<float> weight = block_means(image.grid, share, block);
  for (std::size_t n = 0; n < weight.values.size(); ++n) {
    brightness.values[n] = weight.values[n] > 0 ? brightness.values[n] * weight.values[n] : 0.0F;
  }
  brightness.values = weighted_mean(std::move(brightness.values), std::move(weight.values), brightness.grid, length_mm);
  for (float& value : brightness.values) {
    if (!std::isfinite(value)) value = mean;  // far from everything known
  }
  return interpolated(brightness, image.grid, block);
}

}  // namespace
}  // namespace glisson::segmentation
