// What is no liver to learn from or to complete is said in a sentence, never fitted.

#include <gmock/gmock.h>

#include "ellipsoids.h"
#include "shapes/completion.h"
#include "shapes/correspondence.h"
#include "shapes/liver_outline.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using geometry::Surface;

// Balls of so many mm in an image of 3 x 3 x 4 mm.
imaging::LabelMap balls(const std::vector<Vector3d>& centers_mm, double radius_mm) {
  imaging::LabelMap labels;
  labels.grid.size = {80, 60, 50};
  labels.grid.spacing_mm = {3, 3, 4};
  labels.values.assign(labels.grid.voxels(), 0);
  for (int k = 0; k < 50; ++k) {
    for (int j = 0; j < 60; ++j) {
      for (int i = 0; i < 80; ++i) {
        for (const Vector3d& center : centers_mm) {
          if ((labels.grid.position_mm(i, j, k) - center).norm() < radius_mm) labels.at(i, j, k) = 1;
        }
      }
    }
  }
  return labels;
}

Surface mirrored(Surface surface) {
  for (Vector3d& point : surface.points_mm) point.x() = -point.x();
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  return surface;
}

}  // namespace

TEST(ShapesBadInput, AWholeLiverIsOutlinedToItsVolume) {
  const auto outline = outline_of(balls({{120, 90, 100}}, 60));
  ASSERT_TRUE(outline) << outline.error().message();
  EXPECT_TRUE(is_watertight(outline->surface));
  EXPECT_EQ(outline->cut_off_at, nullptr);
  EXPECT_NEAR(geometry::volume_mm3(outline->surface) / 1000, outline->volume_ml, 0.02 * outline->volume_ml);
}

TEST(ShapesBadInput, AnImageWhoseAxesRunTheOtherWayIsTheSameLiver) {
  imaging::LabelMap labels = balls({{120, 90, 100}, {150, 90, 100}}, 55);
  const auto as_is = outline_of(labels).value();
  imaging::LabelMap turned = labels;
  turned.grid.origin_mm = labels.grid.position_mm(79, 0, 0);
  turned.grid.direction.col(0) *= -1;
  for (int k = 0; k < 50; ++k) {
    for (int j = 0; j < 60; ++j) {
      for (int i = 0; i < 80; ++i) turned.at(i, j, k) = labels.at(79 - i, j, k);
    }
  }
  const auto again = outline_of(turned).value();
  const geometry::Box a = geometry::bounding_box(as_is.surface.points_mm),
                      b = geometry::bounding_box(again.surface.points_mm);
  EXPECT_LT((a.min_mm - b.min_mm).norm() + (a.max_mm - b.max_mm).norm(), 1);
}

TEST(ShapesBadInput, LabelsThatLostTheirSpacingAreRefused) {
  imaging::LabelMap labels = balls({{120, 90, 100}}, 60);
  labels.grid.spacing_mm.setOnes();
  const auto refused = outline_of(labels);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "shapes-unit-spacing");
}

TEST(ShapesBadInput, ALiverInTwoPiecesIsRefused) {
  const auto refused = outline_of(balls({{60, 90, 100}, {180, 90, 100}}, 55));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "shapes-in-pieces");
  EXPECT_THAT(refused.error().message(), testing::HasSubstr("50 %"));
}

TEST(ShapesBadInput, NoLiverAndNoAdultsLiverAreRefused) {
  EXPECT_EQ(outline_of(balls({}, 1)).error().code, "shapes-no-liver");
  EXPECT_EQ(outline_of(balls({{120, 90, 100}}, 30)).error().code, "shapes-volume");
}

TEST(ShapesBadInput, WhereTheImageCutsALiverOffItIsOpenAndSaysWhere) {
  const auto outline = outline_of(balls({{120, 90, 170}}, 70));
  ASSERT_TRUE(outline) << outline.error().message();
  EXPECT_STREQ(outline->cut_off_at, "the head");
  EXPECT_FALSE(is_watertight(outline->surface));
}

TEST(ShapesBadInput, AFlatEndOfAClosedSurfaceIsNoSurfaceOfTheLiver) {
  Surface cut = test::unit_sphere();
  for (Vector3d& point : cut.points_mm) point = {80 * point.x(), 60 * point.y(), std::min(25.0, 55 * point.z())};
  const Surface open = without_flat_ends(cut);
  EXPECT_LT(open.triangles.size(), cut.triangles.size());
  EXPECT_FALSE(is_watertight(open));
  EXPECT_EQ(without_flat_ends(test::ellipsoid({0, 0, 0})).triangles.size(),
            test::ellipsoid({0, 0, 0}).triangles.size());
}

TEST(ShapesBadInput, AMirroredLiverIsRefused) {
  const Surface reference = reference_liver(12).value();
  const Surface mirror = mirrored(reference);
  const auto refused = correspond(reference, mirror, mirror);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "shapes-mirrored");
}

TEST(ShapesBadInput, WhatIsFarOutsideOfTheModelIsRefused) {
  const ShapeModel model = honest_model(test::ellipsoids(30)).value();
  Surface flat = test::unit_sphere();
  for (Vector3d& point : flat.points_mm) point = {140 * point.x(), 30 * point.y(), 100 * point.z()};
  const auto fit = fit_model(model, flat);
  ASSERT_TRUE(fit) << fit.error().message();
  const auto inside = check_inside(model, *fit);
  ASSERT_FALSE(inside);
  EXPECT_EQ(inside.error().code, "shapes-outside");
  EXPECT_TRUE(check_inside(model, fit_model(model, test::ellipsoid({1, 1, -1})).value()));
}

TEST(ShapesBadInput, WhatLiesElsewhereIsNotFitted) {
  const ShapeModel model = honest_model(test::ellipsoids(10)).value();
  FitOptions options;
  options.pose = Eigen::Isometry3d::Identity();
  Surface away = test::ellipsoid({0, 0, 0});
  for (Vector3d& point : away.points_mm) point.x() += 2000;
  const auto refused = fit_model(model, away, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "shapes-no-overlap");
}

}  // namespace glisson::shapes
