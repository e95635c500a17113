// The relaxed cut against every region that a row can be cut into, and against noise.

#include "segmentation/internal/relaxed_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/parallel.h"

namespace glisson::segmentation {
namespace {

imaging::Grid grid_of(std::array<int, 3> size, const Eigen::Vector3d& spacing_mm) {
  imaging::Grid grid;
  grid.size = size;
  grid.spacing_mm = spacing_mm;
  return grid;
}

// Of one row: each change of side costs 1, a voxel inside its cost times its length. Per mm2 across the row.
double energy_of_row(unsigned region, const std::vector<float>& cost_per_mm, double spacing_mm) {
  double energy = 0;
  for (std::size_t voxel = 0; voxel < cost_per_mm.size(); ++voxel) {
    const unsigned here = region >> voxel & 1U;
    if (voxel > 0 && here != (region >> (voxel - 1) & 1U)) energy += 1;
    if (here != 0) energy += static_cast<double>(cost_per_mm[voxel]) * spacing_mm;
  }
  return energy;
}

TEST(RelaxedCut, CostsNoMoreThanAnyRegionOfARow) {
  constexpr int length = 14;
  constexpr double spacing_mm = 2;
  const imaging::Grid row = grid_of({length, 1, 1}, {spacing_mm, 3, 3});
  std::mt19937 random(5);
  std::normal_distribution<float> draw(0, 0.4F);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<float> cost(length);
    for (float& value : cost) value = draw(random);
    std::vector<VoxelSide> sides(length, VoxelSide::either);
    sides.front() = VoxelSide::inside;
    sides.back() = VoxelSide::outside;
    RelaxedCutOptions patient;
    patient.maximum_iterations = patient.check_every = 4000;
    const std::vector<float> u = relaxed_cut(row, cost, sides, patient);
    unsigned found = 0;
    for (std::size_t voxel = 0; voxel < length; ++voxel) found |= (u[voxel] >= 0.5F ? 1U : 0U) << voxel;
    double minimum = INFINITY;
    for (unsigned region = 1; region < 1U << (length - 1); region += 2) {  // the first voxel inside, the last outside
      minimum = std::min(minimum, energy_of_row(region, cost, spacing_mm));
    }
    EXPECT_NEAR(energy_of_row(found, cost, spacing_mm), minimum, 1e-3) << "trial " << trial;
  }
}

// A ball of which a fifth of the voxels, within and without, say the contrary. Voxels are longer along one axis.
std::vector<float> noisy_ball(const imaging::Grid& grid, double radius) {
  std::mt19937 random(3);
  std::vector<float> cost(grid.voxels());
  const Eigen::Vector3d center_mm(30, 30, 30);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const bool inside = (grid.position_mm(i, j, k) - center_mm).norm() < radius;
        const bool lies = random() % 5 == 0;
        cost[grid.offset(i, j, k)] = inside != lies ? -0.5F : 0.5F;
      }
    }
  }
  return cost;
}

TEST(RelaxedCut, ABallIsFoundThoughAFifthOfItsVoxelsLie) {
  const imaging::Grid grid = grid_of({41, 41, 31}, {1.5, 1.5, 2});
  const std::vector<float> u =
      relaxed_cut(grid, noisy_ball(grid, 20), std::vector<VoxelSide>(grid.voxels(), VoxelSide::either));
  std::size_t wrong = 0, inside = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const bool is = (grid.position_mm(i, j, k) - Eigen::Vector3d(30, 30, 30)).norm() < 20;
        inside += is ? 1U : 0U;
        wrong += is != (u[grid.offset(i, j, k)] >= 0.5F) ? 1U : 0U;
      }
    }
  }
  // A shell of half a voxel has 12 % of this ball's volume: the noise costs a third of one.
  EXPECT_LT(static_cast<double>(wrong), 0.05 * static_cast<double>(inside));
}

TEST(RelaxedCut, IsTheSameWhateverTheNumberOfThreads) {
  const imaging::Grid grid = grid_of({41, 41, 31}, {1.5, 1.5, 2});
  const std::vector<float> cost = noisy_ball(grid, 20);
  const std::vector<VoxelSide> sides(grid.voxels(), VoxelSide::either);
  set_thread_count(1);
  const std::vector<float> alone = relaxed_cut(grid, cost, sides);
  set_thread_count(0);
  EXPECT_EQ(alone, relaxed_cut(grid, cost, sides));
}

TEST(RelaxedCut, WhatIsFixedStays) {
  const imaging::Grid grid = grid_of({6, 5, 4}, {1, 1, 1});
  std::vector<VoxelSide> sides(grid.voxels(), VoxelSide::outside);
  sides[grid.offset(2, 2, 2)] = VoxelSide::inside;
  const std::vector<float> u = relaxed_cut(grid, std::vector<float>(grid.voxels(), 0.0F), sides);
  for (std::size_t voxel = 0; voxel < u.size(); ++voxel) {
    EXPECT_EQ(u[voxel], voxel == grid.offset(2, 2, 2) ? 1.0F : 0.0F);
  }
}

}  // namespace
}  // namespace glisson::segmentation
