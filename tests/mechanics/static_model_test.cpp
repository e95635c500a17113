// The solver itself: exact where finite elements are exact, converging where they are not, refusing what has no answer.

#include "mechanics/statics/static_model.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/Dense>
#include <limits>

#include "base/parallel.h"

#include "mechanics/bodies.h"
#include "mechanics/materials/linear_elasticity.h"
#include "mechanics/slow_elasticity.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::box;
using test::fixed;
using test::uniform;
using testing::HasSubstr;

// Every node's displacement, corners then mid-sides.
Eigen::VectorXd all_displacements(const StaticModel& model, const StaticResult& result) {
  const NodeLayout& layout = model.nodes();
  Eigen::VectorXd u(3 * layout.nodes());
  for (std::size_t p = 0; p < layout.node_of_point.size(); ++p) {
    if (layout.node_of_point[p] >= 0) u.segment<3>(3 * layout.node_of_point[p]) = result.displacement_mm[p];
  }
  for (std::size_t e = 0; e < layout.edges.size(); ++e) {
    u.segment<3>(3 * (layout.corner_nodes + int(e))) = result.mid_side_displacement_mm[e];
  }
  return u;
}

// Holds the whole boundary, moves it as the field says, loads the inside with the body force that belongs to it.
template <typename Field, typename BodyForce>
StaticResult with_given_boundary(const StaticModel& model, Field field, BodyForce force_per_mm3) {
  NodalLoad load;
  load.force_mN = test::slow_body_force(model.nodes(), force_per_mm3);
  load.prescribed_displacement_mm.resize(load.force_mN.size());
  for (int n = 0; n < model.nodes().nodes(); ++n) {
    load.prescribed_displacement_mm.segment<3>(3 * n) = field(model.nodes().positions_mm[n]);
  }
  return model.solve_nodal(load).value();
}

geometry::TetMesh disturbed_cube(int n) {
  auto mesh = box(n, n, n, {10, 10, 10});
  test::disturb_inner_points(mesh, 1.2 / n);
  test::name_points(mesh, "boundary", [](const Vector3d& p) { return (p.array() == 0 || p.array() == 10).any(); });
  return mesh;
}

TEST(PatchTest, ALinearFieldIsReproducedExactlyByBothOrders) {
  Matrix3d gradient;
  gradient << 1, 2, -1, 0.5, -1, 3, 2, 1, 0.7;
  gradient *= 1e-3;
  for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic}) {
    StaticOptions options;
    options.order = order;
    const auto mesh = disturbed_cube(3);
    const auto model = StaticModel::create(mesh, uniform(mesh, 5.0), {fixed("boundary")}, options).value();
    const auto field = [&](const Vector3d& p) { return Vector3d(gradient * p); };
    const auto result = with_given_boundary(model, field, [](const Vector3d&) { return Vector3d(0, 0, 0); });
    ASSERT_TRUE(result.may_be_used());
    const Eigen::VectorXd u = all_displacements(model, result);
    for (int n = 0; n < model.nodes().nodes(); ++n) {
      // Displacements reach 0.05 mm; 1e-13 is their rounding times the condition of 27 bricks.
      EXPECT_LT((u.segment<3>(3 * n) - field(model.nodes().positions_mm[n])).norm(), 1e-13);
    }
    // The stress is uniform, so von Mises is the same number everywhere.
    const double expected = von_mises(stress_kPa(lame_from_youngs(5.0, 0.45), small_strain(gradient)));
    for (const double stress : model.von_mises_kPa(result)) EXPECT_NEAR(stress, expected, 1e-10 * expected);
  }
}

