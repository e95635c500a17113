// Bodies that relax, against closed forms of linear viscoelasticity, against the sum over all of their past, and
// against what thermodynamics forbids.

#include "mechanics/materials/relaxation.h"

#include <gmock/gmock.h>
#include <cmath>
#include <complex>
#include <Eigen/Dense>
#include <numbers>
#include <random>

#include "base/parallel.h"
#include "mechanics/bodies.h"
#include "mechanics/dynamics/implicit_euler.h"
#include "mechanics/dynamics/newton_implicit_euler.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

const Relaxation two_terms{{0.3, 0.4}, {0.25, 5.0}};
constexpr MaterialLaw all_laws[] = {MaterialLaw::linear, MaterialLaw::corotational, MaterialLaw::neo_hookean,
                                    MaterialLaw::veronda_westmann};

// G(t) / G(0).
double left_after(const Relaxation& relaxation, double time_s) {
  double left = 1;
  for (const auto& [weight, tau_s] : relaxation) left -= weight * (1 - std::exp(-time_s / tau_s));
  return left;
}
double crept(const std::vector<CreepTerm>& creep, double time_s) {
  double strain = 1;
  for (const auto& [amplitude, constant_s] : creep) strain += amplitude * (1 - std::exp(-time_s / constant_s));
  return strain;
}

// 60 x 20 x 20 mm of 20 kPa on three frictionless walls: pulled at its end it is strained evenly.
constexpr double bar_length_mm = 60, bar_youngs_kPa = 20, bar_area_mm2 = 400;
Body bar(double density_kg_mm3, double poisson_ratio = 0.4) {
  auto mesh = test::box(3, 2, 2, {bar_length_mm, 20, 20});
  test::disturb_inner_points(mesh, 1.0);
  test::name_points(mesh, "x0", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "y0", [](const Vector3d& p) { return p.y() == 0; });
  test::name_points(mesh, "z0", [](const Vector3d& p) { return p.z() == 0; });
  StaticOptions options;
  options.order = ElementOrder::linear;
  options.poisson_ratio = poisson_ratio;
  options.density_kg_mm3 = density_kg_mm3;
  auto youngs = test::uniform(mesh, bar_youngs_kPa);
  return prepare_body(std::move(mesh), std::move(youngs),
                      {test::held_along("x0", true, false, false), test::held_along("y0", false, true, false),
                       test::held_along("z0", false, false, true)},
                      options, Holding::required)
      .value();
}
constexpr double no_inertia = 1e-12, water = 1e-6;  // kg/mm3

// Even over the end face alone.
Loads pull(double force_mN) { return {ToolLoad{{bar_length_mm + 50, 10, 10}, 51.5, {force_mN, 0, 0}}}; }
double elastic_mm(double force_mN) { return force_mN / bar_area_mm2 / bar_youngs_kPa * bar_length_mm; }
int end_node(const Body& body) { return body.layout.node_of_point[test::point_at(body.mesh, {bar_length_mm, 20, 20})]; }
double end_mm(const Body& body, const VectorXd& u_mm) { return u_mm[3 * end_node(body)]; }

TEST(Relaxation, ThatOfACreepFunctionIsItsResolventKernel) {
  const Relaxation one = relaxation_of({{0.4, 3.0}});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_NEAR(one[0].weight, 0.4 / 1.4, 1e-14);
  EXPECT_NEAR(one[0].time_s, 3.0 / 1.4, 1e-13);
  EXPECT_TRUE(relaxation_of({{0.0, 3.0}}).empty());
  EXPECT_EQ(relaxation_of({{0.1, 2.0}, {0.3, 2.0}}).size(), 1u);
  // Strain under a steady stress must be held by that stress: J(t) + integral of J(t - s) dG(s) = 1, by Simpson's rule.
  const std::vector<std::vector<CreepTerm>> creeps{
      {{0.4, 3.0}}, {{0.2, 1.5}, {0.6, 40.0}}, {{0.3, 60.0}, {0.1, 2.0}, {1.5, 9.0}}, {{0.2, 5.0}, {0.2, 5.0001}}};
  for (const auto& creep : creeps) {
    const Relaxation relaxation = relaxation_of(creep);
    EXPECT_EQ(relaxation.size(), creep.size());
    EXPECT_TRUE(check_relaxation(relaxation));
    for (const double t : {0.5, 4.0, 100.0}) {
      const auto integrand = [&](double s) {
        double slope = 0;
        for (const auto& [weight, tau_s] : relaxation) slope -= weight / tau_s * std::exp(-s / tau_s);
        return crept(creep, t - s) * slope;
      };
      constexpr int halves = 20000;
      double sum = integrand(0) + integrand(t);
      for (int i = 1; i < halves; ++i) sum += (i % 2 == 1 ? 4 : 2) * integrand(t * i / halves);
      EXPECT_NEAR(crept(creep, t) + sum * t / halves / 3, 1.0, 1e-8) << creep.size() << " terms, " << t << " s";
    }
    double sum = 1;
    for (const CreepTerm& term : creep) sum += term.amplitude;
    EXPECT_NEAR(long_term_share(relaxation), 1 / sum, 1e-12);
  }
}

