// A body divided: volumes against closed forms, and a mesh that still fits together, opened where it is asked to be.

#include "geometry/split_tetrahedra.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/Geometry>

#include "mechanics/bodies.h"

namespace glisson::geometry {
namespace {

using Eigen::Vector3d;
using mechanics::test::box;
using mechanics::test::disturb_inner_points;
using mechanics::test::name_points;

TetMesh body() {
  TetMesh mesh = box(5, 4, 4, {50, 40, 40});
  disturb_inner_points(mesh, 2.0);
  return mesh;
}

TEST(DividedVolume, OfAPlaneIsExact) {
  const TetMesh mesh = body();
  // Across x at 17 mm; and a corner cut off: x + y + z < 30 is a pyramid of 30^3 / 6.
  const auto across = divided_volume(mesh, CutSurface::plane({17, 3, 4}, {2, 0, 0}).value());
  EXPECT_NEAR(across.below_mm3, 17.0 * 1600, 1e-6);
  EXPECT_NEAR(across.above_mm3, 33.0 * 1600, 1e-6);
  EXPECT_EQ(across.error_mm3, 0);
  const auto corner = divided_volume(mesh, CutSurface::plane({30, 0, 0}, {1, 1, 1}).value());
  EXPECT_NEAR(corner.below_mm3, 4500, 1e-6);
  const auto beside = divided_volume(mesh, CutSurface::plane({60, 0, 0}, {1, 0, 0}).value());
  EXPECT_EQ(beside.above_mm3, 0);
}

TEST(CutSurface, ASheetPassesThroughItsPointsAndIsFlatWhereTheyAre) {
  std::vector<Vector3d> wave, flat;
  for (int i = 0; i <= 5; ++i) {
    for (int k = 0; k <= 4; ++k) {
      wave.emplace_back(10.0 * i, 10.0 * k, 20 + 4 * std::sin(0.1 * i * 10));
      flat.emplace_back(10.0 * i, 10.0 * k, 20 + i);
    }
  }
  const CutSurface sheet = CutSurface::through(wave).value();
  for (const Vector3d& point : wave) EXPECT_NEAR(sheet.height_mm(point), 0, 1e-8);
  const CutSurface plane = CutSurface::through(flat).value();
  EXPECT_NEAR(plane.height_mm({13, 7, 20 + 1.3}), 0, 1e-8);
}

TEST(CutSurface, RefusesPointsThatDoNotSayWhereToCut) {
  const auto why = [](const std::vector<Vector3d>& points) { return CutSurface::through(points).error().message(); };
  EXPECT_THAT(why({{0, 0, 0}, {1, 0, 0}}), testing::HasSubstr("3 to 2000 points"));
  EXPECT_THAT(why({{0, 0, 0}, {10, 0, 0}, {20, 0.1, 0}}), testing::HasSubstr("almost on a line"));
  EXPECT_THAT(why({{0, 0, 0}, {50, 0, 0}, {0, 50, 0}, {50, 50, 0}, {0, 0, 5}}), testing::HasSubstr("above each other"));
  EXPECT_THAT(why({{0, 0, 0}, {NAN, 0, 0}, {1, 1, 1}}), testing::HasSubstr("not finite"));
  EXPECT_FALSE(CutSurface::plane({0, 0, 0}, {0, 0, 0}));
}

TEST(DividedVolume, OfASheetIsRightWithinTheErrorItStates) {
  std::vector<Vector3d> points;
  for (int i = 0; i <= 10; ++i) {
    for (int k = 0; k <= 8; ++k) points.emplace_back(5.0 * i, 5.0 * k, 20 + 4 * std::cos(std::numbers::pi * i / 10.0));
  }
  const CutSurface sheet = CutSurface::through(points).value();
  const TetMesh mesh = body();
  // Under the sheet, by fine columns.
  double below_mm3 = 0;
  const int n = 80;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const double x = 50.0 * (i + 0.5) / n, y = 40.0 * (k + 0.5) / n;
      double low = 0, high = 40;
      const double upwards = sheet.height_mm({x, y, 40}) > 0 ? 1 : -1;
      for (int bisect = 0; bisect < 30; ++bisect) {
        const double z = 0.5 * (low + high);
        (upwards * sheet.height_mm({x, y, z}) > 0 ? high : low) = z;
      }
      below_mm3 += low * (50.0 / n) * (40.0 / n);
    }
  }
  const auto volume = divided_volume(mesh, sheet);
  const double computed_mm3 = sheet.normal().z() > 0 ? volume.below_mm3 : volume.above_mm3;
  EXPECT_NEAR(volume.above_mm3 + volume.below_mm3, 80000, 1e-6);
  EXPECT_NEAR(computed_mm3, below_mm3, volume.error_mm3 + 5.0);  // 5 mm3: what the columns are good for
  EXPECT_LT(volume.error_mm3, 10);
}

// Faces that do not fit would show up as boundary inside the body.
TEST(SplitTetrahedra, TheClosedCutLeavesABodyThatFitsTogether) {
  const TetMesh mesh = body();
  for (const Vector3d& normal : {Vector3d(1, 0, 0), Vector3d(1, 0.4, -0.7), Vector3d(0.2, 1, 0.1)}) {
    const CutSurface cut = CutSurface::plane({22, 19, 21}, normal).value();
    const SplitMesh split =
        split_tetrahedra(mesh, cut, {.snap = 0.15, .is_open = [](const Vector3d&) { return false; }});
    ASSERT_TRUE(check_tetrahedra(split.mesh)) << check_tetrahedra(split.mesh).error().message();
    EXPECT_NEAR(volume_mm3(split.mesh), 80000, 1e-6);
    EXPECT_NEAR(area_mm2(boundary_surface(split.mesh)), 2 * (2000 + 2000 + 1600), 1e-6);
    EXPECT_TRUE(is_watertight(boundary_surface(split.mesh)));
    EXPECT_GT(quality(split.mesh).min_dihedral_deg, 1.0);
    EXPECT_TRUE(split.doubled.empty());
  }
}