TEST(PatchTest, AQuadraticFieldIsReproducedExactlyByQuadraticCells) {
  // u = (x2, xy, -2 zx + y2) * 1e-3 / mm. Its body force is -div sigma, constant.
  const auto mesh = disturbed_cube(2);
  const auto model = StaticModel::create(mesh, uniform(mesh, 5.0), {fixed("boundary")}).value();
  const Lame lame = lame_from_youngs(5.0, 0.45);
  const auto field = [](const Vector3d& p) {
    return Vector3d(1e-3 * Vector3d(p.x() * p.x(), p.x() * p.y(), -2 * p.z() * p.x() + p.y() * p.y()));
  };
  // div u = x (2 + 1 - 2) = x, grad div u = (1, 0, 0); Laplacian u = (2, 0, 2).
  const Vector3d force =
      -1e-3 * ((lame.lambda_kPa + lame.mu_kPa) * Vector3d(1, 0, 0) + lame.mu_kPa * Vector3d(2, 0, 2));
  const auto result = with_given_boundary(model, field, [&](const Vector3d&) { return force; });
  const Eigen::VectorXd u = all_displacements(model, result);
  for (int n = 0; n < model.nodes().nodes(); ++n) {
    EXPECT_LT((u.segment<3>(3 * n) - field(model.nodes().positions_mm[n])).norm(), 1e-12);  // of 0.2 mm
  }
}

// A smooth field that no polynomial cell can represent, with its exact body force.
struct Manufactured {
  double k = M_PI / 10;  // one half wave across the cube of 10 mm
  Lame lame = lame_from_youngs(5.0, 0.45);

  [[nodiscard]] Vector3d field(const Vector3d& p) const {
    return {std::sin(k * p.x()) * std::cos(k * p.y()), std::sin(k * p.y()) * std::cos(k * p.z()),
            std::sin(k * p.z()) * std::cos(k * p.x())};
  }
  [[nodiscard]] Vector3d force(const Vector3d& p) const {
    // Laplacian u = -2 k2 u; div u = k (cos cos + cos cos + cos cos); grad div u term by term.
    const Vector3d grad_div =
        -k * k *
        Vector3d(std::sin(k * p.x()) * std::cos(k * p.y()) + std::cos(k * p.z()) * std::sin(k * p.x()),
                 std::cos(k * p.x()) * std::sin(k * p.y()) + std::sin(k * p.y()) * std::cos(k * p.z()),
                 std::cos(k * p.y()) * std::sin(k * p.z()) + std::sin(k * p.z()) * std::cos(k * p.x()));
    return -((lame.lambda_kPa + lame.mu_kPa) * grad_div - 2 * k * k * lame.mu_kPa * field(p));
  }
};

TEST(ManufacturedSolution, QuadraticCellsConvergeWithOrderThreeInTheL2Norm) {
  const Manufactured manufactured;
  std::vector<double> errors;
  for (const int n : {2, 4, 8}) {
    auto mesh = box(n, n, n, {10, 10, 10});
    test::name_points(mesh, "boundary", [](const Vector3d& p) { return (p.array() == 0 || p.array() == 10).any(); });
    const auto model = StaticModel::create(mesh, uniform(mesh, 5.0), {fixed("boundary")}).value();
    const auto result = with_given_boundary(
        model, [&](const Vector3d& p) { return manufactured.field(p); },
        [&](const Vector3d& p) { return manufactured.force(p); });
    const Eigen::VectorXd u = all_displacements(model, result);
    double squared = 0;
    for (std::size_t c = 0; c < model.nodes().cells.size(); ++c) {
      const test::SlowCell cell(model.nodes(), c);
      test::integrate(cell, [&](const Vector3d& place, double weight) {
        const Eigen::VectorXd values = cell.at(place).values;
        Vector3d difference = -manufactured.field(place);
        for (int a = 0; a < 10; ++a) difference += values[a] * u.segment<3>(3 * model.nodes().cells[c][a]);
        squared += weight * difference.squaredNorm();
      });
    }
    errors.push_back(std::sqrt(squared));
  }
  // Theory: h^3 for quadratic displacements and a smooth solution. Near incompressibility the first step of such
  // coarse meshes is not yet in the asymptotic range (observed 2.7); the second is held to 2.8.
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const double order = std::log2(errors[i - 1] / errors[i]);
    RecordProperty("observed_order_" + std::to_string(i), std::to_string(order));
    EXPECT_GT(order, i == 1 ? 2.5 : 2.8) << errors[i - 1] << " -> " << errors[i];
  }
}

