#pragma once
// Which of several vessels has its wall nearest to a place.

#include <limits>
#include <vector>

#include "vasculature/vessel_graph.h"

namespace glisson::vasculature {

struct NearestLine {
  int number = -1;  // none of them was asked
  double from_wall_mm = std::numeric_limits<double>::infinity();
};

// line_of(n) is the n-th vessel's line, or null where it does not count. Of equally near ones the first.
template <typename LineOf>
NearestLine nearest_line(std::size_t count, const Eigen::Vector3d& place_mm, const LineOf& line_of) {
  NearestLine nearest;
  for (std::size_t n = 0; n < count; ++n) {
    const std::vector<CenterPoint>* line = line_of(n);
    const double away_mm = line != nullptr ? from_wall_mm(*line, place_mm) : nearest.from_wall_mm;
    if (away_mm < nearest.from_wall_mm) nearest = {static_cast<int>(n), away_mm};
  }
  return nearest;
}

}  // namespace glisson::vasculature
