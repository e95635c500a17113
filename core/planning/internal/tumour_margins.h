#pragma once
// What lies how far from each tumour, in order, so that a margin is found by walking outwards until a voxel stays.

#include <cstdint>
#include <string>
#include <vector>

#include "imaging/image.h"
#include "planning/internal/organ.h"

namespace glisson::planning {

struct TumourSurroundings {
  std::string name;
  std::vector<std::uint32_t> voxels;  // its own, of the organ
  struct Near {
    std::uint32_t voxel;
    float distance_mm;  // of its centre from the tumour's border, which lies half a voxel beyond its last voxels
  };
  std::vector<Near> around;  // the nearest first, up to largest_margin_mm
};

// `numbers`: numbers_in(organ).
[[nodiscard]] TumourSurroundings surroundings_of(const std::string& name, const imaging::Mask& tumour,
                                                 const Organ& organ, const std::vector<std::int32_t>& numbers);

}  // namespace glisson::planning
