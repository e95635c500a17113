// A resection planned on a liver that is held aside, against displacements whose outcome is known.

#include "rehearsal/retraction.h"

#include <gmock/gmock.h>

#include "rehearsal/resection.h"
#include "shapes_in_a_block.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using geometry::CutSurface;
using test::ball;
using test::block;
using test::tube;

std::vector<NamedStructure> structures() {
  return {{"tumour-1", StructureKind::tumour, ball({20, 30, 30}, 6)},  // 4 mm from the plane x = 30
          {"portal-vein", StructureKind::vessel, tube({5, 40, 20}, {75, 40, 20}, 4)}};
}

std::vector<Vector3d> displacement_mm(const geometry::TetMesh& mesh, const Eigen::Affine3d& motion) {
  std::vector<Vector3d> moved_mm;
  for (const Vector3d& point : mesh.points_mm) moved_mm.emplace_back(motion * point - point);
  return moved_mm;
}

Result<Resection> plan_displaced(const Eigen::Affine3d& motion, const CutSurface& cut) {
  const geometry::TetMesh rest = block();
  const auto moved_mm = displacement_mm(rest, motion);
  return plan_resection(displaced(rest, moved_mm).value(), cut, displaced(rest, moved_mm, structures()));
}

TEST(Retraction, ALiverCarriedAwayAndTurnedIsCutAsAtRest) {
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.translate(Vector3d(10, -20, 30)).rotate(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()));
  const Vector3d point_mm(30, 0, 0), normal(-1, 0, 0);
  const auto at_rest = plan_resection(block(), CutSurface::plane(point_mm, normal).value(), structures()).value();
  const auto moved =
      plan_displaced(motion, CutSurface::plane(motion * point_mm, motion.linear() * normal).value()).value();
  EXPECT_NEAR(moved.specimen_ml, 30 * 3.6, 1e-9);
  EXPECT_NEAR(moved.remnant_ml, 50 * 3.6, 1e-9);
  EXPECT_NEAR(moved.tumours[0].margin_mm, at_rest.tumours[0].margin_mm, 1e-9);
  EXPECT_EQ(moved.tumours[0].side, ResectionSide::specimen);
  const Vector3d middle_mm(20, 30, 30);
  EXPECT_NEAR(moved.tumours[0].shift_mm, (motion * middle_mm - middle_mm).norm(), 0.01);
  ASSERT_EQ(moved.crossings.size(), 1u);
  EXPECT_NEAR(moved.crossings[0].diameter_mm, at_rest.crossings[0].diameter_mm, 1e-6);
  EXPECT_LT((moved.crossings[0].center_mm - motion * at_rest.crossings[0].center_mm).norm(), 1e-6);
  // Pulled back, the cut is the plane at rest, and the parts those of the body at rest.
  for (const Vector3d& p : put_to_rest(moved.cut).points_mm) EXPECT_NEAR(p.x(), 30, 1e-9);
  EXPECT_NEAR(geometry::volume_mm3(put_to_rest(moved.split.mesh)), 80 * 60 * 60, 1e-6);
}

TEST(Retraction, OfALiverThatIsStretchedMarginsAreThoseNowAndVolumesThoseOfTheTissue) {
  // A quarter longer along x: the plane x = 50 goes through what lies at x = 40 at rest.
  Eigen::Affine3d stretch = Eigen::Affine3d::Identity();
  stretch.scale(Vector3d(1.25, 1, 1));
  const auto plan = plan_displaced(stretch, CutSurface::plane({50, 0, 0}, {-1, 0, 0}).value()).value();
  EXPECT_NEAR(plan.specimen_ml, 40 * 3.6, 1e-9);
  EXPECT_NEAR(plan.remnant_ml, 40 * 3.6, 1e-9);
  EXPECT_NEAR(plan.tumours[0].margin_mm, 50 - 1.25 * 26, 0.02);
  EXPECT_NEAR(plan.tumours[0].shift_mm, 0.25 * 20, 0.01);
  EXPECT_NEAR(plan.cut_area_mm2, 3600, 1e-6);
  for (const Vector3d& p : plan.cut.points_mm) EXPECT_NEAR(p.x(), 50, 1e-9);
  for (const Vector3d& p : put_to_rest(plan.cut).points_mm) EXPECT_NEAR(p.x(), 40, 1e-9);
}

