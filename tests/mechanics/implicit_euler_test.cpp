// A moving body against a slow one, against what mechanics conserves, and against its equilibrium.

#include "mechanics/dynamics/implicit_euler.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>

#include "base/parallel.h"
#include "mechanics/bodies.h"
#include "mechanics/elements/strain.h"
#include "mechanics/slow_motion.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"
#include "support/opencl.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Body body_of(geometry::TetMesh mesh, const std::vector<Support>& supports) {
  StaticOptions options;
  options.order = ElementOrder::linear;
  options.poisson_ratio = 0.4;
  std::vector<double> youngs_kPa;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) youngs_kPa.push_back(4.0 + double(c % 5));
  return prepare_body(std::move(mesh), std::move(youngs_kPa), supports, options, Holding::optional).value();
}

// 60 x 20 x 20 mm, crooked inside, the patches "wall" and "belly" named.
geometry::TetMesh crooked_beam() {
  auto mesh = test::box(9, 3, 3, {60, 20, 20});
  test::disturb_inner_points(mesh, 0.8);
  test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "belly", [](const Vector3d& p) { return p.z() == 0; });
  return mesh;
}

const Loads gravity{GravityLoad{{0, 0, -9810}}};

void expect_steps_of_the_slow_reference(const std::optional<std::string>& device) {
  const Body body = body_of(crooked_beam(), {test::fixed("wall"), {NamedPoints{"belly"}, Foundation{0.02}}});
  const DynamicsOptions options{.step_s = 0.02,
                                .mass_damping_per_s = 0.5,
                                .stiffness_damping_s = 0.003,
                                .relative_tolerance = 1e-9,
                                .max_iterations = 2000,
                                .device = device};
  auto moving = ImplicitEuler::create(body, MaterialLaw::corotational, options).value();
  EXPECT_EQ(moving.cost().device.empty(), !device);
  test::SlowMotion slow(body, options, moving.mass_kg());
  const VectorXd force = moving.force_of(gravity).value();
  for (int step = 0; step < 15; ++step) {
    const StepReport report = moving.step(force);
    slow.step(force);
    ASSERT_TRUE(report.converged) << report.relative_residual;
  }
  // Solved to 1e-9; the rotations, iterated to about 1e-7 squared, and held nodes by a stiff spring leave the rest.
  EXPECT_GT(slow.u_mm.cwiseAbs().maxCoeff(), 5);
  EXPECT_LT((moving.displacement_mm() - slow.u_mm).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((moving.velocity_mm_s() - slow.v_mm_s).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(Motion, EveryStepIsThatOfTheSlowReference) { expect_steps_of_the_slow_reference({}); }

TEST(Motion, EveryStepOnADeviceIsThatOfTheSlowReference) {
  GLISSON_NEEDS_OPENCL();
  expect_steps_of_the_slow_reference("");
}

TEST(Motion, AFreeBodyFallsAsTheRecurrenceSays) {
  const Body body = body_of(crooked_beam(), {});
  const DynamicsOptions options{.step_s = 0.01, .relative_tolerance = 1e-10};
  auto moving = ImplicitEuler::create(body, MaterialLaw::corotational, options).value();
  // Gravity that acts on the lumped masses as it does on the cells, so that nothing deforms: u = g h^2 n (n + 1) / 2.
  const VectorXd force = moving.force_of(gravity).value();
  for (int step = 0; step < 20; ++step) ASSERT_TRUE(moving.step(force).converged);
  const VectorXd u = moving.displacement_mm();
  for (int n = 0; n < body.layout.nodes(); ++n) {
    EXPECT_LT((u.segment<3>(3 * n) - Vector3d(0, 0, -9810 * 1e-4 * 210)).norm(), 1e-5);
  }
}

TEST(Motion, KeepsMomentumWithoutForcesAndOnlyLosesEnergy) {
  const Body body = body_of(crooked_beam(), {});
  auto moving =
      ImplicitEuler::create(body, MaterialLaw::corotational, {.step_s = 0.01, .relative_tolerance = 1e-8}).value();
  const VectorXd mass = moving.mass_kg();
  VectorXd u(3 * body.layout.nodes()), v(u.size());
  for (int n = 0; n < body.layout.nodes(); ++n) {
    const Vector3d& x = body.layout.positions_mm[n];
    u.segment<3>(3 * n) = Vector3d(0.1 * x.x(), std::sin(x.x() / 10), -0.05 * x.z());  // stretched and wavy
    v.segment<3>(3 * n) = Vector3d(30, 2 * x.z(), 10 - 2 * x.y());                     // flying and turning
  }
  moving.set_state(u, v);
  const auto momentum = [&] {
    Vector3d sum(0, 0, 0);
    const VectorXd velocity = moving.velocity_mm_s();
    for (int n = 0; n < body.layout.nodes(); ++n) sum += mass[n] * velocity.segment<3>(3 * n);
    return sum;
  };
  const Vector3d before = momentum();
  double energy = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 40; ++step) {
    const StepReport report = moving.step(VectorXd::Zero(u.size()));
    ASSERT_TRUE(report.converged);
    // The step's own linearisation errs by the square of the turn per step, and can give a little back.
    EXPECT_LT(report.kinetic_energy_uJ + report.strain_energy_uJ, 1.001 * energy) << "step " << step;
    energy = report.kinetic_energy_uJ + report.strain_energy_uJ;
  }
  // Inner forces of each cell sum to zero exactly; what is left of momentum's change is the residual's, 1e-8 a step.
  EXPECT_LT((momentum() - before).norm(), 1e-6 * before.norm());
}

TEST(Motion, ASpinningBodyDoesNotGrow) {
  const Body body = body_of(crooked_beam(), {});
  auto moving = ImplicitEuler::create(body, MaterialLaw::corotational, {.step_s = 0.01}).value();
  VectorXd v(3 * body.layout.nodes());
  const Vector3d spin(0, 0, 10);  // rad/s: 5.7 degrees a step, more than a turn in all
  for (int n = 0; n < body.layout.nodes(); ++n) {
    v.segment<3>(3 * n) = spin.cross(body.layout.positions_mm[n] - Vector3d(30, 10, 10));
  }
  moving.set_state(VectorXd::Zero(v.size()), v);
  double turned = 0;
  for (int step = 0; step < 80; ++step) {
    const StepReport report = moving.step(VectorXd::Zero(v.size()));
    ASSERT_TRUE(report.converged);
    EXPECT_EQ(report.inverted_cells, 0);
    const VectorXd u = moving.displacement_mm();
    // What centrifugal force does: rho (omega L)^2 / (8 E) = 1000e-9 * 600^2 / (8 * 5) = 1 %; and the first steps
    // overshoot. A linear body would have grown without end.
    EXPECT_LT(strain_range(body.mesh, body.layout, u, StrainMeasure::stretch).largest_strain, 0.06) << step;
    turned = std::max(turned, u.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(turned, 50);  // the far end has been on the other side
}

TEST(Motion, ComesToRestInTheEquilibriumOfTheSameCells) {
  const Body body = body_of(crooked_beam(), {test::fixed("wall")});
  auto moving =
      ImplicitEuler::create(body, MaterialLaw::corotational, {.step_s = 0.05, .mass_damping_per_s = 10}).value();
  const VectorXd force = moving.force_of(gravity).value();
  for (int step = 0; step < 150; ++step) ASSERT_TRUE(moving.step(force).converged);
  const auto rest = find_equilibrium(body, materials_of(body, MaterialLaw::corotational), force).value();
  ASSERT_TRUE(rest.may_be_used());
  EXPECT_LT((moving.displacement_mm() - nodal_displacements(body.layout, rest)).cwiseAbs().maxCoeff(),
            1e-3 * rest.max_displacement_mm);
}

TEST(Motion, TheNumberOfThreadsDoesNotChangeAnyBit) {
  const Body body = body_of(crooked_beam(), {test::fixed("wall")});
  const auto run = [&](int threads) {
    set_thread_count(threads);
    auto moving = ImplicitEuler::create(body, MaterialLaw::corotational, {}).value();
    const VectorXd force = moving.force_of(gravity).value();
    for (int step = 0; step < 10; ++step) moving.step(force);
    set_thread_count(0);
    return moving.displacement_mm();
  };
  EXPECT_EQ((run(1) - run(2)).cwiseAbs().maxCoeff(), 0.0);
}

TEST(Motion, AStepThatDoesNotConvergeSaysSoAndMovesNothing) {
  const Body body = body_of(crooked_beam(), {test::fixed("wall")});
  auto moving = ImplicitEuler::create(body, MaterialLaw::corotational, {.max_iterations = 2}).value();
  const StepReport report = moving.step(moving.force_of(gravity).value());
  EXPECT_FALSE(report.converged);
  EXPECT_GT(report.relative_residual, 1e-4);
  EXPECT_EQ(moving.displacement_mm().norm(), 0);
}

TEST(Motion, RefusesWhatItCannotMove) {
  const Body body = body_of(crooked_beam(), {});
  EXPECT_EQ(ImplicitEuler::create(body, MaterialLaw::neo_hookean, {}).error().code, "not-available");
  EXPECT_EQ(ImplicitEuler::create(body, MaterialLaw::linear, {.step_s = 0}).error().code, "step-invalid");
  EXPECT_EQ(ImplicitEuler::create(body, MaterialLaw::linear, {.stiffness_damping_s = NAN}).error().code,
            "step-invalid");
}

}  // namespace
}  // namespace glisson::mechanics
