#include "segmentation/edit.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <random>

#include "segmentation/structures.h"
#include "slanted_grid.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

Mask empty_slanted_mask() { return {slanted_grid(), std::vector<std::uint8_t>(slanted_grid().voxels(), 0)}; }

Vector3d middle_mm() { return slanted_grid().position_mm(Vector3d(14.5, 12.5, 8.5)); }

// A voxel belongs exactly when the slow, obvious question says so.
template <typename Belongs>
void expect_voxels(const Mask& mask, const Belongs& belongs) {
  for (int k = 0; k < mask.grid.size[2]; ++k)
    for (int j = 0; j < mask.grid.size[1]; ++j)
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        ASSERT_EQ(mask.at(i, j, k) != 0, belongs(i, j, k)) << i << " " << j << " " << k;
      }
}

TEST(Edit, PaintsAndErasesABallInMillimetres) {
  const Ball outer{middle_mm(), 9.3}, inner{middle_mm() + Vector3d(2, 1, 0), 5.1};
  const Mask mask = erase(paint(empty_slanted_mask(), outer), inner);
  expect_voxels(mask, [&](int i, int j, int k) {
    const Vector3d at_mm = mask.grid.position_mm(i, j, k);
    return (at_mm - outer.center_mm).norm() <= outer.radius_mm && (at_mm - inner.center_mm).norm() > inner.radius_mm;
  });
}

TEST(Edit, BrushesOutsideTheImageOrWithoutSizeDoNothing) {
  for (const Ball& ball : {Ball{{1e6, 0, 0}, 5}, Ball{middle_mm(), 0}, Ball{middle_mm(), -1},
                           Ball{Vector3d::Constant(std::nan("")), 5}, Ball{middle_mm(), std::nan("")}}) {
    EXPECT_EQ(voxel_count(paint(empty_slanted_mask(), ball)), 0U);
  }
}

TEST(Edit, CutsByAPlane) {
  const Ball ball{middle_mm(), 9.3};
  const Plane plane{middle_mm(), {1, 2, 3}};
  const Mask mask = cut(paint(empty_slanted_mask(), ball), plane);
  expect_voxels(mask, [&](int i, int j, int k) {
    const Vector3d at_mm = mask.grid.position_mm(i, j, k);
    return (at_mm - ball.center_mm).norm() <= ball.radius_mm && (at_mm - plane.point_mm).dot(plane.normal) <= 0;
  });
}

// A triangle drawn on a view, pushed through: inside and outside share the mask out between them.
TEST(Edit, CutsByAnOutline) {
  const Vector3d w = Vector3d(0.2, -0.4, 1).normalized(), u = w.unitOrthogonal(), v = w.cross(u);
  const Outline triangle{{middle_mm() - 6 * u - 5 * v, middle_mm() + 7 * u - 5 * v, middle_mm() + 8 * v}, 3 * w};
  const Mask whole = paint(empty_slanted_mask(), {middle_mm(), 9.3});
  const Mask without_inside = cut(whole, triangle, CutSide::inside);
  const Mask without_outside = cut(whole, triangle, CutSide::outside);
  const auto side = [&](const Vector3d& a, const Vector3d& b, const Vector3d& p) {
    return (b - a).cross(p - a).dot(w);
  };
  expect_voxels(without_outside, [&](int i, int j, int k) {
    const Vector3d p = whole.grid.position_mm(i, j, k);
    const auto& t = triangle.points_mm;
    return whole.at(i, j, k) != 0 && side(t[0], t[1], p) > 0 && side(t[1], t[2], p) > 0 && side(t[2], t[0], p) > 0;
  });
  EXPECT_EQ(united(without_inside, without_outside).values, whole.values);
  EXPECT_EQ(voxel_count(without_inside) + voxel_count(without_outside), voxel_count(whole));
  EXPECT_GT(voxel_count(without_outside), 100U);
}

