// A scenario on a mesh, from question to answer.

#include "mechanics/simulation.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/LU>
#include <limits>
#include <set>

#include "mechanics/bodies.h"
#include "mechanics/contact/large_contact.h"
#include "mechanics/scenario/scenario_file.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

class Simulating : public testing::Test {
 protected:
  Simulating() {
    test::name_points(mesh, "fixed", [](const Vector3d& p) { return p.z() == 0; });
    scenario.youngs_modulus = 5.0;
    scenario.supports = {test::fixed("fixed")};
    scenario.loads = {ToolLoad{{15, 15, 30}, 8, {20, 0, 50}}};
    scenario.landmarks = {{"inside", {15, 15, 20}}, {"just-outside", {15, 15, 32}}};
  }
  std::string refusal() {
    const auto simulation = simulate(mesh, scenario);
    return simulation ? "accepted" : simulation.error().code + ": " + simulation.error().message();
  }
  geometry::TetMesh mesh = test::box(4, 4, 4, {30, 30, 30});
  Scenario scenario;
};

TEST_F(Simulating, FollowsItsLandmarksAndNamesTheFields) {
  const auto simulation = simulate(mesh, scenario).value();
  ASSERT_TRUE(simulation.result.may_be_used());
  EXPECT_EQ(simulation.result.notes.size(), 1u);
  EXPECT_THAT(simulation.result.notes[0], HasSubstr("just-outside lies 2.0 mm outside"));
  ASSERT_EQ(simulation.landmarks.size(), 2u);
  const DisplacedLandmark& inside = simulation.landmarks[0];
  EXPECT_EQ(inside.id, "inside");
  EXPECT_EQ(inside.outside_by_mm, 0);
  EXPECT_GT(inside.displacement_mm, 0);
  EXPECT_NEAR((inside.displaced_mm - inside.rest_mm).norm(), inside.displacement_mm, 1e-12);
  const geometry::Field* displacement = geometry::find_field(simulation.mesh.point_fields, displacement_field);
  ASSERT_NE(displacement, nullptr);
  EXPECT_EQ(displacement->items(), mesh.points_mm.size());
  EXPECT_EQ(geometry::find_field(simulation.mesh.cell_fields, youngs_modulus_field)->values, test::uniform(mesh, 5.0));
  EXPECT_NE(geometry::find_field(simulation.mesh.cell_fields, "von_mises_kPa"), nullptr);
}

TEST_F(Simulating, ALandmarkOnAMeshPointMovesAsThatPoint) {
  scenario.landmarks = {{"corner", mesh.points_mm.back()}};
  const auto simulation = simulate(mesh, scenario).value();
  EXPECT_LT(
      (simulation.landmarks[0].displaced_mm - mesh.points_mm.back() - simulation.result.displacement_mm.back()).norm(),
      1e-9);
}

TEST_F(Simulating, TakesTheModulusFromACellArray) {
  geometry::Field stiffness{"stiffness", 1, test::uniform(mesh, 5.0)};
  geometry::set_field(mesh.cell_fields, stiffness);
  const double uniform = simulate(mesh, scenario)->result.max_displacement_mm;
  scenario.youngs_modulus = "stiffness";
  EXPECT_DOUBLE_EQ(simulate(mesh, scenario)->result.max_displacement_mm, uniform);
  scenario.youngs_modulus.reset();  // the project's own field, which this mesh lacks
  EXPECT_THAT(refusal(), HasSubstr("modulus-missing: The mesh has no cell array youngs_modulus_kPa"));
  scenario.youngs_modulus = "stifness";
  EXPECT_THAT(simulate(mesh, scenario).error().advice(), HasSubstr("stiffness"));
  mesh.cell_fields[0].values[3] = std::numeric_limits<double>::quiet_NaN();
  scenario.youngs_modulus = "stiffness";
  EXPECT_THAT(refusal(), HasSubstr("cell 3"));
}

