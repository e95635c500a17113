// The live rehearsal answers what a full solve would, and quickly.

#include "rehearsal/static_rehearsal.h"

#include <gmock/gmock.h>
#include <cmath>
#include <future>

#include "base/units.h"
#include "mechanics/bodies.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::test::box;
using mechanics::test::fixed;

RehearsalSetup slab() {
  RehearsalSetup setup;
  setup.mesh = box(8, 6, 4, {80, 60, 40});
  mechanics::test::name_points(setup.mesh, "back", [](const Vector3d& p) { return p.y() == 60; });
  for (std::size_t c = 0; c < setup.mesh.cells.size(); ++c) setup.patient_youngs_kPa.push_back(4.0 + 0.5 * (c % 9));
  setup.reference_youngs_kPa = 6.0;
  setup.supports = {fixed("back")};
  setup.standing_loads = {mechanics::GravityLoad{{0, 9810, 0}}};
  setup.landmarks = {{"tumour-1", {40, 20, 25}}, {"tumour-2", {12, 11, 9}}};
  geometry::Surface tumour;
  tumour.points_mm = {{40, 20, 20}, {45, 20, 20}, {40, 25, 20}, {40, 20, 25}};
  tumour.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  setup.structures = {tumour};
  return setup;
}

const Vector3d tool_center_mm(40, 0, 20);
constexpr double tool_radius_mm = 12;

TEST(StaticRehearsal, AnswersWhatAFullSolveOfBothBodiesWould) {
  const RehearsalSetup setup = slab();
  const auto rehearsal = StaticRehearsal::create(setup).value();
  const auto tool = rehearsal.place_tool(tool_center_mm, tool_radius_mm).value();
  for (const Vector3d& force_N : {Vector3d(0, 0, 0), Vector3d(0.1, -0.2, 0.3)}) {
    const RehearsalState state = tool.answer(force_N);
    mechanics::Loads loads = setup.standing_loads;
    loads.push_back(mechanics::ToolLoad{tool_center_mm, tool_radius_mm, force_N.unaryExpr(&units::mN_from_N)});
    const auto full = rehearsal.patient().solve(loads).value();
    const auto reference = rehearsal.models()->reference->model()->solve(loads).value();

    // Superposition is exact: only rounding of displacements of about 10 mm remains.
    const auto& mesh_point = geometry::find_field(rehearsal.surface().point_fields, "mesh_point")->values;
    for (std::size_t p = 0; p < mesh_point.size(); ++p) {
      const auto point = static_cast<std::size_t>(mesh_point[p]);
      EXPECT_LT((state.patient.surface_mm[p] - setup.mesh.points_mm[point] - full.displacement_mm[point]).norm(), 1e-9);
      EXPECT_LT(
          (state.reference->surface_mm[p] - setup.mesh.points_mm[point] - reference.displacement_mm[point]).norm(),
          1e-9);
    }
    const auto places = mechanics::locate_points(setup.mesh, {setup.landmarks[0].position_mm, {45, 20, 20}});
    const auto moved = rehearsal.patient().displacement_at(full, places);
    EXPECT_LT((state.patient.landmarks[0].displaced_mm - setup.landmarks[0].position_mm - moved[0]).norm(), 1e-9);
    EXPECT_LT((state.patient.structures_mm[0][1] - Vector3d(45, 20, 20) - moved[1]).norm(), 1e-9);
    EXPECT_NEAR(state.validity.largest_strain, full.largest_strain, 1e-9);
    EXPECT_LE(state.relative_residual, 1e-9);

    const auto saved = tool.patient_displacement_mm(force_N);
    for (std::size_t p = 0; p < saved.size(); ++p) EXPECT_LT((saved[p] - full.displacement_mm[p]).norm(), 1e-9);
  }
}

