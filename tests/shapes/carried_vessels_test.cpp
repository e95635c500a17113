// Vessels carried along by a shape's warp: exact where the warp is known, inside every liver drawn, the same tree, and
// no vessel into another that it did not touch before. Nobody's livers throughout.

#include "shapes/carried_vessels.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

#include "shapes/drawn_liver.h"
#include "shapes/smooth_model.h"
#include "vasculature/tree_file.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using vasculature::CenterPoint;
using vasculature::TreeBranch;

const LiverWithVessels& reference() {
  static const LiverWithVessels made = reference_vessels().value();
  return made;
}

const ShapeModel& smooth() {
  static const ShapeModel made = smooth_model({.reference_spacing_mm = 7}).value();
  return made;
}

geometry::Surface mapped(geometry::Surface surface, const Eigen::Affine3d& map) {
  for (Vector3d& point : surface.points_mm) point = map * point;
  return surface;
}

// The solid angle of a closed surface seen from inside is 4 pi, from outside 0 (Van Oosterom and Strackee 1983).
double windings(const geometry::Surface& surface, const Vector3d& from_mm) {
  double sum = 0;
  for (const auto& triangle : surface.triangles) {
    std::array<Vector3d, 3> to;
    for (std::size_t c = 0; c < 3; ++c) to[c] = surface.points_mm[std::size_t(triangle[c])] - from_mm;
    const double a = to[0].norm(), b = to[1].norm(), c = to[2].norm();
    sum += 2 * std::atan2(to[0].dot(to[1].cross(to[2])),
                          a * b * c + to[0].dot(to[1]) * c + to[0].dot(to[2]) * b + to[1].dot(to[2]) * a);
  }
  return sum / (4 * std::numbers::pi);
}

// Over all pairs of points: how far walls reach into each other that did not touch before.
double deepest_new_touch_mm(const vasculature::VesselTrees& before, const vasculature::VesselTrees& after) {
  std::vector<CenterPoint> was, is;
  for (std::size_t b = 0; b < after.branches.size(); ++b) {
    was.insert(was.end(), before.branches[b].points.begin(), before.branches[b].points.end());
    is.insert(is.end(), after.branches[b].points.begin(), after.branches[b].points.end());
  }
  const auto gap_mm = [](const CenterPoint& a, const CenterPoint& b) {
    return (a.position_mm - b.position_mm).norm() - a.radius_mm - b.radius_mm;
  };
  double deepest = 0;
  for (std::size_t i = 0; i < is.size(); ++i) {
    for (std::size_t j = i + 1; j < is.size(); ++j) {
      const double now = gap_mm(is[i], is[j]);
      if (now < -deepest && gap_mm(was[i], was[j]) >= 0) deepest = -now;
    }
  }
  return deepest;
}

}  // namespace

TEST(CarriedVessels, TheReferenceHasTreesOfAllSystemsWhoseTwigsLieInIt) {
  std::array<int, 3> branches{};
  std::vector<int> children(reference().trees.branches.size(), 0);
  for (const TreeBranch& branch : reference().trees.branches) {
    ++branches[std::size_t(branch.system)];
    if (branch.parent >= 0) ++children[std::size_t(branch.parent)];
  }
  EXPECT_GT(branches[0], 400);
  EXPECT_GT(branches[1], 300);
  EXPECT_GT(branches[2], 100);
  std::size_t below = 0, all = 0;
  for (std::size_t b = 0; b < children.size(); ++b) {
    if (children[b] == 0) {
      EXPECT_GE(reference().depth_mm[b].back(), shallow_mm);
    }
    for (const double depth_mm : reference().depth_mm[b]) below += depth_mm < shallow_mm ? 1 : 0, ++all;
  }
  EXPECT_LT(double(below), 0.05 * double(all));  // the trunks, in the porta and at the vena cava
}

TEST(CarriedVessels, AnAffineWarpCarriesThemExactly) {
  Eigen::Affine3d map = Eigen::Translation3d(10, -20, 5) * Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()) *
                        Eigen::Scaling(1.2, 0.9, 1.1);
  const auto carried = carry_vessels(reference(), mapped(reference().surface, map));
  ASSERT_TRUE(carried) << carried.error().message();
  const double ratio = 1.2 * 0.9 * 1.1;
  EXPECT_EQ(carried->pulled_in, 0);
  double narrowest = 1;
  for (std::size_t b = 0; b < carried->trees.branches.size(); ++b) {
    const TreeBranch &was = reference().trees.branches[b], &is = carried->trees.branches[b];
    ASSERT_EQ(is.points.size(), was.points.size());
    for (std::size_t i = 0; i < is.points.size(); ++i) {
      EXPECT_LT((is.points[i].position_mm - map * was.points[i].position_mm).norm(), 1e-5);
      const double kept = is.points[i].radius_mm / (was.points[i].radius_mm * std::cbrt(ratio));
      EXPECT_LE(kept, 1 + 1e-6);
      narrowest = std::min(narrowest, kept);
    }
  }
  EXPECT_GT(narrowest, 0.8);  // where walls would have met, squeezed by 0.9
}

TEST(CarriedVessels, LieInEveryLiverDrawnAsTheSameTrees) {
  for (std::uint64_t number = 1; number <= 4; ++number) {
    const DrawnLiver liver = draw_liver(smooth(), 3, number).value();
    const auto carried = carry_vessels(reference(), liver.surface);
    ASSERT_TRUE(carried) << carried.error().message();
    EXPECT_EQ(carried->cut_off + carried->outside, 0);
    const auto& before = reference().trees.branches;
    const auto& after = carried->trees.branches;
    ASSERT_EQ(after.size(), before.size());
    const auto depths = depths_mm(carried->trees, liver.surface);
    std::size_t looked_at = 0;
    for (std::size_t b = 0; b < after.size(); ++b) {
      EXPECT_EQ(after[b].parent, before[b].parent);
      EXPECT_EQ(after[b].system, before[b].system);
      EXPECT_EQ(after[b].name, before[b].name);
      ASSERT_EQ(after[b].points.size(), before[b].points.size());
      if (after[b].parent >= 0) {  // it still begins on its parent
        double nearest_mm = 1e9;
        for (const CenterPoint& point : after[std::size_t(after[b].parent)].points) {
          nearest_mm = std::min(nearest_mm, (point.position_mm - after[b].points.front().position_mm).norm());
        }
        EXPECT_LT(nearest_mm, 1e-9);
      }
      for (std::size_t i = 0; i < after[b].points.size(); ++i) {
        if (reference().depth_mm[b][i] < shallow_mm) continue;
        EXPECT_GT(depths[b][i], pulled_under_mm - 1e-6);
        if (++looked_at % 40 != 0) continue;
        EXPECT_NEAR(windings(liver.surface, after[b].points[i].position_mm), 1, 1e-6);
      }
    }
    EXPECT_GT(looked_at, 5000u);
    EXPECT_LT(deepest_new_touch_mm(reference().trees, carried->trees), 1e-9);
  }
}

TEST(CarriedVessels, AMirroredLiverOrAnotherSurfaceIsRefused) {
  const auto mirrored =
      carry_vessels(reference(), mapped(reference().surface, Eigen::Affine3d(Eigen::Scaling(-0.9, 1.0, 1.0))));
  ASSERT_FALSE(mirrored);
  EXPECT_EQ(mirrored.error().code, "vessels-fold");
  geometry::Surface other = reference().surface;
  other.triangles.pop_back();
  EXPECT_EQ(carry_vessels(reference(), other).error().code, "vessels-not-corresponding");
}

}  // namespace glisson::shapes
