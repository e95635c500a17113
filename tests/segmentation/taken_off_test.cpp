// What a click says is not the organ, on shapes whose answer is known.

#include "segmentation/taken_off.h"

#include <gmock/gmock.h>
#include <random>

#include "segmentation/structures.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

// A ball of 30 mm about the origin, and one of 15 mm that it touches at x = 45: a stomach.
struct TwoBalls {
  imaging::Volume image;
  Mask organ, both;
};
const Vector3d stomach_mm(43, 0, 0);

TwoBalls two_balls(float stomach) {
  TwoBalls made;
  made.image.grid.size = {60, 40, 40};
  made.image.grid.spacing_mm = {2, 2, 2};
  made.image.grid.origin_mm = {-45, -40, -40};
  made.image.unit = "HU";
  made.organ.grid = made.both.grid = made.image.grid;
  const std::size_t voxels = made.image.grid.voxels();
  made.image.values.resize(voxels);
  made.organ.values.resize(voxels);
  made.both.values.resize(voxels);
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0, 10);
  std::size_t voxel = 0;
  for (int k = 0; k < 40; ++k) {
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < 60; ++i, ++voxel) {
        const Vector3d at = made.image.grid.position_mm(i, j, k);
        made.organ.values[voxel] = at.norm() <= 30;
        made.both.values[voxel] = at.norm() <= 30 || (at - stomach_mm).norm() <= 15;
        const bool in_stomach = made.both.values[voxel] != made.organ.values[voxel];
        made.image.values[voxel] = (in_stomach                      ? stomach
                                    : made.organ.values[voxel] != 0 ? 100.0F
                                                                    : -100.0F) +
                                   noise(random);
      }
    }
  }
  return made;
}

double overlap(const Mask& a, const Mask& b) { return dice(a, b).value(); }

}  // namespace

TEST(TakenOff, GoesAsFarAsTheBallThatFitsWhereBrightnessSaysNothing) {
  const TwoBalls balls = two_balls(100);
  ASSERT_LT(overlap(balls.both, balls.organ), 0.95);
  const Mask left = taken_off(balls.both, balls.image, {{}, {stomach_mm}});
  EXPECT_GT(overlap(left, balls.organ), 0.98);
  // All else is as it was.
  for (std::size_t voxel = 0; voxel < left.values.size(); ++voxel) {
    EXPECT_LE(left.values[voxel], balls.both.values[voxel]);
  }
}

TEST(TakenOff, EndsAtTheBorderThatTheImageShows) {
  const TwoBalls balls = two_balls(40);
  // Away from the middle, where the ball is too small and lies askew.
  const Mask left = taken_off(balls.both, balls.image, {{}, {stomach_mm + Vector3d(5, 0, 0)}});
  const Mask blind = taken_off(balls.both, two_balls(100).image, {{}, {stomach_mm + Vector3d(5, 0, 0)}});
  EXPECT_GT(overlap(left, balls.organ), 0.99);
  EXPECT_GT(overlap(left, balls.organ), overlap(blind, balls.organ));
}

TEST(TakenOff, LeavesAnOutlineThatDoesNotHoldThePoint) {
  const TwoBalls balls = two_balls(40);
  EXPECT_EQ(taken_off(balls.organ, balls.image, {{}, {Vector3d(0, 38, 0)}}).values, balls.organ.values);
  EXPECT_EQ(taken_off(balls.organ, balls.image, {{Vector3d(0, 0, 0)}, {}}).values, balls.organ.values);
}

// A point in a narrow stalk cuts off what hangs on it, unless that was said to belong.
TEST(TakenOff, WhatIsCutOffGoesUnlessAPointHoldsIt) {
  TwoBalls balls = two_balls(100);
  Mask stalked = balls.organ;
  const imaging::Grid& grid = stalked.grid;
  std::size_t far = 0;
  for (int k = 0; k < 40; ++k) {
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < 60; ++i) {
        const Vector3d at = grid.position_mm(i, j, k);
        const bool stalk = std::hypot(at.y(), at.z()) < 4 && at.x() > 0 && at.x() < 55;
        const bool end = (at - Vector3d(58, 0, 0)).norm() < 9;
        if (stalk || end) stalked.at(i, j, k) = 1;
        if (end) ++far;
      }
    }
  }
  const Vector3d click_mm(38, 0, 0), end_mm(58, 0, 0);
  const std::size_t alone = voxel_count(taken_off(stalked, balls.image, {{}, {click_mm}}));
  const std::size_t kept = voxel_count(taken_off(stalked, balls.image, {{end_mm}, {click_mm}}));
  EXPECT_GE(kept, alone + far);
  EXPECT_LT(alone, voxel_count(balls.organ) + 100);
}

}  // namespace glisson::segmentation
