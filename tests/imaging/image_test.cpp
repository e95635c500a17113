// Where a grid stands, and when two grids are the same.

#include "imaging/image.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

namespace glisson::imaging {
namespace {

Grid oblique_grid() {
  Grid grid;
  grid.size = {40, 30, 20};
  grid.spacing_mm = {1.5, 1.5, 3};
  grid.origin_mm = {-12, 40, 7};
  grid.direction = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return grid;
}

TEST(Grid, TakesAnIndexToThePatientAndBack) {
  const Grid grid = oblique_grid();
  const Eigen::Vector3d index(3.25, 17.5, 11);
  EXPECT_LT((grid.index_of(grid.position_mm(index)) - index).norm(), 1e-12);
}

TEST(Grid, AVoxelOfATiltedGantryIsSmallerByTheCosineOfTheTilt) {
  Grid grid = oblique_grid();
  EXPECT_NEAR(grid.voxel_volume_mm3(), 1.5 * 1.5 * 3, 1e-12);
  const double tilt = 0.3;
  grid.direction.col(2) = std::cos(tilt) * grid.direction.col(2) + std::sin(tilt) * grid.direction.col(1);
  EXPECT_NEAR(grid.voxel_volume_mm3(), 1.5 * 1.5 * 3 * std::cos(tilt), 1e-12);
}

TEST(Grid, IsTheSameOnlyIfEveryVoxelStandsInTheSamePlace) {
  const Grid grid = oblique_grid();
  EXPECT_TRUE(same_grid(grid, grid));

  // A spacing off by 1e-4 mm moves the far corner by 39 of those, well over the tolerance of 1e-3 mm.
  Grid stretched = grid;
  stretched.spacing_mm[0] += 1e-4;
  EXPECT_FALSE(same_grid(grid, stretched));

  Grid cropped = grid;
  cropped.size[2] -= 1;
  EXPECT_FALSE(same_grid(grid, cropped));

  Grid nowhere = grid;
  nowhere.origin_mm[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(same_grid(grid, nowhere));
}

}  // namespace
}  // namespace glisson::imaging
