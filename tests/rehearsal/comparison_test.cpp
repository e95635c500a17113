// Two results side by side.

#include "rehearsal/comparison.h"

#include <gmock/gmock.h>

#include "mechanics/bodies.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;

// A cube of 20 mm whose every point is displaced by the same vector.
ComparedResult displaced_by(const Vector3d& shift_mm) {
  ComparedResult result;
  result.mesh = mechanics::test::box(4, 4, 4, {20, 20, 20});
  geometry::Field displacement{mechanics::displacement_field, 3, {}};
  for (std::size_t p = 0; p < result.mesh.points_mm.size(); ++p) {
    displacement.values.insert(displacement.values.end(), shift_mm.data(), shift_mm.data() + 3);
  }
  geometry::set_field(result.mesh.point_fields, displacement);
  const Vector3d rest_mm(3, 3, 3);
  result.landmarks = {{"tumour-1", rest_mm, rest_mm + shift_mm, shift_mm.norm(), 0.0}};
  return result;
}

TEST(Comparison, MeasuresTheDistanceBetweenTheTwoPlacesOfAPoint) {
  const auto comparison = compare(displaced_by({3, 0, 0}), displaced_by({0, 4, 0})).value();
  EXPECT_NEAR(comparison.mean_mm, 5.0, 1e-12);  // 3-4-5, at every point
  EXPECT_NEAR(comparison.max_mm, 5.0, 1e-12);
  EXPECT_FALSE(comparison.max_near_tool_mm);  // no tool, no place near it
  ASSERT_EQ(comparison.landmarks.size(), 1u);
  EXPECT_EQ(comparison.landmarks[0].id, "tumour-1");
  EXPECT_DOUBLE_EQ(comparison.landmarks[0].displacement_a_mm, 3.0);
  EXPECT_DOUBLE_EQ(comparison.landmarks[0].displacement_b_mm, 4.0);
}

TEST(Comparison, FiveMillimetresExactlyAreSignificantAndLessAreNot) {
  EXPECT_TRUE(compare(displaced_by({5, 0, 0}), displaced_by({0, 0, 0}))->significant());
  EXPECT_FALSE(compare(displaced_by({4.999, 0, 0}), displaced_by({0, 0, 0}))->significant());
}

TEST(Comparison, NearTheToolMeansWithinTwiceItsRadius) {
  auto a = displaced_by({0, 0, 0});
  const auto b = displaced_by({0, 0, 0});
  // One corner differs by 7 mm; a tool far from it does not see it, a tool at it does.
  a.mesh.point_fields.front().values[0] = 7.0;
  a.tools = {{Vector3d(20, 20, 20), 5.0, Vector3d(0, 0, 0)}};
  EXPECT_EQ(compare(a, b)->max_near_tool_mm.value(), 0.0);
  a.tools.push_back({Vector3d(0, 9.9, 0), 5.0, Vector3d(0, 0, 0)});
  EXPECT_EQ(compare(a, b)->max_near_tool_mm.value(), 7.0);
  EXPECT_EQ(compare(a, b)->max_mm, 7.0);
}

TEST(Comparison, RefusesResultsOfDifferentMeshes) {
  auto a = displaced_by({0, 0, 0});
  const auto b = displaced_by({0, 0, 0});
  a.mesh.points_mm[7].x() += 0.01;
  EXPECT_EQ(compare(a, b).error().code, "comparison-mismatch");
  a = displaced_by({0, 0, 0});
  a.mesh.cells.pop_back();
  EXPECT_EQ(compare(a, b).error().code, "comparison-mismatch");
  a = displaced_by({0, 0, 0});
  a.mesh.point_fields.clear();
  EXPECT_EQ(compare(a, b).error().code, "comparison-mismatch");
}

TEST(Comparison, RefusesAResultThatMayNotBeUsed) {
  mechanics::Simulation never_run;
  EXPECT_EQ(compare(never_run, never_run).error().code, "comparison-mismatch");
}

}  // namespace
}  // namespace glisson::rehearsal
