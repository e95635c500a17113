// Problems whose answers are in textbooks: columns, springs, beams, Cook's membrane, Lame's cylinder.

#include <gmock/gmock.h>
#include <cmath>

#include "mechanics/bodies.h"
#include "mechanics/elements/boundary.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using test::box;
using test::fixed;
using test::held_along;
using test::uniform;

constexpr double g_mm_s2 = 9810.0;

// Solves with a traction (kPa, a function of the face's normal) on the faces that the predicate takes.
template <typename Takes, typename Traction>
StaticResult solve_with_traction(const StaticModel& model, Takes takes, Traction traction_kPa) {
  NodalLoad load;
  load.force_mN = Eigen::VectorXd::Zero(3 * model.nodes().nodes());
  for (const BoundaryFace& face : boundary_faces(model.mesh(), model.nodes())) {
    if (takes(face)) add_traction(face, traction_kPa(face.normal), load.force_mN);
  }
  return model.solve_nodal(load).value();
}

StaticOptions options_for(double poisson_ratio, ElementOrder order = ElementOrder::quadratic) {
  StaticOptions options;
  options.poisson_ratio = poisson_ratio;
  options.order = order;
  return options;
}

TEST(Column, UnderItsOwnWeightShortensAsTheClosedFormSays) {
  // nu = 0: u_z = -(rho g / E) (L z - z^2 / 2), a quadratic that the cells hold exactly.
  auto mesh = box(2, 2, 4, {10, 10, 50});
  test::disturb_inner_points(mesh, 1.0);
  test::name_points(mesh, "floor", [](const Vector3d& p) { return p.z() == 0; });
  const double rho = 1000e-9, youngs = 6.0;
  const auto result =
      solve_static(mesh, uniform(mesh, youngs), {fixed("floor")}, {GravityLoad{{0, 0, -g_mm_s2}}}, options_for(0.0))
          .value();
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    const double z = mesh.points_mm[p].z();
    const Vector3d expected(0, 0, -rho * g_mm_s2 / youngs * (50 * z - z * z / 2));
    EXPECT_LT((result.displacement_mm[p] - expected).norm(), 1e-10);  // of 2 mm
  }
}

TEST(Column, OnSpringsSinksByItsWeightOverTheirStiffness) {
  auto mesh = box(2, 2, 4, {10, 10, 50});
  test::name_points(mesh, "floor", [](const Vector3d& p) { return p.z() == 0; });
  const double rho = 1000e-9, youngs = 6.0, k = 0.5;
  const auto result = solve_static(mesh, uniform(mesh, youngs), {{NamedPoints{"floor"}, Foundation{k}}},
                                   {GravityLoad{{0, 0, -g_mm_s2}}}, options_for(0.0))
                          .value();
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    const double z = mesh.points_mm[p].z();
    const double sinks = rho * g_mm_s2 * 50 / k;
    const Vector3d expected(0, 0, -sinks - rho * g_mm_s2 / youngs * (50 * z - z * z / 2));
    EXPECT_LT((result.displacement_mm[p] - expected).norm(), 1e-10);
  }
  EXPECT_NEAR(result.foundation_reaction_mN.z(), rho * g_mm_s2 * 5000, 1e-8);
}

TEST(Pressure, AllAroundShrinksAnyBodyUniformly) {
  // u = -p (1 - 2 nu) / E x, for every shape; three symmetry planes hold it.
  auto mesh = test::bent_box(4, 4, 4, [](const Vector3d& unit) {
    const Vector3d cube = 20 * unit;
    return Vector3d(cube.x() + 0.02 * cube.x() * cube.y(), cube.y() + 0.01 * cube.y() * cube.z(), cube.z());
  });
  test::name_points(mesh, "x0", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "y0", [](const Vector3d& p) { return p.y() == 0; });
  test::name_points(mesh, "z0", [](const Vector3d& p) { return p.z() == 0; });
  const double pressure = 1.6, nu = 0.45, youngs = 6.0;  // 12 mmHg, as in insufflation
  const auto result = solve_static(mesh, uniform(mesh, youngs),
                                   {held_along("x0", true, false, false), held_along("y0", false, true, false),
                                    held_along("z0", false, false, true)},
                                   {PressureLoad{pressure}}, options_for(nu))
                          .value();
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    const Vector3d expected = -pressure * (1 - 2 * nu) / youngs * mesh.points_mm[p];
    EXPECT_LT((result.displacement_mm[p] - expected).norm(), 1e-10);  // of 0.7 mm
  }
}

