// Friction in the hand: Coulomb's law in closed form, and the slow way by Newton's method on the same mesh.

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>

#include "mechanics/bodies.h"
#include "mechanics/contact/large_contact.h"
#include "mechanics/contact/live_body.h"
#include "mechanics/potentials/elastic.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

LiveOptions close_to_rest() {
  LiveOptions options;
  options.settled_mm = 2e-3;
  options.penetration_tolerance_mm = 0.02;
  return options;
}

LiveState at_rest(const LiveBody& body, const LiveState& from, const std::vector<ContactTool>& tools) {
  const LiveOptions options = close_to_rest();
  LiveState rest = body.settle(body.step(from, tools, options).value(), tools, options).value();
  EXPECT_TRUE(rest.settled) << rest.report.relative_residual;
  return rest;
}

// A block 40 x 40 x 20 mm lies on four rods along x, which a force spread over its top presses it on; springs under
// that face hold it.
class BlockOnRods : public testing::Test {
 protected:
  static constexpr double mu = 0.2, weight_mN = 300, springs_mN_mm = 32, side_mm = 40;

  BlockOnRods() : mesh_(test::box(4, 4, 2, {side_mm, side_mm, 20})) {
    test::name_points(mesh_, "top", [](const Vector3d& p) { return p.z() > 20 - 1e-9; });
    StaticOptions options;
    options.poisson_ratio = 0.4;
    auto model = StaticModel::create(mesh_, test::uniform(mesh_, 30),
                                     {{NamedPoints{"top"}, Foundation{springs_mN_mm / (side_mm * side_mm)}}}, options)
                     .value();
    auto places = locate_points(mesh_, {{20, 20, 20}});
    body_.emplace(LiveBody::create(std::move(model), MaterialLaw::neo_hookean,
                                   {{NamedPoints{"top"}, Foundation{springs_mN_mm / (side_mm * side_mm)}}}, {},
                                   std::move(places), 1)
                      .value());
  }

  static std::vector<ContactTool> pulled_by(double pull_mN, double friction = mu) {
    TouchingTool floor;
    for (const double y : {5.0, 15.0, 25.0, 35.0}) floor.shape.push_back({{-60, y, -5}, {100, y, -5}, 5});
    floor.friction = friction;
    return {{"floor", floor}, {"weight", ToolLoad{{20, 20, 120}, 104.2, {pull_mN, 0, -weight_mN}}}};
  }
  // Pulled a little farther at a time.
  LiveState pulled(LiveState state, double from_mN, double to_mN, double friction = mu) const {
    constexpr int steps = 4;
    for (int step = 1; step <= steps; ++step) {
      state = at_rest(*body_, state, pulled_by(from_mN + (to_mN - from_mN) * step / steps, friction));
    }
    return state;
  }
  static double drawn_mm(const LiveState& state) { return state.watched_mm[0].x(); }
  static double friction_mN(const LiveState& state) { return -state.tools[0].force_mN.x(); }
  static double normal_mN(const LiveState& state) { return state.tools[0].force_mN.z(); }

  geometry::TetMesh mesh_;
  std::optional<LiveBody> body_;
};

TEST_F(BlockOnRods, StaysWhereItIsBelowMuNAndSlidesBeyond) {
  const LiveState laid = pulled(body_->untouched(), 0, 0);
  EXPECT_NEAR(normal_mN(laid), weight_mN, 0.02 * weight_mN);  // the springs bear some of it
  const double most_mN = mu * normal_mN(laid);
  const LiveState stuck = pulled(laid, 0, 0.8 * most_mN);
  // Sheared, and held by its foot: friction bears nearly all, and without it the springs would be drawn by 1.5 mm.
  EXPECT_GT(friction_mN(stuck), 0.7 * most_mN);
  EXPECT_LT(drawn_mm(stuck), 0.2);

  const double pull_mN = most_mN + 4 * springs_mN_mm;
  const LiveState slid = pulled(stuck, 0.8 * most_mN, pull_mN);
  EXPECT_LE(slid.tools[0].sticking, 1);  // a place that it may just have met
  EXPECT_NEAR(friction_mN(slid) / normal_mN(slid), mu, 0.01 * mu);
  // On its top the springs take what friction does not.
  EXPECT_NEAR(drawn_mm(slid) * springs_mN_mm, pull_mN - friction_mN(slid), 0.02 * pull_mN);
  EXPECT_NEAR(drawn_mm(slid), 4, 0.1);
  const LiveState smooth = pulled(pulled(body_->untouched(), 0, 0, 0), 0, pull_mN, 0);
  EXPECT_NEAR(friction_mN(smooth), 0, 1e-9);
  EXPECT_NEAR(drawn_mm(smooth) * springs_mN_mm, pull_mN, 0.02 * pull_mN);

  // Let go, it slides back as far as friction lets it, and no farther: what is lost on the way does not come back.
  const LiveState back = pulled(slid, pull_mN, 0);
  EXPECT_NEAR(friction_mN(back) / normal_mN(back), -mu, 0.01 * mu);
  EXPECT_NEAR(drawn_mm(back) * springs_mN_mm, most_mN, 0.05 * most_mN);
}

TEST_F(BlockOnRods, TheSamePullsGiveTheSameBitsAndSettlingAgainMovesNothing) {
  const auto once = [&] { return pulled(body_->untouched(), 0, 150); };
  const LiveState one = once(), two = once();
  EXPECT_TRUE((one.u_mm.array() == two.u_mm.array()).all());
  const LiveState again = body_->settle(one, pulled_by(150), close_to_rest()).value();
  EXPECT_TRUE((one.u_mm.array() == again.u_mm.array()).all());
}

