// Supports that move by a displacement: closed forms, the force that they need, and what knows none.

#include <gmock/gmock.h>
#include <cmath>

#include "mechanics/bodies.h"
#include "mechanics/scenario/scenario_file.h"
#include "mechanics/simulation.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double length_mm = 20, side_mm = 10, youngs_kPa = 6;

// A bar along x whose sides slide on three planes, so that its stress is uniform.
class DrawnBar : public testing::Test {
 protected:
  DrawnBar() {
    test::name_points(bar, "x0", [](const Vector3d& p) { return p.x() == 0; });
    test::name_points(bar, "y0", [](const Vector3d& p) { return p.y() == 0; });
    test::name_points(bar, "z0", [](const Vector3d& p) { return p.z() == 0; });
    test::name_points(bar, "end", [](const Vector3d& p) { return p.x() == length_mm; });
    test::disturb_inner_points(bar, 0.3);
    scenario.youngs_modulus = youngs_kPa;
    scenario.supports = {test::held_along("x0", true, false, false), test::held_along("y0", false, true, false),
                         test::held_along("z0", false, false, true)};
  }
  void draw_end_by(double x_mm) {
    scenario.supports.push_back({NamedPoints{"end"}, Fixed{{true, false, false}, {x_mm, 0, 0}}});
  }
  [[nodiscard]] std::string refusal() const {
    const auto simulation = simulate(bar, scenario);
    return simulation ? "accepted" : simulation.error().code + ": " + simulation.error().message();
  }
  geometry::TetMesh bar = test::box(4, 2, 2, {length_mm, side_mm, side_mm});
  Scenario scenario;
};

TEST_F(DrawnBar, LinearElasticityThinsItByPoissonsRatioAndNeedsHookesForce) {
  scenario.poisson_ratio = 0.45;
  draw_end_by(2.0);
  const Simulation drawn = simulate(bar, scenario).value();
  ASSERT_TRUE(drawn.result.may_be_used()) << drawn.result.why_stopped;
  const double strain = 2.0 / length_mm;
  for (std::size_t p = 0; p < bar.points_mm.size(); ++p) {
    const Vector3d thinned = strain * bar.points_mm[p].cwiseProduct(Vector3d(1, -0.45, -0.45));
    EXPECT_LT((drawn.result.displacement_mm[p] - thinned).norm(), 1e-9);
  }
  const double force_mN = youngs_kPa * strain * side_mm * side_mm;
  ASSERT_EQ(drawn.result.support_reaction_mN.size(), 4U);
  EXPECT_LT((drawn.result.support_reaction_mN[3] - Vector3d(force_mN, 0, 0)).norm(), 1e-8 * force_mN);
  EXPECT_LT((drawn.result.support_reaction_mN[0] + Vector3d(force_mN, 0, 0)).norm(), 1e-8 * force_mN);
  EXPECT_NEAR(drawn.result.strain_energy_uJ, 0.5 * force_mN * 2.0, 1e-6 * force_mN);
}

TEST_F(DrawnBar, CorotationalElasticityReachesTheClosedFormFarFromRest) {
  // Poisson's ratio 0: the sides stay, and the nominal stress is E (s - 1).
  scenario.poisson_ratio = 0.0;
  scenario.material = MaterialLaw::corotational;
  draw_end_by(10.0);
  const Simulation drawn = simulate(bar, scenario).value();
  ASSERT_TRUE(drawn.result.may_be_used()) << drawn.result.why_stopped;
  for (std::size_t p = 0; p < bar.points_mm.size(); ++p) {
    EXPECT_LT((drawn.result.displacement_mm[p] - Vector3d(0.5 * bar.points_mm[p].x(), 0, 0)).norm(), 1e-4);
  }
  const double force_mN = 0.5 * youngs_kPa * side_mm * side_mm;
  EXPECT_NEAR(drawn.result.support_reaction_mN[3].x(), force_mN, 1e-5 * force_mN);
}