TEST(StaticModel, AgreesWithTheSlowDenseMethodOnAHeterogeneousBody) {
  for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic}) {
    auto mesh = box(3, 2, 2, {30, 20, 15});
    test::disturb_inner_points(mesh, 2.0);
    test::name_points(mesh, "fixed", [](const Vector3d& p) { return p.x() == 0; });
    std::vector<double> youngs_kPa;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) youngs_kPa.push_back(2.0 + 10.0 * (c % 7));
    StaticOptions options;
    options.order = order;
    options.poisson_ratio = 0.3;
    const auto model = StaticModel::create(mesh, youngs_kPa, {fixed("fixed")}, options).value();
    const Vector3d gravity(100, -9810, 300);
    const auto result = model.solve({GravityLoad{gravity}}).value();

    const NodeLayout& layout = model.nodes();
    Eigen::MatrixXd k = test::slow_stiffness(layout, youngs_kPa, 0.3);
    Eigen::VectorXd f =
        test::slow_body_force(layout, [&](const Vector3d&) { return Vector3d(options.density_kg_mm3 * gravity); });
    for (int n = 0; n < layout.nodes(); ++n) {
      if (layout.positions_mm[n].x() > 0) continue;
      for (int d = 3 * n; d < 3 * n + 3; ++d) {
        k.row(d).setZero();
        k.col(d).setZero();
        k(d, d) = 1;
        f[d] = 0;
      }
    }
    const Eigen::VectorXd slow = k.ldlt().solve(f);
    EXPECT_LT((all_displacements(model, result) - slow).norm(), 1e-10 * slow.norm());
  }
}

TEST(StaticModel, WorkEqualsEnergyAndReactionsBalanceTheLoads) {
  auto mesh = box(4, 3, 3, {40, 30, 20});
  test::name_points(mesh, "left", [](const Vector3d& p) { return p.x() == 0; });
  test::name_points(mesh, "floor", [](const Vector3d& p) { return p.z() == 0; });
  const auto model =
      StaticModel::create(mesh, uniform(mesh, 6.0), {fixed("left"), {NamedPoints{"floor"}, Foundation{0.05}}}).value();
  const auto result =
      model.solve({GravityLoad{{0, 0, -9810}}, ToolLoad{{40, 15, 20}, 12, {50, 20, 200}}, PressureLoad{0.2}}).value();
  ASSERT_TRUE(result.may_be_used());
  EXPECT_LE(result.relative_residual, 1e-9);
  // Clapeyron: the work of a load that grows with the displacement is the energy stored.
  EXPECT_NEAR(result.external_work_uJ, result.strain_energy_uJ + result.foundation_energy_uJ,
              1e-9 * result.external_work_uJ);
  EXPECT_GT(result.foundation_energy_uJ, 0);
  const Vector3d sum = result.applied_force_mN + result.fixed_reaction_mN + result.foundation_reaction_mN;
  EXPECT_LT(sum.norm(), 1e-8 * result.applied_force_mN.norm());
  // 24,000 mm3 at 1000 kg/m3 weigh 235.44 mN; the pressure on a closed surface sums to nothing.
  EXPECT_LT((result.applied_force_mN - Vector3d(50, 20, 200 - 235.44)).norm(), 1e-9);
}

