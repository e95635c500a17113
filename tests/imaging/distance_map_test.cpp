#include "imaging/distance_map.h"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

namespace glisson::imaging {
namespace {

Mask scattered_mask(unsigned seed, double share) {
  Mask mask;
  mask.grid.size = {13, 9, 11};
  mask.grid.spacing_mm = {0.8, 1.7, 3.1};
  mask.values.resize(mask.grid.voxels());
  std::mt19937 random(seed);
  std::bernoulli_distribution inside(share);
  for (auto& value : mask.values) value = inside(random) ? 1 : 0;
  return mask;
}

Eigen::Vector3d position_mm(const Grid& grid, std::size_t voxel) {
  const auto nx = static_cast<std::size_t>(grid.size[0]), ny = static_cast<std::size_t>(grid.size[1]);
  return grid.position_mm(static_cast<int>(voxel % nx), static_cast<int>(voxel / nx % ny),
                          static_cast<int>(voxel / (nx * ny)));
}

TEST(DistanceMap, AgreesWithTryingEveryPairOfVoxels) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Mask mask = scattered_mask(seed, 0.002 * std::pow(3.0, seed));
    const NearestVoxels found = nearest_voxels(mask);
    EXPECT_EQ(found.squared_distance_mm2, squared_distances_mm2(mask));
    for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
      double smallest_mm2 = INFINITY;
      for (std::size_t other = 0; other < mask.values.size(); ++other) {
        if (!mask.values[other]) continue;
        smallest_mm2 =
            std::min(smallest_mm2, (position_mm(mask.grid, voxel) - position_mm(mask.grid, other)).squaredNorm());
      }
      if (std::isinf(smallest_mm2)) {
        ASSERT_EQ(found.offset[voxel], no_voxel);
        continue;
      }
      // Single precision after each of three passes.
      ASSERT_NEAR(found.squared_distance_mm2[voxel], smallest_mm2, 1e-6 * smallest_mm2);
      ASSERT_EQ(mask.values[found.offset[voxel]], 1);
      ASSERT_NEAR((position_mm(mask.grid, voxel) - position_mm(mask.grid, found.offset[voxel])).squaredNorm(),
                  smallest_mm2, 1e-6 * smallest_mm2);
    }
  }
}

TEST(DistanceMap, IsInfiniteWhereTheMaskIsEmpty) {
  const NearestVoxels found = nearest_voxels(scattered_mask(0, 0.0));
  EXPECT_TRUE(std::isinf(found.squared_distance_mm2[5]));
  EXPECT_EQ(found.offset[5], no_voxel);
}

}  // namespace
}  // namespace glisson::imaging
