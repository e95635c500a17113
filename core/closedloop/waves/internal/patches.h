#pragma once
// Where the patches of a frequency lie: a lattice over the region, of bumps that lie within it.

#include <array>
#include <optional>
#include <vector>

#include "closedloop/experiment/experiment.h"
#include "closedloop/waves/internal/test_functions.h"

namespace glisson::closedloop {

struct Patch {
  std::array<int, 3> middle{0, 0, 0};  // voxel
  Eigen::Vector3d place_mm;            // patient LPS
};

// Half widths in voxels for a radius in mm: at least six, or what the grid holds where that is four or five; 0 along an
// axis of one voxel. Nothing where the grid is too small for four.
[[nodiscard]] std::optional<std::array<int, 3>> patch_radius(const imaging::Grid& grid, double radius_mm);

// Of neighbours the test functions' correlation is at most some hundredths. At most so many; more are thinned out.
inline constexpr std::size_t maximum_patches = 600;
[[nodiscard]] std::vector<Patch> patches_of(const Elastography& waves, const TestFunctions& functions);

}  // namespace glisson::closedloop
