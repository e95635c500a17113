// Histograms of both sides, counted in blocks, blurred, and read between the blocks' centres.

#include "segmentation/internal/likelihood_ratio.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "base/result.h"
#include "imaging/filters.h"
#include "segmentation/working_grid.h"

namespace glisson::segmentation {
namespace {

// One side's values: what share of the surroundings each bin is, a bin after the other; and of all of the side.
struct SideHistogram {
  std::vector<std::vector<float>> local;  // [bin][block]
  std::vector<float> total;               // [block]: the sum over the bins
  std::vector<float> everywhere;          // [bin], together 1
};

// Blocks of the image, in which histograms are counted: they change slowly.
struct Blocks {
  imaging::Grid grid;
  std::array<int, 3> size;
};
Blocks blocks_over(const imaging::Grid& grid, double local_mm);

std::vector<std::uint8_t> bins_of(const imaging::Image<float>& image, const TissueModel& tissue,
                                  const LikelihoodOptions& options);
constexpr std::uint8_t no_bin = 255;

SideHistogram counted(const std::vector<std::uint8_t>& bins, const std::vector<std::uint8_t>& of_side,
                      const imaging::Grid& grid, const Blocks& blocks, const LikelihoodOptions& options);

// The eight blocks around a voxel with their weights.
struct Corners {
  std::array<std::size_t, 8> block;
  std::array<float, 8> weight;
};
Corners corners_of(const std::array<int, 3>& voxel, const Blocks& blocks);
float likelihood(const SideHistogram& side, std::size_t bin, const Corners& corners, double everywhere_share);

}  // namespace

std::vector<float> log_likelihood_ratio(const imaging::Image<float>& image, const std::vector<float>& border_mm,
                                        const TissueModel& tissue, double band_mm, const LikelihoodOptions& options) {
  GLISSON_ASSERT(options.bins > 0 && options.bins < no_bin);
  const std::size_t voxels = image.values.size();
  const std::vector<std::uint8_t> bins = bins_of(image, tissue, options);
  std::vector<std::uint8_t> inner(voxels), outer(voxels);
  const auto clear_mm = static_cast<float>(options.clear_mm), far_mm = static_cast<float>(options.far_mm);
  for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
    inner[voxel] = border_mm[voxel] < -clear_mm && border_mm[voxel] > -far_mm ? 1 : 0;
    outer[voxel] = border_mm[voxel] > clear_mm && border_mm[voxel] < far_mm ? 1 : 0;
  }
  const Blocks blocks = blocks_over(image.grid, options.local_mm);
  const SideHistogram within = counted(bins, inner, image.grid, blocks, options);
  const SideHistogram beyond = counted(bins, outer, image.grid, blocks, options);

  std::vector<float> ratio(voxels);
  const auto most = static_cast<float>(options.most), band = static_cast<float>(band_mm);
  const auto unseen_outside = static_cast<float>(options.unseen_outside);
  const auto unseen_inside = static_cast<float>(options.unseen_inside);
  parallel_for(static_cast<std::size_t>(image.grid.size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (auto k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      for (int j = 0; j < image.grid.size[1]; ++j) {
        for (int i = 0; i < image.grid.size[0]; ++i) {
          const std::size_t voxel = image.grid.offset(i, j, k);
          if (bins[voxel] == no_bin || std::abs(border_mm[voxel]) > band) continue;
          const Corners corners = corners_of({i, j, k}, blocks);
          const float outside = likelihood(beyond, bins[voxel], corners, options.everywhere_share) + unseen_outside;
          const float inside = likelihood(within, bins[voxel], corners, options.everywhere_share) + unseen_inside;
          ratio[voxel] = std::clamp(std::log(outside / inside), -most, most);
        }
      }
    }
  });
  return ratio;
}

namespace {

Blocks blocks_over(const imaging::Grid& grid, double local_mm) {
  Blocks blocks;
  blocks.size = blocks_of(grid, local_mm / 2);
  const Eigen::Vector3d factor(blocks.size[0], blocks.size[1], blocks.size[2]);
  blocks.grid = grid;
  blocks.grid.spacing_mm = grid.spacing_mm.cwiseProduct(factor);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    blocks.grid.size[axis] = (grid.size[axis] + blocks.size[axis] - 1) / blocks.size[axis];
  }
  return blocks;
}

