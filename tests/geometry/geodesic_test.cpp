#include "geometry/geodesic.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/internal/intrinsic_delaunay.h"
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

// Crane et al. report mean errors of one to three per cent of the distance on meshes like these.
void expect_near_exact(const char* file, int from) {
  const Surface surface = read_surface(glisson::test::shared_data() / file).value();
  const HeatGeodesics heat = HeatGeodesics::prepare(surface).value();
  const Eigen::VectorXd by_heat = heat.distances_mm(from);
  const std::vector<double> exact = exact_geodesic_distances_mm(surface, from).value();
  const Eigen::Map<const Eigen::VectorXd> exact_mm(exact.data(), by_heat.size());
  EXPECT_LT((by_heat - exact_mm).cwiseAbs().sum(), 0.03 * exact_mm.sum());
  EXPECT_EQ(by_heat, heat.distances_mm(from)) << "the second question is answered like the first";
}

TEST(HeatGeodesics, AreNearTheExactOnesOnARealLiver) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  expect_near_exact("pbsm_liver_insilico/Liver1/tgt.ply", 17);
}

// With long legs: heat that comes to their ends is as little as numbers can be.
TEST(HeatGeodesics, AreNearTheExactOnesOnAWolf) {
  GLISSON_NEEDS_DATA("tosca_nonrigid_shapes");
  expect_near_exact("tosca_nonrigid_shapes/wolf0.off", 170);
}

TEST(HeatGeodesics, AnswerManySourcesAsEachAlone) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Surface liver =
      read_surface(glisson::test::shared_data() / "pbsm_liver_insilico" / "Liver1" / "tgt.ply").value();
  const HeatGeodesics heat = HeatGeodesics::prepare(liver).value();
  const std::vector<int> from{17, 0, 900, 4000, 2000, 17, 31, 77, 1234, 3, 5000};
  const Eigen::MatrixXd together = heat.distances_mm(from);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Eigen::VectorXd alone = heat.distances_mm(from[i]);
    EXPECT_LT((together.row(static_cast<Eigen::Index>(i)).transpose() - alone).cwiseAbs().maxCoeff(),
              1e-9 * alone.maxCoeff());
  }
}

// A sheet of slivers, rolled up: unrolled, distances are straight lines.
Surface rolled_slivers() {
  constexpr int along = 41, around = 13;
  constexpr double radius_mm = 10;
  Surface surface;
  for (int j = 0; j < around; ++j) {
    for (int i = 0; i < along; ++i) {
      const double angle = 0.2 * (j + 0.9 * (i % 2)), x_mm = 0.15 * i;
      surface.points_mm.emplace_back(x_mm, radius_mm * std::cos(angle), radius_mm * std::sin(angle));
    }
  }
  for (int j = 0; j + 1 < around; ++j) {
    for (int i = 0; i + 1 < along; ++i) {
      const int a = j * along + i, b = a + 1, c = a + along, d = c + 1;
      surface.triangles.insert(surface.triangles.end(), {{a, b, d}, {a, d, c}});
    }
  }
  return surface;
}

TEST(IntrinsicDelaunay, HasNoNegativeCotangentsAndKeepsTheArea) {
  const Surface surface = rolled_slivers();
  const std::vector<IntrinsicTriangle> triangles = intrinsic_delaunay(surface);
  ASSERT_EQ(triangles.size(), surface.triangles.size());
  double area_mm2 = 0;
  std::map<std::pair<int, int>, double> cotangents;
  for (const IntrinsicTriangle& triangle : triangles) {
    const auto& [ab, bc, ca] = triangle.lengths_mm;
    const double twice_area = ab * third_corner_mm(ab, bc, ca).y();
    area_mm2 += 0.5 * twice_area;
    for (int k = 0; k < 3; ++k) {
      const double across = triangle.lengths_mm[k], b = triangle.lengths_mm[(k + 1) % 3],
                   c = triangle.lengths_mm[(k + 2) % 3];
      const auto edge = std::minmax(triangle.points[k], triangle.points[(k + 1) % 3]);
      cotangents[{edge.first, edge.second}] += (b * b + c * c - across * across) / (2 * twice_area);
    }
  }
  // Lengths of edges over a bend are those of the unfolded sheet.
  EXPECT_NEAR(area_mm2, geometry::area_mm2(surface), 1e-9 * area_mm2);
  const HeatGeodesics heat = HeatGeodesics::prepare(surface).value();
  const std::vector<double> exact = exact_geodesic_distances_mm(surface, 20).value();
  const Eigen::VectorXd by_heat = heat.distances_mm(20);
  double error_mm = 0, total_mm = 0;
  for (std::size_t p = 0; p < exact.size(); ++p) {
    error_mm += std::abs(by_heat[static_cast<Eigen::Index>(p)] - exact[p]);
    total_mm += exact[p];
  }
  EXPECT_LT(error_mm / total_mm, 0.05);
  std::map<std::pair<int, int>, int> sides;
  for (const IntrinsicTriangle& triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto edge = std::minmax(triangle.points[k], triangle.points[(k + 1) % 3]);
      ++sides[{edge.first, edge.second}];
    }
  }
  for (const auto& [edge, cotangent] : cotangents) {
    if (sides[edge] == 1) continue;  // of the border
    EXPECT_GE(cotangent, -1e-8) << edge.first << ", " << edge.second;
  }
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
