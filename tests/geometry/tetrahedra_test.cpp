// Bodies of tetrahedra against closed forms: a box, the regular tetrahedron.

#include <gmock/gmock.h>
#include <cmath>
#include <numbers>

#include "geometry/tetrahedra.h"
#include "support/shapes.h"

namespace glisson::geometry {
namespace {

using Eigen::Vector3d;
using test::box_of_tetrahedra;
using testing::HasSubstr;

TetMesh regular_tetrahedron() { return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 3, 2}}, {}, {}}; }

TEST(Tetrahedra, OfABoxFillItsVolume) {
  const TetMesh box = box_of_tetrahedra({3, 4, 5}, {30, 20, 10});
  EXPECT_NEAR(volume_mm3(box), 6000, 1e-9);
  EXPECT_NEAR(cell_volume_mm3(box, 0), 6000.0 / (3 * 4 * 5 * 6), 1e-12);
  EXPECT_TRUE(check_tetrahedra(box));
}

TEST(Tetrahedra, TheBoundaryOfABoxIsItsWatertightSkin) {
  const TetMesh box = box_of_tetrahedra({3, 4, 5}, {30, 20, 10}, {100, 0, 0});
  const Surface skin = boundary_surface(box);
  EXPECT_TRUE(is_watertight(skin));
  EXPECT_NEAR(volume_mm3(skin), 6000, 1e-9);  // positive: the triangles face outward
  EXPECT_NEAR(area_mm2(skin), 2 * (600 + 300 + 200), 1e-9);
  EXPECT_EQ(skin.triangles.size(), 2U * 2 * (3 * 4 + 4 * 5 + 3 * 5));
}

TEST(Tetrahedra, TheBoundaryTellsWhereItsPointsAndTrianglesComeFrom) {
  const TetMesh box = box_of_tetrahedra({2, 2, 3}, {1, 1, 1});
  const Surface skin = boundary_surface(box);
  const Field* mesh_point = find_field(skin.point_fields, "mesh_point");
  const Field* mesh_cell = find_field(skin.cell_fields, "mesh_cell");
  ASSERT_NE(mesh_point, nullptr);
  ASSERT_NE(mesh_cell, nullptr);
  for (std::size_t i = 0; i < skin.points_mm.size(); ++i) {
    EXPECT_EQ(skin.points_mm[i], box.points_mm[static_cast<std::size_t>(mesh_point->values[i])]);
  }
  for (std::size_t i = 0; i < skin.triangles.size(); ++i) {
    const auto& cell = box.cells[static_cast<std::size_t>(mesh_cell->values[i])];
    for (const int corner : skin.triangles[i]) {
      EXPECT_THAT(cell, testing::Contains(static_cast<int>(mesh_point->values[static_cast<std::size_t>(corner)])));
    }
  }
}

TEST(Tetrahedra, QualityOfTheRegularOneIsKnown) {
  const TetQuality regular = quality(regular_tetrahedron());
  const double dihedral_deg = std::acos(1.0 / 3.0) * 180 / std::numbers::pi;  // 70.53
  EXPECT_NEAR(regular.min_dihedral_deg, dihedral_deg, 1e-9);
  EXPECT_NEAR(regular.max_dihedral_deg, dihedral_deg, 1e-9);
  EXPECT_NEAR(regular.mean_aspect, 1.0, 1e-12);
  EXPECT_NEAR(regular.max_aspect, 1.0, 1e-12);
}

TEST(Tetrahedra, QualityOfACubesCornerIsKnown) {
  // Edges 1, 1, 1, sqrt 2 (three times); dihedral angles of 90 degrees and acos(1/sqrt 3); its height over the slanted
  // face is 1/sqrt 3.
  const TetMesh corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, {}, {}};
  const TetQuality of_corner = quality(corner);
  EXPECT_NEAR(of_corner.min_dihedral_deg, std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(of_corner.max_dihedral_deg, 90, 1e-9);
  EXPECT_NEAR(of_corner.max_aspect, std::sqrt(2.0) * std::sqrt(2.0 / 3.0) * std::sqrt(3.0), 1e-12);
}

TEST(Tetrahedra, AFlatOrTurnedCellIsNamed) {
  TetMesh box = box_of_tetrahedra({2, 1, 1}, {1, 1, 1});
  std::swap(box.cells[5][0], box.cells[5][1]);
  const auto checked = check_tetrahedra(box);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, "mesh-inverted");
  EXPECT_THAT(checked.error().message(), HasSubstr("Tetrahedron 5"));
}

TEST(Tetrahedra, PartsThatShareNoFaceAreCountedAndSized) {
  TetMesh box = box_of_tetrahedra({2, 1, 1}, {1, 1, 1});
  const TetMesh other = box_of_tetrahedra({1, 1, 1}, {1, 1, 1}, {5, 0, 0});
  const int shift = static_cast<int>(box.points_mm.size());
  for (const Vector3d& point : other.points_mm) box.points_mm.push_back(point);
  for (const auto& [a, b, c, d] : other.cells) box.cells.push_back({a + shift, b + shift, c + shift, d + shift});
  const auto checked = check_tetrahedra(box);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, "mesh-in-parts");
  EXPECT_THAT(checked.error().message(), HasSubstr("12, 6"));
}

TEST(Tetrahedra, AnIndexOutOfRangeIsRefusedBeforeItIsUsed) {
  TetMesh box = box_of_tetrahedra({1, 1, 1}, {1, 1, 1});
  box.cells[2][3] = 8;
  EXPECT_EQ(check_tetrahedra(box).error().code, "mesh-index");
  EXPECT_EQ(check_tetrahedra({}).error().code, "mesh-empty");
}

}  // namespace
}  // namespace glisson::geometry