TEST(Relaxation, IsRefusedWhereItLeavesNothingOrHasNoTime) {
  EXPECT_TRUE(check_relaxation({}));
  EXPECT_TRUE(check_relaxation(two_terms));
  for (const RelaxationTerm& term :
       {RelaxationTerm{0, 1}, {1, 1}, {-0.1, 1}, {0.5, 0}, {0.5, -1}, {NAN, 1}, {0.5, INFINITY}}) {
    const auto refused = check_relaxation({{0.1, 1.0}, term});
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message(), HasSubstr("Term 2"));
  }
  EXPECT_THAT(check_relaxation({{0.6, 1}, {0.5, 2}}).error().message(), HasSubstr("sum to 1.1"));
  EXPECT_FALSE(check_relaxation(Relaxation(most_relaxation_terms + 1, {0.01, 1.0})));
  const Body body = bar(water);
  EXPECT_EQ(ImplicitEuler::create(body, MaterialLaw::linear, {.relaxation = {{1.2, 1}}}).error().code,
            "relaxation-invalid");
}

// The standard linear solid under a stress that comes at once: u = u(elastic) J(t), J of the creep that the relaxation
// was made from. A step sees the load come within it, so that the error falls with the step.
TEST(Relaxation, ABarUnderASteadyPullCreepsAsTheStandardLinearSolid) {
  const std::vector<CreepTerm> creep{{0.5, 2.0}};
  const Body body = bar(no_inertia);
  const Loads loads = pull(4.0);
  const auto error_at = [&](double step_s, double time_s) {
    auto moving =
        ImplicitEuler::create(
            body, MaterialLaw::linear,
            {.step_s = step_s, .relaxation = relaxation_of(creep), .relative_tolerance = 1e-9, .max_iterations = 2000})
            .value();
    const VectorXd force_mN = moving.force_of(loads).value();
    for (int step = 0; step < std::lround(time_s / step_s); ++step) EXPECT_TRUE(moving.step(force_mN).converged);
    return end_mm(body, moving.displacement_mm()) / elastic_mm(4.0) / crept(creep, time_s) - 1;
  };
  for (const double time_s : {0.4, 2.0, 8.0}) EXPECT_NEAR(error_at(0.04, time_s), 0, 0.01) << time_s;
  const double coarse = error_at(0.2, 2.0), fine = error_at(0.1, 2.0), finest = error_at(0.05, 2.0);
  EXPECT_NEAR(coarse / fine, 2, 0.1);
  EXPECT_NEAR(fine / finest, 2, 0.05);
}

// Of each law, by each mover that has it, under a pull by 0.005 %.
TEST(Relaxation, EveryLawCreepsAsTheLinearOneAtSmallStrain) {
  const std::vector<CreepTerm> creep{{0.2, 0.5}, {0.4, 4.0}};
  const Body body = bar(no_inertia);
  const double force_mN = 0.4;
  const DynamicsOptions options{
      .step_s = 0.02, .relaxation = relaxation_of(creep), .relative_tolerance = 1e-8, .max_iterations = 2000};
  auto linear = ImplicitEuler::create(body, MaterialLaw::linear, options).value();
  auto corotational = ImplicitEuler::create(body, MaterialLaw::corotational, options).value();
  const VectorXd force = linear.force_of(pull(force_mN)).value();
  std::vector<NewtonImplicitEuler> newtons;
  for (const MaterialLaw law : all_laws) {
    auto materials = materials_of(body, law, 2.0);
    auto loads = applied_loads(body, pull(force_mN), pressure_kind_of(materials)).value();
    newtons.push_back(NewtonImplicitEuler::create(body, std::move(materials), std::move(loads), options).value());
  }
  const double all_mm = elastic_mm(force_mN);
  for (int step = 1; step <= 200; ++step) {
    ASSERT_TRUE(linear.step(force).converged);
    ASSERT_TRUE(corotational.step(force).converged);
    const double u_mm = end_mm(body, linear.displacement_mm());
    if (step >= 10) {
      EXPECT_NEAR(u_mm, all_mm * crept(creep, options.step_s * step), 0.01 * all_mm) << step;
    }
    EXPECT_NEAR(end_mm(body, corotational.displacement_mm()), u_mm, 2e-4 * all_mm) << step;
    for (auto& newton : newtons) {
      ASSERT_TRUE(newton.step().value().converged);
      EXPECT_NEAR(end_mm(body, newton.displacement_mm()), u_mm, 2e-4 * all_mm) << step;
    }
  }
}

