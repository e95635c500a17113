#include "closedloop/waves/internal/patches.h"

#include <algorithm>
#include <cmath>

namespace glisson::closedloop {
namespace {

constexpr int smallest_radius = 4;        // voxels: below that sums over voxels are no integrals of third derivatives
constexpr int exact_radius = 6;           // from which they are, to a thousandth
constexpr double stride_radii = 1.4;      // nearer, neighbours share more than two hundredths of their noise
constexpr double all_but_nothing = 2e-4;  // of the bump: what lies outside of the region there does not matter

// Middles along an axis, the lattice in the middle of the grid.
std::vector<int> lattice(int size, int radius) {
  if (radius == 0) return {0};
  const int stride = static_cast<int>(std::ceil(stride_radii * radius));
  const int room = size - 1 - 2 * (radius - 1);
  std::vector<int> middles;
  for (int at = radius - 1 + (room % stride) / 2; at <= size - radius; at += stride) middles.push_back(at);
  return middles;
}

bool lies_within(const Elastography& waves, const TestFunctions& functions, const std::array<int, 3>& middle) {
  for (int k = -functions.reach(2); k <= functions.reach(2); ++k) {
    for (int j = -functions.reach(1); j <= functions.reach(1); ++j) {
      for (int i = -functions.reach(0); i <= functions.reach(0); ++i) {
        if (waves.region[waves.grid.offset(middle[0] + i, middle[1] + j, middle[2] + k)] == 0 &&
            functions.value({0, 0, 0}, {i, j, k}) > all_but_nothing)
          return false;
      }
    }
  }
  return true;
}

}  // namespace

std::optional<std::array<int, 3>> patch_radius(const imaging::Grid& grid, double radius_mm) {
  std::array<int, 3> radius{0, 0, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (grid.size.at(axis) == 1) continue;
    const int largest = (grid.size.at(axis) + 1) / 2;
    if (largest < smallest_radius) return std::nullopt;
    const double voxels = radius_mm / grid.spacing_mm[static_cast<Eigen::Index>(axis)];
    radius.at(axis) =
        static_cast<int>(std::lround(std::clamp<double>(voxels, std::min(exact_radius, largest), largest)));
  }
  return radius;
}

std::vector<Patch> patches_of(const Elastography& waves, const TestFunctions& functions) {
  std::vector<Patch> all;
  for (const int k : lattice(waves.grid.size[2], functions.radius()[2])) {
    for (const int j : lattice(waves.grid.size[1], functions.radius()[1])) {
      for (const int i : lattice(waves.grid.size[0], functions.radius()[0])) {
        if (lies_within(waves, functions, {i, j, k})) all.push_back({{i, j, k}, waves.grid.position_mm(i, j, k)});
      }
    }
  }
  if (all.size() <= maximum_patches) return all;
  std::vector<Patch> kept;
  for (std::size_t p = 0; p < maximum_patches; ++p) kept.push_back(all[p * all.size() / maximum_patches]);
  return kept;
}

}  // namespace glisson::closedloop