TEST(LameCylinder, UnderInnerPressureApproachesTheClosedForm) {
  // A quarter of a thick tube in plane strain: u_r = (1 + nu) p a2 / (E (b2 - a2)) ((1 - 2 nu) r + b2 / r)
  // (Timoshenko and Goodier, Theory of Elasticity, art. 28). Straight edges replace the arcs, so the shape itself is
  // off by h2 / 8a: with 12 cells to the quarter, 0.2 %.
  const double a = 10, b = 20, nu = 0.45, youngs = 6.0, p = 0.5;
  auto mesh = test::bent_box(8, 12, 1, [&](const Vector3d& unit) {
    const double r = a + (b - a) * unit.x(), angle = M_PI / 2 * unit.y();
    return Vector3d(r * std::cos(angle), r * std::sin(angle), 2 * unit.z());
  });
  test::name_points(mesh, "x0", [](const Vector3d& q) { return std::abs(q.x()) < 1e-9; });
  test::name_points(mesh, "y0", [](const Vector3d& q) { return std::abs(q.y()) < 1e-9; });
  test::name_points(mesh, "all", [](const Vector3d&) { return true; });
  const auto model = StaticModel::create(mesh, uniform(mesh, youngs),
                                         {held_along("x0", true, false, false), held_along("y0", false, true, false),
                                          held_along("all", false, false, true)},
                                         options_for(nu))
                         .value();
  const auto result = solve_with_traction(
      model, [&](const BoundaryFace& face) { return face.centroid_mm.head<2>().norm() < a + 0.1; },
      [&](const Vector3d& normal) { return Vector3d(-p * normal); });
  for (const double r : {10.0, 15.0, 20.0}) {
    const double expected = (1 + nu) * p * a * a / (youngs * (b * b - a * a)) * ((1 - 2 * nu) * r + b * b / r);
    const double angle = M_PI / 4;
    const auto at = test::point_at(mesh, {r * std::cos(angle), r * std::sin(angle), 0});
    EXPECT_NEAR(result.displacement_mm[at].norm(), expected, 0.005 * expected) << "at r = " << r;
  }
}

// --- the cantilever of table 6.1 of the dissertation: 50 x 10 x 10 mm, 12 kPa, 997 kg/m3

constexpr double beam_length = 50, beam_height = 10, beam_youngs = 12, beam_density = 997e-9;
constexpr double beam_area = beam_height * beam_height;
constexpr double beam_inertia = beam_area * beam_height * beam_height / 12;

StaticModel cantilever(int across, double nu, ElementOrder order = ElementOrder::quadratic) {
  auto mesh = box(5 * across, across, across, {beam_length, beam_height, beam_height});
  test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  StaticOptions options = options_for(nu, order);
  options.density_kg_mm3 = beam_density;
  return StaticModel::create(mesh, uniform(mesh, beam_youngs), {fixed("wall")}, options).value();
}

double shear_stiffness(double nu) {
  const double kappa = 10 * (1 + nu) / (12 + 11 * nu);  // Cowper 1966, for a rectangle
  return kappa * beam_youngs / (2 * (1 + nu)) * beam_area;
}

double axis_deflection(const StaticModel& model, const StaticResult& result, double x) {
  const auto places = locate_points(model.mesh(), {{x, beam_height / 2, beam_height / 2}});
  return -model.displacement_at(result, places)[0].z();
}

TEST(Cantilever, UnderItsWeightFollowsTheDissertationsBeamWithShear) {
  // Equation 6.6, w(x) = f x2 (6 L2 - 4 L x + x2) / (24 E I), is Euler and Bernoulli's; Timoshenko's adds the shear,
  // f (L x - x2 / 2) / (kappa G A), 3 % at the tip of this stocky beam. At nu = 0 the wall causes no end effect.
  const auto model = cantilever(2, 0.0);
  const auto result = model.solve({GravityLoad{{0, 0, -g_mm_s2}}}).value();
  const double f = beam_density * g_mm_s2 * beam_area;
  for (const double x : {12.5, 25.0, 37.5, 50.0}) {
    const double euler =
        f * x * x * (6 * beam_length * beam_length - 4 * beam_length * x + x * x) / (24 * beam_youngs * beam_inertia);
    const double timoshenko = euler + f * (beam_length * x - x * x / 2) / shear_stiffness(0.0);
    EXPECT_NEAR(axis_deflection(model, result, x), timoshenko, 0.01 * timoshenko) << "at x = " << x;
    EXPECT_GT(axis_deflection(model, result, x), euler);
  }
}

TEST(Cantilever, UnderAnEndLoadFollowsTimoshenko) {
  const auto model = cantilever(4, 0.0);
  const double force = 0.5;  // mN
  const auto result = model.solve({ToolLoad{{50, 5, 5}, 4.5, {0, 0, -force}}}).value();
  const double euler = force * std::pow(beam_length, 3) / (3 * beam_youngs * beam_inertia);
  const double timoshenko = euler + force * beam_length / shear_stiffness(0.0);
  EXPECT_NEAR(axis_deflection(model, result, beam_length), timoshenko, 0.01 * timoshenko);
}