TEST_F(Simulating, AMotionOfAnyMaterialTracksTheLandmarksAndEndsWithTheLoadsCarried) {
  scenario.poisson_ratio = 0.3;
  scenario.loads = {ToolLoad{{15, 15, 30}, 8, {30, 0, 0}}};
  scenario.motion = Motion{0.05, 40, 20.0, 0.01};
  for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::corotational, MaterialLaw::neo_hookean}) {
    scenario.material = law;
    const auto moved = simulate(mesh, scenario).value();
    ASSERT_TRUE(moved.result.may_be_used()) << moved.result.why_stopped;
    ASSERT_EQ(moved.steps.size(), 40u);
    EXPECT_EQ(moved.steps.back().landmarks_mm[0], moved.landmarks[0].displaced_mm);
    EXPECT_GT((moved.steps[20].landmarks_mm[0] - moved.steps[0].landmarks_mm[0]).norm(), 0.01);
    EXPECT_NEAR(moved.steps.back().time_s, 2.0, 1e-12);
    // At rest in the end, the supports carry the tool.
    const Eigen::Vector3d carried_mN = moved.result.fixed_reaction_mN + moved.result.foundation_reaction_mN;
    EXPECT_LT((carried_mN + Eigen::Vector3d(30, 0, 0)).norm(), 0.05);
  }
}

TEST_F(Simulating, TheMaterialsAgreeUnderASmallForceAndPartUnderALargeOne) {
  const auto displaced_mm = [&](MaterialLaw law, double force_mN) {
    scenario.material = law;
    scenario.loads = {ToolLoad{{15, 15, 30}, 8, {force_mN, 0, 0}}};
    const auto simulation = simulate(mesh, scenario).value();
    EXPECT_TRUE(simulation.result.may_be_used()) << simulation.result.why_stopped;
    return simulation.landmarks[0].displacement_mm;
  };
  // Strains of 1e-4, so differences of that order; then a quarter of the body's height.
  for (const MaterialLaw law : {MaterialLaw::corotational, MaterialLaw::neo_hookean}) {
    const double small_mm = displaced_mm(MaterialLaw::linear, 0.1);
    EXPECT_NEAR(displaced_mm(law, 0.1), small_mm, 1e-3 * small_mm);
    EXPECT_GT(std::abs(displaced_mm(law, 600) / displaced_mm(MaterialLaw::linear, 600) - 1), 0.01);
  }
}

TEST_F(Simulating, MotionComesToRestNearTheEquilibrium) {
  scenario.poisson_ratio = 0.3;
  const double at_rest_mm = simulate(mesh, scenario)->landmarks[0].displacement_mm;
  scenario.motion = Motion{0.05, 60, 5.0, 0.0};
  const auto moved = simulate(mesh, scenario).value();
  ASSERT_TRUE(moved.result.may_be_used()) << moved.result.why_stopped;
  EXPECT_THAT(moved.result.why_stopped, HasSubstr("All 60 steps converged"));
  // Not nearer: motion has linear cells, which are stiffer than the quadratic ones of the equilibrium.
  EXPECT_NEAR(moved.landmarks[0].displacement_mm, at_rest_mm, 0.2 * at_rest_mm);
}

