// The terms of a body's potential energy: each energy against its force and each force against its tangent, and states
// whose answers are known.

#include "mechanics/potentials/total_potential.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/Geometry>

#include "mechanics/bodies.h"
#include "mechanics/contact/internal/cut_contact_potential.h"
#include "mechanics/contact/internal/grasp_potential.h"
#include "mechanics/contact/internal/tool_contact_potential.h"
#include "mechanics/materials/capsule.h"
#include "mechanics/potentials/dead_load.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/potentials/quadratic.h"
#include "mechanics/potentials/standing_stress.h"
#include "mechanics/potentials/stiffness_matrix.h"
#include "mechanics/scenario/patient_position.h"
#include "mechanics/statics/equilibrium.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

constexpr ElementOrder both_orders[] = {ElementOrder::linear, ElementOrder::quadratic};

struct Around {
  std::optional<Capsule> capsule;
  std::vector<Support> supports;
  double follower_pressure_kPa = 0;
};

Body body_of(geometry::TetMesh mesh, double youngs_kPa, ElementOrder order, const Around& around,
             Holding holding = Holding::optional, double poisson_ratio = 0.4) {
  auto youngs = test::uniform(mesh, youngs_kPa);
  StaticOptions options;
  options.poisson_ratio = poisson_ratio;
  options.order = order;
  options.capsule = around.capsule;
  return prepare_body(std::move(mesh), std::move(youngs), around.supports, options, holding).value();
}

geometry::TetMesh block() {
  auto mesh = test::box(3, 2, 2, {6, 4, 4});
  test::disturb_inner_points(mesh, 0.2);
  test::name_points(mesh, "end", [](const Vector3d& p) { return p.x() == 6; });
  return mesh;
}

VectorXd wavy(const Body& body, double amount_mm) {
  VectorXd u(3 * body.layout.nodes());
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = amount_mm * std::sin(1.3 * double(i) + 0.4);
  return u;
}

// What every term is judged by: its force is minus the slope of its energy, and its exact tangent that of its force.
// `what_moves` is the least norm of the change of force that the direction makes: no term is judged where it does not
// act.
void expect_slopes(const Potential& term, const Body& body, const VectorXd& u, const std::string& name,
                   double what_moves = 1e-3) {
  const VectorXd direction = wavy(body, 1.0).reverse();
  const double step = 1e-6;
  const auto force = [&](const VectorXd& at) {
    VectorXd sum = VectorXd::Zero(at.size());
    term.add_force(at, sum);
    return sum;
  };
  const VectorXd ahead = u + step * direction, behind = u - step * direction;
  const double slope = (term.energy_uJ(ahead) - term.energy_uJ(behind)) / (2 * step);
  EXPECT_NEAR(slope, -force(u).dot(direction), 1e-6 * std::abs(slope) + 1e-7) << name;
  const VectorXd change = (force(behind) - force(ahead)) / (2 * step);
  TangentSum sum(body.layout);
  term.add_tangent(u, Tangent::exact, sum);
  const VectorXd product = sum.take().selfadjointView<Eigen::Lower>() * direction;
  EXPECT_LT((product - change).norm(), 2e-6 * change.norm() + 1e-9) << name;
  EXPECT_GE(change.norm(), what_moves) << name;
  EXPECT_GE(term.scale_uJ(u), 0) << name;
}

TEST(Potentials, ForceIsTheSlopeOfEnergyAndTangentTheSlopeOfForceOfEachTermOfABody) {
  const Support foundation{NamedPoints{"end"}, Foundation{2.0}};
  const Support taut{NamedPoints{"end"}, Ligament{{9, 1, 5}, 40.0, 0.0}};
  const Support slack{NamedPoints{"end"}, Ligament{{9, 1, 5}, 40.0, 0.01}};
  const std::pair<const char*, Around> each[] = {{"foundation", {{}, {foundation}, 0}},
                                                 {"ligament", {{}, {taut}, 0}},
                                                 {"slack ligament", {{}, {slack}, 0}},
                                                 {"capsule", {Capsule{900, 0.1}, {}, 0}},
                                                 {"gas", {{}, {}, 1.6}}};
  for (const ElementOrder order : both_orders) {
    for (const auto& [name, around] : each) {
      const Body body = body_of(block(), 6, order, around);
      const Potentials terms = boundary_potentials(body, around.follower_pressure_kPa);
      ASSERT_EQ(terms.size(), 1) << name;
      expect_slopes(*terms.front(), body, wavy(body, 0.1), name);
    }
    const Body body = body_of(block(), 6, order, {});
    const VectorXd u = wavy(body, 0.1);
    for (const MaterialLaw law :
         {MaterialLaw::linear, MaterialLaw::corotational, MaterialLaw::neo_hookean, MaterialLaw::veronda_westmann}) {
      const auto materials = materials_of(body, law, 2.0);
      expect_slopes(ElasticPotential(body, materials), body, u, "elastic");
    }
    expect_slopes(DeadLoad(wavy(body, 3.0)), body, u, "dead load", 0);
    std::vector<Eigen::Matrix3d> stresses_kPa;
    for (std::size_t s = 0; s < body.layout.cells.size() * (order == ElementOrder::linear ? 1 : 4); ++s) {
      const double t = 1.7 * double(s);
      stresses_kPa.push_back(Eigen::Matrix3d{{std::sin(t), 0.4, std::cos(t)}, {0.4, 1, -0.2}, {std::cos(t), -0.2, -2}});
    }
    expect_slopes(StandingStress(body, stresses_kPa), body, u, "standing stress", 1);
    const Eigen::SparseMatrix<double> stiffness = assemble_stiffness(body);
    expect_slopes(QuadraticPotential(0.7, stiffness, wavy(body, 0.3)), body, u, "quadratic");
  }
}