TEST(StaticModel, OneSolveForEachOfSeveralLoadsGivesWhatSeparateSolvesGive) {
  auto mesh = box(3, 3, 3, {30, 30, 30});
  test::name_points(mesh, "floor", [](const Vector3d& p) { return p.z() == 0; });
  const auto model = StaticModel::create(mesh, uniform(mesh, 6.0), {fixed("floor")}).value();
  const std::vector<Loads> cases{{GravityLoad{{0, 0, -9810}}}, {ToolLoad{{15, 15, 30}, 8, {10, 0, 30}}}, {}};
  const auto together = model.solve_each(cases).value();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto alone = model.solve(cases[i]).value();
    ASSERT_TRUE(together[i].may_be_used());
    for (std::size_t p = 0; p < alone.displacement_mm.size(); ++p) {
      EXPECT_LT((alone.displacement_mm[p] - together[i].displacement_mm[p]).norm(), 1e-9);
    }
  }
  EXPECT_EQ(together[2].max_displacement_mm, 0);  // no load: no displacement, and a residual of nothing
  EXPECT_EQ(together[2].relative_residual, 0);
}

TEST(StaticModel, MutualPointsAnswerEachOtherAsSeparateSolvesSay) {
  auto mesh = box(3, 3, 3, {30, 30, 30});
  test::disturb_inner_points(mesh, 2.0);
  test::name_points(mesh, "floor", [](const Vector3d& p) { return p.z() == 0; });
  std::vector<int> points;
  for (const Vector3d& place : {Vector3d(10, 0, 30), Vector3d(0, 0, 0), Vector3d(30, 20, 10), Vector3d(20, 30, 20)}) {
    points.push_back(static_cast<int>(test::point_at(mesh, place)));  // the second is held
  }
  const auto model = StaticModel::create(mesh, uniform(mesh, 6.0), {fixed("floor")}, {}, {}, points).value();
  const Eigen::MatrixXd mutual = model.mutual_compliance();
  ASSERT_EQ(mutual.rows(), 12);
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(3 * model.nodes().nodes(), 12);
  for (int i = 0; i < 4; ++i) unit.block<3, 3>(3 * model.nodes().node_of_point[points[i]], 3 * i).setIdentity();
  const auto responses = model.respond(unit);
  ASSERT_TRUE(responses.converged);
  EXPECT_LT((unit.transpose() * responses.displacement_mm - mutual).norm(), 1e-10 * mutual.norm());
  EXPECT_EQ(mutual.middleRows<3>(3).norm(), 0);
}

TEST(StaticModel, TheAnswerTurnsWithTheBody) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.8, 0.3, -0.4, 0.2).normalized();
  const Vector3d shift(100, -50, 30);
  auto mesh = box(4, 2, 2, {40, 20, 20});
  test::name_points(mesh, "end", [](const Vector3d& p) { return p.x() == 0; });
  auto turned = mesh;
  for (Vector3d& p : turned.points_mm) p = turn * p + shift;
  const Vector3d center(40, 10, 20), force(5, 20, -30);
  const auto one = solve_static(mesh, uniform(mesh, 6), {fixed("end")}, {ToolLoad{center, 9, force}}).value();
  const auto other =
      solve_static(turned, uniform(mesh, 6), {fixed("end")}, {ToolLoad{turn * center + shift, 9, turn * force}})
          .value();
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    EXPECT_LT((turn * one.displacement_mm[p] - other.displacement_mm[p]).norm(), 1e-9 * one.max_displacement_mm);
  }
}

TEST(StaticModel, TheNumberOfThreadsDoesNotChangeAnyBitOfTheStiffness) {
  // Checked through the answer: assembly is the only parallel part of ours that writes into the matrix.
  auto mesh = box(6, 6, 6, {30, 30, 30});
  test::name_points(mesh, "floor", [](const Vector3d& p) { return p.z() == 0; });
  const Loads loads{GravityLoad{{0, 0, -9810}}};
  set_thread_count(1);
  const auto one = solve_static(mesh, uniform(mesh, 6), {fixed("floor")}, loads).value();
  set_thread_count(2);
  const auto two = solve_static(mesh, uniform(mesh, 6), {fixed("floor")}, loads).value();
  set_thread_count(0);
  EXPECT_EQ(one.external_work_uJ, two.external_work_uJ);
}