TEST(Relaxation, ABodyThatIsLetGoCreepsBack) {
  const std::vector<CreepTerm> creep{{0.5, 2.0}};
  const Body body = bar(no_inertia);
  auto moving =
      ImplicitEuler::create(
          body, MaterialLaw::linear,
          {.step_s = 0.02, .relaxation = relaxation_of(creep), .relative_tolerance = 1e-9, .max_iterations = 2000})
          .value();
  const VectorXd force_mN = moving.force_of(pull(4.0)).value(), none = VectorXd::Zero(force_mN.size());
  for (int step = 1; step <= 400; ++step) {
    ASSERT_TRUE(moving.step(step <= 150 ? force_mN : none).converged);
    if (step < 160 || step % 40 != 0) continue;
    const double t = 0.02 * step;
    EXPECT_NEAR(end_mm(body, moving.displacement_mm()), elastic_mm(4.0) * (crept(creep, t) - crept(creep, t - 3.0)),
                0.01 * elastic_mm(4.0))
        << t;
  }
}

// Held where it was put at once, what a body resists with follows G(t), at any strain and any step.
TEST(Relaxation, AHeldBodyRelaxesByItsModulus) {
  const Body body = bar(water);
  for (const MaterialLaw law : all_laws) {
    const double strain = law == MaterialLaw::linear ? 0.01 : 0.2;
    VectorXd u_mm(3 * body.layout.nodes());
    for (int n = 0; n < body.layout.nodes(); ++n) {
      const Vector3d& x = body.layout.positions_mm[n];
      u_mm.segment<3>(3 * n) = Vector3d(strain * x.x() + 0.3 * strain * x.y(), -0.3 * strain * x.y(), 0);
    }
    const auto materials = materials_of(body, law, 2.0);
    const VectorXd at_once_mN = internal_force_mN(body, materials, u_mm);
    const std::vector<double> at_once_kPa = von_mises_of_cells(body, materials, u_mm);
    for (const double step_s : {0.03, 1.0}) {
      StressHistory history(body, materials, two_terms, step_s);
      history.jump(body, u_mm);
      EXPECT_LT((history.resisting_force_mN(body) - at_once_mN).norm(), 1e-12 * at_once_mN.norm());
      if (law == MaterialLaw::linear || law == MaterialLaw::corotational) {
        const double once_uJ = strain_energy_uJ(body, materials, u_mm);
        EXPECT_NEAR(history.free_energy_uJ(body), once_uJ, 1e-9 * once_uJ);
      }
      double last_uJ = history.free_energy_uJ(body);
      for (int step = 1; step <= 20; ++step) {
        history.advance(body, u_mm);
        const double left = left_after(two_terms, step * step_s);
        EXPECT_LT((history.resisting_force_mN(body) - left * at_once_mN).norm(), 1e-10 * at_once_mN.norm());
        EXPECT_NEAR(history.von_mises_of_cells(body, u_mm)[7], left * at_once_kPa[7], 1e-10 * at_once_kPa[7]);
        EXPECT_LT(history.free_energy_uJ(body), last_uJ);
        last_uJ = history.free_energy_uJ(body);
      }
    }
  }
}

