// Rigid alignment, thin-plate splines and non-rigid ICP.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "geometry/mesh_file.h"
#include "registration/nonrigid_icp.h"
#include "registration/rigid.h"
#include "registration/thin_plate.h"
#include "support/data.h"

namespace glisson::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using geometry::Surface;

std::vector<Vector3d> random_points(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> in_cube(-50, 50);
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) points.emplace_back(in_cube(random), in_cube(random), in_cube(random));
  return points;
}

Isometry3d some_motion() {
  return Eigen::Translation3d(10, -20, 5) * Eigen::AngleAxisd(2.5, Vector3d(1, 2, -1).normalized());
}

double mean_distance_mm(const Surface& a, const Surface& b) {
  double sum_mm = 0;
  for (std::size_t i = 0; i < a.points_mm.size(); ++i) sum_mm += (a.points_mm[i] - b.points_mm[i]).norm();
  return sum_mm / static_cast<double>(a.points_mm.size());
}

Surface liver(const char* file) {
  return geometry::read_surface(glisson::test::shared_data() / "pbsm_liver_insilico" / "Liver1" / file).value();
}

TEST(AlignPoints, FindsAMotionAgain) {
  const auto from = random_points(10, 1);
  std::vector<Vector3d> to;
  for (const Vector3d& point : from) to.push_back(some_motion() * point);
  EXPECT_TRUE(align_points(from, to).value().isApprox(some_motion(), 1e-12));
  to[3] += Vector3d(100, 0, 0);  // an outlier that does not count
  std::vector<double> weights(10, 1.0);
  weights[3] = 0;
  EXPECT_TRUE(align_points(from, to, weights).value().isApprox(some_motion(), 1e-12));
}

TEST(AlignPoints, NeverReflects) {
  auto from = random_points(10, 2);
  std::vector<Vector3d> to;
  for (const Vector3d& point : from) to.emplace_back(-point.x(), point.y(), point.z());
  EXPECT_NEAR(align_points(from, to).value().linear().determinant(), 1, 1e-12);
}

TEST(AlignPoints, RefusesTooFewPointsAndLines) {
  EXPECT_EQ(align_points({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}).error().code, "alignment-too-few-points");
  const std::vector<Vector3d> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}};
  EXPECT_EQ(align_points(line, line).error().code, "alignment-too-few-points");
  EXPECT_EQ(align_points(line, {{0, 0, 0}}).error().code, "alignment-sizes");
  auto bad = line;
  bad[1].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(align_points(bad, line).error().code, "alignment-sizes");
}

TEST(ThinPlate, GoesThroughItsPointsAndKeepsAffineMaps) {
  const auto from = random_points(30, 3);
  const auto noise = random_points(30, 4);
  std::vector<Vector3d> bent, straight;
  Eigen::Matrix3d shear;
  shear << 1.1, 0.2, 0, 0, 0.9, 0.1, 0.3, 0, 1;
  for (std::size_t i = 0; i < 30; ++i) {
    bent.push_back(from[i] + 0.1 * noise[i]);
    straight.push_back(shear * from[i] + Vector3d(1, 2, 3));
  }
  const auto warp = ThinPlateSpline::fit(from, bent).value();
  for (std::size_t i = 0; i < 30; ++i) EXPECT_LT((warp(from[i]) - bent[i]).norm(), 1e-9);
  const auto affine = ThinPlateSpline::fit(from, straight).value();
  for (const Vector3d& point : random_points(10, 5)) {
    EXPECT_LT((affine(point) - shear * point - Vector3d(1, 2, 3)).norm(), 1e-9);
    EXPECT_TRUE(affine.jacobian(point).isApprox(shear, 1e-9));
  }
}