TEST(StaticModel, APointThatNoCellUsesStaysAndHarmsNothing) {
  auto mesh = box(2, 2, 2, {10, 10, 10});
  mesh.points_mm.emplace_back(500, 500, 500);
  test::name_points(mesh, "floor", [](const Vector3d& p) { return p.z() == 0; });
  const auto result = solve_static(mesh, uniform(mesh, 6), {fixed("floor")}, {GravityLoad{{0, 0, -9810}}}).value();
  EXPECT_TRUE(result.may_be_used());
  EXPECT_EQ(result.displacement_mm.back(), Vector3d(0, 0, 0));
}

TEST(StaticModel, SaysWhenTheLoadIsBeyondSmallStrain) {
  auto mesh = box(4, 2, 2, {40, 20, 20});
  test::name_points(mesh, "end", [](const Vector3d& p) { return p.x() == 0; });
  const auto model = StaticModel::create(mesh, uniform(mesh, 1.0), {fixed("end")}).value();
  EXPECT_TRUE(model.solve({ToolLoad{{40, 10, 10}, 12, {0, 0, 0.1}}}).value().notes.empty());
  const auto beyond = model.solve({ToolLoad{{40, 10, 10}, 12, {0, 0, 100}}}).value();
  EXPECT_GT(beyond.largest_strain, 0.2);
  ASSERT_FALSE(beyond.notes.empty());
  const auto inverted = model.solve({ToolLoad{{40, 10, 10}, 12, {-3000, 0, 0}}}).value();
  EXPECT_GT(inverted.inverted_cells, 0);
  EXPECT_THAT(inverted.notes.front(), HasSubstr("inside out"));
}

// --- what is refused

std::string refusal(geometry::TetMesh mesh, std::vector<double> youngs_kPa, std::vector<Support> supports,
                    StaticOptions options = {}) {
  const auto model = StaticModel::create(std::move(mesh), std::move(youngs_kPa), std::move(supports), options);
  return model ? "accepted" : model.error().code + ": " + model.error().message();
}

class Refusals : public testing::Test {
 protected:
  Refusals() {
    test::name_points(mesh, "fixed", [](const Vector3d& p) { return p.x() == 0; });
  }
  void name(const std::string& array, const std::vector<Vector3d>& places_mm) {
    test::name_points(mesh, array, [&](const Vector3d& p) {
      return std::any_of(places_mm.begin(), places_mm.end(), [&](const Vector3d& q) { return (p - q).norm() < 1e-9; });
    });
  }
  geometry::TetMesh mesh = box(2, 2, 2, {20, 20, 20});
  std::vector<double> youngs_kPa = uniform(mesh, 5.0);
};

TEST_F(Refusals, AModulusThatIsNotAPositiveNumberIsNamedByItsCell) {
  youngs_kPa[17] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(mesh, youngs_kPa, {fixed("fixed")}), HasSubstr("modulus-invalid: Young's modulus of cell 17"));
  youngs_kPa[17] = 0;
  EXPECT_THAT(refusal(mesh, youngs_kPa, {fixed("fixed")}), HasSubstr("cell 17 is 0 kPa"));
  youngs_kPa.pop_back();
  EXPECT_THAT(refusal(mesh, youngs_kPa, {fixed("fixed")}), HasSubstr("modulus-invalid"));
}

