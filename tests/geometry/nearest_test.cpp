// Nearest points and distances to surfaces, judged by asking every point and every triangle.

#include "geometry/nearest.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <random>

#include "geometry/mesh_file.h"
#include "support/data.h"
#include "support/shapes.h"

namespace glisson::geometry {
namespace {

using Eigen::Vector3d;
using test::sphere_surface;

std::vector<Vector3d> random_points(int count, double half_width_mm) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-half_width_mm, half_width_mm);
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return points;
}

// C. Ericson, Real-Time Collision Detection (2005), asks which feature is nearest; here the slow way: the foot of the
// perpendicular where it falls inside, else the nearest of the three edges.
double slow_distance(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const auto to_edge = [&](const Vector3d& from, const Vector3d& to) {
    const double along = std::clamp((p - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
    return (p - from - along * (to - from)).norm();
  };
  const double to_edges = std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
  const Vector3d normal = (b - a).cross(c - a).normalized();
  const Vector3d foot = p - (p - a).dot(normal) * normal;
  const bool inside = normal.dot((b - a).cross(foot - a)) >= 0 && normal.dot((c - b).cross(foot - b)) >= 0 &&
                      normal.dot((a - c).cross(foot - c)) >= 0;
  return inside ? std::abs((p - a).dot(normal)) : to_edges;
}

TEST(NearestPoint, AgreesWithAskingEveryPoint) {
  const auto points = random_points(2000, 100);
  const NearestPoint tree(points);
  for (const Vector3d& asked : random_points(200, 130)) {
    std::vector<double> squared;
    for (const Vector3d& point : points) squared.push_back((point - asked).squaredNorm());
    const auto found = tree.nearest(asked);
    std::vector<double> sorted = squared;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_DOUBLE_EQ(found.squared_distance_mm2, sorted[0]);
    EXPECT_DOUBLE_EQ(squared[static_cast<std::size_t>(found.point)], sorted[0]);

    const auto five = tree.nearest(asked, 5);
    ASSERT_EQ(five.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(five[i].squared_distance_mm2, sorted[i]);

    const auto near = tree.within(asked, 20);
    EXPECT_EQ(near.size(), static_cast<std::size_t>(
                               std::count_if(squared.begin(), squared.end(), [](double d) { return d < 400; })));
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end(), [](const auto& a, const auto& b) {
      return a.squared_distance_mm2 < b.squared_distance_mm2;
    }));
  }
}

TEST(NearestPoint, GivesAllWhereFewerAreThanAskedFor) {
  const NearestPoint tree(random_points(3, 10));
  EXPECT_EQ(tree.nearest(Vector3d::Zero(), 10).size(), 3U);
  EXPECT_TRUE(tree.nearest(Vector3d::Zero(), 0).empty());
}

TEST(SurfaceDistance, AgreesWithAskingEveryTriangle) {
  const Surface sphere = sphere_surface(30, 2, {5, 0, 0});
  const SurfaceDistance tree(sphere);
  for (const Vector3d& asked : random_points(300, 60)) {
    double nearest = 1e9;
    for (const auto& [a, b, c] : sphere.triangles) {
      nearest = std::min(nearest, slow_distance(asked, sphere.points_mm[static_cast<std::size_t>(a)],
                                                sphere.points_mm[static_cast<std::size_t>(b)],
                                                sphere.points_mm[static_cast<std::size_t>(c)]));
    }
    const auto closest = tree.closest(asked);
    EXPECT_NEAR(closest.distance_mm, nearest, 1e-9);
    EXPECT_NEAR((closest.point_mm - asked).norm(), closest.distance_mm, 1e-12);
    const auto& [a, b, c] = sphere.triangles[static_cast<std::size_t>(closest.triangle)];
    EXPECT_NEAR(
        slow_distance(asked, sphere.points_mm[static_cast<std::size_t>(a)],
                      sphere.points_mm[static_cast<std::size_t>(b)], sphere.points_mm[static_cast<std::size_t>(c)]),
        nearest, 1e-9);
  }
}

TEST(SurfaceDistance, TellsInsideFromOutsideEvenOnRaysThroughCorners) {
  // The sphere's own grid of corners and edges lies on the axes and diagonals through these positions.
  const SurfaceDistance tree(sphere_surface(30, 3));
  EXPECT_TRUE(tree.is_inside(Vector3d::Zero()));
  for (const Vector3d& asked : random_points(500, 40)) {
    if (std::abs(asked.norm() - 30) < 0.2) continue;  // chords lie up to 0.15 mm inside the sphere
    EXPECT_EQ(tree.is_inside(asked), asked.norm() < 30) << asked.transpose();
  }
}

TEST(SurfaceDistance, FlatTrianglesArePassedOver) {
  Surface sphere = sphere_surface(10, 1);
  sphere.triangles.insert(sphere.triangles.begin(), {0, 0, 1});
  const auto closest = SurfaceDistance(sphere).closest(sphere.points_mm[0] * 2);
  EXPECT_NEAR(closest.distance_mm, 10, 1e-9);
  EXPECT_GT(closest.triangle, 0);
}

// Squares of distances overflow there; what is nearest does not.
TEST(SurfaceDistance, APlaceAsFarAsNumbersGoHasANearestPoint) {
  const Surface ball = sphere_surface(10, 2);
  const Eigen::Vector3d far_mm(1e308, 0, 0);
  const auto closest = SurfaceDistance(ball).closest(far_mm);
  EXPECT_NEAR(closest.point_mm.x(), 10, 0.5);
  EXPECT_GT(closest.distance_mm, 1e99);
  const auto nearest = NearestPoint(ball.points_mm).nearest(far_mm);
  EXPECT_GT(nearest.squared_distance_mm2, 1e198);
}

TEST(SurfaceDistance, ASurfaceOfLinesAndPointsIsRefusedBefore) {
  Surface flat;
  flat.points_mm = {{0, 0, 0}, {0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {7e5, 7e5, 7e5}};
  flat.triangles = {{0, 1, 2}, {1, 1, 3}, {2, 2, 2}};
  EXPECT_EQ(check_surface(flat).error().code, "surface-flat");
  flat.points_mm[2] = {1, 0, 0};
  EXPECT_TRUE(check_surface(flat));
  flat.points_mm[2] = {1e308, 0, 0};
  EXPECT_EQ(check_surface(flat).error().code, "surface-too-far");
}

TEST(GapBetween, ConcentricSpheresAreTheDifferenceOfTheirRadiiApart) {
  // Chords of the larger sphere sag 0.05 mm with edges of 4.5 mm.
  const SurfaceGap gap = gap_between(sphere_surface(50, 4), sphere_surface(47, 4), 1.0);
  EXPECT_NEAR(gap.hausdorff_mm, 3, 0.1);
  EXPECT_NEAR(gap.mean_mm, 3, 0.1);
}

TEST(GapBetween, SeesABumpFromEitherSide) {
  const Surface smooth = sphere_surface(50, 3);
  Surface bumped = smooth;
  bumped.points_mm[7] *= 1.2;
  EXPECT_NEAR(gap_between(smooth, bumped, 0.5).hausdorff_mm, 10, 0.5);
  EXPECT_DOUBLE_EQ(gap_between(smooth, bumped, 0.5).hausdorff_mm, gap_between(bumped, smooth, 0.5).hausdorff_mm);
  EXPECT_LT(gap_between(smooth, bumped, 0.5).mean_mm, 0.2);
  EXPECT_NEAR(gap_between(smooth, smooth, 1).hausdorff_mm, 0, 1e-9);
}

TEST(SurfaceDistance, ARealTumourLiesInsideItsLiver) {
  GLISSON_NEEDS_DATA("liver_patient_models_ucl");
  const auto folder = test::shared_data() / "liver_patient_models_ucl/models/Liver";
  const auto liver = read_surface(folder / "liver.vtk");
  const auto tumours = read_surface(folder / "liver_tumours.vtk");
  ASSERT_TRUE(liver && tumours);
  const SurfaceDistance tree(*liver);
  const auto inside = std::count_if(tumours->points_mm.begin(), tumours->points_mm.end(),
                                    [&](const Vector3d& point) { return tree.is_inside(point); });
  EXPECT_GT(static_cast<double>(inside), 0.9 * static_cast<double>(tumours->points_mm.size()));
}

}  // namespace
}  // namespace glisson::geometry
