#include "segmentation/signed_distance.h"

#include <cmath>

#include "imaging/filters.h"

namespace glisson::segmentation {

std::vector<float> signed_distances_mm(const imaging::Mask& mask) {
  std::vector<float> distance_mm = imaging::squared_distances_mm2(mask);
  const std::vector<float> squared_depth_mm2 = imaging::squared_depths_mm2(mask);
  for (std::size_t voxel = 0; voxel < distance_mm.size(); ++voxel) {
    distance_mm[voxel] = mask.values[voxel] != 0 ? -std::sqrt(squared_depth_mm2[voxel]) : std::sqrt(distance_mm[voxel]);
  }
  return distance_mm;
}

}  // namespace glisson::segmentation
