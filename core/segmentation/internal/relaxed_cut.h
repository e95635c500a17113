#pragma once
// The region of minimum cost of its voxels and its border together.

#include <cstdint>
#include <vector>

#include "imaging/image.h"

namespace glisson::segmentation {

// Where a voxel is allowed to be.
enum class VoxelSide : std::uint8_t { outside, inside, either };

struct RelaxedCutOptions {
  int maximum_iterations = 200;  // a band of ten voxels settles in 40 to 60
  int check_every = 20;
  double settled_share = 1e-4;  // of the voxels that may be either: fewer have changed side since the last check
};

// Minimises the integral of |grad u| + cost u over 0 <= u <= 1, where u is 0 outside and 1 inside. `cost_per_mm`, one a
// voxel, is what a voxel inside costs more than one outside, against 1 for each mm2 of border. Where u is at least 0.5
// is one of the regions of minimum cost, whatever the start (Nikolova, Esedoglu and Chan, SIAM J Appl Math 66:1632,
// 2006). By the primal-dual steps of Chambolle and Pock (J Math Imaging Vis 40:120, 2011). The image's border is free.
// Gives u, one a voxel. Deterministic, whatever the number of threads.
[[nodiscard]] std::vector<float> relaxed_cut(const imaging::Grid& grid, const std::vector<float>& cost_per_mm,
                                             const std::vector<VoxelSide>& sides,
                                             const RelaxedCutOptions& options = {});

}  // namespace glisson::segmentation
