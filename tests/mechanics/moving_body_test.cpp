// A linear body in motion under tools: against the steps of `simulate` by Newton's method, against closed forms, and
// what no step may give.

#include "mechanics/dynamics/moving_body.h"

#include <gmock/gmock.h>
#include <cmath>
#include <complex>
#include <numbers>

#include "mechanics/bodies.h"
#include "mechanics/dynamics/internal/implicit_step.h"
#include "mechanics/elements/internal/mass_matrix.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/solvers/internal/newton.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

// 80 x 80 x 40 mm, soft and stiff, its ground fixed and its far side on springs.
struct Block {
  geometry::TetMesh mesh;
  std::vector<double> at_once_kPa;
  std::vector<Support> supports;
  StaticOptions options;
};
Block soft_and_stiff() {
  Block block;
  block.mesh = test::box(4, 4, 2, {80, 80, 40});
  test::disturb_inner_points(block.mesh, 2.0);
  test::name_points(block.mesh, "ground", [](const Vector3d& p) { return p.z() == 0; });
  test::name_points(block.mesh, "far", [](const Vector3d& p) { return p.x() == 80; });
  for (std::size_t c = 0; c < block.mesh.cells.size(); ++c) {
    block.at_once_kPa.push_back(geometry::cell_centroid_mm(block.mesh, c).x() < 40 ? 4 : 12);
  }
  block.supports = {test::fixed("ground"), {NamedPoints{"far"}, Foundation{0.05}}};
  return block;
}

StaticModel at_rest(const Block& block, const Relaxation& relaxation = {}) {
  std::vector<double> after_long_kPa = block.at_once_kPa;
  for (double& modulus_kPa : after_long_kPa) modulus_kPa *= long_term_share(relaxation);
  return StaticModel::create(block.mesh, after_long_kPa, block.supports, block.options).value();
}

// A step the obvious way: the minimum of its potential energy, the whole tangent factorised anew.
struct SlowMotion {
  Body body;
  std::vector<Material> materials;  // of a step
  DynamicsOptions options;
  Eigen::SparseMatrix<double> mass_kg;
  StressHistory history;
  VectorXd u_mm, v_mm_s;

  SlowMotion(const Block& block, const DynamicsOptions& with, const VectorXd& from_mm)
      : body(prepare_body(block.mesh, block.at_once_kPa, block.supports, block.options, Holding::required).value()),
        materials(materials_of(body, MaterialLaw::linear)),
        options(with),
        mass_kg(consistent_mass_kg(body)),
        history(body, materials, with.relaxation, with.step_s),
        u_mm(from_mm),
        v_mm_s(VectorXd::Zero(from_mm.size())) {
    for (Material& material : materials) material = scaled(material, share_within(with.relaxation, with.step_s));
  }

  void step(const VectorXd& dead_mN) {
    const AppliedLoads loads{dead_mN};
    const ImplicitStep step(body, materials, loads, options, mass_kg, u_mm, v_mm_s,
                            options.relaxation.empty() ? Potentials() : history.potentials(body));
    const auto found = minimise(step.potential(), body.resolved.fixed, step.scale_mN(), u_mm,
                                {1e-8, 40, body.options.memory_limit_bytes}, {})
                           .value();
    ASSERT_TRUE(found.converged);
    v_mm_s = (found.u_mm - u_mm) / options.step_s;
    u_mm = found.u_mm;
    history.advance(body, u_mm);
  }
};

// Of a state's tools, on the nodes.
VectorXd forces_mN(const MovingBody& moving, const Body& body, const MovingState& state) {
  VectorXd force_mN = VectorXd::Zero(state.u_mm.size());
  const auto& mesh_point = geometry::find_field(moving.surface().point_fields, "mesh_point")->values;
  for (const auto& [point, force] : state.force_mN) {
    force_mN.segment<3>(3 * body.layout.node_of_point[std::size_t(mesh_point[std::size_t(point)])]) += force;
  }
  return force_mN;
}

ContactTool jaws_that_pull(double pull_mN) { return {"pull", Grasp{{60, 60, 40}, 15, pull_mN, {0.3, 0, 1}}}; }
ContactTool jaws_at(const Vector3d& drawn_mm) { return {"hold", Grasp{{60, 20, 40}, 12, drawn_mm, {0, 0, 1}}}; }
ContactTool probe_at(double depth_mm) {
  return {"probe",
          TouchingTool{palpation_probe(8), pose_towards({25, 40, 48 - depth_mm}, {0, 0, -1}), std::nullopt, 0}};
}

