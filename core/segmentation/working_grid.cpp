// Block means, and trilinear interpolation back.

#include "segmentation/working_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"

namespace glisson::segmentation {

std::array<int, 3> blocks_of(const imaging::Grid& grid, double spacing_mm) {
  std::array<int, 3> block{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double wanted = std::round(spacing_mm / grid.spacing_mm[static_cast<Eigen::Index>(axis)]);
    block[axis] = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(std::max(grid.size[axis], 1))));
  }
  return block;
}

imaging::Image<float> block_means(const imaging::Grid& grid, const std::vector<float>& values,
                                  const std::array<int, 3>& block) {
  imaging::Image<float> coarse;
  coarse.grid = grid;
  const Eigen::Vector3d factor(block[0], block[1], block[2]);
  coarse.grid.spacing_mm = grid.spacing_mm.cwiseProduct(factor);
  coarse.grid.origin_mm = grid.position_mm(0.5 * (factor - Eigen::Vector3d::Ones()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    coarse.grid.size[axis] = (grid.size[axis] + block[axis] - 1) / block[axis];
  }
  coarse.values.resize(coarse.grid.voxels());
  parallel_for(static_cast<std::size_t>(coarse.grid.size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (auto k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      for (int j = 0; j < coarse.grid.size[1]; ++j) {
        for (int i = 0; i < coarse.grid.size[0]; ++i) {
          double sum = 0;
          int count = 0;
          for (int c = k * block[2]; c < std::min((k + 1) * block[2], grid.size[2]); ++c) {
            for (int b = j * block[1]; b < std::min((j + 1) * block[1], grid.size[1]); ++b) {
              for (int a = i * block[0]; a < std::min((i + 1) * block[0], grid.size[0]); ++a) {
                const float value = values[grid.offset(a, b, c)];
                if (!std::isfinite(value)) continue;
                sum += static_cast<double>(value);
                ++count;
              }
            }
          }
          coarse.at(i, j, k) = count > 0 ? static_cast<float>(sum / count) : std::numeric_limits<float>::quiet_NaN();
        }
      }
    }
  });
  return coarse;
}

imaging::Mask block_majority(const imaging::Mask& mask, const std::array<int, 3>& block) {
  if (block == std::array<int, 3>{1, 1, 1}) return mask;
  const imaging::Image<float> share =
      block_means(mask.grid, std::vector<float>(mask.values.begin(), mask.values.end()), block);
  imaging::Mask coarse{share.grid, std::vector<std::uint8_t>(share.values.size())};
  for (std::size_t n = 0; n < share.values.size(); ++n) coarse.values[n] = share.values[n] >= 0.5F ? 1 : 0;
  return coarse;
}

namespace {

// Between which two coarse voxels a fine one lies, and how far along.
struct Between {
  int low, high;
  float along;
};

std::vector<Between> places_along(std::size_t axis, const imaging::Grid& coarse, const imaging::Grid& fine, int block) {
  std::vector<Between> places(static_cast<std::size_t>(fine.size[axis]));
  for (std::size_t n = 0; n < places.size(); ++n) {
    const double index = std::clamp((static_cast<double>(n) - 0.5 * (block - 1)) / block, 0.0, coarse.size[axis] - 1.0);
    const int low = static_cast<int>(index);
    places[n] = {low, std::min(low + 1, coarse.size[axis] - 1), static_cast<float>(index - low)};
  }
  return places;
}

}  // namespace

std::vector<float> interpolated(const imaging::Image<float>& coarse, const imaging::Grid& fine,
                                const std::array<int, 3>& block) {
  if (block == std::array<int, 3>{1, 1, 1}) return coarse.values;
  const std::vector<Between> at_i = places_along(0, coarse.grid, fine, block[0]);
  const std::vector<Between> at_j = places_along(1, coarse.grid, fine, block[1]);
  const std::vector<Between> at_k = places_along(2, coarse.grid, fine, block[2]);
  std::vector<float> values(fine.voxels());
  parallel_for(at_k.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      for (std::size_t j = 0; j < at_j.size(); ++j) {
        const auto row = [&](int b, int c) { return &coarse.values[coarse.grid.offset(0, b, c)]; };
        const float* const rows[4] = {row(at_j[j].low, at_k[k].low), row(at_j[j].high, at_k[k].low),
                                      row(at_j[j].low, at_k[k].high), row(at_j[j].high, at_k[k].high)};
        float* const to = &values[fine.offset(0, static_cast<int>(j), static_cast<int>(k))];
        for (std::size_t i = 0; i < at_i.size(); ++i) {
          const auto along_i = [&](const float* from) {
            return from[at_i[i].low] + at_i[i].along * (from[at_i[i].high] - from[at_i[i].low]);
          };
          const float low = along_i(rows[0]) + at_j[j].along * (along_i(rows[1]) - along_i(rows[0]));
          const float high = along_i(rows[2]) + at_j[j].along * (along_i(rows[3]) - along_i(rows[2]));
          to[i] = low + at_k[k].along * (high - low);
        }
      }
    }
  });
  return values;
}

}  // namespace glisson::segmentation
