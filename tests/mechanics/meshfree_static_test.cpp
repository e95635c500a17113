// The meshfree engine as a StaticModel: what it answers is what the engine solves, and tools take it in hand.

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "cut_bar.h"
#include "mechanics/contact/contact.h"
#include "mechanics/meshfree/meshfree_model.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

class MeshfreeBar : public testing::Test {
 protected:
  MeshfreeBar() : mesh_(test::bar(12, 4, 6)) { test::name_supports_of_bar(mesh_); }
  MeshfreeModel meshfree(int nodes, const ChosenLaw& law = MaterialLaw::linear) const {
    return MeshfreeModel::create(mesh_, test::uniform(mesh_, test::youngs_kPa), test::supports_of_bar(), law, {},
                                 {.nodes = nodes})
        .value();
  }
  StaticModel elements() const {
    return StaticModel::create(mesh_, test::uniform(mesh_, test::youngs_kPa), test::supports_of_bar()).value();
  }
  static double farthest_mm(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
    double farthest = 0;
    for (std::size_t p = 0; p < a.size(); ++p) farthest = std::max(farthest, (a[p] - b[p]).norm());
    return farthest;
  }

  geometry::TetMesh mesh_;
  const Loads loads_{ToolLoad{{80, 12, 40}, 12, {-15, 4, 26}}, GravityLoad{{0, 0, -9810}}};
};

TEST_F(MeshfreeBar, AnswersAsTheEngineSolves) {
  const MeshfreeModel model = meshfree(40);
  const StaticModel taken = model.static_model().value();
  const StaticResult solved = model.solve(loads_).value(), answered = taken.solve(loads_).value();
  ASSERT_TRUE(solved.may_be_used() && answered.may_be_used());
  EXPECT_GT(solved.max_displacement_mm, 1);
  EXPECT_LT(farthest_mm(solved.displacement_mm, answered.displacement_mm), 1e-5 * solved.max_displacement_mm);
  EXPECT_NEAR(answered.strain_energy_uJ, solved.strain_energy_uJ, 1e-4 * solved.strain_energy_uJ);
  EXPECT_LT((answered.fixed_reaction_mN - solved.fixed_reaction_mN).norm(), 1e-3 * solved.applied_force_mN.norm());
  EXPECT_LT((answered.applied_force_mN + answered.fixed_reaction_mN + answered.foundation_reaction_mN).norm(),
            0.02 * answered.applied_force_mN.norm());
  // Half as stiff a body on supports as before, by an engine of its own.
  const StaticModel softer = taken.with_moduli(test::uniform(mesh_, test::youngs_kPa / 2), {}).value();
  EXPECT_GT(softer.solve(loads_)->max_displacement_mm, 1.3 * answered.max_displacement_mm);
}

// A tool finds the same body, which gives way less than by finite elements: a subset of their displacements.
TEST_F(MeshfreeBar, GivesWayUnderAToolNearlyAsFiniteElementsDo) {
  const std::vector<ContactTool> probe{
      {"probe", TouchingTool{palpation_probe(8), pose_towards({60, 12, 60}, {0, 0, -1}), 60.0}}};
  const auto places = locate_points(mesh_, {{60, 12, 20}, {75, 12, 10}});
  const auto pressed = [&](StaticModel model) {
    const ContactBody body = ContactBody::create(std::move(model), {}, places).value();
    return body.solve(body.untouched(), probe).value();
  };
  const ContactState exact = pressed(elements());
  const ContactState state = pressed(meshfree(60).static_model().value());
  EXPECT_TRUE(state.report.converged);
  EXPECT_LE(state.report.penetration_mm, 0.1);
  EXPECT_NEAR(state.tools[0].force_mN.z(), -60, 0.5);
  const double gap_mm = 12;  // between the probe and the bar, before it came down
  EXPECT_LT(state.tools[0].advance_mm, exact.tools[0].advance_mm);
  EXPECT_GT(state.tools[0].advance_mm - gap_mm, 0.7 * (exact.tools[0].advance_mm - gap_mm));
  EXPECT_LT(farthest_mm(state.watched_mm, exact.watched_mm), 0.2 * exact.watched_mm[0].norm());
}

TEST_F(MeshfreeBar, IsRefusedWhereItCannotBeTakenInHand) {
  const auto stiffening = meshfree(10, MaterialLaw::neo_hookean).static_model();
  ASSERT_FALSE(stiffening);
  EXPECT_EQ(stiffening.error().code, "not-available");
  EXPECT_THAT(stiffening.error().message(), HasSubstr("linear, isotropic liver without ligaments"));
}

}  // namespace
}  // namespace glisson::mechanics