TEST(Cantilever, NearIncompressibilityQuadraticCellsKeepTheBeamAndLinearOnesLock) {
  // nu = 0.49. The wall keeps the section from narrowing, which stiffens a stocky three-dimensional beam against beam
  // theory's 80.0 mm: refining the quadratic cells gives 71.0, 74.6 and 75.3 mm (2, 4 and 6 bricks across). Linear
  // cells with as many nodes as the second give 44.8.
  const Loads weight{GravityLoad{{0, 0, -g_mm_s2}}};
  const double f = beam_density * g_mm_s2 * beam_area, nu = 0.49;
  const double timoshenko = f * std::pow(beam_length, 4) / (8 * beam_youngs * beam_inertia) +
                            f * beam_length * beam_length / 2 / shear_stiffness(nu);
  const auto quadratic = cantilever(4, nu);
  const auto linear = cantilever(8, nu, ElementOrder::linear);
  const double by_quadratic = axis_deflection(quadratic, quadratic.solve(weight).value(), beam_length);
  const double by_linear = axis_deflection(linear, linear.solve(weight).value(), beam_length);
  EXPECT_NEAR(by_quadratic, timoshenko, 0.08 * timoshenko);
  EXPECT_NEAR(by_quadratic, 75.3, 0.02 * 75.3);
  EXPECT_LT(by_linear, 0.6 * timoshenko);
  RecordProperty("timoshenko_mm", std::to_string(timoshenko));
  RecordProperty("quadratic_mm", std::to_string(by_quadratic));
  RecordProperty("linear_mm", std::to_string(by_linear));
}

TEST(BeamOnSprings, SinksUnderACentralLoadAsHetenyiSays) {
  // A free-free beam of length L on a foundation k b per length (Hetenyi, Beams on Elastic Foundation, 1946):
  // w(centre) = (P beta / 2 k b) (cosh bL + cos bL + 2) / (sinh bL + sin bL), beta = (k b / 4 E I)^(1/4).
  // Left out of it, and worth about 1 % together: shear, and the springs' pull along the beam's under-surface.
  const double length = 320, side = 10, youngs = 1000, k = 0.02, force = 10;
  auto mesh = box(40, 2, 2, {length, side, side});
  test::name_points(mesh, "underside", [](const Vector3d& p) { return p.z() == 0; });
  const auto model =
      StaticModel::create(mesh, uniform(mesh, youngs), {{NamedPoints{"underside"}, Foundation{k}}}, options_for(0.3))
          .value();
  const auto result = model.solve({ToolLoad{{length / 2, side / 2, side}, 6, {0, 0, -force}}}).value();
  const double kb = k * side, inertia = std::pow(side, 4) / 12;
  const double beta = std::pow(kb / (4 * youngs * inertia), 0.25), bl = beta * length;
  const double expected = force * beta / (2 * kb) * (std::cosh(bl) + std::cos(bl) + 2) / (std::sinh(bl) + std::sin(bl));
  const double sinks = -result.displacement_mm[test::point_at(mesh, {length / 2, side / 2, 0})].z();
  EXPECT_NEAR(sinks, expected, 0.02 * expected);
}

// --- Cook's membrane in plane strain: a slab of one layer whose points stay in their planes

double cook_tip_mm(int n, double nu, ElementOrder order) {
  auto mesh = test::bent_box(n, n, 1, [&](const Vector3d& unit) {
    const double x = 48 * unit.x(), low = 44 * unit.x(), high = 44 + 16 * unit.x();
    return Vector3d(x, low + (high - low) * unit.y(), 48.0 / n * unit.z());
  });
  test::name_points(mesh, "left", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "all", [](const Vector3d&) { return true; });
  const auto model = StaticModel::create(mesh, uniform(mesh, 250),
                                         {fixed("left"), held_along("all", false, false, true)}, options_for(nu, order))
                         .value();
  const auto result = solve_with_traction(
      model, [](const BoundaryFace& face) { return face.normal.x() > 0.999; },
      [](const Vector3d&) { return Vector3d(0, 100.0 / 16.0, 0); });
  EXPECT_TRUE(result.may_be_used()) << result.why_stopped;
  return result.displacement_mm[test::point_at(mesh, {48, 60, 0})].y();
}

TEST(CooksMembrane, DoesNotLockNearIncompressibility) {
  // E = 250, nu = 0.4999, F = 100: the tip rises by 7.77 (7.769 in Nakshatrala, Masud and Hjelmstad, On finite element
  // formulations for nearly incompressible linear elasticity, Comput. Mech. 41, 2008). Observed here with quadratic
  // cells: 6.09, 7.13, 7.52 (and 7.67 at 32 a side), rising towards it; linear cells stay near 2.1.
  const double reference = 7.769;
  const double coarse = cook_tip_mm(8, 0.4999, ElementOrder::quadratic);
  const double fine = cook_tip_mm(16, 0.4999, ElementOrder::quadratic);
  EXPECT_GT(coarse, 0.90 * reference);
  EXPECT_GT(fine, 0.96 * reference);
  EXPECT_LT(fine, reference);
  // Aitken's limit of the last three meshes, were the errors a geometric series.
  const double coarsest = cook_tip_mm(4, 0.4999, ElementOrder::quadratic);
  const double limit = fine + (fine - coarse) * (fine - coarse) / ((coarse - coarsest) - (fine - coarse));
  EXPECT_NEAR(limit, reference, 0.01 * reference);
  EXPECT_LT(cook_tip_mm(16, 0.4999, ElementOrder::linear), 0.35 * reference);
}

}  // namespace
}  // namespace glisson::mechanics
