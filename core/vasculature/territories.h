#pragma once
// Which tissue belongs to which branch.
//
// A voxel of the liver belongs to the branch whose wall is nearest, along ways that stay in the liver. These are
// nearest-neighbour territories (Selle, Preim, Schenk and Peitgen 2002, IEEE Trans Med Imaging 21:1344). Distances are
// counted from the wall, not from the centre line. So a branch is ahead of another by the difference of their radii (an
// additively weighted Voronoi diagram: Aurenhammer 1991, ACM Comput Surv 23:345).

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"
#include "vasculature/systems.h"

namespace glisson::vasculature {

struct Territories {
  imaging::Grid grid;                // of the liver mask
  std::vector<std::int32_t> branch;  // of VesselTrees::branches; -1 outside, and where no way leads
  std::vector<float> distance_mm;    // from its wall; negative in it
  std::vector<double> volume_ml;     // of each branch
};

// Fails with territories-no-branch (the system has none in the liver) and liver-empty.
Result<Territories> territories_of(const VesselTrees& trees, System system, const imaging::Mask& liver);

// What a branch and all that grows from it supplies or drains.
[[nodiscard]] std::vector<double> volumes_beyond_ml(const VesselTrees& trees, const Territories& territories);

}  // namespace glisson::vasculature