TEST_F(Simulating, AMotionOfEveryMaterialCreepsInBothEngines) {
  scenario.poisson_ratio = 0.3;
  scenario.loads = {ToolLoad{{15, 15, 30}, 8, {3, 0, 0}}};
  scenario.meshfree.nodes = 40;
  scenario.motion = Motion{0.05, 80, 5.0, 0.0};
  for (const Engine engine : {Engine::fem, Engine::meshfree}) {
    for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::corotational, MaterialLaw::neo_hookean}) {
      scenario.engine = engine;
      scenario.material = law;
      scenario.relaxation = {};
      const double elastic_mm = simulate(mesh, scenario)->landmarks[0].displacement_mm;
      // One term: J(t) = 1 + a (1 - exp(-t / T)), a = g / (1 - g), T = tau / (1 - g).
      scenario.relaxation = {{0.4, 1.2}};
      const auto moved = simulate(mesh, scenario).value();
      ASSERT_TRUE(moved.result.may_be_used()) << moved.result.why_stopped;
      for (const std::size_t step : {19u, 39u, 79u}) {
        const double crept_mm = (moved.steps[step].landmarks_mm[0] - scenario.landmarks[0].position_mm).norm();
        const double expected = 1 + 0.4 / 0.6 * (1 - std::exp(-moved.steps[step].time_s / 2.0));
        EXPECT_NEAR(crept_mm / elastic_mm, expected, 0.02) << name_of(law) << ", step " << step;
      }
      // What the supports carry is of the relaxed stress: the tool, all but what still moves.
      const Vector3d carried_mN = moved.result.fixed_reaction_mN + moved.result.foundation_reaction_mN;
      EXPECT_LT((carried_mN + Vector3d(3, 0, 0)).norm(), 0.02) << name_of(law);
    }
  }
}

// At a quarter of the block's height too, where creep is no multiple of anything.
TEST_F(Simulating, AMotionThatRelaxesEndsWhereSofterTissueDoes) {
  scenario.poisson_ratio = 0.3;
  scenario.loads = {ToolLoad{{15, 15, 30}, 8, {400, 0, 0}}};
  scenario.motion = Motion{0.5, 60, 5.0, 0.0};
  const auto end_mm = [&] {
    const auto moved = simulate(mesh, scenario).value();
    EXPECT_TRUE(moved.result.may_be_used()) << moved.result.why_stopped;
    return moved.landmarks[0].displaced_mm;
  };
  for (const MaterialLaw law : {MaterialLaw::corotational, MaterialLaw::neo_hookean, MaterialLaw::veronda_westmann}) {
    scenario.material = law;
    scenario.strain_stiffening = law == MaterialLaw::veronda_westmann ? 2 : 0;
    scenario.relaxation = {{0.2, 0.3}, {0.15, 2.0}};
    scenario.youngs_modulus = 5.0;
    const Vector3d relaxed_mm = end_mm();
    scenario.relaxation = {};
    const Vector3d at_once_mm = end_mm();
    scenario.youngs_modulus = 5.0 * 0.65;
    const Vector3d softer_mm = end_mm();
    EXPECT_GT((softer_mm - at_once_mm).norm(), 1) << name_of(law);
    EXPECT_LT((relaxed_mm - softer_mm).norm(), 5e-3 * (softer_mm - scenario.landmarks[0].position_mm).norm())
        << name_of(law);
  }
}

TEST_F(Simulating, AnEquilibriumOfTissueThatRelaxesIsThatAfterLong) {
  scenario.youngs_modulus = 5.0 * 0.6;
  const auto softer = simulate(mesh, scenario).value();
  scenario.youngs_modulus = 5.0;
  scenario.relaxation = {{0.4, 1.2}};
  const auto relaxed = simulate(mesh, scenario).value();
  EXPECT_EQ(relaxed.landmarks[0].displaced_mm, softer.landmarks[0].displaced_mm);
  EXPECT_THAT(relaxed.result.notes, testing::Contains(HasSubstr("after long, with 0.6 times the stiffness")));
  EXPECT_EQ(geometry::find_field(relaxed.mesh.cell_fields, youngs_modulus_field)->values, test::uniform(mesh, 5.0));
  EXPECT_EQ(youngs_modulus_of_cells(mesh, scenario)->front(), 5.0 * 0.6);
  scenario.relaxation = {{0.7, 1.2}, {0.4, 3}};
  EXPECT_THAT(refusal(), HasSubstr("relaxation-invalid: The weights of a relaxation sum to 1.1"));
  scenario.relaxation = {{0.4, 1.2}};
  SimulationOptions from_data;
  from_data.data = MaterialData::create({{-0.1, -1}, {-0.05, -0.5}, {0, 0}, {0.05, 0.5}, {0.1, 1}}, {}).value();
  EXPECT_EQ(simulate(mesh, scenario, from_data).error().code, "not-available");
}