TEST(StaticRehearsal, SaysTheLargestStrainThatAFullSolveFindsWhateverTheDirection) {
  // Where no corner but the one that the bound promises most were looked at, some of these would be too small.
  const RehearsalSetup setup = slab();
  const auto rehearsal = StaticRehearsal::create(setup).value();
  const auto tool = rehearsal.place_tool(tool_center_mm, tool_radius_mm).value();
  for (int i = 0; i < 12; ++i) {
    const Vector3d force_N = 0.05 * i * Vector3d(std::cos(i), std::sin(2 * i), std::cos(3 * i));
    mechanics::Loads loads = setup.standing_loads;
    loads.push_back(mechanics::ToolLoad{tool_center_mm, tool_radius_mm, force_N.unaryExpr(&units::mN_from_N)});
    EXPECT_NEAR(tool.answer(force_N).validity.largest_strain, rehearsal.patient().solve(loads)->largest_strain, 1e-9)
        << i;
  }
}

TEST(StaticRehearsal, CountsTheCellsTurnedInsideOutAsAFullSolveDoes) {
  const RehearsalSetup setup = slab();
  const auto rehearsal = StaticRehearsal::create(setup).value();
  const auto tool = rehearsal.place_tool(tool_center_mm, tool_radius_mm).value();
  int maximum = 0;
  for (const Vector3d& force_N : {Vector3d(0, 0, -4), Vector3d(0, 30, 0), Vector3d(10, 60, -20)}) {
    mechanics::Loads loads = setup.standing_loads;
    loads.push_back(mechanics::ToolLoad{tool_center_mm, tool_radius_mm, force_N.unaryExpr(&units::mN_from_N)});
    const mechanics::Validity validity = tool.answer(force_N).validity;
    EXPECT_EQ(validity.inverted_cells, rehearsal.patient().solve(loads)->inverted_cells) << force_N.transpose();
    EXPECT_EQ(validity.usable(), validity.inverted_cells == 0);
    maximum = std::max(maximum, validity.inverted_cells);
  }
  EXPECT_GT(maximum, 0);
}

TEST(StaticRehearsal, KnowsTheForceAtWhichTheModelEnds) {
  const auto rehearsal = StaticRehearsal::create(slab()).value();
  const auto tool = rehearsal.place_tool(tool_center_mm, tool_radius_mm).value();
  const Vector3d direction = Vector3d(0.2, -1, 0.5).normalized();
  constexpr double maximum_N = 20;
  const double within_N = tool.force_within_the_model_N(direction, maximum_N);
  ASSERT_GT(within_N, 0);
  ASSERT_LT(within_N, maximum_N);
  EXPECT_EQ(tool.answer(within_N * direction).validity.state(), mechanics::AnswerState::within);
  EXPECT_NE(tool.answer((within_N + 0.01 * maximum_N) * direction).validity.state(), mechanics::AnswerState::within);
  EXPECT_EQ(tool.force_within_the_model_N(direction, 0.5 * within_N), 0.5 * within_N);
}

TEST(StaticRehearsal, ComparesEachLandmarkWithTheReferenceBody) {
  const auto rehearsal = StaticRehearsal::create(slab()).value();
  const auto state = rehearsal.place_tool(tool_center_mm, tool_radius_mm)->answer({0, -1, 0});
  ASSERT_EQ(state.differences.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(state.differences[i].difference_mm,
                (state.patient.landmarks[i].displaced_mm - state.reference->landmarks[i].displaced_mm).norm(), 1e-12);
  }
  EXPECT_GT(state.max_difference_mm, 0);
}

TEST(StaticRehearsal, GoesWithoutATwinWhereNoneIsAsked) {
  RehearsalSetup setup = slab();
  setup.reference_youngs_kPa.reset();
  const auto rehearsal = StaticRehearsal::create(std::move(setup)).value();
  EXPECT_FALSE(rehearsal.has_reference());
  EXPECT_TRUE(rehearsal.reference_is_made());
  const auto state = rehearsal.place_tool(tool_center_mm, tool_radius_mm)->answer({0, -1, 0});
  EXPECT_FALSE(state.reference);
  EXPECT_TRUE(state.differences.empty());
}