std::vector<std::uint8_t> bins_of(const imaging::Image<float>& image, const TissueModel& tissue,
                                  const LikelihoodOptions& options) {
  std::vector<std::uint8_t> bins(image.values.size(), no_bin);
  const auto range = static_cast<float>(options.range_sd * tissue.sd);
  const auto last = static_cast<float>(options.bins - 1);
  for (std::size_t voxel = 0; voxel < bins.size(); ++voxel) {
    const float off = tissue.residual(image.values[voxel], voxel);
    if (!std::isfinite(off)) continue;
    const float place = (off + range) / (2 * range) * static_cast<float>(options.bins);
    bins[voxel] = static_cast<std::uint8_t>(std::clamp(std::floor(place), 0.0F, last));
  }
  return bins;
}

// Half of each bin goes to its neighbours: a value is not known better than that.
void smooth_over_bins(std::vector<float>& bins) {
  const std::vector<float> before = bins;
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    const float low = before[bin > 0 ? bin - 1 : 0], high = before[std::min(bin + 1, bins.size() - 1)];
    bins[bin] = 0.25F * low + 0.5F * before[bin] + 0.25F * high;
  }
}

SideHistogram counted(const std::vector<std::uint8_t>& bins, const std::vector<std::uint8_t>& of_side,
                      const imaging::Grid& grid, const Blocks& blocks, const LikelihoodOptions& options) {
  const auto bin_count = static_cast<std::size_t>(options.bins);
  SideHistogram side;
  side.local.assign(bin_count, std::vector<float>(blocks.grid.voxels()));
  side.total.assign(blocks.grid.voxels(), 0.0F);
  side.everywhere.assign(bin_count, 0.0F);
  const float share = 1.0F / static_cast<float>(blocks.size[0] * blocks.size[1] * blocks.size[2]);
  std::vector<std::size_t> all(bin_count);
  std::size_t voxels = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::size_t voxel = grid.offset(i, j, k);
        if (of_side[voxel] == 0 || bins[voxel] == no_bin) continue;
        side.local[bins[voxel]][blocks.grid.offset(i / blocks.size[0], j / blocks.size[1], k / blocks.size[2])] +=
            share;
        ++all[bins[voxel]];
        ++voxels;
      }
    }
  }
  for (std::size_t bin = 0; bin < bin_count && voxels > 0; ++bin) {
    side.everywhere[bin] = static_cast<float>(static_cast<double>(all[bin]) / static_cast<double>(voxels));
  }
  smooth_over_bins(side.everywhere);
  for (std::vector<float>& counts : side.local) {
    counts = imaging::gaussian_blur(std::move(counts), blocks.grid, options.local_mm);
  }
  std::vector<float> column(bin_count);
  for (std::size_t block = 0; block < side.total.size(); ++block) {
    // A recursive Gaussian may swing below 0 by rounding.
    for (std::size_t bin = 0; bin < bin_count; ++bin) column[bin] = std::max(side.local[bin][block], 0.0F);
    smooth_over_bins(column);
    for (std::size_t bin = 0; bin < bin_count; ++bin) {
      side.local[bin][block] = column[bin];
      side.total[block] += column[bin];
    }
  }
  return side;
}

Corners corners_of(const std::array<int, 3>& voxel, const Blocks& blocks) {
  std::array<std::array<int, 2>, 3> at{};
  std::array<float, 3> along{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float place = (static_cast<float>(voxel[axis]) - 0.5F * static_cast<float>(blocks.size[axis] - 1)) /
                        static_cast<float>(blocks.size[axis]);
    const float inside = std::clamp(place, 0.0F, static_cast<float>(blocks.grid.size[axis] - 1));
    const int low = static_cast<int>(inside);
    at[axis] = {low, std::min(low + 1, blocks.grid.size[axis] - 1)};
    along[axis] = inside - static_cast<float>(low);
  }
  Corners corners{};
  for (std::size_t n = 0; n < 8; ++n) {
    const std::size_t a = n & 1U, b = n >> 1U & 1U, c = n >> 2U & 1U;
    corners.block[n] = blocks.grid.offset(at[0][a], at[1][b], at[2][c]);
    corners.weight[n] =
        (a != 0 ? along[0] : 1 - along[0]) * (b != 0 ? along[1] : 1 - along[1]) * (c != 0 ? along[2] : 1 - along[2]);
  }
  return corners;
}

float likelihood(const SideHistogram& side, std::size_t bin, const Corners& corners, double everywhere_share) {
  float seen = 0, total = 0;
  for (std::size_t n = 0; n < 8; ++n) {
    seen += corners.weight[n] * side.local[bin][corners.block[n]];
    total += corners.weight[n] * side.total[corners.block[n]];
  }
  const auto everywhere = static_cast<float>(everywhere_share);
  return (seen + everywhere * side.everywhere[bin]) / (total + everywhere);
}

}  // namespace
}  // namespace glisson::segmentation