TEST_F(Simulating, APartOpenCutPartsUnderTheToolInEveryMaterialAndBothEngines) {
  scenario.poisson_ratio = 0.3;
  // Half through the block, from the top, across x.
  scenario.cuts = {{{15, 15, 30}, {1, 0, 0}, 20, {}}};
  scenario.loads = {ToolLoad{{25, 15, 30}, 6, {60, 0, 0}}};
  for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::corotational, MaterialLaw::neo_hookean}) {
    scenario.material = law;
    const auto simulation = simulate(mesh, scenario).value();
    ASSERT_TRUE(simulation.result.may_be_used()) << simulation.result.why_stopped;
    EXPECT_GT(simulation.cut->largest_opening_mm, 0.5);
    EXPECT_LT(simulation.cut->largest_overlap_mm, 0.05);
    EXPECT_GT(simulation.mesh.points_mm.size(), mesh.points_mm.size());
  }
  scenario.material = MaterialLaw::linear;
  const double opened_mm = simulate(mesh, scenario)->cut->largest_opening_mm;
  scenario.engine = Engine::meshfree;
  scenario.meshfree.nodes = 60;
  const double by_frames_mm = simulate(mesh, scenario)->cut->largest_opening_mm;
  EXPECT_GT(by_frames_mm, 0.5 * opened_mm);
  EXPECT_LT(by_frames_mm, 1.05 * opened_mm);
  scenario.engine = Engine::fem;
  scenario.cuts = {{{90, 0, 0}, {1, 0, 0}}};
  EXPECT_THAT(refusal(), HasSubstr("cut-misses: Cut 1 opens the body nowhere"));
}

// The deepest that a point of either half's wall lies within the other half, as they are now: cell by cell.
double overlap_of_halves_mm(const geometry::TetMesh& rest, const std::vector<Vector3d>& moved_mm, double at_x_mm) {
  const auto is_left = [&](const std::array<int, 4>& cell) {
    double x = 0;
    for (const int point : cell) x += 0.25 * rest.points_mm[point].x();
    return x < at_x_mm;
  };
  std::vector<std::array<Vector3d, 3>> wall[2];
  std::vector<std::array<Vector3d, 4>> cells[2];
  std::set<int> points[2];
  for (const auto& cell : rest.cells) {
    const int side = is_left(cell) ? 0 : 1;
    std::vector<int> on_wall;
    for (const int point : cell) {
      if (std::abs(rest.points_mm[point].x() - at_x_mm) < 1e-6) on_wall.push_back(point);
    }
    cells[side].push_back({moved_mm[cell[0]], moved_mm[cell[1]], moved_mm[cell[2]], moved_mm[cell[3]]});
    if (on_wall.size() == 3) {
      wall[side].push_back({moved_mm[on_wall[0]], moved_mm[on_wall[1]], moved_mm[on_wall[2]]});
    }
    points[side].insert(on_wall.begin(), on_wall.end());
  }
  double deepest_mm = 0;
  for (const int side : {0, 1}) {
    for (const int point : points[side]) {
      const Vector3d& here = moved_mm[point];
      const bool inside = std::any_of(cells[1 - side].begin(), cells[1 - side].end(), [&](const auto& corner) {
        Eigen::Matrix3d edges;
        edges << corner[1] - corner[0], corner[2] - corner[0], corner[3] - corner[0];
        const Vector3d at = edges.inverse() * (here - corner[0]);
        return at.minCoeff() >= 0 && at.sum() <= 1;
      });
      if (!inside) continue;
      double to_wall_mm = 1e9;
      for (const auto& triangle : wall[1 - side]) {
        to_wall_mm = std::min(to_wall_mm, nearest_of(Rod{here, here, 0}, triangle).distance_mm);
      }
      deepest_mm = std::max(deepest_mm, to_wall_mm);
    }
  }
  return deepest_mm;
}