// The judge loads the end instead, with a dead load: another path through the solver to the same state.
TEST_F(DrawnBar, NeoHookeanNeedsTheForceThatStretchesItAsFar) {
  scenario.poisson_ratio = 0.45;
  scenario.material = MaterialLaw::neo_hookean;
  Scenario pulled = scenario;
  const double force_mN = 250;
  pulled.loads = {ToolLoad{{length_mm, side_mm / 2, side_mm / 2}, 5.5, {force_mN, 0, 0}}};
  const Simulation under_load = simulate(bar, pulled).value();
  ASSERT_TRUE(under_load.result.may_be_used()) << under_load.result.why_stopped;
  double stretch_mm = 0;
  int at_end = 0;
  for (std::size_t p = 0; p < bar.points_mm.size(); ++p) {
    if (bar.points_mm[p].x() != length_mm) continue;
    stretch_mm += under_load.result.displacement_mm[p].x();
    ++at_end;
  }
  stretch_mm /= at_end;
  ASSERT_GT(stretch_mm, 0.3 * length_mm);

  draw_end_by(stretch_mm);
  const Simulation drawn = simulate(bar, scenario).value();
  ASSERT_TRUE(drawn.result.may_be_used()) << drawn.result.why_stopped;
  EXPECT_NEAR(drawn.result.support_reaction_mN[3].x(), force_mN, 1e-3 * force_mN);
  for (std::size_t p = 0; p < bar.points_mm.size(); ++p) {
    EXPECT_LT((drawn.result.displacement_mm[p] - under_load.result.displacement_mm[p]).norm(), 0.02);
  }
}

TEST_F(DrawnBar, ASqueezeToLessThanHalfLeavesNoCellInsideOut) {
  // The interior has to come along: with the end alone moved by 12 mm cells would turn inside out.
  scenario.poisson_ratio = 0.3;
  scenario.material = MaterialLaw::neo_hookean;
  draw_end_by(-12.0);
  const Simulation squeezed = simulate(bar, scenario).value();
  ASSERT_TRUE(squeezed.result.may_be_used()) << squeezed.result.why_stopped;
  EXPECT_EQ(squeezed.result.inverted_cells, 0);
  EXPECT_LT(squeezed.result.support_reaction_mN[3].x(), 0);
  EXPECT_NEAR(squeezed.result.max_displacement_mm, 12.0, 3.0);
}

TEST_F(DrawnBar, WhatKnowsNoPrescribedDisplacementRefusesIt) {
  draw_end_by(1.0);
  const Scenario asked = scenario;
  scenario.engine = Engine::meshfree;
  EXPECT_THAT(refusal(), HasSubstr("not-available: A support that moves by a displacement"));
  scenario = asked;
  scenario.motion = Motion{0.01, 3, 0, 0};
  EXPECT_THAT(refusal(), HasSubstr("not-available: A support that moves by a displacement"));
  scenario = asked;
  ScenarioGrasp jaws;
  jaws.center_mm = {10, 10, 5};
  jaws.radius_mm = 3;
  scenario.tools = {{"jaws", jaws}};
  EXPECT_THAT(refusal(), HasSubstr("not-available: A support that moves by a displacement"));
}

TEST_F(DrawnBar, TwoSupportsThatMoveOnePointApartAreRefused) {
  draw_end_by(1.0);
  draw_end_by(2.0);
  EXPECT_THAT(refusal(), HasSubstr("support-contradicts: Support 5 moves points that another support holds"));
  std::get<Fixed>(scenario.supports.back().how).displacement_mm.x() = 1.0;
  EXPECT_EQ(refusal(), "accepted");
  std::get<Fixed>(scenario.supports.back().how).displacement_mm.x() = std::nan("");
  EXPECT_THAT(refusal(), HasSubstr("support-invalid"));
}

TEST(PrescribedDisplacement, IsReadWrittenAndRefusedInScenarios) {
  const Scenario read =
      parse_scenario(
          R"({"supports": [{"point_array": "a", "directions": ["x", "y"], "displacement_mm": [1.5, -2, 0]}]})")
          .value();
  const auto& moved = std::get<Fixed>(read.supports[0].how);
  EXPECT_EQ(moved.displacement_mm, Vector3d(1.5, -2, 0));
  EXPECT_EQ(scenario_text(parse_scenario(scenario_text(read)).value()), scenario_text(read));
  const std::pair<const char*, const char*> refused[] = {
      {R"({"supports": [{"point_array": "a", "displacement_mm": [0, 1]}]})", "must be three numbers"},
      {R"({"supports": [{"point_array": "a", "directions": ["x"], "displacement_mm": [0, 1, 0]}]})", "leave free"},
      {R"({"supports": [{"point_array": "a", "foundation_kPa_per_mm": 1, "displacement_mm": [0, 1, 0]}]})",
       "neither a foundation nor a ligament"},
  };
  for (const auto& [json, expected] : refused) {
    const auto answer = parse_scenario(json);
    ASSERT_FALSE(answer) << json;
    EXPECT_THAT(answer.error().message(), HasSubstr(expected));
  }
}

}  // namespace
}  // namespace glisson::mechanics