// And in the movers: its ends held, nothing moves inside, and the walls' reaction relaxes.
TEST(Relaxation, WhatIsHeldAtBothEndsStaysAndPullsLess) {
  auto mesh = test::box(3, 2, 2, {bar_length_mm, 20, 20});
  test::name_points(mesh, "ends", [](const Vector3d& p) { return p.x() == 0 || p.x() == bar_length_mm; });
  StaticOptions options;
  options.order = ElementOrder::linear;
  auto youngs = test::uniform(mesh, bar_youngs_kPa);
  const Body body =
      prepare_body(std::move(mesh), std::move(youngs), {test::fixed("ends")}, options, Holding::required).value();
  // Drawn out by 1 mm: the equilibrium of an elastic body with that end held there.
  Scenario drawn;
  drawn.supports = {{geometry::Box{{-1, -1, -1}, {1, 21, 21}}, Fixed{}},
                    {geometry::Box{{59, -1, -1}, {61, 21, 21}}, Fixed{{true, true, true}, {1, 0, 0}}}};
  options.prescribed_displacements = true;
  const Body drawing = prepare_body(body.mesh, body.youngs_kPa, drawn.supports, options, Holding::required).value();
  const VectorXd u_mm = nodal_displacements(
      body.layout, find_equilibrium(drawing, materials_of(drawing, MaterialLaw::linear), Loads{}).value());
  ASSERT_NEAR(end_mm(body, u_mm), 1.0, 1e-9);
  auto moving = ImplicitEuler::create(
                    body, MaterialLaw::linear,
                    {.step_s = 0.1, .relaxation = two_terms, .relative_tolerance = 1e-9, .max_iterations = 2000})
                    .value();
  moving.set_state(u_mm, VectorXd::Zero(u_mm.size()));
  const auto pulls_mN = [&] {
    const VectorXd force = moving.history()->resisting_force_mN(body);
    double sum = 0;
    for (int n = 0; n < body.layout.nodes(); ++n) sum += body.layout.positions_mm[n].x() == 0 ? force[3 * n] : 0;
    return -sum;
  };
  const double at_once_mN = pulls_mN();
  EXPECT_GT(at_once_mN, bar_youngs_kPa * bar_area_mm2 / bar_length_mm);
  for (int step = 1; step <= 50; ++step) {
    ASSERT_TRUE(moving.step(VectorXd::Zero(u_mm.size())).converged);
    EXPECT_NEAR(pulls_mN(), at_once_mN * left_after(two_terms, 0.1 * step), 1e-5 * at_once_mN);
    EXPECT_LT((moving.displacement_mm() - u_mm).cwiseAbs().maxCoeff(), 1e-5);
  }
}

// E*(w) = E (1 - sum g / (1 + i w tau)): storage and loss of a bar that is pulled to and fro.
TEST(Relaxation, ASinusoidalPullShowsStorageAndLoss) {
  const Body body = bar(no_inertia);
  for (const double omega_per_s : {0.3, 2.0, 10.0}) {
    const int per_period = 400;
    const double step_s = 2 * std::numbers::pi / omega_per_s / per_period;
    auto moving = ImplicitEuler::create(
                      body, MaterialLaw::linear,
                      {.step_s = step_s, .relaxation = two_terms, .relative_tolerance = 1e-9, .max_iterations = 2000})
                      .value();
    const VectorXd force_mN = moving.force_of(pull(4.0)).value();
    const int before = 4 * per_period;
    Eigen::MatrixXd waves(per_period, 4);  // with what is left of the beginning, which has become slow
    VectorXd u_mm(per_period);
    for (int step = 1; step <= before + per_period; ++step) {
      const double phase = omega_per_s * step_s * step;
      ASSERT_TRUE(moving.step(std::sin(phase) * force_mN).converged);
      if (step <= before) continue;
      waves.row(step - before - 1) << std::sin(phase), std::cos(phase), 1, phase;
      u_mm[step - before - 1] = end_mm(body, moving.displacement_mm());
    }
    const Eigen::VectorXd part = waves.colPivHouseholderQr().solve(u_mm);
    const std::complex<double> measured_kPa = bar_youngs_kPa * elastic_mm(4.0) / std::complex(part[0], part[1]);
    std::complex<double> expected_kPa = bar_youngs_kPa;
    for (const auto& [weight, tau_s] : two_terms) {
      expected_kPa -= bar_youngs_kPa * weight / std::complex(1.0, omega_per_s * tau_s);
    }
    EXPECT_NEAR(measured_kPa.real(), expected_kPa.real(), 0.002 * std::abs(expected_kPa)) << omega_per_s;
    EXPECT_NEAR(measured_kPa.imag(), expected_kPa.imag(), 0.002 * std::abs(expected_kPa)) << omega_per_s;
  }
}

