// Points are found in the cell that holds them, or on the nearest place of the boundary.

#include "mechanics/elements/point_location.h"

#include <gmock/gmock.h>
#include <cmath>

#include "mechanics/bodies.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

Vector3d position_of(const geometry::TetMesh& mesh, const PointInMesh& place) {
  Vector3d position(0, 0, 0);
  for (int i = 0; i < 4; ++i) position += place.barycentric[i] * mesh.points_mm[mesh.cells[place.cell][i]];
  return position;
}

geometry::TetMesh crooked_body() {
  auto mesh = test::bent_box(5, 4, 6, [](const Vector3d& unit) {
    const double turn = 1.2 * unit.z();
    const Vector3d p(30 * unit.x() - 15, 20 * unit.y() - 10, 50 * unit.z());
    return Vector3d(std::cos(turn) * p.x() - std::sin(turn) * p.y(), std::sin(turn) * p.x() + std::cos(turn) * p.y(),
                    p.z());
  });
  test::disturb_inner_points(mesh, 0.8);
  return mesh;
}

TEST(LocatePoints, APointInTheBodyIsWhereItsBarycentricCoordinatesSay) {
  const auto mesh = crooked_body();
  std::vector<Vector3d> inside;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Eigen::Vector4d l = Eigen::Vector4d(0.1 + 0.01 * (c % 7), 0.2, 0.3, 0.0);
    inside.emplace_back(l[0] * mesh.points_mm[mesh.cells[c][0]] + l[1] * mesh.points_mm[mesh.cells[c][1]] +
                        l[2] * mesh.points_mm[mesh.cells[c][2]] + (1 - l.sum()) * mesh.points_mm[mesh.cells[c][3]]);
  }
  const auto places = locate_points(mesh, inside);
  for (std::size_t c = 0; c < places.size(); ++c) {
    EXPECT_EQ(places[c].cell, int(c));
    EXPECT_EQ(places[c].outside_by_mm, 0);
    EXPECT_LT((position_of(mesh, places[c]) - inside[c]).norm(), 1e-10);
  }
}

TEST(LocatePoints, TheMeshesOwnPointsAreInside) {
  const auto mesh = crooked_body();
  for (const PointInMesh& place : locate_points(mesh, mesh.points_mm)) EXPECT_LT(place.outside_by_mm, 1e-9);
}

// Each cell is of positive volume and lies well beside those that it shares a face with.
TEST(CellsInOthers, AreThoseOfABarWhoseEndsOverlap) {
  const auto bar_bent_by = [](double turn) {
    return test::bent_box(2, 2, 40, [turn](const Vector3d& unit) {
      const double radius_mm = 40 + 10 * unit.x(), angle = turn * unit.z();
      return Vector3d(radius_mm * std::cos(angle), radius_mm * std::sin(angle), 10 * unit.y());
    });
  };
  const double once = 2 * std::acos(-1.0);
  const auto overlapping = bar_bent_by(1.05 * once);
  ASSERT_TRUE(geometry::check_tetrahedra(overlapping));
  const double layers = 2 * 0.05 / 1.05 * 40;  // of 24 cells, at both ends
  EXPECT_GT(cells_in_others(overlapping), 0.5 * layers * 24);
  EXPECT_LT(cells_in_others(overlapping), 1.5 * layers * 24);
  EXPECT_EQ(cells_in_others(bar_bent_by(0.98 * once)), 0);
  EXPECT_EQ(cells_in_others(crooked_body()), 0);
}

TEST(LocatePoints, OutsideTheDistanceAndPlaceAreThoseOfTheSlowSearch) {
  const auto mesh = crooked_body();
  const geometry::Surface surface = geometry::boundary_surface(mesh);
  std::vector<Vector3d> outside;
  for (int i = 0; i < 40; ++i) outside.emplace_back(60 * std::sin(1.0 * i), 60 * std::cos(1.0 * i), -20 + 2.3 * i);
  const auto places = locate_points(mesh, outside);
  for (std::size_t i = 0; i < outside.size(); ++i) {
    // The slow search: many places on every triangle. 60 steps of edges under 15 mm: right to 0.25 mm.
    double slow_mm = 1e9;
    for (const auto& [a, b, c] : surface.triangles) {
      for (int s = 0; s <= 60; ++s) {
        for (int t = 0; s + t <= 60; ++t) {
          const Vector3d on = surface.points_mm[a] + s / 60.0 * (surface.points_mm[b] - surface.points_mm[a]) +
                              t / 60.0 * (surface.points_mm[c] - surface.points_mm[a]);
          slow_mm = std::min(slow_mm, (on - outside[i]).norm());
        }
      }
    }
    EXPECT_LE(places[i].outside_by_mm, slow_mm + 1e-9);
    EXPECT_NEAR(places[i].outside_by_mm, slow_mm, 0.25);
    EXPECT_NEAR((position_of(mesh, places[i]) - outside[i]).norm(), places[i].outside_by_mm, 1e-9);
  }
}

TEST(LocatePoints, NoPointsGiveNoPlaces) { EXPECT_TRUE(locate_points(crooked_body(), {}).empty()); }

}  // namespace
}  // namespace glisson::mechanics
