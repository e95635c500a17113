#pragma once
// Fronts that set out from many places at once and go through a mask at 1 mm a mm: who comes first, and when.

#include <cstdint>
#include <vector>

#include "imaging/image.h"

namespace glisson::vasculature {

struct Source {
  std::size_t voxel = 0;
  float arrival_mm = 0;  // may be negative
  std::int32_t label = 0;
  Eigen::Vector3d center_mm{0, 0, 0};  // of the ball whose wall sends the front
  double radius_mm = 0;
};

struct Arrivals {
  std::vector<float> mm;            // infinite where no front comes
  std::vector<std::int32_t> label;  // -1 there
};

// Fast marching, first order (Sethian 1996, PNAS 93:1591), with a queue of buckets (Yatziv, Bartesaghi and Sapiro 2006,
// J Comput Phys 212:393). A voxel takes the label of that neighbour whose source is nearest, the neighbour's detour
// added. Labels that came from the earliest neighbour would drift along the grid's axes. Of sources in one voxel the
// earliest counts, of equal ones the lowest label. Same input, same answer.
[[nodiscard]] Arrivals march(const imaging::Mask& inside, const std::vector<Source>& sources);

}  // namespace glisson::vasculature