// The mean displacement along z of what jaws hold there, by the surface's area around each point.
double mean_of_patch_mm(const MovingBody& moving, const MovingState& state, const Vector3d& place_mm,
                        double radius_mm) {
  const geometry::Surface& surface = moving.surface();
  std::vector<double> area_mm2(surface.points_mm.size(), 0.0);
  for (const auto& [a, b, c] : surface.triangles) {
    const Vector3d& p = surface.points_mm[std::size_t(a)];
    const double sixth_mm2 =
        (surface.points_mm[std::size_t(b)] - p).cross(surface.points_mm[std::size_t(c)] - p).norm() / 6;
    for (const int corner : {a, b, c}) area_mm2[std::size_t(corner)] += sixth_mm2;
  }
  double sum_mm = 0, sum_mm2 = 0;
  for (std::size_t p = 0; p < surface.points_mm.size(); ++p) {
    if ((surface.points_mm[p] - place_mm).norm() > radius_mm) continue;
    sum_mm += area_mm2[p] * state.surface_mm[p].z();
    sum_mm2 += area_mm2[p];
  }
  return sum_mm / sum_mm2;
}

// Tools come, press, hold, pull and go; what they push with is what the slow motion is loaded by.
TEST(MovingBody, StepsUnderToolsAreThoseOfTheSlowMotion) {
  Block block = soft_and_stiff();
  for (const Relaxation& relaxation : {Relaxation{}, Relaxation{{0.3, 0.05}, {0.25, 0.6}}}) {
    const DynamicsOptions options{
        .step_s = 0.01, .mass_damping_per_s = 1.5, .stiffness_damping_s = 0.004, .relaxation = relaxation};
    const auto moving = MovingBody::create(at_rest(block, relaxation), {}, {}, 0, options).value();
    MovingState state = moving.untouched();
    SlowMotion slow(block, options, state.u_mm);
    double largest_mm = 0;
    for (int step = 1; step <= 60; ++step) {
      std::vector<ContactTool> tools;
      if (step < 50) tools.push_back(probe_at(std::min(0.4 * step, 6.0)));
      if (step >= 10 && step < 40) tools.push_back(jaws_that_pull(150));
      if (step >= 20) tools.push_back(jaws_at({0, 0, std::min(0.3 * (step - 19), 3.0)}));
      state = moving.step(state, tools).value();
      ASSERT_TRUE(state.report.converged) << step;
      EXPECT_LE(state.report.penetration_mm, 0.1) << step;
      slow.step(forces_mN(moving, slow.body, state));
      largest_mm = std::max(largest_mm, slow.u_mm.cwiseAbs().maxCoeff());
      ASSERT_LT((state.u_mm - slow.u_mm).cwiseAbs().maxCoeff(), 2e-5 * largest_mm) << step;
      if (step >= 20) {
        EXPECT_NEAR(mean_of_patch_mm(moving, state, {60, 20, 40}, 12), 0.3 * std::min(step - 19, 10), 1e-3);
      }
    }
    EXPECT_GT(largest_mm, 4);
    EXPECT_NEAR(state.time_s, slow.options.step_s * 60, 1e-12);
  }
}

