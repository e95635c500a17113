// Motion by Newton's method: it is the implicit Euler that it says it is, and it agrees with the fast mover.

#include "mechanics/dynamics/newton_implicit_euler.h"

#include <gtest/gtest.h>
#include <cmath>

#include "mechanics/bodies.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Body beam(const std::vector<Support>& more = {}, Holding holding = Holding::required) {
  auto mesh = test::box(6, 2, 2, {60, 20, 20});
  test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "end", [](const Vector3d& p) { return p.x() == 60; });
  StaticOptions options;
  options.order = ElementOrder::linear;
  options.poisson_ratio = 0.4;
  std::vector<Support> supports = more;
  if (holding == Holding::required) supports.push_back(test::fixed("wall"));
  auto youngs = test::uniform(mesh, 20);
  return prepare_body(std::move(mesh), std::move(youngs), supports, options, holding).value();
}

NewtonImplicitEuler moving(const Body& body, MaterialLaw law, const Loads& loads, const DynamicsOptions& options) {
  auto materials = materials_of(body, law, 2.0);
  auto applied = applied_loads(body, loads, pressure_kind_of(materials)).value();
  return NewtonImplicitEuler::create(body, std::move(materials), std::move(applied), options).value();
}

TEST(NewtonImplicitEuler, LinearElasticityMovesAsTheFastMoverMovesIt) {
  // Both solve the same linear equations each step.
  const Body body = beam();
  const Loads loads{GravityLoad{{0, 0, -9810}}};
  const DynamicsOptions options{
      .step_s = 0.01, .mass_damping_per_s = 1, .stiffness_damping_s = 0.002, .relative_tolerance = 1e-9};
  auto newton = moving(body, MaterialLaw::linear, loads, options);
  auto fast = ImplicitEuler::create(body, MaterialLaw::linear, options).value();
  const VectorXd force_mN = fast.force_of(loads).value();
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(newton.step().value().converged);
    ASSERT_TRUE(fast.step(force_mN).converged);
  }
  EXPECT_GT(fast.displacement_mm().norm(), 1.0);
  EXPECT_LT((newton.displacement_mm() - fast.displacement_mm()).norm(), 1e-5 * fast.displacement_mm().norm());
}

TEST(NewtonImplicitEuler, ADampedMotionOfEveryLawComesToRestAtItsEquilibrium) {
  const Body body = beam({{NamedPoints{"end"}, Ligament{{60, 10, 60}, 2.0, 1.0}}});
  const Loads loads{GravityLoad{{0, 0, -9810}}, PressureLoad{1.6}};
  for (const MaterialLaw law : {MaterialLaw::corotational, MaterialLaw::neo_hookean, MaterialLaw::veronda_westmann}) {
    auto motion = moving(body, law, loads, {.step_s = 0.05, .mass_damping_per_s = 20, .relative_tolerance = 1e-8});
    for (int i = 0; i < 60; ++i) ASSERT_TRUE(motion.step().value().converged);
    const auto rest = find_equilibrium(body, materials_of(body, law, 2.0), loads).value();
    ASSERT_TRUE(rest.may_be_used());
    const VectorXd u = nodal_displacements(body.layout, rest);
    EXPECT_LT((motion.displacement_mm() - u).cwiseAbs().maxCoeff(), 1e-2) << u.cwiseAbs().maxCoeff();
  }
}

TEST(NewtonImplicitEuler, AFreeBodyKeepsItsMomentumAndTurnsWithoutGrowing) {
  const Body body = beam({}, Holding::optional);
  auto motion = moving(body, MaterialLaw::neo_hookean, {}, {.step_s = 0.005, .relative_tolerance = 1e-10});
  const VectorXd mass_kg = lumped_mass_kg(body);
  VectorXd v(mass_kg.size());
  const Vector3d omega(0, 0, 4), center(30, 10, 10), along(50, 0, 20);
  for (int n = 0; n < body.layout.nodes(); ++n) {
    v.segment<3>(3 * n) = along + omega.cross(body.layout.positions_mm[n] - center);
  }
  motion.set_velocity(v);
  const auto momentum = [&](const VectorXd& velocity) { return sum_of(mass_kg.cwiseProduct(velocity)); };
  const Vector3d before = momentum(v);
  for (int i = 0; i < 40; ++i) ASSERT_TRUE(motion.step().value().converged);
  EXPECT_LT((momentum(motion.velocity_mm_s()) - before).norm(), 1e-6 * before.norm());
  // 0.2 s at 4 rad/s: 0.8 rad. Linear elasticity would have grown the beam by 1/cos(0.8) - 1 = 44 %.
  const auto at = [&](const Vector3d& place) {
    const auto p = test::point_at(body.mesh, place);
    return (body.mesh.points_mm[p] + motion.displacement_mm().segment<3>(3 * body.layout.node_of_point[p])).eval();
  };
  EXPECT_NEAR((at({60, 10, 10}) - at({0, 10, 10})).norm(), 60, 1.0);
}

TEST(NewtonImplicitEuler, ABodyThatFallsFallsAsImplicitEulerSays) {
  const Body body = beam({}, Holding::optional);
  auto motion = moving(body, MaterialLaw::neo_hookean, {GravityLoad{{0, 0, -9810}}}, {.step_s = 0.01});
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(motion.step().value().converged);
  // u = g h^2 (1 + 2 + ... + 10).
  EXPECT_NEAR(motion.displacement_mm()[2], -9810 * 1e-4 * 55, 1e-3);
}

}  // namespace
}  // namespace glisson::mechanics
