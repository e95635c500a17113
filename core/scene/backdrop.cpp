#include "scene/backdrop.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glisson::scene {

Backdrop ct_backdrop(std::shared_ptr<const imaging::Volume> volume) { return {std::move(volume), 130, 600}; }

Backdrop backdrop_by_brightness(std::shared_ptr<const imaging::Volume> volume) {
  // A hundred thousand of them tell the shares well enough.
  const std::vector<float>& all = volume->values;
  const std::size_t step = std::max<std::size_t>(1, all.size() / 100000);
  std::vector<float> some;
  for (std::size_t v = 0; v < all.size(); v += step) {
    if (std::isfinite(all[v])) some.push_back(all[v]);
  }
  if (some.empty()) return {std::move(volume), 0, 1};
  const float darkest = *std::min_element(some.begin(), some.end());
  std::erase_if(some, [&](float value) { return value <= darkest; });
  if (some.empty()) return {std::move(volume), darkest, darkest + 1.0};
  std::sort(some.begin(), some.end());
  const auto at = [&](double share) {
    return static_cast<double>(some[static_cast<std::size_t>(share * double(some.size() - 1))]);
  };
  const double low = at(0.8);
  return {std::move(volume), low, std::max(at(0.995), low + 1e-6 * std::max(1.0, std::abs(low)))};
}

CoarseBackdrop coarsened(const Backdrop& backdrop, int largest_side) {
  const imaging::Grid& fine = backdrop.volume->grid;
  CoarseBackdrop coarse{fine, {}};
  std::array<int, 3> block{};
  Eigen::Vector3d first(0, 0, 0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto along = static_cast<Eigen::Index>(axis);
    block[axis] = (fine.size[axis] + largest_side - 1) / largest_side;
    coarse.grid.size[axis] = std::max(1, fine.size[axis] / block[axis]);
    coarse.grid.spacing_mm[along] = fine.spacing_mm[along] * block[axis];
    first[along] = 0.5 * (block[axis] - 1);
  }
  coarse.grid.origin_mm = fine.position_mm(first);
  coarse.values.resize(coarse.grid.voxels());
  const auto row = static_cast<std::size_t>(fine.size[0]), layer = row * static_cast<std::size_t>(fine.size[1]);
  const double scale = 255 / (backdrop.high - backdrop.low);
  const double share = 1.0 / (double(block[0]) * block[1] * block[2]);
  std::size_t out = 0;
  for (int z = 0; z < coarse.grid.size[2]; ++z) {
    for (int y = 0; y < coarse.grid.size[1]; ++y) {
      for (int x = 0; x < coarse.grid.size[0]; ++x) {
        double sum = 0;
        for (int k = 0; k < block[2]; ++k) {
          for (int j = 0; j < block[1]; ++j) {
            const std::size_t begin = static_cast<std::size_t>(z * block[2] + k) * layer +
                                      static_cast<std::size_t>(y * block[1] + j) * row +
                                      static_cast<std::size_t>(x) * static_cast<std::size_t>(block[0]);
            for (std::size_t i = begin; i < begin + static_cast<std::size_t>(block[0]); ++i) {
              sum += backdrop.volume->values[i];
            }
          }
        }
        const double value = scale * (sum * share - backdrop.low);
        coarse.values[out++] = value > 0 ? static_cast<std::uint8_t>(std::min(value, 255.0)) : 0;  // NaN: clear
      }
    }
  }
  return coarse;
}

}  // namespace glisson::scene