TEST_F(Refusals, PoissonsRatioOutsideItsRange) {
  for (const double nu : {0.5, 0.7, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    StaticOptions options;
    options.poisson_ratio = nu;
    EXPECT_THAT(refusal(mesh, youngs_kPa, {fixed("fixed")}, options), HasSubstr("poisson-invalid"));
  }
}

TEST_F(Refusals, ACellTurnedInsideOut) {
  std::swap(mesh.cells[5][0], mesh.cells[5][1]);
  EXPECT_THAT(refusal(mesh, youngs_kPa, {fixed("fixed")}), HasSubstr("5"));
}

TEST_F(Refusals, SupportsThatNameNothing) {
  EXPECT_THAT(refusal(mesh, youngs_kPa, {fixed("nowhere")}), HasSubstr("array-unknown"));
  EXPECT_THAT(refusal(mesh, youngs_kPa, {{Ball{{100, 0, 0}, 5}, Fixed{}}}), HasSubstr("support-empty: Support 1"));
  name("corner", {{0, 0, 0}});
  EXPECT_THAT(refusal(mesh, youngs_kPa, {{NamedPoints{"corner"}, Foundation{1.0}}}), HasSubstr("covers no face"));
  EXPECT_THAT(refusal(mesh, youngs_kPa, {{NamedPoints{"fixed"}, Foundation{-1.0}}}), HasSubstr("support-invalid"));
}

TEST_F(Refusals, ABodyThatIsNotHeldIsToldItsFreeMotion) {
  EXPECT_THAT(refusal(mesh, youngs_kPa, {}), HasSubstr("it is not held at all"));
  name("corner", {{20, 0, 0}});
  EXPECT_THAT(refusal(mesh, youngs_kPa, {fixed("corner")}),
              HasSubstr("it can turn about the point (20.0, 0.0, 0.0) mm"));
  name("edge", {{0, 20, 0}, {10, 20, 0}, {20, 20, 0}});
  const std::string hinge = refusal(mesh, youngs_kPa, {fixed("edge")});
  EXPECT_THAT(hinge, HasSubstr("it can turn about the axis through"));
  EXPECT_THAT(hinge, HasSubstr("20.0, 0.0) mm along x"));
  EXPECT_THAT(refusal(mesh, youngs_kPa, {test::held_along("fixed", false, true, true)}),
              HasSubstr("it can slide along x"));
  // A face that may not leave its plane: two slides and the turn about the plane's normal.
  const std::string plane = refusal(mesh, youngs_kPa, {test::held_along("fixed", true, false, false)});
  EXPECT_THAT(plane, HasSubstr("can slide in the plane across x and can turn about the axis"));
}

TEST_F(Refusals, ABodyOnAFoundationAloneIsHeld) {
  EXPECT_EQ(refusal(mesh, youngs_kPa, {{NamedPoints{"fixed"}, Foundation{0.1}}}), "accepted");
}

TEST_F(Refusals, AToolThatTouchesNothingAndLoadsThatAreNotNumbers) {
  const auto model = StaticModel::create(mesh, youngs_kPa, {fixed("fixed")}).value();
  const auto missed = model.solve({ToolLoad{{60, 10, 10}, 5, {0, 0, 10}}});
  ASSERT_FALSE(missed);
  EXPECT_EQ(missed.error().code, "tool-touches-nothing");
  EXPECT_THAT(missed.error().message(), HasSubstr("40."));  // mm from the nearest face
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(model.solve({GravityLoad{{0, nan, 0}}}).error().code, "load-invalid");
  EXPECT_EQ(model.solve({PressureLoad{nan}}).error().code, "load-invalid");
  EXPECT_EQ(model.solve({ToolLoad{{20, 10, 10}, -1, {0, 0, 10}}}).error().code, "load-invalid");
}

TEST_F(Refusals, AFactorThatWouldNotFitIsRefusedBeforeItIsComputed) {
  StaticOptions options;
  options.memory_limit_bytes = 1000;
  EXPECT_THAT(refusal(mesh, youngs_kPa, {fixed("fixed")}, options), HasSubstr("too-large"));
}

TEST_F(Refusals, ACancelledModelIsNotBuilt) {
  std::stop_source stop;
  stop.request_stop();
  const auto model = StaticModel::create(mesh, youngs_kPa, {fixed("fixed")}, {},
                                         Progress([](double, std::string_view) {}, stop.get_token()));
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().code, "cancelled");
}

}  // namespace
}  // namespace glisson::mechanics
