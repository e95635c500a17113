// Each filter against the slow, obvious way.

#include "imaging/filters.h"

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

template <typename Visit>
void for_each_voxel(const Grid& grid, Visit&& visit) {
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) visit(i, j, k);
    }
  }
}

TEST(SquaredDistances, AgreeWithTryingEveryPairOfVoxels) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Mask mask = scattered_mask(seed, 0.002 * std::pow(3.0, seed));
    const std::vector<float> found_mm2 = squared_distances_mm2(mask);
    for_each_voxel(mask.grid, [&](int i, int j, int k) {
      double smallest_mm2 = INFINITY;
      for_each_voxel(mask.grid, [&](int a, int b, int c) {
        if (mask.at(a, b, c) == 0) return;
        const double mm2 = (mask.grid.position_mm(i, j, k) - mask.grid.position_mm(a, b, c)).squaredNorm();
        smallest_mm2 = std::min(smallest_mm2, mm2);
      });
      const float found = found_mm2[mask.grid.offset(i, j, k)];
      if (std::isinf(smallest_mm2)) {
        EXPECT_TRUE(std::isinf(found));
      } else {
        EXPECT_NEAR(found, smallest_mm2, 1e-5 * smallest_mm2);  // single precision, in three passes
      }
    });
  }
}

TEST(GaussianBlur, IsTheConvolutionWithinAHundredthOfItsHeight) {
  Grid grid;
  grid.size = {40, 31, 25};
  grid.spacing_mm = {1.0, 1.5, 2.0};
  const Eigen::Vector3d middle_mm = grid.position_mm(20, 15, 12);
  std::vector<float> point(grid.voxels(), 0.0F);
  point[grid.offset(20, 15, 12)] = 1.0F;
  for (const double sd_mm : {2.0, 3.5}) {
    const std::vector<float> blurred = gaussian_blur(point, grid, sd_mm);
    double sum = 0;
    for_each_voxel(grid, [&](int i, int j, int k) {
      sum += std::exp(-0.5 * (grid.position_mm(i, j, k) - middle_mm).squaredNorm() / (sd_mm * sd_mm));
    });
    for_each_voxel(grid, [&](int i, int j, int k) {
      const double exact =
          std::exp(-0.5 * (grid.position_mm(i, j, k) - middle_mm).squaredNorm() / (sd_mm * sd_mm)) / sum;
      EXPECT_NEAR(blurred[grid.offset(i, j, k)], exact, 0.01 * std::max(exact, 1.0 / sum)) << sd_mm;
    });
  }
}

TEST(GaussianBlur, LeavesAConstantAsItIsAndThinImagesToo) {
  Grid grid;
  grid.size = {12, 3, 7};
  const std::vector<float> sevens(grid.voxels(), 7.0F);
  for (const float value : gaussian_blur(sevens, grid, 2.0)) EXPECT_NEAR(value, 7.0F, 1e-4F);
}

// Voxel by voxel: takes over the smallest number among its neighbours until nothing changes.
std::vector<std::uint32_t> smallest_number_within_reach(const Mask& mask, Neighbours neighbours) {
  std::vector<std::uint32_t> number(mask.values.size(), 0);
  for (std::size_t voxel = 0; voxel < number.size(); ++voxel) {
    if (mask.values[voxel] != 0) number[voxel] = static_cast<std::uint32_t>(voxel + 1);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for_each_voxel(mask.grid, [&](int i, int j, int k) {
      std::uint32_t& here = number[mask.grid.offset(i, j, k)];
      for (int step = 0; step < 27 && here != 0; ++step) {
        const int di = step % 3 - 1, dj = step / 3 % 3 - 1, dk = step / 9 - 1;
        if (neighbours == Neighbours::faces && std::abs(di) + std::abs(dj) + std::abs(dk) != 1) continue;
        if (!mask.grid.contains(i + di, j + dj, k + dk)) continue;
        const std::uint32_t there = number[mask.grid.offset(i + di, j + dj, k + dk)];
        if (there == 0 || there >= here) continue;
        here = there;
        changed = true;
      }
    });
  }
  return number;
}

TEST(ConnectedVoxels, AreThoseWithinReachOfEachOther) {
  for (const Neighbours neighbours : {Neighbours::faces, Neighbours::all}) {
    for (unsigned seed = 0; seed < 4; ++seed) {
      const Mask mask = scattered_mask(seed, neighbours == Neighbours::faces ? 0.3 : 0.08);
      const ConnectedVoxels connected = connected_voxels(mask, neighbours);
      const std::vector<std::uint32_t> number = smallest_number_within_reach(mask, neighbours);
      std::vector<std::size_t> sizes(connected.sizes.size(), 0);
      std::vector<std::uint32_t> number_of(connected.sizes.size(), 0);
      for (std::size_t voxel = 0; voxel < number.size(); ++voxel) {
        const std::uint32_t piece = connected.piece[voxel];
        ASSERT_EQ(piece == 0, mask.values[voxel] == 0);
        ++sizes[piece];
        if (number_of[piece] == 0) number_of[piece] = number[voxel];
        ASSERT_EQ(number_of[piece], number[voxel]);
      }
      EXPECT_EQ(sizes, connected.sizes);
      const auto largest = std::max_element(sizes.begin() + 1, sizes.end());
      EXPECT_EQ(connected.sizes[connected.largest()], *largest);
    }
  }
  EXPECT_EQ(connected_voxels(scattered_mask(0, 0.0), Neighbours::all).largest(), 0U);
}

TEST(FillHoles, FillsWhatDoesNotReachTheGridsBorder) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Mask mask = scattered_mask(seed, 0.4 + 0.1 * seed);
    Mask outside = mask;
    for (std::uint8_t& value : outside.values) value = value == 0 ? 1 : 0;
    const std::vector<std::uint32_t> number = smallest_number_within_reach(outside, Neighbours::faces);
    std::vector<std::uint8_t> reaches(number.size() + 1, 0);
    for_each_voxel(mask.grid, [&](int i, int j, int k) {
      const auto& [nx, ny, nz] = mask.grid.size;
      if (i == 0 || j == 0 || k == 0 || i + 1 == nx || j + 1 == ny || k + 1 == nz) {
        reaches[number[mask.grid.offset(i, j, k)]] = 1;
      }
    });
    reaches[0] = 0;
    const Mask filled = fill_holes(mask);
    std::size_t gained = 0;
    for (std::size_t voxel = 0; voxel < number.size(); ++voxel) {
      ASSERT_EQ(filled.values[voxel], reaches[number[voxel]] != 0 ? 0 : 1) << seed;
      gained += filled.values[voxel] != mask.values[voxel] ? 1U : 0U;
    }
    EXPECT_GT(gained, 0U);
  }
}

}  // namespace
}  // namespace glisson::imaging