TEST_F(Simulating, WallsThatNothingKeepsApartPassThroughEachOtherAndTheResultSaysSo) {
  scenario.poisson_ratio = 0.3;
  scenario.loads = {ToolLoad{{30, 15, 25}, 8, {-120, 0, 0}}};
  scenario.cuts = {{{15, 0, 0}, {1, 0, 0}}};
  const auto cut = simulate(mesh, scenario).value();
  EXPECT_GT(cut.cut->largest_overlap_mm, 0.5);
  EXPECT_THAT(cut.result.notes, Contains(HasSubstr("\"cut_walls\": \"apart\"")));
  scenario.cut_walls = Scenario::Walls::apart;
  scenario.engine = Engine::meshfree;
  EXPECT_THAT(refusal(), HasSubstr("not-available: The walls of cuts"));
}

TEST_F(Simulating, HalvesOfACutThatArePressedTogetherDoNotPassThroughEachOther) {
  // The right half is pushed at its top against the left one, by which alone (poor in contact) it would go through it
  // by millimetres. Together they give way by less than it alone and by more than the block in one piece.
  scenario.poisson_ratio = 0.3;
  scenario.cut_walls = Scenario::Walls::apart;
  const std::vector<ScenarioTool> probe = {
      {"probe", ScenarioRigidTool{palpation_probe(8), {42, 15, 24}, {-1, 0, 0}, 8, {}}}};
  for (const bool touched : {false, true}) {
    scenario.loads = touched ? Loads{} : Loads{ToolLoad{{30, 15, 25}, 8, {-120, 0, 0}}};
    scenario.tools = touched ? probe : std::vector<ScenarioTool>{};
    for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::neo_hookean}) {
      if (touched && law != MaterialLaw::linear) continue;
      scenario.material = law;
      scenario.cuts = {};
      const double whole_mm = simulate(mesh, scenario)->result.max_displacement_mm;
      scenario.cuts = {{{15, 0, 0}, {1, 0, 0}}};
      const auto cut = simulate(mesh, scenario).value();
      ASSERT_TRUE(cut.result.may_be_used()) << cut.result.why_stopped;
      EXPECT_GT(cut.result.displacement_mm[test::point_at(mesh, {0, 15, 30})].norm(), 0.3);  // the left half is pushed
      EXPECT_GT(cut.result.max_displacement_mm, touched ? 0.0 : whole_mm);
      std::vector<Vector3d> moved_mm = cut.mesh.points_mm;
      for (std::size_t p = 0; p < moved_mm.size(); ++p) moved_mm[p] += cut.result.displacement_mm[p];
      EXPECT_LE(overlap_of_halves_mm(cut.mesh, moved_mm, 15), 0.1);
      EXPECT_LE(cut.contact->penetration_mm, 0.1);
      const Vector3d pushed = touched ? cut.tools[0].force_mN : Vector3d(-120, 0, 0);
      EXPECT_LT((cut.result.fixed_reaction_mN + pushed).norm(), 0.01 * pushed.norm());
    }
  }
}

