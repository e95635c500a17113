#pragma once
// How long and how wide a branch is, of its points alone.

#include <vector>

#include "base/upper_median.h"

namespace glisson::vasculature {

// Gives a branch its length_mm along its points, and the median of their radii as radius_mm. One without points keeps
// its radius.
template <typename Branch>
void measure_by_points(Branch& branch) {
  branch.length_mm = 0;
  if (branch.points.empty()) return;
  std::vector<double> radii_mm;
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    radii_mm.push_back(branch.points[i].radius_mm);
    if (i > 0) branch.length_mm += (branch.points[i].position_mm - branch.points[i - 1].position_mm).norm();
  }
  branch.radius_mm = upper_median(std::move(radii_mm));
}

}  // namespace glisson::vasculature
