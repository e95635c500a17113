// A mask carried to another grid, judged voxel by voxel by the obvious way.

#include "segmentation/resample.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <random>

namespace glisson::segmentation {
namespace {

imaging::Mask random_mask(const imaging::Grid& grid) {
  std::mt19937 random(7);
  imaging::Mask mask{grid, std::vector<std::uint8_t>(grid.voxels())};
  for (auto& value : mask.values) value = random() % 3 == 0 ? 1 : 0;
  return mask;
}

TEST(Resample, TakesTheVoxelThatEachCentreLiesIn) {
  const imaging::Grid from{{9, 7, 5}, {2, 3, 4}, {-8, -9, -7}, Eigen::Matrix3d::Identity()};
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const imaging::Grid to{{14, 12, 10}, {1.7, 1.9, 2.3}, {-10, -8, -9}, turned};
  const imaging::Mask mask = random_mask(from);
  const imaging::Mask carried = resample(mask, to);
  std::size_t inside = 0;
  for (int k = 0; k < to.size[2]; ++k) {
    for (int j = 0; j < to.size[1]; ++j) {
      for (int i = 0; i < to.size[0]; ++i) {
        const Eigen::Vector3d index = from.index_of(to.position_mm(i, j, k));
        const int x = static_cast<int>(std::floor(index.x() + 0.5));
        const int y = static_cast<int>(std::floor(index.y() + 0.5));
        const int z = static_cast<int>(std::floor(index.z() + 0.5));
        const bool covered = from.contains(x, y, z);
        inside += covered ? 1 : 0;
        ASSERT_EQ(carried.at(i, j, k), covered ? mask.at(x, y, z) : 0) << i << ' ' << j << ' ' << k;
      }
    }
  }
  EXPECT_GT(inside, 300u);  // the grids do overlap: the test is about something
}

// Also where both grids' axes run alike, which is gone along axis by axis.
TEST(Resample, ReadsAnImageBetweenItsVoxelsAndBeyondItsBorderTheNearest) {
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  std::mt19937 random(3);
  imaging::Image<float> image{{{9, 7, 5}, {2, 3, 4}, {-8, -9, -7}, turned}, std::vector<float>(9 * 7 * 5)};
  for (float& value : image.values) value = std::normal_distribution<float>(50, 20)(random);
  for (const Eigen::Matrix3d& direction : {turned, Eigen::Matrix3d(Eigen::Matrix3d::Identity())}) {
    const imaging::Grid to{{14, 12, 1}, {1.7, 1.9, 2.3}, {-10, -8, -5}, direction};
    const imaging::Image<float> read = resample(image, to);
    for (int j = 0; j < to.size[1]; ++j) {
      for (int i = 0; i < to.size[0]; ++i) {
        EXPECT_NEAR(read.at(i, j, 0), value_between(image, image.grid.index_of(to.position_mm(i, j, 0))), 1e-4);
      }
    }
  }
}

TEST(Resample, OnTheSameGridNothingChanges) {
  const imaging::Grid grid{{5, 6, 7}, {1, 2, 3}, {10, 20, 30}, Eigen::Matrix3d::Identity()};
  const imaging::Mask mask = random_mask(grid);
  EXPECT_EQ(resample(mask, grid).values, mask.values);
}

}  // namespace
}  // namespace glisson::segmentation