TEST_F(Simulating, ASheetThroughPointsOfAPlaneCutsAsThePlaneDoesAndABentOneElsewhere) {
  scenario.poisson_ratio = 0.3;
  scenario.loads = {ToolLoad{{25, 15, 30}, 6, {60, 0, 0}}};
  scenario.cuts = {{{16, 0, 0}, {1, 0, 0}}};  // both halves stand on the held ground
  const auto plane = simulate(mesh, scenario).value();
  const auto of_sheet = [&](double bulge_mm, Engine engine) {
    Cut sheet;
    sheet.points_mm = {{16, 0, 0}, {16, 30, 0}, {16, 0, 30}, {16, 30, 30}, {16 + bulge_mm, 15, 15}};
    scenario.cuts = {sheet};
    scenario.engine = engine;
    scenario.meshfree.nodes = 60;
    return simulate(mesh, scenario).value();
  };
  const auto flat = of_sheet(0, Engine::fem);
  EXPECT_NEAR(flat.cut->largest_opening_mm, plane.cut->largest_opening_mm, 1e-6);
  for (const Engine engine : {Engine::fem, Engine::meshfree}) {
    const auto bent = of_sheet(4, engine);
    ASSERT_TRUE(bent.result.may_be_used());
    EXPECT_GT(bent.cut->largest_opening_mm, 1.0);
    EXPECT_LT(bent.result.displacement_mm[test::point_at(mesh, {0, 15, 30})].norm(), 1e-6);  // the other half
    EXPECT_GT(std::abs(bent.cut->largest_opening_mm - flat.cut->largest_opening_mm), 0.01);
  }
}

TEST_F(Simulating, AWholeCutMakesTwoBodiesThatMustEachBeHeld) {
  scenario.loads = {ToolLoad{{25, 15, 30}, 6, {60, 0, 0}}};
  scenario.cuts = {{{15, 0, 0}, {1, 0, 0}}};
  const auto apart = simulate(mesh, scenario).value();
  ASSERT_TRUE(apart.result.may_be_used());
  EXPECT_EQ(apart.result.displacement_mm[test::point_at(mesh, {0, 15, 30})].norm(), 0);
  EXPECT_GT(apart.cut->largest_opening_mm, 1.0);
  scenario.cuts = {{{0, 0, 20}, {0, 0, 1}}};  // the top stands on nothing
  EXPECT_THAT(refusal(), HasSubstr("body-free: The supports do not hold the body: it in its part 2 of 2"));
  scenario.motion = Motion{0.01, 5, 0.0, 0.0};  // but it may fly
  EXPECT_TRUE(simulate(mesh, scenario)->result.may_be_used());
}

TEST_F(Simulating, ToolsInContactPushAsTheScenarioSays) {
  scenario.loads = {};
  scenario.tools = {{"probe", ScenarioRigidTool{palpation_probe(8), {15, 15, 50}, {0, 0, -1}, 0, 100.0}},
                    {"jaws", ScenarioGrasp{{30, 15, 15}, 9, {3, 0, 0}, {}}}};
  const auto touched = simulate(mesh, scenario).value();
  ASSERT_TRUE(touched.result.may_be_used()) << touched.result.why_stopped;
  ASSERT_EQ(touched.tools.size(), 2u);
  EXPECT_NEAR(touched.tools[0].force_mN.z(), -100, 0.5);
  EXPECT_GT(touched.tools[1].force_mN.x(), 0);
  EXPECT_LE(touched.contact->penetration_mm, 0.1);
  EXPECT_LT((touched.result.fixed_reaction_mN + touched.tools[0].force_mN + touched.tools[1].force_mN).norm(), 1.0);
  scenario.engine = Engine::meshfree;
  EXPECT_THAT(refusal(), HasSubstr("not-available: By the meshfree engine a grasper pulls"));
  scenario.motion = Motion{0.1, 20, 0.0, 0.02};
  EXPECT_THAT(refusal(), HasSubstr("not-available: By the meshfree engine a grasper pulls"));
  scenario.motion.reset();
  scenario.engine = Engine::fem;
  scenario.material = MaterialLaw::neo_hookean;
  const auto far = simulate(mesh, scenario).value();
  ASSERT_TRUE(far.result.may_be_used()) << far.result.why_stopped;
  EXPECT_NEAR(far.tools[0].force_mN.z(), -100, 0.5);
  EXPECT_GT(far.tools[1].force_mN.x(), 0);
  EXPECT_LE(far.contact->penetration_mm, 0.1);
}