TEST(ThinPlate, DerivativeIsThatOfTheWarp) {
  const auto from = random_points(20, 6);
  auto to = from;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += 0.1 * random_points(20, 7)[i];
  const auto warp = ThinPlateSpline::fit(from, to).value();
  const Vector3d at(3, 4, 5);
  const double h = 1e-5;  // central differences: error h^2 against rounding 1e-16 / h
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d step = h * Vector3d::Unit(axis);
    EXPECT_LT(((warp(at + step) - warp(at - step)) / (2 * h) - warp.jacobian(at).col(axis)).norm(), 1e-7);
  }
}

TEST(ThinPlate, FollowsALonePointTheLessTheStifferItIs) {
  const auto from = random_points(40, 8);
  auto to = from;
  to[0] += Vector3d(10, 0, 0);
  double before_mm = std::numeric_limits<double>::infinity();
  for (const double stiffness_mm : {0.0, 10.0, 100.0}) {
    const double followed_mm = (ThinPlateSpline::fit(from, to, stiffness_mm).value()(from[0]) - from[0]).norm();
    EXPECT_LT(followed_mm, before_mm);
    before_mm = followed_mm;
  }
  EXPECT_LT(before_mm, 5);
}

TEST(ThinPlate, RefusesPlanesAndMergesDuplicates) {
  std::vector<Vector3d> flat = random_points(10, 9);
  for (Vector3d& point : flat) point.z() = 0;
  EXPECT_EQ(ThinPlateSpline::fit(flat, flat).error().code, "spline-too-few-points");
  auto from = random_points(10, 10);
  auto to = from;
  from.push_back(from[0]);
  to.push_back(to[0] + Vector3d(2, 0, 0));
  EXPECT_LT((ThinPlateSpline::fit(from, to).value()(from[0]) - from[0] - Vector3d(1, 0, 0)).norm(), 1e-9);
}

TEST(RigidIcp, FindsASmallMotionAgain) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Surface target = liver("tgt.ply");
  const Isometry3d motion = Eigen::Translation3d(5, -4, 3) * Eigen::AngleAxisd(0.1, Vector3d::UnitY());
  const RigidIcpResult result = rigid_icp(moved(target, motion.inverse()), target, {.iterations = 300}).value();
  // It stops when steps fall below 1e-3 mm, some way before the end of a slow linear convergence.
  EXPECT_LT(mean_distance_mm(moved(moved(target, motion.inverse()), result.transform), target), 0.2);
}

// The truth is the whole liver; only its front was given.
TEST(NonrigidIcp, BringsAWholeLiverNearerToItsDeformedFrontThanAnyRigidMotion) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Surface source = liver("src.ply");
  const Surface target = liver("tgt.ply");
  const Surface truth = liver("gt.ply");
  const RigidIcpResult rigid = rigid_icp(source, target).value();
  const Surface aligned = moved(source, rigid.transform);
  EXPECT_LT(mean_distance_mm(aligned, truth), 5.0);
  const NonrigidIcpResult result = nonrigid_icp(aligned, target).value();
  EXPECT_LT(result.rms_mm, 0.7);
  const Surface best = moved(source, align_points(source.points_mm, truth.points_mm).value());
  const double best_mm = mean_distance_mm(best, truth), after_mm = mean_distance_mm(result.surface, truth);
  EXPECT_LT(after_mm, best_mm);
  fmt::print("whole liver: {:.2f} mm off before, {:.2f} by the best rigid motion that knows the truth, {:.2f} after\n",
             mean_distance_mm(source, truth), best_mm, after_mm);
}

TEST(NonrigidIcp, RefusesUnknownLandmarksAndFarSurfaces) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Surface target = liver("tgt.ply");
  EXPECT_EQ(nonrigid_icp(target, target, {.landmarks = {{-1, {0, 0, 0}}}}).error().code, "landmark-unknown");
  const Isometry3d far_away(Eigen::Translation3d(1e4, 0, 0));
  EXPECT_EQ(nonrigid_icp(moved(target, far_away), target).error().code, "registration-no-pairs");
}

}  // namespace
}  // namespace glisson::registration