// The places are chosen by hand: pressing, apart, and sliding within and beyond the limit of friction.
TEST(Potentials, ForceIsTheSlopeOfEnergyAndTangentTheSlopeOfForceOfEachContact) {
  const Body body = body_of(block(), 6, ElementOrder::linear, {});
  const VectorXd u = wavy(body, 0.1);
  const double k = 500;
  const auto& nodes = body.boundary.front().nodes;
  ContactConstraint constraint{};
  constraint.k_mN_mm = constraint.along_mN_mm = k;
  constraint.weights << 0.5, 0.3, 0.2, 0, 0, 0;
  constraint.nodes.fill(nodes[0]);
  for (int i = 0; i < 3; ++i) {
    constraint.nodes[i] = nodes[i];
    constraint.rest_mm += constraint.weights[i] * body.layout.positions_mm[nodes[i]];
  }
  const Vector3d place_mm = place_of(constraint, u);
  constraint.rod = {place_mm + Vector3d(-3, 1.2, 1.0), place_mm + Vector3d(3, 1.3, 0.9), 1.5};
  constraint.multiplier_mN = 40;
  const double gap_mm = gap_of(constraint, u).mm;
  ASSERT_LT(std::abs(gap_mm), 0.5);
  const std::vector<ContactConstraint> pressing{constraint};
  expect_slopes(ToolContactPotential(pressing), body, u, "tool", 10);
  std::vector<ContactConstraint> apart{constraint};
  apart.front().multiplier_mN = k * gap_mm - 1;
  expect_slopes(ToolContactPotential(apart), body, u, "tool apart", 0);
  for (const double slid_mm : {0.001, 0.5}) {
    ContactConstraint sliding = constraint;
    sliding.friction = 0.4;
    limit_friction(sliding, sliding.multiplier_mN, u);
    sliding.from_mm = place_mm - slid_mm * Vector3d(1, 0, 0);
    const std::vector<ContactConstraint> one{sliding};
    expect_slopes(ToolContactPotential(one), body, u, "friction", 10);
  }

  PrescribedPatch patch{0, {nodes[0], nodes[1], nodes[2]}, {0.2, 0.3, 0.5}, {0, 0, 0}, {0.4, 0.1, 0.2}, {3, 2, 1}};
  const std::vector<PrescribedPatch> patches{patch};
  expect_slopes(GraspPotential(patches, k), body, u, "grasp", 10);

  CutContact contact{};
  contact.point = body.boundary.back().nodes[0];
  contact.corners = {nodes[0], nodes[1], nodes[2]};
  contact.weights = Vector3d(0.5, 0.3, 0.2);
  contact.normal = Vector3d(1, 2, 2) / 3;
  contact.rest_mm = body.layout.positions_mm[contact.point] - body.layout.positions_mm[nodes[0]];
  contact.multiplier_mN = 20000;
  const std::vector<CutContact> contacts{contact};
  ASSERT_GT(normal_force_mN(contact, k, u), 0);
  expect_slopes(CutContactPotential(contacts, k), body, u, "cut", 10);
}

