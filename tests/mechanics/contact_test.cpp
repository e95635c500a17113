// Tools in contact: the small problem against its conditions, a ball against Hertz, and what is promised of every
// state.

#include "mechanics/contact/contact.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/Geometry>

#include "mechanics/bodies.h"
#include "mechanics/contact/internal/contact_forces.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

TEST(ContactForces, SatisfyTheConditionsOnManySmallProblems) {
  for (int seed = 0; seed < 200; ++seed) {
    std::srand(static_cast<unsigned>(seed));
    const Eigen::Index m = 3 + seed % 20;
    const Eigen::MatrixXd root = Eigen::MatrixXd::Random(m, m);
    ContactProblem problem{root * root.transpose() + 0.01 * Eigen::MatrixXd::Identity(m, m), Eigen::VectorXd::Random(m),
                           seed % 3, Eigen::MatrixXd::Zero(m, 0), Eigen::VectorXd(0)};
    const Eigen::Index one_sided = m - problem.two_sided;
    if (seed % 2 == 1) {
      problem.drives = Eigen::MatrixXd::Zero(m, 1);
      problem.drives.col(0).head(one_sided) = (Eigen::VectorXd::Random(one_sided).array() + 1.5).matrix();
      problem.drive_force = Eigen::VectorXd::Constant(1, 0.7);
    }
    const ContactForces solved = solve_contact(problem);
    ASSERT_TRUE(solved.converged) << seed;
    Eigen::VectorXd gap = problem.start + problem.compliance * solved.force;
    gap.head(one_sided) += 1e-3 * problem.compliance.diagonal().cwiseProduct(solved.force).head(one_sided);  // its give
    if (problem.drives.cols() > 0) {
      gap -= problem.drives * solved.advance;
      EXPECT_NEAR(problem.drives.col(0).dot(solved.force), 0.7, 1e-6);
    }
    for (Eigen::Index c = 0; c < m; ++c) {
      if (c >= one_sided) {
        EXPECT_NEAR(gap[c], 0, 1e-6);
        continue;
      }
      EXPECT_GE(solved.force[c], 0);
      EXPECT_GE(gap[c], -1e-6);
      EXPECT_NEAR(solved.force[c] * gap[c], 0, 1e-5);
    }
  }
}

TEST(ContactForces, OfMoreContactsThanThereAreWaysToMoveStayBounded) {
  // Sixty contacts on what moves in nine ways, as many places on the same few triangles are.
  for (int seed = 0; seed < 20; ++seed) {
    std::srand(static_cast<unsigned>(seed));
    const Eigen::MatrixXd root = Eigen::MatrixXd::Random(60, 9).array() + 1.0;
    const ContactProblem problem{root * root.transpose(), Eigen::VectorXd::Random(60), 0, Eigen::MatrixXd::Zero(60, 0),
                                 Eigen::VectorXd(0)};
    const ContactForces solved = solve_contact(problem);
    ASSERT_TRUE(solved.converged) << seed;
    EXPECT_LT(solved.exchanges, 100);
    EXPECT_LT(solved.force.sum(), 10.0);
  }
}

