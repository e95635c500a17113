// The image is blurred, its second differences are the Hessian, and the eigenvalues say tube, plate or blob.

#include "segmentation/internal/tubularity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>
#include <numbers>

#include "base/parallel.h"
#include "base/result.h"
#include "base/upper_median.h"
#include "imaging/filters.h"
#include "segmentation/internal/tissue_model.h"
#include "segmentation/working_grid.h"

namespace glisson::segmentation {
namespace {

using imaging::Grid;

// Of one scale, in the order of the voxels asked for.
struct AtScale {
  std::vector<float> tube;    // c / e
  std::vector<float> middle;  // of each 16th: size of the middle eigenvalue, by sd^2
};
AtScale at_scale(const std::vector<float>& blurred, const Grid& grid, const std::vector<std::size_t>& voxels,
                 double sd_mm, int sign);

std::vector<std::size_t> inner_voxels(const imaging::Mask& within);
// Of each voxel asked for, from the middle eigenvalues around it.
std::vector<float> noise_around(const AtScale& at, const Grid& grid, const std::vector<std::size_t>& voxels);

constexpr std::size_t every = 16;  // voxel tells the noise

}  // namespace

Tubularity tubularity(const imaging::Image<float>& image, const imaging::Mask& within,
                      const std::vector<double>& radii_mm, int sign, const Progress& progress) {
  const Grid& grid = image.grid;
  GLISSON_ASSERT(imaging::same_grid(grid, within.grid));
  GLISSON_ASSERT(grid.spacing_mm.maxCoeff() < 1.001 * grid.spacing_mm.minCoeff());
  const std::vector<std::size_t> voxels = inner_voxels(within);
  Tubularity found{std::vector<float>(grid.voxels(), 0), std::vector<float>(grid.voxels(), 0),
                   std::vector<float>(grid.voxels(), 0)};
  for (std::size_t scale = 0; scale < radii_mm.size() && !voxels.empty(); ++scale) {
    if (progress.cancelled()) return {};
    progress.report(static_cast<double>(scale) / static_cast<double>(radii_mm.size()), GLISSON_TEXT("Finding vessels"));
    const double sd_mm = radii_mm[scale] / std::numbers::sqrt2;
    const AtScale at = at_scale(imaging::gaussian_blur(image.values, grid, sd_mm), grid, voxels, sd_mm, sign);
    const std::vector<float> noise = noise_around(at, grid, voxels);
    for (std::size_t n = 0; n < voxels.size(); ++n) {
      const std::size_t voxel = voxels[n];
      const float contrast = std::numbers::e_v<float> * at.tube[n];
      if (contrast > found.contrast[voxel]) {
        found.contrast[voxel] = contrast;
        found.radius_mm[voxel] = static_cast<float>(radii_mm[scale]);
      }
      found.to_noise[voxel] = std::max(found.to_noise[voxel], at.tube[n] / noise[n]);
    }
  }
  return found;
}

namespace {

// Those with a neighbour on every side.
std::vector<std::size_t> inner_voxels(const imaging::Mask& within) {
  std::vector<std::size_t> voxels;
  const std::array<int, 3>& size = within.grid.size;
  for (int k = 1; k + 1 < size[2]; ++k) {
    for (int j = 1; j + 1 < size[1]; ++j) {
      for (int i = 1; i + 1 < size[0]; ++i) {
        if (within.at(i, j, k) != 0) voxels.push_back(within.grid.offset(i, j, k));
      }
    }
  }
  return voxels;
}

// The median of all, larger or smaller as their mean over blocks is. What is far from it, a vessel, counts as twice it.
std::vector<float> noise_around(const AtScale& at, const Grid& grid, const std::vector<std::size_t>& voxels) {
  constexpr double block_mm = 10, around_mm = 20;
  const auto median = std::max(static_cast<float>(upper_median(at.middle)), 1e-30F);
  std::vector<float> sampled(grid.voxels(), std::numeric_limits<float>::quiet_NaN());
  double sum = 0;
  for (std::size_t n = 0; n < at.middle.size(); ++n) {
    const float clipped = std::min(at.middle[n], 2 * median);
    sampled[voxels[n * every]] = clipped;
    sum += static_cast<double>(clipped);
  }
  const double mean = sum / static_cast<double>(at.middle.size());
  const std::array<int, 3> block = blocks_of(grid, block_mm);
  imaging::Image<float> coarse = block_means(grid, sampled, block);
  coarse.values = smoothed(coarse, around_mm);
  const std::vector<float> around = interpolated(coarse, grid, block);
  std::vector<float> noise(voxels.size(), median);
  for (std::size_t n = 0; n < voxels.size(); ++n) {
    const float here = around[voxels[n]];
    if (std::isfinite(here) && mean > 0) noise[n] = std::max(median * here / static_cast<float>(mean), 1e-30F);
  }
  return noise;
}

// By differences of voxels, times the spacing's power.
struct Curvature {
  Eigen::Vector3f gradient;
  Eigen::Matrix3f hessian;
};
Curvature curvature_at(const float* at, std::ptrdiff_t row, std::ptrdiff_t slice) {
  const std::array<std::ptrdiff_t, 3> step{1, row, slice};
  Curvature curved;
  for (int a = 0; a < 3; ++a) {
    const std::ptrdiff_t by = step[static_cast<std::size_t>(a)];
    curved.gradient[a] = 0.5F * (at[by] - at[-by]);
    curved.hessian(a, a) = at[by] + at[-by] - 2 * *at;
    for (int b = 0; b < a; ++b) {
      const std::ptrdiff_t other = step[static_cast<std::size_t>(b)];
      curved.hessian(a, b) = 0.25F * (at[by + other] - at[by - other] - at[other - by] + at[-by - other]);
    }
  }
  return curved;
}

// Ascending.
Eigen::Vector3f eigenvalues(const Eigen::Matrix3f& lower) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>().computeDirect(lower, Eigen::EigenvaluesOnly).eigenvalues();
}

// Along a tube nothing curves: lambda[2] is as large as the others in a blob, and positive at a saddle. On its axis the
// brightness has no slope: where it has, a blob's border is as curved.
float tube_at(const Curvature& curved, const Eigen::Vector3f& lambda, float sd_voxels) {
  if (lambda[1] >= 0) return 0;
  const float along = lambda[2] / lambda[1];
  const float is_long = along > 0 ? 1 - along : 1 / (1 + along * along);
  const float across = std::sqrt(lambda[0] * lambda[1]);
  const float off_axis = curved.gradient.norm() / (across * sd_voxels);
  return sd_voxels * sd_voxels * across * is_long * std::exp(-0.5F * off_axis * off_axis);
}

AtScale at_scale(const std::vector<float>& blurred, const Grid& grid, const std::vector<std::size_t>& voxels,
                 double sd_mm, int sign) {
  const auto row = static_cast<std::ptrdiff_t>(grid.size[0]);
  const std::ptrdiff_t slice = row * grid.size[1];
  const auto sd_voxels = static_cast<float>(sd_mm / grid.spacing_mm.x());
  AtScale answer{std::vector<float>(voxels.size(), 0), std::vector<float>((voxels.size() + every - 1) / every)};
  parallel_for(voxels.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const Curvature curved = curvature_at(blurred.data() + voxels[n], row, slice);
      const bool may_be_tube = static_cast<float>(sign) * curved.hessian.trace() < 0;
      if (!may_be_tube && n % every != 0) continue;
      const Eigen::Vector3f lambda = eigenvalues(static_cast<float>(sign) * curved.hessian);
      if (n % every == 0) answer.middle[n / every] = sd_voxels * sd_voxels * std::abs(lambda[1]);
      if (may_be_tube) answer.tube[n] = tube_at(curved, lambda, sd_voxels);
    }
  });
  return answer;
}

}  // namespace
}  // namespace glisson::segmentation
