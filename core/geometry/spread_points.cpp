#include "geometry/spread_points.h"

#include <algorithm>
#include <limits>

namespace glisson::geometry {

std::vector<std::size_t> spread_points(const std::vector<Eigen::Vector3d>& points_mm, std::size_t count,
                                       std::size_t first) {
  std::vector<std::size_t> chosen;
  std::vector<double> squared_mm2(points_mm.size(), std::numeric_limits<double>::infinity());
  for (std::size_t next = first; chosen.size() < std::min(count, points_mm.size());) {
    chosen.push_back(next);
    for (std::size_t p = 0; p < points_mm.size(); ++p) {
      squared_mm2[p] = std::min(squared_mm2[p], (points_mm[p] - points_mm[next]).squaredNorm());
    }
    next = static_cast<std::size_t>(std::max_element(squared_mm2.begin(), squared_mm2.end()) - squared_mm2.begin());
  }
  return chosen;
}

}  // namespace glisson::geometry
