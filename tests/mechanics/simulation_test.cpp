// A scenario on a mesh, from question to answer.

#include "mechanics/simulation.h"

#include <gmock/gmock.h>
#include <cmath>
#include <limits>

#include "mechanics/bodies.h"
#include "mechanics/static_model.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

class Simulating : public testing::Test {
 protected:
  Simulating() {
    test::name_points(mesh, "fixed", [](const Vector3d& p) { return p.z() == 0; });
    scenario.youngs_modulus = 5.0;
    scenario.supports = {test::held("fixed")};
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
    const Eigen::Vector3d carried_mN = moved.result.held_reaction_mN + moved.result.foundation_reaction_mN;
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
