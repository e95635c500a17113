// The surface around a mask is closed, faces outwards, and is where the mask is, on any grid.

#include "meshing/mask_surface.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <numbers>

namespace glisson::meshing {
namespace {

constexpr double radius_mm = 20;
const Eigen::Vector3d center_mm(5, -10, 30);

imaging::Grid centred_grid(const std::array<int, 3>& size, const Eigen::Vector3d& spacing_mm,
                           const Eigen::Matrix3d& direction) {
  imaging::Grid grid{size, spacing_mm, {0, 0, 0}, direction};
  grid.origin_mm = center_mm - grid.position_mm(Eigen::Vector3d(size[0] - 1, size[1] - 1, size[2] - 1) / 2);
  return grid;
}

imaging::Mask ball(const imaging::Grid& grid) {
  imaging::Mask mask{grid, std::vector<std::uint8_t>(grid.voxels())};
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        mask.at(i, j, k) = (grid.position_mm(i, j, k) - center_mm).norm() <= radius_mm ? 1 : 0;
      }
    }
  }
  return mask;
}

void expect_ball(const geometry::Surface& surface, double tolerance_mm) {
  EXPECT_TRUE(geometry::is_watertight(surface));
  const double true_volume = 4.0 / 3.0 * std::numbers::pi * std::pow(radius_mm, 3);
  EXPECT_NEAR(geometry::volume_mm3(surface), true_volume, 0.05 * true_volume);  // positive: it faces outwards
  for (const Eigen::Vector3d& point : surface.points_mm) {
    ASSERT_NEAR((point - center_mm).norm(), radius_mm, tolerance_mm);
  }
}

TEST(MaskSurface, OfABallIsABall) {
  // Smoothed, it stays within a voxel of the true sphere.
  expect_ball(mask_surface(ball(centred_grid({50, 50, 50}, {1, 1, 1}, Eigen::Matrix3d::Identity()))).value(), 1.0);
}

TEST(MaskSurface, KeepsItsPlaceOnATurnedAnisotropicLeftHandedGrid) {
  Eigen::Matrix3d direction = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 1, 2).normalized()).toRotationMatrix();
  direction.col(2) *= -1;
  expect_ball(mask_surface(ball(centred_grid({40, 40, 24}, {1.2, 1.2, 2.0}, direction))).value(), 2.0);
}

TEST(MaskSurface, KeepsAVesselOfTwoVoxels) {
  const imaging::Grid grid{{10, 10, 60}, {1, 1, 1}, {0, 0, 0}, Eigen::Matrix3d::Identity()};
  imaging::Mask mask{grid, std::vector<std::uint8_t>(grid.voxels())};
  for (int k = 5; k < 55; ++k) {
    for (int offset = 0; offset < 4; ++offset) mask.at(4 + offset % 2, 4 + offset / 2, k) = 1;
  }
  // A square bar of 200 mm3 is rounded; most of it must be left (strong smoothing thins it to a thread).
  EXPECT_GT(geometry::volume_mm3(mask_surface(mask).value()), 0.5 * 200);
}

TEST(MaskSurface, ClosesWhatTheImageCuts) {
  const imaging::Grid grid{{10, 10, 10}, {1, 1, 1}, {0, 0, 0}, Eigen::Matrix3d::Identity()};
  const imaging::Mask full{grid, std::vector<std::uint8_t>(grid.voxels(), 1)};
  EXPECT_TRUE(geometry::is_watertight(mask_surface(full).value()));
}

TEST(MaskSurface, OfNothingIsRefused) {
  const imaging::Grid grid{{4, 4, 4}, {1, 1, 1}, {0, 0, 0}, Eigen::Matrix3d::Identity()};
  EXPECT_EQ(mask_surface({grid, std::vector<std::uint8_t>(grid.voxels(), 0)}).error().code, "mask-empty");
}

}  // namespace
}  // namespace glisson::meshing