// What a tool with friction meets at an advance depends on its way there: bounds on the advance that were true once
// would close on one where it is not true any more, and the push would never be met.
TEST_F(Simulating, AToolWithFrictionIsPushedUntilItMeetsItsForce) {
  mesh = test::box(4, 4, 3, {32, 32, 24});
  test::name_points(mesh, "ground", [](const Vector3d& p) { return p.z() < 1e-9; });
  scenario = {};
  scenario.youngs_modulus = 6.0;
  scenario.supports = {test::fixed("ground")};
  ScenarioRigidTool probe{palpation_probe(5), {16, 16, 40}, {0, 0, -1}, 0, 100.0};
  probe.friction = 0.2;
  scenario.tools = {{"probe", probe}};
  const auto pressed = simulate(mesh, scenario).value();
  ASSERT_TRUE(pressed.result.may_be_used()) << pressed.result.why_stopped;
  EXPECT_NEAR(pressed.tools[0].force_mN.z(), -100, 0.5);
  EXPECT_LE(pressed.contact->penetration_mm, 0.1);
  EXPECT_GT(pressed.tools[0].sticking + pressed.tools[0].slipping, 0);
}

TEST_F(Simulating, ToolsPressOnMeshfreeBodiesNearlyAsOnCells) {
  // A probe pushed by 100 mN sinks in by less than into cells, since a few frames cannot follow its dent: 44 % of the
  // way with 20 of them, over 70 with 40.
  scenario.loads = {};
  scenario.tools = {{"probe", ScenarioRigidTool{palpation_probe(8), {15, 15, 50}, {0, 0, -1}, 0, 100.0}}};
  scenario.meshfree.nodes = 20;
  for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::neo_hookean}) {
    scenario.material = law;
    scenario.engine = Engine::fem;
    const auto cells = simulate(mesh, scenario).value();
    scenario.engine = Engine::meshfree;
    const auto frames = simulate(mesh, scenario).value();
    ASSERT_TRUE(frames.result.may_be_used()) << frames.result.why_stopped;
    EXPECT_NEAR(frames.tools[0].force_mN.z(), -100, 0.5);
    EXPECT_LE(frames.contact->penetration_mm, 0.1);
    EXPECT_LT((frames.result.fixed_reaction_mN + frames.tools[0].force_mN).norm(), 1.0);
    // Both ways begin 12 mm above the top.
    EXPECT_LT(frames.tools[0].advance_mm, cells.tools[0].advance_mm + 0.1);
    EXPECT_GT(frames.tools[0].advance_mm - 12, 0.4 * (cells.tools[0].advance_mm - 12));
  }
}

TEST_F(Simulating, ToolsMoveWithTheBody) {
  // A probe that goes into the body's top within two seconds, and jaws that draw its side, both slowly against its own
  // swinging: at the end they push as in equilibrium. The law does not matter; linear cells on both sides.
  scenario.loads = {};
  scenario.tools = {{"probe", ScenarioRigidTool{palpation_probe(8), {15, 15, 39}, {0, 0, -1}, 4.0, {}}},
                    {"jaws", ScenarioGrasp{{30, 15, 15}, 9, {2, 0, 0}, {}}}};
  scenario.motion = Motion{0.1, 20, 0.0, 0.02};
  for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::corotational}) {
    scenario.material = law;
    const auto moved = simulate(mesh, scenario).value();
    ASSERT_TRUE(moved.result.may_be_used()) << moved.result.why_stopped;
    ASSERT_EQ(moved.tools.size(), 2u);
    EXPECT_LE(moved.contact->penetration_mm, 0.1);
    EXPECT_LT(moved.tools[0].force_mN.z(), -50);

    StaticOptions options;
    options.poisson_ratio = scenario.poisson_ratio;
    options.order = ElementOrder::linear;
    const auto body = prepare_body(mesh, youngs_modulus_of_cells(mesh, scenario).value(), scenario.supports, options,
                                   Holding::required)
                          .value();
    std::vector<std::vector<ContactTool>> stations;
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
      stations.push_back(
          {{"probe", TouchingTool{palpation_probe(8), pose_towards({15, 15, 39 - 4 * part}, {0, 0, -1}), {}}},
           {"jaws", Grasp{{30, 15, 15}, 9, Vector3d(2 * part, 0, 0)}}});
    }
    const AppliedLoads nothing{Eigen::VectorXd::Zero(3 * body.layout.nodes())};
    const auto still = find_equilibrium_in_contact(body, materials_of(body, law), nothing, stations).value();
    ASSERT_TRUE(still.result.may_be_used()) << still.result.why_stopped;
    for (int tool = 0; tool < 2; ++tool) {
      const Vector3d expected = still.tools[tool].force_mN;
      EXPECT_LT((moved.tools[tool].force_mN - expected).norm(), 0.05 * expected.norm()) << tool;
    }
  }
  scenario.motion->steps = 1;
  std::get<ScenarioRigidTool>(scenario.tools[0].what).advance_mm = 5.0;
  EXPECT_THAT(refusal(), HasSubstr("tool-too-fast: Tool probe would move by 5.0 mm a step"));
}