TEST(Retraction, ABentSheetDividesTheTissueThatItPassesThroughNow) {
  // Sheared, a sheet that is carried along divides what it divided at rest.
  Eigen::Affine3d shear = Eigen::Affine3d::Identity();
  shear.linear()(0, 2) = 0.4;
  std::vector<Vector3d> at_rest_mm, now_mm;
  for (const double y : {5.0, 30.0, 55.0}) {
    for (const double z : {5.0, 30.0, 55.0}) at_rest_mm.emplace_back(30 + (y == 30 ? 6 : 0), y, z);
  }
  for (const Vector3d& point : at_rest_mm) now_mm.emplace_back(shear * point);
  const auto rest = plan_resection(block(), CutSurface::through(at_rest_mm).value(), structures()).value();
  const auto now = plan_displaced(shear, CutSurface::through(now_mm).value()).value();
  EXPECT_NEAR(now.specimen_ml + now.remnant_ml, 288, 1e-9);
  // Not the same sheet between its points: thin plates over two planes.
  EXPECT_NEAR(now.specimen_ml, rest.specimen_ml, 1.0);
}

TEST(Retraction, WithoutADisplacementEverythingIsAsAtRest) {
  const CutSurface cut = CutSurface::plane({30, 0, 0}, {-1, 0.3, 0}).value();
  const auto rest = plan_resection(block(), cut, structures()).value();
  const auto still = plan_displaced(Eigen::Affine3d::Identity(), cut).value();
  EXPECT_EQ(still.specimen_ml, rest.specimen_ml);
  EXPECT_EQ(still.tumours[0].margin_mm, rest.tumours[0].margin_mm);
  EXPECT_EQ(still.tumours[0].shift_mm, 0);
  EXPECT_EQ(put_to_rest(still.split.mesh).points_mm, rest.split.mesh.points_mm);
}

TEST(Retraction, WhatCannotBeMeasuredIsRefused) {
  const geometry::TetMesh rest = block();
  EXPECT_EQ(displaced(rest, {}).error().code, "retraction-mismatch");
  Eigen::Affine3d mirrored = Eigen::Affine3d::Identity();
  mirrored.scale(Vector3d(-1, 1, 1));
  const auto inside_out = displaced(rest, displacement_mm(rest, mirrored));
  ASSERT_FALSE(inside_out);
  EXPECT_EQ(inside_out.error().code, "retraction-inverted");
  EXPECT_THAT(inside_out.error().message(),
              testing::HasSubstr("inside out (" + std::to_string(rest.cells.size()) + ")"));
}

TEST(Retraction, AHepaticVeinTooWideForOneIsToldFromTheVenaCava) {
  const std::vector<NamedStructure> veins{
      {"hepatic-vein", StructureKind::vessel, tube({5, 30, 30}, {75, 30, 30}, 15.25)},
      {"hepatic-vein-2", StructureKind::vessel, tube({5, 52, 52}, {75, 52, 52}, 5)},
      {"portal-vein", StructureKind::vessel, tube({5, 30, 30}, {75, 30, 30}, 11)}};
  const auto plan = plan_resection(block(), CutSurface::plane({30, 0, 0}, {-1, 0, 0}).value(), veins).value();
  ASSERT_EQ(plan.crossings.size(), 3u);
  EXPECT_TRUE(plan.crossings[0].vena_cava_by_calibre());   // 30.5 mm
  EXPECT_FALSE(plan.crossings[1].vena_cava_by_calibre());  // a portal vein, of whatever width
  EXPECT_FALSE(plan.crossings[2].vena_cava_by_calibre());
}

}  // namespace
}  // namespace glisson::rehearsal