TEST(Potentials, ASumIsTheSumOfItsTermsAndItsTangentReachesNodesThatShareNoCell) {
  const Body body = body_of(block(), 6, ElementOrder::quadratic, {Capsule{900, 0.1}, {}, 1.6});
  const auto materials = materials_of(body, MaterialLaw::neo_hookean);
  const VectorXd u = wavy(body, 0.1);
  const int last = body.layout.nodes() - 1;
  const std::vector<PrescribedPatch> far_apart{{0, {0, last}, {0.5, 0.5}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}}};
  const Potentials grasp{std::make_shared<GraspPotential>(far_apart, 30.0)};
  const Potentials terms = static_potentials(body, materials, {wavy(body, 2.0), 1.6});
  const TotalPotential total = TotalPotential(body, terms).with(grasp);
  EXPECT_NEAR(total.energy_uJ(u), energy_uJ(terms, u) + energy_uJ(grasp, u), 1e-9 * std::abs(total.energy_uJ(u)));
  EXPECT_LT((total.force_mN(u) - force_mN(terms, u) - force_mN(grasp, u)).norm(), 1e-9 * total.force_mN(u).norm());
  const Eigen::SparseMatrix<double> with = total.tangent(u, Tangent::exact);
  const Eigen::SparseMatrix<double> without = TotalPotential(body, terms).tangent(u, Tangent::exact);
  EXPECT_EQ(without.coeff(3 * last, 0), 0);
  EXPECT_DOUBLE_EQ(with.coeff(3 * last, 0), 30.0 * 0.25);
  EXPECT_NEAR(with.coeff(0, 0) - without.coeff(0, 0), 30.0 * 0.25, 1e-9);
}

TEST(Surroundings, ASheetStretchedAnswersAsTheClosedForms) {
  const Capsule capsule{900, 0.1};
  const double mu_t = 900 * 0.1 / 3;
  Matrix32d f = Matrix32d::Zero();
  const double s = 1.3;
  f(0, 0) = s;
  f(1, 1) = 1 / std::sqrt(s);  // free sides: incompressible uniaxial stress, P = mu t (s - 1/s^2)
  EXPECT_NEAR(membrane_stress(capsule, f)(0, 0), mu_t * (s - 1 / (s * s)), 1e-12);
  EXPECT_NEAR(membrane_stress(capsule, f)(1, 1), 0, 1e-12);
  f(1, 1) = s;  // equibiaxial: P = mu t (s - 1/s^5)
  EXPECT_NEAR(membrane_stress(capsule, f)(1, 1), mu_t * (s - std::pow(s, -5)), 1e-12);
  const Matrix32d turned = Eigen::AngleAxisd(1.0, Vector3d(1, 2, 3).normalized()).toRotationMatrix() * f;
  EXPECT_NEAR(energy_per_area(capsule, turned), energy_per_area(capsule, f), 1e-12);
}

// A cube under gas all around shrinks evenly by s: the nominal stress of the law, P = dW/ds / 3, is -p s^2.
TEST(Surroundings, GasAroundAFreeCubeSqueezesItAsTheClosedFormSays) {
  auto mesh = test::box(2, 2, 2, {10, 10, 10});
  const auto face = [&](const char* name, int axis) {
    test::name_points(mesh, name, [axis](const Vector3d& p) { return p[axis] == 0; });
  };
  face("x0", 0);
  face("y0", 1);
  face("z0", 2);
  for (const ElementOrder order : both_orders) {
    const Body body = body_of(mesh, 6, order,
                              {{},
                               {test::held_along("x0", true, false, false), test::held_along("y0", false, true, false),
                                test::held_along("z0", false, false, true)}},
                              Holding::required);
    for (const MaterialLaw law : {MaterialLaw::corotational, MaterialLaw::neo_hookean, MaterialLaw::veronda_westmann}) {
      const auto materials = materials_of(body, law, 2.0);
      const double follower_pressure_kPa = 2.0;
      const auto result = find_equilibrium(body, materials, Loads{PressureLoad{follower_pressure_kPa}}).value();
      ASSERT_TRUE(result.may_be_used()) << result.why_stopped;
      const double s = 1 + result.displacement_mm[test::point_at(mesh, {10, 10, 10})].x() / 10;
      EXPECT_LT(s, 0.95);
      const Eigen::Matrix3d f = s * Eigen::Matrix3d::Identity();
      EXPECT_NEAR(first_piola_kPa(materials.front(), f)(1, 1), -follower_pressure_kPa * s * s, 1e-5);
      EXPECT_NEAR(result.displacement_mm[test::point_at(mesh, {10, 0, 10})].z(), 10 * (s - 1), 1e-5);
    }
  }
}

// A cube in a tight skin under a uniaxial pull: the skin's four sides carry their share of it, and its tops and the
// other two stretch along. Small enough that linear elasticity must agree with Newton.
TEST(Surroundings, TheCapsuleOfLinearElasticityIsThatOfLargeDeformationAtSmallOnes) {
  auto mesh = test::box(3, 3, 3, {10, 10, 10});
  test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  const Loads pull{ToolLoad{{10, 5, 5}, 4, {0.02, 0.01, 0}}};
  StaticOptions options;
  options.capsule = Capsule{8220, 0.1};
  const auto model = StaticModel::create(mesh, test::uniform(mesh, 6), {test::fixed("wall")}, options).value();
  const auto linear = model.solve(pull).value();
  options.capsule.reset();
  const auto bare = solve_static(mesh, test::uniform(mesh, 6), {test::fixed("wall")}, pull, options).value();
  options.capsule = Capsule{8220, 0.1};
  const Body body =
      prepare_body(mesh, test::uniform(mesh, 6), {test::fixed("wall")}, options, Holding::required).value();
  const auto large = find_equilibrium(body, materials_of(body, MaterialLaw::corotational), pull).value();
  ASSERT_TRUE(large.may_be_used()) << large.why_stopped;
  EXPECT_NEAR(large.max_displacement_mm, linear.max_displacement_mm, 1e-3 * linear.max_displacement_mm);
  EXPECT_LT(linear.max_displacement_mm, 0.5 * bare.max_displacement_mm);  // 8 MPa over 0.1 mm is a stiff skin
}