// A wide ball pressed on a block and drawn along: places stick, slip, and stick again.
class BallOnBlock : public testing::Test {
 protected:
  static constexpr double mu = 0.3, radius_mm = 120, depth_mm = 0.5;

  BallOnBlock() : mesh_(test::box(4, 4, 2, {30, 30, 15})) {
    test::name_points(mesh_, "ground", [](const Vector3d& p) { return p.z() < 1e-9; });
    options_.poisson_ratio = 0.4;
    auto model = StaticModel::create(mesh_, test::uniform(mesh_, 10), supports_, options_).value();
    auto places = locate_points(mesh_, {{15, 15, 14}});
    body_.emplace(
        LiveBody::create(std::move(model), MaterialLaw::neo_hookean, supports_, {}, std::move(places), 1).value());
  }

  static std::vector<ContactTool> at(double way_mm, double deep_mm = depth_mm) {
    ContactTool ball{"ball", TouchingTool{palpation_probe(radius_mm),
                                          pose_towards({15 + way_mm, 15, 15 + radius_mm - deep_mm}, {0, 0, -1}),
                                          {}}};
    std::get<TouchingTool>(ball.what).friction = mu;
    return {ball};
  }
  static std::vector<std::vector<ContactTool>> stations(const std::vector<double>& ways_mm) {
    std::vector<std::vector<ContactTool>> all{at(0, depth_mm / 2), at(0)};
    for (const double way_mm : ways_mm) all.push_back(at(way_mm));
    return all;
  }
  LiveState live(const std::vector<double>& ways_mm) const {
    LiveState state = body_->untouched();
    for (const auto& tools : stations(ways_mm)) state = at_rest(*body_, state, tools);
    return state;
  }

  geometry::TetMesh mesh_;
  std::vector<Support> supports_{test::fixed("ground")};
  StaticOptions options_;
  std::optional<LiveBody> body_;
};

TEST_F(BallOnBlock, BearsWhatTheSlowWayBears) {
  const Body slow = prepare_body(mesh_, test::uniform(mesh_, 10), supports_, options_, Holding::required).value();
  const auto materials = materials_of(slow, MaterialLaw::neo_hookean);
  const AppliedLoads nothing{Eigen::VectorXd::Zero(3 * slow.layout.nodes()), 0};
  ContactOptions tight;
  tight.penetration_tolerance_mm = close_to_rest().penetration_tolerance_mm;
  for (const std::vector<double>& ways_mm :
       std::vector<std::vector<double>>{{0.04}, {0.5, 1, 1.5}, {0.5, 1, 1.5, 1.47}, {0.5, 1, 1.5, 1, 0.5}}) {
    const auto exact = find_equilibrium_in_contact(slow, materials, nothing, stations(ways_mm), tight).value();
    ASSERT_TRUE(exact.result.may_be_used()) << exact.result.why_stopped;
    const LiveState state = live(ways_mm);
    const Vector3d &force_mN = state.tools[0].force_mN, &exact_mN = exact.tools[0].force_mN;
    EXPECT_NEAR(force_mN.z() / exact_mN.z(), 1, 0.03) << ways_mm.back();
    EXPECT_NEAR((force_mN.x() - exact_mN.x()) / exact_mN.z(), 0, 0.03) << ways_mm.back();
  }
}

// Coulomb's loop: drawn to and fro by A, what is lost is the area of a parallelogram, 4 mu N (A - mu N / K).
TEST_F(BallOnBlock, LosesTheWorkOfCoulombsLoop) {
  constexpr double far_mm = 1.2, step_mm = 0.1;
  LiveState state = live({});
  std::vector<double> ways_mm, pulls_mN;
  double stiffest_mN_mm = 0, normal_mN = 0;
  const auto go = [&](double to_mm) {
    const double from_mm = ways_mm.empty() ? 0 : ways_mm.back();
    const int steps = static_cast<int>(std::lround(std::abs(to_mm - from_mm) / step_mm));
    for (int step = 1; step <= steps; ++step) {
      const double way_mm = from_mm + (to_mm - from_mm) * step / steps;
      state = at_rest(*body_, state, at(way_mm));
      const double pull_mN = state.tools[0].force_mN.x();
      if (!ways_mm.empty()) {
        stiffest_mN_mm = std::max(stiffest_mN_mm, (pull_mN - pulls_mN.back()) / (way_mm - ways_mm.back()));
      }
      ways_mm.push_back(way_mm);
      pulls_mN.push_back(pull_mN);
    }
  };
  go(far_mm);
  const std::size_t begin = ways_mm.size() - 1;
  go(-far_mm);
  normal_mN = -state.tools[0].force_mN.z();
  go(far_mm);
  double lost_uJ = 0;
  for (std::size_t i = begin + 1; i < ways_mm.size(); ++i) {
    lost_uJ += 0.5 * (pulls_mN[i] + pulls_mN[i - 1]) * (ways_mm[i] - ways_mm[i - 1]);
  }
  EXPECT_NEAR(lost_uJ / (4 * mu * normal_mN * (far_mm - mu * normal_mN / stiffest_mN_mm)), 1, 0.1);
  for (std::size_t i = begin; i < ways_mm.size(); ++i) {
    EXPECT_LE(std::abs(pulls_mN[i]), 1.03 * mu * normal_mN + 1) << ways_mm[i];
  }
}

}  // namespace
}  // namespace glisson::mechanics