TEST(RigidTool, TheNearestPlacesOfRodAndTriangleAreThoseThatSamplingFinds) {
  std::srand(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Rod rod{3 * Vector3d::Random(), 3 * Vector3d::Random(), 1};
    const std::array<Vector3d, 3> triangle{3 * Vector3d::Random(), 3 * Vector3d::Random(), 3 * Vector3d::Random()};
    double sampled = 1e9;
    const int n = 60;
    for (int i = 0; i <= n; ++i) {
      for (int k = 0; k <= n - i; ++k) {
        const Vector3d p = (i * triangle[0] + k * triangle[1] + (n - i - k) * triangle[2]) / n;
        const Vector3d axis = rod.to_mm - rod.from_mm;
        const double s = std::clamp((p - rod.from_mm).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
        sampled = std::min(sampled, (rod.from_mm + s * axis - p).norm());
      }
    }
    const double found = nearest_of(rod, triangle).distance_mm;
    EXPECT_LE(found, sampled + 1e-12);
    EXPECT_GT(found, sampled - 0.1);  // what the samples are apart
  }
}

// A block 80 x 80 x 40 mm on a fixed ground, finer in the middle of its top.
class Block : public testing::Test {
 protected:
  static ContactBody block(int n = 8) {
    auto mesh = test::bent_box(n, n, n / 2, [](const Vector3d& unit) {
      const auto drawn_in = [](double x) { return 40 + 40 * (2 * x - 1) * (0.4 + 0.6 * std::pow(2 * x - 1, 2)); };
      return Vector3d(drawn_in(unit.x()), drawn_in(unit.y()), 40 * (1 - std::pow(1 - unit.z(), 1.6)));
    });
    test::name_points(mesh, "ground", [](const Vector3d& p) { return p.z() < 1e-9; });
    StaticOptions options;
    options.poisson_ratio = 0.45;
    auto model = StaticModel::create(mesh, test::uniform(mesh, 10), {test::fixed("ground")}, options).value();
    return ContactBody::create(std::move(model), {}, {{0, {0.25, 0.25, 0.25, 0.25}, 0}}).value();
  }
  static ContactTool ball(double radius_mm, const Vector3d& center_mm, std::optional<double> push_mN = {}) {
    return {"ball", TouchingTool{palpation_probe(radius_mm), pose_towards(center_mm, {0, 0, -1}), push_mN}};
  }
};

TEST_F(Block, ABallPressedInIsPushedBackAboutAsHertzSays) {
  const ContactBody body = block(14);
  const double radius = 20, depth = 2;
  const auto state = body.solve(body.untouched(), {ball(radius, {40, 40, 40 + radius - depth})}).value();
  ASSERT_TRUE(state.report.converged);
  // F = 4/3 E / (1 - nu^2) sqrt(R) d^(3/2) on a half space; the ground 40 mm below and the facets are what differ.
  const double hertz_mN = 4.0 / 3.0 * 10 / (1 - 0.45 * 0.45) * std::sqrt(radius) * std::pow(depth, 1.5);
  EXPECT_NEAR(-state.tools[0].force_mN.z() / hertz_mN, 1.1, 0.25);
  EXPECT_LT(state.tools[0].force_mN.head<2>().norm(), 0.05 * hertz_mN);  // no friction
}

TEST_F(Block, NoStatePenetratesAndNoForcePullsWhereverTheToolSlides) {
  const ContactBody body = block();
  ContactState state = body.untouched();
  for (const double x : {30.0, 33.0, 36.0, 39.0, 42.0, 45.0}) {
    state = body.solve(state, {ball(8, {x, 40, 45})}).value();
    ASSERT_TRUE(state.report.converged) << state.report.penetration_mm << " " << state.report.movement_mm;
    EXPECT_LE(state.report.penetration_mm, 0.1);
    EXPECT_LT(state.tools[0].force_mN.z(), 0);
    EXPECT_GT(state.tools[0].contacts, 0);
  }
  const auto lifted = body.solve(state, {ball(8, {45, 40, 60})}).value();
  ASSERT_TRUE(lifted.report.converged);
  EXPECT_EQ(lifted.tools[0].contacts, 0);
  for (const Vector3d& u : lifted.surface_mm) EXPECT_LT(u.norm(), 1e-9);
}

TEST_F(Block, APushedToolSlidesToWhereTheBodyBearsItsForce) {
  const ContactBody body = block();
  const auto pushed = body.solve(body.untouched(), {ball(8, {40, 40, 70}, 150.0)}).value();
  ASSERT_TRUE(pushed.report.converged) << pushed.report.rounds;
  EXPECT_NEAR(pushed.tools[0].force_mN.z(), -150, 0.1);
  EXPECT_LE(pushed.report.penetration_mm, 0.1);
  // Held where it came to, it bears the same.
  const auto fixed = body.solve(body.untouched(), {ball(8, {40, 40, 70 - pushed.tools[0].advance_mm})}).value();
  ASSERT_TRUE(fixed.report.converged);
  EXPECT_NEAR(fixed.tools[0].force_mN.z(), -150, 8);  // 0.1 mm of play is some per cent of the force
  EXPECT_NEAR(fixed.report.energy_uJ, pushed.report.energy_uJ, 0.1 * pushed.report.energy_uJ);
}

TEST_F(Block, SeveralToolsAtOnceEachBearTheirOwn) {
  const ContactBody body = block();
  const std::vector<ContactTool> tools{
      ball(8, {28, 40, 60}, 60.0),
      {"rod", TouchingTool{{{{0, -12, 0}, {0, 12, 0}, 3.0}}, pose_towards({52, 40, 60}, {0, 0, -1}), 90.0}},
      {"jaws", Grasp{{40, 70, 40}, 12, Vector3d(0, 0, 3), {0, 0, 1}}}};
  const auto state = body.solve(body.untouched(), tools).value();
  ASSERT_TRUE(state.report.converged) << state.report.rounds << " " << state.report.movement_mm;
  EXPECT_NEAR(state.tools[0].force_mN.z(), -60, 0.1);
  EXPECT_NEAR(state.tools[1].force_mN.z(), -90, 0.1);
  EXPECT_GT(state.tools[1].contacts, 1);  // along the rod
  EXPECT_GT(state.tools[2].force_mN.z(), 0);
  // The sum is in equilibrium with what the whole solve finds at the ground.
  const auto whole = body.whole_result(state).value();
  Vector3d tools_mN = Vector3d::Zero();
  for (const ToolContact& tool : state.tools) tools_mN += tool.force_mN;
  EXPECT_LT((whole.fixed_reaction_mN + tools_mN).norm(), 0.01 * tools_mN.norm() + 0.1);
  for (std::size_t p = 0; p < state.surface_mm.size(); ++p) {
    const auto mesh_point = static_cast<std::size_t>(body.surface().point_fields[0].values[p]);
    EXPECT_LT((state.surface_mm[p] - whole.displacement_mm[mesh_point]).norm(), 1e-6);
  }
}

TEST_F(Block, TheSameBeginningAndToolsGiveTheSameBitsWhateverWasRemembered) {
  const ContactBody fresh = block(), used = block();
  ASSERT_TRUE(used.solve(used.untouched(), {ball(8, {50, 35, 44})}));
  const auto a = fresh.solve(fresh.untouched(), {ball(8, {40, 40, 45})}).value();
  const auto b = used.solve(used.untouched(), {ball(8, {40, 40, 45})}).value();
  EXPECT_EQ(a.surface_mm, b.surface_mm);
  EXPECT_EQ(a.watched_mm, b.watched_mm);
  EXPECT_EQ(a.report.rounds, b.report.rounds);
  EXPECT_GT(a.report.new_solves, 0);
  const auto again = fresh.solve(fresh.untouched(), {ball(8, {40, 40, 45})}).value();
  EXPECT_EQ(again.report.new_solves, 0);
}

// What is seen elsewhere agrees to the digits of single precision.
TEST_F(Block, WhatWasPreparedIsTouchedWithoutASolveAndToTheSameBits) {
  const ContactBody fresh = block(), prepared = block();
  const std::vector<ContactTool> tools{ball(8, {40, 40, 45})};
  int groups = 0;
  while (prepared.prepare_touch(prepared.untouched(), tools).value()) ++groups;
  EXPECT_GT(groups, 10);
  const auto a = fresh.solve(fresh.untouched(), tools).value();
  ContactState b = prepared.untouched();
  for (int again = 0; again < 3; ++again) {  // what was prepared of a point is completed when it is shown again
    b = prepared.solve(prepared.untouched(), tools).value();
    EXPECT_EQ(b.report.new_solves, 0);
    EXPECT_EQ(a.surface_mm, b.surface_mm);
    EXPECT_NEAR(a.report.largest_strain, b.report.largest_strain, 1e-5 * a.report.largest_strain);
    EXPECT_LT((a.watched_mm[0] - b.watched_mm[0]).norm(), 1e-5 * a.watched_mm[0].norm());
  }
}

TEST_F(Block, AStateIsKeptWithoutItsShapeAndShownAgainToTheSameBits) {
  const ContactBody body = block();
  const std::vector<ContactTool> tools{ball(8, {40, 40, 45})};
  const auto shown = body.solve(body.untouched(), tools).value();
  const ContactState kept = ContactBody::without_shape(shown);
  EXPECT_TRUE(kept.surface_mm.empty() && kept.watched_mm.empty());
  const auto again = body.with_shape(kept).value();
  EXPECT_EQ(again.surface_mm, shown.surface_mm);
  EXPECT_EQ(again.watched_mm, shown.watched_mm);
  const std::vector<ContactTool> next{ball(8, {42, 40, 45})};
  EXPECT_EQ(body.solve(kept, next)->surface_mm, body.solve(shown, next)->surface_mm);
}

TEST_F(Block, WhatCannotBeMeantIsRefused) {
  const ContactBody body = block();
  const auto why = [&](const ContactTool& tool) { return body.solve(body.untouched(), {tool}).error().code; };
  EXPECT_EQ(why(ball(8, {40, 40, -30}, 50.0)), "tool-touches-nothing");  // it goes away from the block
  EXPECT_EQ(why(ball(-1, {40, 40, 60})), "tool-invalid");
  EXPECT_EQ(why(ball(8, {NAN, 40, 60})), "tool-invalid");
  EXPECT_EQ(why({"jaws", Grasp{{40, 40, 90}, 5, Vector3d(0, 0, 1), {0, 0, 1}}}), "tool-touches-nothing");
}

}  // namespace
}  // namespace glisson::mechanics