TEST_F(Simulating, ToolsMoveWithMeshfreeBodiesAsInEquilibriumAndNearlyAsWithCells) {
  // A probe that goes into the top, slowly against the body's swinging: at the end it meets what it meets in
  // equilibrium there, and, since the frames follow its dent less, up to some times what cells push with.
  scenario.loads = {};
  scenario.tools = {{"probe", ScenarioRigidTool{palpation_probe(8), {15, 15, 39}, {0, 0, -1}, 3.0, {}}}};
  scenario.meshfree.nodes = 20;
  const Motion slowly{0.1, 12, 0.0, 0.02};
  for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::neo_hookean}) {
    scenario.material = law;
    scenario.engine = Engine::meshfree;
    scenario.motion.reset();
    const auto still = simulate(mesh, scenario).value();
    scenario.motion = slowly;
    const auto moved = simulate(mesh, scenario).value();
    ASSERT_TRUE(moved.result.may_be_used()) << moved.result.why_stopped;
    ASSERT_EQ(moved.tools.size(), 1u);
    EXPECT_LE(moved.contact->penetration_mm, 0.1);
    EXPECT_NEAR(moved.tools[0].force_mN.z() / still.tools[0].force_mN.z(), 1, 0.05);
    EXPECT_NEAR(moved.result.max_displacement_mm / still.result.max_displacement_mm, 1, 0.05);
    EXPECT_LT((moved.result.fixed_reaction_mN + moved.tools[0].force_mN).norm(), 0.05 * moved.tools[0].force_mN.norm());

    scenario.engine = Engine::fem;
    const auto cells = simulate(mesh, scenario).value();
    ASSERT_TRUE(cells.result.may_be_used()) << cells.result.why_stopped;
    const double ratio = moved.tools[0].force_mN.z() / cells.tools[0].force_mN.z();
    EXPECT_GT(ratio, 1);
    EXPECT_LT(ratio, 2.5);
  }
  scenario.engine = Engine::meshfree;
  scenario.motion->steps = 1;
  std::get<ScenarioRigidTool>(scenario.tools[0].what).advance_mm = 5.0;
  EXPECT_THAT(refusal(), HasSubstr("tool-too-fast"));
}

TEST_F(Simulating, RefusesALandmarkOfAnotherPlace) {
  scenario.landmarks.push_back({"lost", {300, 0, 0}});
  EXPECT_THAT(refusal(), HasSubstr("landmark-outside: Landmark lost lies 270.0 mm outside"));
}

TEST_F(Simulating, ReportsProgressToTheEnd) {
  double last = 0;
  const Progress progress([&](double fraction, std::string_view) {
    EXPECT_GE(fraction, last);
    last = fraction;
  });
  ASSERT_TRUE(simulate(mesh, scenario, {}, progress));
  EXPECT_EQ(last, 1.0);
}

}  // namespace
}  // namespace glisson::mechanics