TEST(SplitTetrahedra, TheOpenCutMakesTwoBodiesWithTheCutAsTheirWalls) {
  TetMesh mesh = body();
  const CutSurface cut = CutSurface::plane({22, 0, 0}, {1, 0, 0}).value();
  const SplitMesh split = split_tetrahedra(mesh, cut, {.snap = 0, .is_open = {}});
  EXPECT_NEAR(area_mm2(split.cut), 1600, 1e-6);
  const auto part = parts_by_faces(split.mesh);
  EXPECT_EQ(*std::max_element(part.begin(), part.end()), 1);
  double above_mm3 = 0;
  for (std::size_t c = 0; c < split.side.size(); ++c) {
    if (split.side[c] > 0) above_mm3 += cell_volume_mm3(split.mesh, c);
    EXPECT_EQ(part[c] == part[0], split.side[c] == split.side[0]);
  }
  EXPECT_NEAR(above_mm3, 28.0 * 1600, 1e-6);
  const Surface boundary = boundary_surface(split.mesh);
  EXPECT_TRUE(is_watertight(boundary));
  EXPECT_NEAR(area_mm2(boundary), 2 * (2000 + 2000 + 1600) + 2 * 1600, 1e-6);
  for (const auto& [a, b, c] : split.cut.triangles) {
    const auto& p = split.cut.points_mm;
    EXPECT_GT((p[b] - p[a]).cross(p[c] - p[a]).x(), 0);
  }
}

TEST(SplitTetrahedra, ACutOpenInPartLeavesAHinge) {
  const TetMesh mesh = body();
  const CutSurface cut = CutSurface::plane({22, 0, 0}, {1, 0, 0}).value();
  const SplitMesh split =
      split_tetrahedra(mesh, cut, {.snap = 0.15, .is_open = [](const Vector3d& p) { return p.z() > 15; }});
  EXPECT_TRUE(check_tetrahedra(split.mesh));  // it hangs together
  EXPECT_FALSE(split.doubled.empty());
  for (const auto& [below, above] : split.doubled) {
    EXPECT_EQ(split.mesh.points_mm[below], split.mesh.points_mm[above]);
    EXPECT_GT(split.mesh.points_mm[below].z(), 15);
  }
  const Surface boundary = boundary_surface(split.mesh);
  EXPECT_TRUE(is_watertight(boundary));
  EXPECT_GT(area_mm2(boundary), 2 * (2000 + 2000 + 1600) + 2 * 15 * 40);
}

TEST(SplitTetrahedra, NamesHoldOnlyBetweenNamedPointsAndNumbersAreInterpolated) {
  TetMesh mesh = body();
  name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  Field height{"z", 1, {}};
  for (const Vector3d& p : mesh.points_mm) height.values.push_back(p.z());
  mesh.point_fields.push_back(height);
  Field number{"number", 1, {}};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) number.values.push_back(double(c));
  mesh.cell_fields.push_back(number);
  const SplitMesh split = split_tetrahedra(mesh, CutSurface::plane({3, 20, 19}, {0.1, 0, 1}).value());
  const Field& wall = *find_field(split.mesh.point_fields, "wall");
  const Field& z = *find_field(split.mesh.point_fields, "z");
  ASSERT_EQ(wall.values.size(), split.mesh.points_mm.size());
  for (std::size_t p = 0; p < split.mesh.points_mm.size(); ++p) {
    EXPECT_EQ(wall.values[p], split.mesh.points_mm[p].x() == 0 ? 1.0 : 0.0);
    EXPECT_NEAR(z.values[p], split.mesh.points_mm[p].z(), 1e-9);
  }
  const Field& kept = *find_field(split.mesh.cell_fields, "number");
  for (std::size_t c = 0; c < split.parent.size(); ++c) EXPECT_EQ(kept.values[c], split.parent[c]);
}

TEST(SplitTetrahedra, ASurfaceThatMissesLeavesTheMesh) {
  const TetMesh mesh = body();
  const SplitMesh split = split_tetrahedra(mesh, CutSurface::plane({99, 0, 0}, {1, 0, 0}).value());
  EXPECT_EQ(split.mesh.cells, mesh.cells);
  EXPECT_TRUE(split.cut.triangles.empty());
}

TEST(SplitTetrahedra, TwoCutsOneAfterTheOtherMakeThreeParts) {
  const SplitMesh first = split_tetrahedra(body(), CutSurface::plane({18, 0, 0}, {1, 0, 0.1}).value());
  const SplitMesh second = split_tetrahedra(first.mesh, CutSurface::plane({36, 0, 0}, {1, 0.2, 0}).value());
  const auto part = parts_by_faces(second.mesh);
  EXPECT_EQ(*std::max_element(part.begin(), part.end()), 2);
  EXPECT_NEAR(volume_mm3(second.mesh), 80000, 1e-6);
}

}  // namespace
}  // namespace glisson::geometry
