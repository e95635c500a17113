// A line swept along one way: its heights and depths against a plane and a circle, and that it grows without a change.

#include <gmock/gmock.h>

#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

#include "geometry/cut_surface.h"

namespace glisson::geometry {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

const Vector3d into_mm = 20 * Vector3d(0.3, -0.2, -1).normalized();

// Nothing special about the frame.
Vector3d turned(const Vector3d& place_mm) {
  const Vector3d in = into_mm.normalized(), first = in.unitOrthogonal();
  return Vector3d(7, -3, 11) + place_mm.x() * first + place_mm.y() * in.cross(first) + place_mm.z() * in;
}

TEST(SweptLine, StraightItIsThePlaneThroughItAndTheWayIn) {
  std::vector<Vector3d> line;
  for (const double x : {0.0, 2.5, 9.0, 30.0}) line.push_back(turned({x, 0.4 * x, 0.1 * x}));
  const CutSurface swept = CutSurface::swept(line, into_mm).value();
  const CutSurface plane = CutSurface::plane(line[0], into_mm.cross(line[3] - line[0])).value();
  EXPECT_FALSE(swept.is_plane());
  EXPECT_LT((swept.normal() - plane.normal()).norm(), 1e-12);
  const double length_mm = std::hypot(30.0, 12.0);
  for (const Vector3d& at : {Vector3d(3, 7, 2), Vector3d(-20, 5, 40), Vector3d(60, -9, -3), Vector3d(12, 4.8, 1.2)}) {
    EXPECT_NEAR(swept.height_mm(turned(at)), plane.height_mm(turned(at)), 1e-12);
    const double along_mm = (30 * at.x() + 12 * at.y()) / length_mm;
    const CutSurface::OnLine on_line = swept.on_line(turned(at));
    EXPECT_NEAR(on_line.along_mm, along_mm, 1e-12);
    // Beyond its ends the line is as deep as they are.
    EXPECT_NEAR(on_line.deep_mm, at.z() - 3 * std::clamp(along_mm / length_mm, 0.0, 1.0), 1e-12);
  }
}

TEST(SweptLine, AlongACircleItIsAsFarAsTheCircleWithinWhatItsChordsCut) {
  constexpr double radius_mm = 25, step = 0.05;
  std::vector<Vector3d> line;
  for (double angle = 0; angle < std::numbers::pi; angle += step) {
    line.push_back(turned({radius_mm * std::cos(angle), radius_mm * std::sin(angle), 0}));
  }
  const CutSurface swept = CutSurface::swept(line, into_mm).value();
  const double chord_mm = radius_mm * (1 - std::cos(0.5 * step));
  for (const double angle : {0.2, 1.0, 1.57, 2.9}) {
    for (const double r_mm : {4.0, 24.0, 25.0, 26.5, 60.0}) {
      const Vector3d at = turned({r_mm * std::cos(angle), r_mm * std::sin(angle), 8});
      // The circle goes from the first axis to the second, seen against the way in: its middle is to the right.
      EXPECT_NEAR(swept.height_mm(at), radius_mm - r_mm, chord_mm + 1e-12);
      EXPECT_NEAR(swept.on_line(at).along_mm, radius_mm * angle, 0.5 * radius_mm * step);
      EXPECT_NEAR(swept.on_line(at).deep_mm, 8, 1e-12);
    }
  }
}

TEST(SweptLine, DrawnFurtherItIsTheSameToTheBitBesideWhatThereWas) {
  std::vector<Vector3d> line;
  for (double x = 0; x < 40; x += 2.7) line.push_back(turned({x, 6 * std::sin(0.2 * x), 0.02 * x * x}));
  const CutSurface whole = CutSurface::swept(line, into_mm).value();
  const CutSurface part = CutSurface::swept({line.begin(), line.begin() + 8}, into_mm).value();
  EXPECT_TRUE(whole.goes_on(part));
  EXPECT_TRUE(whole.goes_on(whole));
  EXPECT_FALSE(part.goes_on(whole));
  EXPECT_FALSE(whole.is_same(part));
  EXPECT_FALSE(CutSurface::swept(line, 2 * into_mm)->goes_on(part));
  int beside = 0;
  for (double x = -5; x < 15; x += 1.3) {
    for (const double y : {-4.0, 0.0, 3.0}) {
      const Vector3d at = turned({x, y + 6 * std::sin(0.2 * x), 5});
      if (part.on_line(at).along_mm > 14) continue;
      ++beside;
      EXPECT_EQ(whole.height_mm(at), part.height_mm(at));
      EXPECT_EQ(whole.on_line(at).along_mm, part.on_line(at).along_mm);
      EXPECT_EQ(whole.on_line(at).deep_mm, part.on_line(at).deep_mm);
    }
  }
  EXPECT_GT(beside, 20);
}

TEST(SweptLine, RefusesWhatSaysNoWay) {
  const auto why = [](const std::vector<Vector3d>& line, const Vector3d& into) {
    return CutSurface::swept(line, into).error().message();
  };
  EXPECT_THAT(why({{0, 0, 0}}, into_mm), HasSubstr("2 to 2000 places; there are 1"));
  EXPECT_THAT(why({{0, 0, 0}, {1, 0, 0}}, {0, 0, 0}), HasSubstr("a way into the body"));
  EXPECT_THAT(why({{0, 0, 0}, {NAN, 0, 0}}, into_mm), HasSubstr("not finite"));
  EXPECT_THAT(why({{0, 0, 0}, {3, 0, 0}, Vector3d(3, 0, 0) + into_mm}, into_mm), HasSubstr("Places 2 and 3"));
}

}  // namespace
}  // namespace glisson::geometry
