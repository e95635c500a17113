// Thin vessels for pictures: what is drawn in the place of splinters, and that what is thick stays as it is.

#include "vasculature/tubes.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "drawn_vessels.h"
#include "meshing/mask_surface.h"
#include "vasculature/center_lines.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using imaging::Mask;
using test::draw;

constexpr double voxel_mm = 0.8;

const Vector3d trunk_from(10, 10, 8), trunk_to(10, 10, 62), twig_from(10, 10, 35), twig_to(55, 31, 47);

Mask trunk_with_twig(double twig_radius_mm) {
  imaging::Grid grid;
  grid.size = {85, 60, 90};
  grid.spacing_mm = {voxel_mm, voxel_mm, voxel_mm};
  Mask mask{grid, std::vector<std::uint8_t>(grid.voxels(), 0)};
  draw(mask, trunk_from, trunk_to, 4);
  if (twig_radius_mm > 0) draw(mask, twig_from, twig_to, twig_radius_mm);
  return mask;
}

double off_axis_mm(const Vector3d& place, const Vector3d& from, const Vector3d& to) {
  const Vector3d way = to - from;
  const double t = std::clamp((place - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (place - from - t * way).norm();
}

TEST(Tubes, AThinBranchIsOneClosedTubeOfItsRadiusAndTheThickOneKeepsItsSurface) {
  const double radius_mm = 0.8;  // a voxel
  const Mask mask = trunk_with_twig(radius_mm);
  const auto outline = meshing::mask_surface(mask).value();
  const auto graph = center_lines(mask).value();
  const TubeOptions options{.thin_mm = thin_radius_mm(mask.grid.spacing_mm)};
  EXPECT_NEAR(options.thin_mm, 1.2, 1e-12);
  const auto drawn = with_tubes(mask, outline, graph, options);
  ASSERT_TRUE(drawn);
  EXPECT_TRUE(geometry::check_surface(*drawn));

  // Away from the trunk every point lies around the twig's axis at about its radius: of a mask of such voxels line and
  // radius are known to half a voxel each.
  int along_the_twig = 0;
  for (const Vector3d& p : drawn->points_mm) {
    if (off_axis_mm(p, trunk_from, trunk_to) < 8 || (p - twig_to).norm() < 4) continue;
    ++along_the_twig;
    EXPECT_LT(off_axis_mm(p, twig_from, twig_to), radius_mm + voxel_mm);
  }
  EXPECT_GT(along_the_twig, 200);
  // Nothing of the trunk is new or gone but where the twig leaves it.
  const auto is_trunk = [](const Vector3d& p) { return off_axis_mm(p, twig_from, twig_to) > 5; };
  EXPECT_EQ(std::count_if(drawn->points_mm.begin(), drawn->points_mm.end(), is_trunk),
            std::count_if(outline.points_mm.begin(), outline.points_mm.end(), is_trunk));

  // The tube is closed, its triangles turned outward, and it reaches from inside of the trunk to the twig's end.
  const auto pieces = geometry::connected_pieces(*drawn);
  const auto tube = std::find_if(pieces.begin(), pieces.end(), [](const auto& one) { return is_watertight(one); });
  ASSERT_NE(tube, pieces.end());
  EXPECT_GT(volume_mm3(*tube), 0);
  const auto reaches = [&](auto near) { return std::any_of(tube->points_mm.begin(), tube->points_mm.end(), near); };
  EXPECT_TRUE(reaches([](const Vector3d& p) { return off_axis_mm(p, trunk_from, trunk_to) < 4; }));
  EXPECT_TRUE(reaches([](const Vector3d& p) { return (p - twig_to).norm() < 3; }));
}

TEST(Tubes, WhereNothingIsThinNothingIsDrawnAnew) {
  const Mask mask = trunk_with_twig(0);
  const auto outline = meshing::mask_surface(mask).value();
  EXPECT_FALSE(
      with_tubes(mask, outline, center_lines(mask).value(), {.thin_mm = thin_radius_mm(mask.grid.spacing_mm)}));
}

// A tree of one and a half voxels all along is made of tubes alone, in one piece where its outline falls apart.
TEST(Tubes, WhatIsThinEverywhereIsTubesAlone) {
  Mask mask = trunk_with_twig(0);
  std::fill(mask.values.begin(), mask.values.end(), std::uint8_t{0});
  draw(mask, twig_from, twig_to, 0.75);
  const auto outline = meshing::mask_surface(mask).value();
  const auto drawn = with_tubes(mask, outline, center_lines(mask).value(), {.thin_mm = 1.2});
  ASSERT_TRUE(drawn);
  for (const geometry::Surface& piece : geometry::connected_pieces(*drawn)) EXPECT_TRUE(is_watertight(piece));
}

}  // namespace
}  // namespace glisson::vasculature