// A ball held by nothing but a spring of known stiffness is a weight on a spring, once it hangs taut.
TEST(Surroundings, AWeightHangsFromItsLigamentAsFarAsSlackAndStiffnessSay) {
  auto mesh = test::box(2, 2, 2, {10, 10, 10});
  test::name_points(mesh, "all", [](const Vector3d&) { return true; });
  test::name_points(mesh, "top", [](const Vector3d& p) { return p.z() == 10; });
  // Free along z alone; a ligament straight up, so far away that its springs are parallel.
  const Body body = body_of(mesh, 6000, ElementOrder::quadratic,
                            {{},
                             {test::held_along("all", true, true, false),
                              {NamedPoints{"all"}, Foundation{1e-6}},
                              {NamedPoints{"top"}, Ligament{{5, 5, 1e6}, 5.0, 3.0}}}},
                            Holding::required);
  const auto result =
      find_equilibrium(body, materials_of(body, MaterialLaw::corotational), Loads{GravityLoad{{0, 0, -9810}}}).value();
  ASSERT_TRUE(result.may_be_used()) << result.why_stopped;
  const double weight_mN = 9.81;  // 1000 mm3 of water
  EXPECT_NEAR(result.displacement_mm[test::point_at(mesh, {5, 5, 10})].z(), -(3.0 + weight_mN / 5.0), 0.01);
  EXPECT_NEAR(result.ligament_reaction_mN.z(), weight_mN, 0.01);
}

TEST(Surroundings, ALigamentDoesNotPush) {
  auto mesh = test::box(3, 1, 1, {30, 10, 10});
  test::name_points(mesh, "wall", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "end", [](const Vector3d& p) { return p.x() == 30; });
  const Support band{NamedPoints{"end"}, Ligament{{60, 5, 5}, 500.0, 0.0}};
  const auto end_mm = [&](const std::vector<Support>& supports, double force_mN) {
    const Body body = body_of(mesh, 6, ElementOrder::quadratic, {{}, supports}, Holding::required);
    const auto result = find_equilibrium(body, materials_of(body, MaterialLaw::neo_hookean),
                                         Loads{ToolLoad{{30, 5, 5}, 6, {force_mN, 0, 0}}});
    EXPECT_TRUE(result && result->may_be_used()) << result->why_stopped;
    return result->displacement_mm[test::point_at(mesh, {30, 5, 5})].x();
  };
  // The anchor lies beyond the end: what moves towards it goes slack.
  const double towards_mm = end_mm({test::fixed("wall")}, 8), away_mm = end_mm({test::fixed("wall")}, -8);
  EXPECT_NEAR(end_mm({test::fixed("wall"), band}, 8), towards_mm, 1e-5);
  EXPECT_GT(end_mm({test::fixed("wall"), band}, -8), 0.2 * away_mm);  // 13.7 mN would buckle it (Euler)
}

TEST(Surroundings, LinearModelsRefuseALigamentAndSayWhatToDo) {
  auto mesh = block();
  const auto model = StaticModel::create(mesh, test::uniform(mesh, 6),
                                         {test::fixed("end"), {NamedPoints{"end"}, Ligament{{9, 1, 5}, 40.0, 0.0}}});
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().code, "not-available");
}

TEST(PatientPosition, GravityGoesToTheBackTheFeetAndTheSideThatIsDown) {
  const double g = units::standard_gravity_mm_s2;
  EXPECT_LT((gravity_mm_s2(supine) - Vector3d(0, g, 0)).norm(), 1e-9);
  EXPECT_LT((gravity_mm_s2({90, 0}) - Vector3d(0, 0, -g)).norm(), 1e-9);  // standing
  EXPECT_LT((gravity_mm_s2({0, 90}) - Vector3d(g, 0, 0)).norm(), 1e-9);   // on the left side
  const Vector3d usual = gravity_mm_s2({20, -15});
  EXPECT_NEAR(usual.norm(), g, 1e-9);
  EXPECT_LT(usual.x(), 0);
  EXPECT_LT(usual.z(), 0);
}

}  // namespace
}  // namespace glisson::mechanics
