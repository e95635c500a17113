#include "vasculature/internal/liver_frame.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace glisson::vasculature {

using Eigen::Vector3d;

double LiverFrame::scale() const { return std::cbrt(volume_ml / 1500); }

Result<LiverFrame> liver_frame(const imaging::Mask& liver) {
  const imaging::Grid& grid = liver.grid;
  std::array<std::vector<std::size_t>, 3> along;  // voxels in each layer across an axis of the grid
  for (std::size_t a = 0; a < 3; ++a) along[a].assign(static_cast<std::size_t>(grid.size[a]), 0);
  Vector3d low = Vector3d::Constant(1e30), high = -low, sum = Vector3d::Zero();
  std::size_t voxels = 0;
  const auto for_all = [&](const auto& visit) {
    for (int k = 0; k < grid.size[2]; ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          if (liver.at(i, j, k) != 0) visit(i, j, k);
        }
      }
    }
  };
  for_all([&](int i, int j, int k) {
    const Vector3d p = grid.position_mm(i, j, k);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    sum += p;
    ++voxels;
    ++along[0][static_cast<std::size_t>(i)], ++along[1][static_cast<std::size_t>(j)];
    ++along[2][static_cast<std::size_t>(k)];
  });
  if (voxels == 0) {
    return failure("liver-empty", GLISSON_TEXT("The liver mask holds no voxels: mark the liver first."));
  }
  for (const auto& layers : along) {
    const std::size_t widest = *std::max_element(layers.begin(), layers.end());
    if (4 * std::max(layers.front(), layers.back()) > widest) {
      return failure("liver-cut-off",
                     GLISSON_TEXT("The image ends within the liver, so that its segments cannot be told: take a scan "
                                  "that holds all of it."));
    }
  }

  // Histograms along the patient's axes, for the box without its outermost hundredths.
  constexpr double bin_mm = 0.5;
  std::array<std::vector<std::size_t>, 3> counts;
  for (int a = 0; a < 3; ++a) {
    counts[static_cast<std::size_t>(a)].assign(static_cast<std::size_t>((high[a] - low[a]) / bin_mm) + 1, 0);
  }
  for_all([&](int i, int j, int k) {
    const Vector3d p = grid.position_mm(i, j, k) - low;
    for (int a = 0; a < 3; ++a) ++counts[static_cast<std::size_t>(a)][static_cast<std::size_t>(p[a] / bin_mm)];
  });
  LiverFrame frame;
  frame.volume_ml = static_cast<double>(voxels) * grid.voxel_volume_mm3() / 1000;
  frame.centroid_mm = sum / static_cast<double>(voxels);
  for (int a = 0; a < 3; ++a) {
    const auto& bins = counts[static_cast<std::size_t>(a)];
    std::size_t below = 0, first = bins.size(), last = 0;
    for (std::size_t b = 0; b < bins.size(); ++b) {
      below += bins[b];
      if (first == bins.size() && below * 100 >= voxels) first = b;
      if (below * 100 <= 99 * voxels) last = b;
    }
    frame.low_mm[a] = low[a] + static_cast<double>(first) * bin_mm;
    frame.high_mm[a] = low[a] + static_cast<double>(last + 1) * bin_mm;
  }
  return frame;
}

}  // namespace glisson::vasculature