TEST(MovingBody, BeginsAtRestUnderItsLoadsAndStays) {
  const Block block = soft_and_stiff();
  const Relaxation relaxation{{0.4, 0.5}};
  const StaticModel model = at_rest(block, relaxation);
  const Loads loads{GravityLoad{{0, 0, -9810}}};
  const auto moving = MovingBody::create(model, loads, {}, 0, {.step_s = 0.02, .relaxation = relaxation}).value();
  const VectorXd rest_mm = nodal_displacements(model.nodes(), model.solve(loads).value());
  MovingState state = moving.untouched();
  for (int step = 0; step < 50; ++step) state = moving.step(state, {}).value();
  EXPECT_GT(rest_mm.cwiseAbs().maxCoeff(), 0.5);
  EXPECT_LT((state.u_mm - rest_mm).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_FALSE(state.moves);
}

// A bar that does not grow thin (Poisson's ratio 0), fixed at one end: along its length it swings as a string does, in
// 4 L sqrt(density / E). A step of implicit Euler with Rayleigh's damping multiplies the mode by the root z of
// (1 + h alpha + (h^2 + h beta) w^2) z^2 - (2 + h alpha + h beta w^2) z + 1.
TEST(MovingBody, SwingsWithThePeriodAndTheDampingOfTheClosedForm) {
  constexpr double length_mm = 60, youngs_kPa = 20, density_kg_mm3 = 1e-6, amplitude_mm = 1;
  Block block;
  block.mesh = test::box(12, 1, 1, {length_mm, 5, 5});
  test::name_points(block.mesh, "x0", [](const Vector3d& p) { return p.x() == 0; });
  block.at_once_kPa = test::uniform(block.mesh, youngs_kPa);
  block.supports = {test::fixed("x0")};
  block.options.poisson_ratio = 0;
  block.options.density_kg_mm3 = density_kg_mm3;
  const double w = std::numbers::pi / (2 * length_mm) * std::sqrt(youngs_kPa / density_kg_mm3);
  const double period_s = 2 * std::numbers::pi / w, h = period_s / 200;
  const StaticModel model = at_rest(block);
  for (const auto& [alpha, beta] : {std::pair(0.0, 0.0), std::pair(8.0, 0.0), std::pair(0.0, 1e-3)}) {
    const auto moving =
        MovingBody::create(model, {}, {}, 0, {.step_s = h, .mass_damping_per_s = alpha, .stiffness_damping_s = beta})
            .value();
    MovingState state = moving.untouched();
    const auto shape = [&](double x_mm) { return amplitude_mm * std::sin(std::numbers::pi * x_mm / (2 * length_mm)); };
    const NodeLayout& layout = model.nodes();
    for (std::size_t c = 0; c < layout.cells.size(); ++c) {
      for (int i = 0; i < layout.nodes_per_cell(); ++i) {
        const auto ends = i < 4 ? std::array{i, i} : edges_of_cell[std::size_t(i - 4)];
        double x_mm = 0;
        for (const int end : ends) {
          x_mm += 0.5 * block.mesh.points_mm[std::size_t(block.mesh.cells[c][std::size_t(end)])].x();
        }
        state.u_mm[3 * layout.cells[c][std::size_t(i)]] = shape(x_mm);
      }
    }
    const double a = 1 + h * alpha + (h * h + h * beta) * w * w, b = 2 + h * alpha + h * beta * w * w;
    const std::complex<double> z = (b + std::sqrt(std::complex<double>(b * b - 4 * a))) / (2 * a), q = 1.0 / z;
    const std::complex<double> c(amplitude_mm / 2, (q.real() - 1) * amplitude_mm / (2 * q.imag()));
    const int tip = 3 * layout.node_of_point[test::point_at(block.mesh, {length_mm, 0, 0})];
    std::vector<double> crossings_s;
    double before_mm = amplitude_mm;
    for (int step = 1; step <= 600; ++step) {
      state = moving.step(state, {}).value();
      ASSERT_NEAR(state.u_mm[tip], 2 * (c * std::pow(z, step)).real(), 0.01 * amplitude_mm) << alpha << ' ' << beta;
      if ((state.u_mm[tip] < 0) != (before_mm < 0)) crossings_s.push_back(state.time_s);
      before_mm = state.u_mm[tip];
    }
    ASSERT_GE(crossings_s.size(), 5U);
    EXPECT_NEAR(crossings_s[4] - crossings_s[0], 2 * period_s, 0.01 * period_s + 2 * h);
  }
}

TEST(MovingBody, GainsNoEnergyInThousandsOfFreeSteps) {
  Block block = soft_and_stiff();
  block.mesh = test::box(3, 2, 2, {60, 40, 40});
  test::name_points(block.mesh, "ground", [](const Vector3d& p) { return p.z() == 0; });
  test::name_points(block.mesh, "far", [](const Vector3d& p) { return p.x() == 60; });
  block.at_once_kPa = test::uniform(block.mesh, 6);
  for (const Relaxation& relaxation : {Relaxation{}, Relaxation{{0.4, 0.3}, {0.2, 4.0}}}) {
    for (const double step_s : {0.0005, 0.05}) {
      const auto moving =
          MovingBody::create(at_rest(block, relaxation), {}, {}, 0, {.step_s = step_s, .relaxation = relaxation})
              .value();
      MovingState state = moving.untouched();
      for (int step = 0; step < 20; ++step) {
        state = moving.step(state, {{"pull", Grasp{{50, 20, 40}, 12, 20.0 * step, {0.3, 0, 1}}}}).value();
      }
      const double at_first_uJ = moving.energy_uJ(state);
      double before_uJ = at_first_uJ;
      for (int step = 0; step < 3000; ++step) {
        state = moving.step(state, {}).value();
        const double now_uJ = moving.energy_uJ(state);
        ASSERT_LE(now_uJ, before_uJ + 1e-7 * at_first_uJ) << step;
        before_uJ = now_uJ;
      }
      EXPECT_GT(at_first_uJ, 100);
    }
  }
}

// All moduli relax alike: under a steady pull each place creeps as J(t), whatever the shape, and comes back as what the
// pull's end leaves of it.
TEST(MovingBody, CreepsAndComesBackAsTheClosedForm) {
  Block block = soft_and_stiff();
  block.supports = {test::fixed("ground")};  // springs would not creep along
  block.options.density_kg_mm3 = 1e-10;      // inertia is nothing here
  const double amplitude = 0.8, time_s = 2;
  const Relaxation relaxation = relaxation_of({{amplitude, time_s}});
  const double h = 0.01;
  const auto moving =
      MovingBody::create(at_rest(block, relaxation), {}, {}, 0, {.step_s = h, .relaxation = relaxation}).value();
  const auto creep = [&](double t_s) { return 1 + amplitude * (1 - std::exp(-t_s / time_s)); };
  MovingState state = moving.step(moving.untouched(), {jaws_that_pull(200)}).value();
  const VectorXd at_once_mm = state.u_mm / creep(h / 2);
  for (int step = 2; step <= 400; ++step) {
    state = moving.step(state, {jaws_that_pull(200)}).value();
    if (step % 50 == 0) {
      EXPECT_LT((state.u_mm - creep(step * h) * at_once_mm).norm(), 0.005 * state.u_mm.norm()) << step;
    }
  }
  for (int step = 1; step <= 400; ++step) {
    state = moving.step(state, {}).value();
    if (step % 50 == 0) {
      const double left = creep(4 + step * h) - creep(step * h);
      EXPECT_LT((state.u_mm - left * at_once_mm).norm(), 0.01 * at_once_mm.norm()) << step;
    }
  }
  EXPECT_TRUE(state.moves);  // an eighth of what crept is still to come back
}

TEST(MovingBody, ComesToRestWhereTheBodyAtRestIs) {
  const Block block = soft_and_stiff();
  const Relaxation relaxation{{0.5, 0.1}};
  const StaticModel model = at_rest(block, relaxation);
  const std::vector<PointInMesh> places = locate_points(block.mesh, {{25, 40, 30}, {60, 20, 35}});
  const auto still = ContactBody::create(model, {}, places, 2).value();
  const auto moving = MovingBody::create(model, {}, places, 2, {.step_s = 0.02, .relaxation = relaxation}).value();
  ContactState rest = still.untouched();
  MovingState state = moving.untouched();
  std::vector<ContactTool> tools;
  for (int step = 1; step <= 5; ++step) {
    tools = {probe_at(1.2 * step), jaws_at({0, 0, 0.6 * step})};
    rest = still.solve(rest, tools).value();
    state = moving.step(state, tools).value();
  }
  int steps = 0;
  for (; steps < 2000 && state.moves; ++steps) state = moving.step(state, tools).value();
  EXPECT_LT(steps, 400);
  for (std::size_t w = 0; w < places.size(); ++w) {
    EXPECT_LT((state.watched_mm[w] - rest.watched_mm[w]).norm(), 0.05);  // the contact's own tolerance
  }
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_LT((state.tools[t].force_mN - rest.tools[t].force_mN).norm(), 0.02 * rest.tools[t].force_mN.norm());
  }
}

TEST(MovingBody, RefusesWhatItCannotMove) {
  Block block = soft_and_stiff();
  EXPECT_THAT(MovingBody::create(at_rest(block), {}, {}, 0, {.step_s = 0}).error().message(), HasSubstr("step"));
  block.options.order = ElementOrder::linear;
  EXPECT_THAT(MovingBody::create(at_rest(block), {}, {}, 0, {}).error().message(), HasSubstr("quadratic"));
}

}  // namespace
}  // namespace glisson::mechanics