// What lies there unused would take as much memory as the patient.
TEST(StaticRehearsal, MakesItsReferenceBodyForTheFirstToolOnBothAndForNobodyBefore) {
  const auto rehearsal = StaticRehearsal::create(slab()).value();
  EXPECT_TRUE(rehearsal.has_reference());
  EXPECT_FALSE(rehearsal.reference_is_made());
  const auto alone = rehearsal.place_tool(tool_center_mm, tool_radius_mm, StaticRehearsal::On::patient).value();
  EXPECT_FALSE(rehearsal.reference_is_made());
  EXPECT_FALSE(alone.compared());
  const RehearsalState before = alone.answer({0, -1, 0});
  EXPECT_FALSE(before.reference);
  EXPECT_TRUE(before.differences.empty());

  // Asked for by several at once it is made once, and the patient's answer is the same to the bit.
  std::vector<std::future<Result<PlacedTool>>> asked;
  for (int k = 0; k < 3; ++k) {
    asked.push_back(
        std::async(std::launch::async, [&] { return rehearsal.place_tool(tool_center_mm, tool_radius_mm); }));
  }
  for (auto& one : asked) {
    const auto both = one.get().value();
    EXPECT_TRUE(both.compared());
    EXPECT_EQ(both.answer({0, -1, 0}).patient.surface_mm, before.patient.surface_mm);
  }
  EXPECT_TRUE(rehearsal.reference_is_made());
  EXPECT_TRUE(rehearsal.make_reference());
}

// In the patient's order of elimination, as if it had been made by itself.
TEST(StaticRehearsal, TheReferenceBodyIsTheOneThatItsModulusMakes) {
  const RehearsalSetup setup = slab();
  const auto rehearsal = StaticRehearsal::create(setup).value();
  const auto own = mechanics::StaticModel::create(
      setup.mesh, std::vector<double>(setup.mesh.cells.size(), *setup.reference_youngs_kPa), setup.supports);
  ASSERT_TRUE(own);
  const auto reference = rehearsal.models()->reference->model().value();
  EXPECT_EQ(reference.solve(setup.standing_loads)->displacement_mm, own->solve(setup.standing_loads)->displacement_mm);
  EXPECT_EQ(reference.cost().factor_bytes, own->cost().factor_bytes);
}

TEST(StaticRehearsal, RefusesAToolInTheAirAndALandmarkFarOutside) {
  const auto rehearsal = StaticRehearsal::create(slab()).value();
  EXPECT_EQ(rehearsal.place_tool({40, -50, 20}, 5).error().code, "tool-touches-nothing");
  RehearsalSetup setup = slab();
  setup.landmarks.push_back({"elsewhere", {500, 0, 0}});
  const auto refused = StaticRehearsal::create(std::move(setup));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "landmark-outside");
  EXPECT_THAT(refused.error().message(), testing::HasSubstr("elsewhere"));
}

TEST(StaticRehearsal, APlacedToolOutlivesItsRehearsal) {
  std::optional<PlacedTool> tool;
  {
    const auto rehearsal = StaticRehearsal::create(slab()).value();
    tool = rehearsal.place_tool(tool_center_mm, tool_radius_mm).value();
  }
  EXPECT_GT(tool->answer({0, -1, 0}).patient.max_displacement_mm, 0);
}

TEST(StaticRehearsal, AMovedForceIsAnsweredInUnderAMillisecond) {
  RehearsalSetup setup = slab();
  const auto rehearsal = StaticRehearsal::create(std::move(setup)).value();
  const auto tool = rehearsal.place_tool(tool_center_mm, tool_radius_mm).value();
  double best_ms = 1e9;  // of ten, so that a busy machine does not fail the test
  for (int i = 0; i < 10; ++i) best_ms = std::min(best_ms, tool.answer({0, -0.1 * i, 0}).answer_ms);
  EXPECT_LT(best_ms, 1.0);
}

}  // namespace
}  // namespace glisson::rehearsal