VectorXd wavy(const Body& body, double amount_mm, double phase) {
  VectorXd u(3 * body.layout.nodes());
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = amount_mm * std::sin(1.3 * double(i) + phase);
  return u;
}

// Of a path through wavy states each law's stress is the sum over all of its past, T0 growing evenly within a step:
// the integral of G over each step, not a recurrence.
TEST(Relaxation, StressIsTheSumOverAllOfThePast) {
  const Body body = bar(water);
  const double h = 0.37;
  for (const MaterialLaw law : all_laws) {
    const auto materials = materials_of(body, law, 2.0);
    StressHistory history(body, materials, two_terms, h);
    std::vector<VectorXd> path;
    for (int step = 1; step <= 8; ++step) {
      path.push_back(wavy(body, law == MaterialLaw::linear ? 0.02 : 0.5, 0.9 * step * step));
      history.advance(body, path.back());
    }
    const auto in_frame = [&](const Matrix3d& f, const Material& material) -> std::pair<Matrix3d, Matrix3d> {
      const Matrix3d p = first_piola_kPa(material, f);
      if (law == MaterialLaw::linear) return {Matrix3d::Identity(), p};
      if (law == MaterialLaw::corotational) {
        const Matrix3d r = polar_decomposition(f).rotation;
        return {r, r.transpose() * p};
      }
      return {f, f.colPivHouseholderQr().solve(p)};
    };
    VectorXd slow_mN = VectorXd::Zero(path.back().size());
    for (std::size_t c = 0; c < body.layout.cells.size(); ++c) {
      const CellGeometry shape = cell_geometry(body.mesh, c);
      Matrix3d stress = Matrix3d::Zero(), before = stress, frame = stress;
      for (std::size_t m = 0; m < path.size(); ++m) {
        Matrix3d f = Matrix3d::Identity();
        for (int i = 0; i < 4; ++i) {
          f += path[m].segment<3>(3 * body.layout.cells[c][i]) * shape.barycentric_gradients.row(i);
        }
        const auto [turned, elastic] = in_frame(f, materials[c]);
        double mean = long_term_share(two_terms);  // of G(t - s) over the step
        const double from_s = h * double(path.size() - 1 - m), to_s = from_s + h;
        for (const auto& [weight, tau_s] : two_terms) {
          mean += weight * tau_s / h * (std::exp(-from_s / tau_s) - std::exp(-to_s / tau_s));
        }
        stress += mean * (elastic - before);
        before = elastic;
        frame = turned;
      }
      for (int i = 0; i < 4; ++i) {
        slow_mN.segment<3>(3 * body.layout.cells[c][i]) +=
            shape.volume_mm3 * frame * stress * shape.barycentric_gradients.row(i).transpose();
      }
    }
    EXPECT_GT(slow_mN.norm(), 1.0);
    EXPECT_LT((history.resisting_force_mN(body) - slow_mN).norm(), 1e-10 * slow_mN.norm());
  }
}

// A strained body that is turned as it relaxes relaxes as one that stays, and its forces turn with it.
TEST(Relaxation, NoTurnOfTheBodyChangesWhatItIsMadeOf) {
  const Body body = bar(water);
  const Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const VectorXd u_mm = wavy(body, 0.4, 0.3);
  VectorXd turned_mm(u_mm.size());
  for (int n = 0; n < body.layout.nodes(); ++n) {
    const Vector3d& x = body.layout.positions_mm[n];
    turned_mm.segment<3>(3 * n) = turn * (x + u_mm.segment<3>(3 * n)) - x;
  }
  for (const MaterialLaw law : {MaterialLaw::corotational, MaterialLaw::neo_hookean, MaterialLaw::veronda_westmann}) {
    const auto materials = materials_of(body, law, 2.0);
    StressHistory stays(body, materials, two_terms, 0.3), turns(body, materials, two_terms, 0.3);
    for (StressHistory* history : {&stays, &turns}) history->jump(body, u_mm);
    stays.advance(body, u_mm);
    turns.advance(body, turned_mm);
    const VectorXd expected = stays.resisting_force_mN(body), found = turns.resisting_force_mN(body);
    for (int n = 0; n < body.layout.nodes(); ++n) {
      EXPECT_LT((found.segment<3>(3 * n) - turn * expected.segment<3>(3 * n)).norm(), 1e-9 * expected.norm());
    }
  }
}

