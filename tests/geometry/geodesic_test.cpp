#include "geometry/geodesic.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

#include "geometry/mesh_file.h"
#include "support/data.h"

namespace glisson::geometry {
namespace {

using Eigen::Vector3d;

// A flat square of side x side points, 1 mm apart, its diagonals alternating.
Surface square(int side) {
  Surface surface;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) surface.points_mm.emplace_back(i, j, 0);
  for (int j = 0; j + 1 < side; ++j)
    for (int i = 0; i + 1 < side; ++i) {
      const int a = j * side + i, b = a + 1, c = a + side, d = c + 1;
      if ((i + j) % 2 == 0) {
        surface.triangles.insert(surface.triangles.end(), {{a, b, d}, {a, d, c}});
      } else {
        surface.triangles.insert(surface.triangles.end(), {{a, b, c}, {b, d, c}});
      }
    }
  return surface;
}

TEST(ExactGeodesics, AreStraightLinesOnAPlane) {
  const Surface surface = square(12);
  const std::vector<double> distances_mm = exact_geodesic_distances_mm(surface, 0).value();
  for (std::size_t p = 0; p < distances_mm.size(); ++p) EXPECT_NEAR(distances_mm[p], surface.points_mm[p].norm(), 1e-9);
}

// Crane et al. report mean errors of one to three per cent of the distance on meshes like this one.
TEST(HeatGeodesics, AreNearTheExactOnesOnARealLiver) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Surface liver =
      read_surface(glisson::test::shared_data() / "pbsm_liver_insilico" / "Liver1" / "tgt.ply").value();
  HeatGeodesics heat = HeatGeodesics::prepare(liver).value();
  const std::vector<double> by_heat = heat.distances_mm(17);
  const std::vector<double> exact = exact_geodesic_distances_mm(liver, 17).value();
  double error_mm = 0, total_mm = 0;
  for (std::size_t p = 0; p < exact.size(); ++p) {
    error_mm += std::abs(by_heat[p] - exact[p]);
    total_mm += exact[p];
  }
  EXPECT_LT(error_mm / total_mm, 0.03);
  EXPECT_EQ(by_heat, heat.distances_mm(17)) << "the second question is answered like the first";
}

TEST(HeatGeodesics, RefuseWhatHeatCannotFlowOver) {
  Surface two = square(3);
  const Surface other = square(3);
  for (const Vector3d& point : other.points_mm) two.points_mm.push_back(point + Vector3d(100, 0, 0));
  for (auto [a, b, c] : other.triangles) two.triangles.push_back({a + 9, b + 9, c + 9});
  EXPECT_EQ(HeatGeodesics::prepare(two).error().code, "surface-in-pieces");

  Surface book = square(2);  // three pages on one edge
  book.points_mm.emplace_back(0, 0, 5);
  book.points_mm.emplace_back(0, 0, -5);
  book.triangles.insert(book.triangles.end(), {{0, 3, 4}, {0, 3, 5}});
  EXPECT_EQ(HeatGeodesics::prepare(book).error().code, "surface-not-manifold");

  Surface bad = square(3);
  bad.points_mm[4].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(HeatGeodesics::prepare(bad).has_value());
}

}  // namespace
}  // namespace glisson::geometry
