// The border is put between an organ and neighbours of which one is brighter and one darker.

#include "segmentation/internal/outline_border.h"

#include <gtest/gtest.h>

#include <random>

#include "segmentation/structures.h"

namespace glisson::segmentation {
namespace {

constexpr double ball_radius_mm = 25;

// A ball of 100 among slabs of 60 and of 140, 6 mm each, so that its surroundings' mean is its own; a spread of 10.
imaging::Volume ball_among_slabs() {
  imaging::Volume image;
  image.grid.size = {60, 60, 40};
  image.grid.spacing_mm = {1.5, 1.5, 2};
  image.values.resize(image.grid.voxels());
  std::mt19937 random(11);
  std::normal_distribution<float> noise(0, 10);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) {
        const bool inside = (image.grid.position_mm(i, j, k) - Eigen::Vector3d(45, 45, 40)).norm() < ball_radius_mm;
        image.at(i, j, k) = (inside ? 100.0F : i / 4 % 2 == 0 ? 60.0F : 140.0F) + noise(random);
      }
  return image;
}

imaging::Mask ball_in(const imaging::Grid& grid, const Eigen::Vector3d& center_mm, double radius) {
  imaging::Mask mask{grid, std::vector<std::uint8_t>(grid.voxels())};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        mask.at(i, j, k) = (grid.position_mm(i, j, k) - center_mm).norm() < radius ? 1 : 0;
  return mask;
}

TEST(OutlineBorder, LiesBetweenAnOrganAndNeighboursThatAverageToIt) {
  const imaging::Volume image = ball_among_slabs();
  const imaging::Mask truth = ball_in(image.grid, {45, 45, 40}, ball_radius_mm);
  const OrganLook look{TissueModel::Drift::additive, 30, 1};
  for (const imaging::Mask& drawn :
       {ball_in(image.grid, {45, 45, 40}, ball_radius_mm - 3), ball_in(image.grid, {45, 45, 40}, ball_radius_mm + 3),
        ball_in(image.grid, {48, 45, 40}, ball_radius_mm)}) {
    const double before = dice(drawn, truth).value();
    const double after = dice(with_border_refined(drawn, image, look), truth).value();
    EXPECT_LT(before, 0.93);
    EXPECT_GT(after, 0.975) << "from " << before;  // a third of a voxel all around is 0.98
  }
}

TEST(OutlineBorder, AnEmptyOutlineStaysEmpty) {
  const imaging::Volume image = ball_among_slabs();
  const imaging::Mask none{image.grid, std::vector<std::uint8_t>(image.grid.voxels())};
  EXPECT_EQ(with_border_refined(none, image, {}).values, none.values);
}

}  // namespace
}  // namespace glisson::segmentation