// On any path with any step what is put in is at least what is stored more: at small strain always.
TEST(Relaxation, NeverGivesBackMoreThanWasPutIn) {
  const Body body = bar(water);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const double step_s : {0.01, 0.3, 4.0, 200.0}) {
    StressHistory history(body, materials_of(body, MaterialLaw::linear), {{0.5, 0.3}, {0.4, 6.0}}, step_s);
    VectorXd u_mm = VectorXd::Zero(3 * body.layout.nodes());
    double stored_uJ = 0, lost_uJ = 0;
    for (int step = 0; step < 60; ++step) {
      VectorXd next = u_mm;
      if (step % 4 != 3) {
        for (Eigen::Index i = 0; i < next.size(); ++i) next[i] = 0.02 * any(random);
      }
      history.advance(body, next);
      const double work_uJ = history.resisting_force_mN(body).dot(next - u_mm);
      const double now_uJ = history.free_energy_uJ(body);
      EXPECT_GE(work_uJ - (now_uJ - stored_uJ), -1e-12 * now_uJ) << step_s << " s, step " << step;
      lost_uJ += work_uJ - (now_uJ - stored_uJ);
      stored_uJ = now_uJ;
      u_mm = next;
    }
    EXPECT_GT(lost_uJ, 0.1 * stored_uJ);
  }
}

// Let go from a stretch, kinetic and free energy only fall, faster than without relaxation, by every law.
TEST(Relaxation, ASwingingBodyOnlyLosesEnergyAndLosesItFaster) {
  const Body body = bar(water);
  const auto energies_uJ = [&](MaterialLaw law, const Relaxation& relaxation) {
    const auto materials = materials_of(body, law, 2.0);
    auto moving = NewtonImplicitEuler::create(
                      body, materials, applied_loads(body, {}, pressure_kind_of(materials)).value(),
                      {.step_s = 0.001, .relaxation = relaxation, .relative_tolerance = 1e-8, .max_iterations = 40})
                      .value();
    VectorXd v_mm_s(3 * body.layout.nodes());
    for (int n = 0; n < body.layout.nodes(); ++n) {
      v_mm_s.segment<3>(3 * n) = Vector3d(8 * body.layout.positions_mm[n].x(), 0, 0);
    }
    moving.set_velocity(v_mm_s);
    std::vector<double> all;
    for (int step = 0; step < 60; ++step) {
      const StepReport report = moving.step().value();
      EXPECT_TRUE(report.converged);
      all.push_back(report.kinetic_energy_uJ + report.strain_energy_uJ);
    }
    return all;
  };
  for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::neo_hookean}) {
    const auto elastic = energies_uJ(law, {}), relaxing = energies_uJ(law, {{0.5, 0.02}});
    for (std::size_t i = 1; i < relaxing.size(); ++i) EXPECT_LT(relaxing[i], relaxing[i - 1]) << i;
    EXPECT_LT(relaxing.back(), 0.7 * elastic.back());
  }
}

TEST(Relaxation, TheSameStepsGiveTheSameBitsWithAnyNumberOfThreads) {
  const Body body = bar(water);
  const auto run = [&](int threads, MaterialLaw law) {
    set_thread_count(threads);
    const DynamicsOptions options{.step_s = 0.02, .relaxation = two_terms, .max_iterations = 500};
    VectorXd u_mm;
    if (law == MaterialLaw::neo_hookean) {
      const auto materials = materials_of(body, law);
      auto moving = NewtonImplicitEuler::create(
                        body, materials, applied_loads(body, pull(800), pressure_kind_of(materials)).value(), options)
                        .value();
      for (int step = 0; step < 6; ++step) EXPECT_TRUE(moving.step().value().converged);
      u_mm = moving.displacement_mm();
    } else {
      auto moving = ImplicitEuler::create(body, law, options).value();
      const VectorXd force_mN = moving.force_of(pull(800)).value();
      for (int step = 0; step < 20; ++step) EXPECT_TRUE(moving.step(force_mN).converged);
      u_mm = moving.displacement_mm();
    }
    set_thread_count(0);
    return u_mm;
  };
  for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::corotational, MaterialLaw::neo_hookean}) {
    const VectorXd once = run(1, law);
    EXPECT_GT(once.norm(), 1.0);
    EXPECT_EQ((once - run(1, law)).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_EQ((once - run(2, law)).cwiseAbs().maxCoeff(), 0.0);
  }
}

}  // namespace
}  // namespace glisson::mechanics
