// A planned resection of a body whose volumes, margins and vessels are known.

#include "rehearsal/resection.h"

#include <gmock/gmock.h>

#include "shapes_in_a_block.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using geometry::CutSurface;

using test::ball;
using test::block;
using test::tube;

TEST(Resection, VolumesMarginsSidesAndVesselsAreThoseOfTheGeometry) {
  const std::vector<NamedStructure> structures{
      {"tumour-1", StructureKind::tumour, ball({20, 30, 30}, 6)},     // 4 mm from the cut, in the specimen
      {"tumour-2", StructureKind::tumour, ball({29.5, 12, 12}, 5)},   // cut through
      {"tumour-3", StructureKind::tumour, ball({45.5, 45, 45}, 15)},  // 0.5 mm, in the remnant
      {"portal-vein", StructureKind::vessel, tube({5, 40, 20}, {75, 40, 20}, 4)},
      {"hepatic-vein", StructureKind::vessel, tube({10, 10, 45}, {50, 50, 45}, 3)},  // crossed at 45 degrees
      {"artery", StructureKind::vessel, tube({50, 10, 10}, {50, 50, 10}, 2)}};
  const auto plan = plan_resection(block(), CutSurface::plane({30, 0, 0}, {-1, 0, 0}).value(), structures).value();
  EXPECT_NEAR(plan.specimen_ml, 30 * 3.6, 1e-9);
  EXPECT_NEAR(plan.remnant_ml, 50 * 3.6, 1e-9);
  EXPECT_NEAR(plan.remnant_percent(), 62.5, 1e-9);
  EXPECT_NEAR(plan.cut_area_mm2, 3600, 1e-6);
  EXPECT_TRUE(plan.specimen_is_above);

  ASSERT_EQ(plan.tumours.size(), 3u);
  EXPECT_EQ(plan.tumours[0].side, ResectionSide::specimen);
  EXPECT_NEAR(plan.tumours[0].margin_mm, 4, 0.02);
  EXPECT_TRUE(plan.tumours[0].narrow());
  EXPECT_FALSE(plan.tumours[0].r1());
  EXPECT_EQ(plan.tumours[1].side, ResectionSide::both);
  EXPECT_EQ(plan.tumours[1].margin_mm, 0);
  EXPECT_EQ(plan.tumours[2].side, ResectionSide::remnant);
  EXPECT_NEAR(plan.tumours[2].margin_mm, 0.5, 0.1);
  EXPECT_TRUE(plan.tumours[2].r1());
  EXPECT_THAT(plan.notes, testing::ElementsAre("tumour-2 is cut through.", "tumour-3 is left in the remnant."));

  ASSERT_EQ(plan.crossings.size(), 2u);
  EXPECT_EQ(plan.crossings[0].name, "portal-vein");
  EXPECT_NEAR(plan.crossings[0].diameter_mm, 8, 0.05);
  EXPECT_LT((plan.crossings[0].center_mm - Vector3d(30, 40, 20)).norm(), 0.05);
  EXPECT_NEAR(plan.crossings[1].diameter_mm, 6, 0.05);
  EXPECT_NEAR(plan.crossings[1].area_mm2, 9 * std::numbers::pi * std::sqrt(2.0), 0.3);
  EXPECT_EQ(plan.vessels[2].side, ResectionSide::remnant);
}

TEST(Resection, AMarginIsToTheCutInsideTheLiverAndNotToItsPlane) {
  // The plane cuts a corner off; the tumour lies near the plane far from that corner, outside of the body's reach.
  const CutSurface corner = CutSurface::plane({10, 0, 0}, Vector3d(1, 1, 1)).value();
  const auto plan =
      plan_resection(block(), corner, {{"tumour-1", StructureKind::tumour, ball({40, 30, 30}, 5)}}).value();
  EXPECT_NEAR(plan.specimen_ml, 1e-3 * 1000 / 6, 1e-9);
  EXPECT_GT(plan.tumours[0].margin_mm, (90.0 / std::sqrt(3.0)) - 5 - 0.1);
}

TEST(Resection, TheSpecimenIsWhereItsPointIs) {
  const CutSurface cut = CutSurface::plane({30, 0, 0}, {1, 0, 0}).value();
  EXPECT_NEAR(plan_resection(block(), cut, {}, Vector3d(70, 30, 30))->specimen_ml, 50 * 3.6, 1e-9);
  EXPECT_EQ(plan_resection(block(), cut, {}, Vector3d(30, 30, 30)).error().code, "specimen-on-cut");
  EXPECT_EQ(plan_resection(block(), CutSurface::plane({99, 0, 0}, {1, 0, 0}).value(), {}).error().code, "cut-misses");
}

TEST(Resection, TheTwoPartsAreBodiesOfTheirOwn) {
  const auto plan = plan_resection(block(), CutSurface::plane({33, 0, 0}, {1, 0.2, 0}).value(), {}).value();
  const auto part = geometry::parts_by_faces(plan.split.mesh);
  EXPECT_EQ(*std::max_element(part.begin(), part.end()), 1);
  double specimen_ml = 0;
  for (std::size_t c = 0; c < part.size(); ++c) {
    if ((plan.split.side[c] > 0) == plan.specimen_is_above) {
      specimen_ml += 1e-3 * geometry::cell_volume_mm3(plan.split.mesh, c);
    }
  }
  // The mesh's cut passes through points that it found near: a little off the exact volume.
  EXPECT_NEAR(specimen_ml, plan.specimen_ml, 0.02 * plan.specimen_ml);
}

}  // namespace
}  // namespace glisson::rehearsal