TEST(Edit, FillsHolesButNotBays) {
  Mask mask = erase(paint(empty_slanted_mask(), {middle_mm(), 10}), {middle_mm(), 4});
  const Mask solid = paint(empty_slanted_mask(), {middle_mm(), 10});
  EXPECT_EQ(fill_holes(mask).values, solid.values);
  for (int i = 0; i < 15; ++i) mask.at(i, 12, 8) = 0;  // a channel from the cavity to the border
  EXPECT_EQ(fill_holes(mask).values, mask.values);
}

TEST(Edit, KeepsTheLargestPiece) {
  const Mask large = paint(empty_slanted_mask(), {middle_mm(), 6});
  const Mask both = paint(large, {middle_mm() + slanted_grid().direction * Vector3d(11, 0, 0), 3});
  ASSERT_GT(voxel_count(both), voxel_count(large));
  EXPECT_EQ(keep_largest(both).values, large.values);
  EXPECT_EQ(voxel_count(keep_largest(empty_slanted_mask())), 0U);
}

TEST(Edit, MarginsAgreeWithTryingEveryPairOfVoxels) {
  std::mt19937 random(3);
  Mask mask = empty_slanted_mask();
  for (int n = 0; n < 12; ++n) mask.values[random() % mask.values.size()] = 1;
  const double margin_mm = 4.4;
  const Mask grown = with_margin(mask, margin_mm);
  const auto reach = [&](const Mask& of, std::uint8_t wanted, int i, int j, int k) {
    for (int c = 0; c < of.grid.size[2]; ++c)
      for (int b = 0; b < of.grid.size[1]; ++b)
        for (int a = 0; a < of.grid.size[0]; ++a)
          if (of.at(a, b, c) == wanted &&
              (of.grid.position_mm(a, b, c) - of.grid.position_mm(i, j, k)).norm() <= margin_mm)
            return true;
    return false;
  };
  expect_voxels(grown, [&](int i, int j, int k) { return reach(mask, 1, i, j, k); });
  const Mask shrunk = with_margin(grown, -margin_mm);
  std::uniform_int_distribution<int> at(0, 17);
  for (int n = 0; n < 300; ++n) {
    const int i = at(random), j = at(random), k = at(random);
    ASSERT_EQ(shrunk.at(i, j, k) != 0, grown.at(i, j, k) != 0 && !reach(grown, 0, i, j, k));
  }
  // Closing never loses what was there.
  EXPECT_EQ(united(shrunk, mask).values, shrunk.values);
}

TEST(Edit, TheImageBorderIsNotOutside) {
  Mask full = empty_slanted_mask();
  std::fill(full.values.begin(), full.values.end(), std::uint8_t{1});
  EXPECT_EQ(with_margin(full, -5).values, full.values);
  EXPECT_EQ(smooth(full, 3).values, full.values);
}

TEST(Edit, SmoothingKeepsABallAndTakesAHairAway) {
  const Mask ball = paint(empty_slanted_mask(), {middle_mm(), 10});
  Mask hairy = ball;
  for (int i = 0; i < 30; ++i) hairy.at(i, 12, 8) = 1;
  const Mask smoothed = smooth(hairy, 2);
  EXPECT_EQ(smoothed.at(0, 12, 8), 0);
  // A ball of radius r shrinks by about sd^2 / r, here 0.4 mm of 10: 12 % of its volume, a Dice of 0.94.
  EXPECT_GT(dice(smoothed, ball).value(), 0.93);
}

TEST(Edit, UnionAndDifference) {
  const Mask a = paint(empty_slanted_mask(), {middle_mm(), 6}),
             b = paint(empty_slanted_mask(), {middle_mm() + Vector3d(4, 0, 0), 6});
  EXPECT_EQ(united(subtracted(a, b), b).values, united(a, b).values);
  EXPECT_EQ(voxel_count(subtracted(a, a)), 0U);
}

}  // namespace
}  // namespace glisson::segmentation
