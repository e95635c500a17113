// A body at large strain in the hand: against the slow way by factors, on the same mesh, and what is promised of every
// first picture.

#include "mechanics/contact/live_body.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/Geometry>

#include "mechanics/bodies.h"
#include "mechanics/contact/internal/quadratic_cells.h"
#include "mechanics/contact/large_contact.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/scenario/cut.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "mechanics/simulation.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

const ChosenLaw neo_hookean = MaterialLaw::neo_hookean;
const ChosenLaw stiffening(MaterialLaw::veronda_westmann, 3);

// A block 60 x 60 x 30 mm, softer on one side, nearly incompressible, fixed below, with a foundation at one end.
class LiveBlock : public testing::Test {
 protected:
  LiveBlock() : mesh_(test::box(6, 6, 3, {60, 60, 30})) {
    test::name_points(mesh_, "ground", [](const Vector3d& p) { return p.z() < 1e-9; });
    test::name_points(mesh_, "side", [](const Vector3d& p) { return p.x() > 60 - 1e-9; });
    test::disturb_inner_points(mesh_, 1.0);
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      youngs_kPa_.push_back(geometry::cell_centroid_mm(mesh_, c).x() < 30 ? 4 : 8);
    }
    supports_ = {test::fixed("ground"), {NamedPoints{"side"}, Foundation{0.05}}};
    options_.poisson_ratio = 0.45;
    places_ = locate_points(mesh_, {{28, 30, 22}, {45, 20, 15}, {30, 45, 25}});
  }
  LiveBody live(const ChosenLaw& law) const {
    auto model = StaticModel::create(mesh_, youngs_kPa_, supports_, options_).value();
    return LiveBody::create(std::move(model), law, supports_, loads_, places_, places_.size()).value();
  }
  Body slow() const { return prepare_body(mesh_, youngs_kPa_, supports_, options_, Holding::required).value(); }
  static ContactTool probe(const Vector3d& center_mm, std::optional<double> push_mN = {}) {
    return {"probe", TouchingTool{palpation_probe(8), pose_towards(center_mm, {0, 0, -1}), push_mN}};
  }
  static double farthest_mm(const LiveState& a, const LiveState& b) {
    double farthest = 0;
    for (std::size_t w = 0; w < a.watched_mm.size(); ++w) {
      farthest = std::max(farthest, (a.watched_mm[w] - b.watched_mm[w]).norm());
    }
    return farthest;
  }

  geometry::TetMesh mesh_;
  std::vector<double> youngs_kPa_;
  std::vector<Support> supports_;
  StaticOptions options_;
  Loads loads_ = {GravityLoad{{0, 0, -9810}}};
  std::vector<PointInMesh> places_;
};

TEST_F(LiveBlock, EightCellsAtATimeGiveTheForcesOfTheSlowIntegral) {
  const Body body = slow();
  VectorXd u_mm(3 * body.layout.nodes());
  for (Eigen::Index i = 0; i < u_mm.size(); ++i) u_mm[i] = 0.8 * std::sin(0.7 * double(i));
  for (const ChosenLaw& law : {neo_hookean, stiffening}) {
    const QuadraticCells cells(body, law);
    const auto materials = materials_of(body, law.law, law.strain_stiffening);
    const VectorXd exact_mN = internal_force_mN(body, materials, u_mm);
    VectorXd force_mN = VectorXd::Zero(u_mm.size());
    std::vector<double> room;
    EXPECT_EQ(cells.add_force(u_mm, force_mN, room).inverted_points, 0);
    EXPECT_LT((force_mN + exact_mN).norm(), 1e-9 * exact_mN.norm());
    EXPECT_GT(cells.largest_strain(body, u_mm, room), 0.1);
  }
}

// The live levels join what lies close together, over a cut's walls too; where it rests must not know of that.
TEST_F(LiveBlock, MeshedWithACutItRestsUnderADeadLoadWhereNewtonsStepsSay) {
  const OpenedBody opened = open_cuts(mesh_, {Cut{{30.5, 30, 30}, {1, 0.1, 0}, 25}}, Along::nearly).value();
  ASSERT_FALSE(opened.walls.empty());
  const auto youngs_kPa = test::uniform(opened.mesh, 5);
  const ToolLoad pull{{42, 30, 30}, 10, {400, 0, 100}};
  const Body body = prepare_body(opened.mesh, youngs_kPa, supports_, options_, Holding::required).value();
  const auto slow = find_equilibrium(body, materials_of(body, MaterialLaw::neo_hookean),
                                     applied_loads(body, {pull}, PressureKind::follower).value())
                        .value();
  ASSERT_TRUE(slow.may_be_used()) << slow.why_stopped;

  auto model = StaticModel::create(opened.mesh, youngs_kPa, supports_, options_).value();
  const auto places = locate_points(opened.mesh, {{42, 30, 22}, {20, 30, 22}});
  const LiveBody live = LiveBody::create(std::move(model), neo_hookean, supports_, {}, places, places.size()).value();
  LiveState state = live.untouched();
  std::vector<ContactTool> tools;
  for (const double share : {0.5, 1.0}) {
    tools = {{"pull", ToolLoad{pull.center_mm, pull.radius_mm, share * pull.force_mN}}};
    state = live.step(state, tools).value();
  }
  LiveOptions patient;
  patient.settling_rounds = 60;
  state = live.settle(state, tools, patient).value();
  ASSERT_TRUE(state.settled);
  const StaticResult rested = live.whole_result(state);
  double farthest_mm = 0, error_mm = 0;
  for (std::size_t p = 0; p < rested.displacement_mm.size(); ++p) {
    farthest_mm = std::max(farthest_mm, slow.displacement_mm[p].norm());
    error_mm = std::max(error_mm, (rested.displacement_mm[p] - slow.displacement_mm[p]).norm());
  }
  EXPECT_GT(opening_of(opened, slow.displacement_mm).largest_opening_mm, 2.0);
  EXPECT_LT(error_mm, 1e-3 * farthest_mm) << "of " << farthest_mm << " mm";
}

TEST_F(LiveBlock, RestsWhereTheSlowWayDoes) {
  const Body body = slow();
  ContactOptions as_tight;
  as_tight.penetration_tolerance_mm = LiveOptions().penetration_tolerance_mm;
  for (const ChosenLaw& law : {neo_hookean, stiffening}) {
    const auto materials = materials_of(body, law.law, law.strain_stiffening);
    const auto loads = applied_loads(body, loads_, PressureKind::follower).value();
    std::vector<std::vector<ContactTool>> stations;
    const LiveBody block = live(law);
    LiveState state = block.untouched();
    for (int step = 1; step <= 5; ++step) {
      stations.push_back({probe({30, 30, 38.0 - 1.2 * step})});
      state = block.step(state, stations.back()).value();
    }
    state = block.settle(state, stations.back()).value();
    ASSERT_TRUE(state.settled);
    EXPECT_LE(state.report.penetration_mm, 0.1);
    EXPECT_EQ(state.report.inverted_cells, 0);
    EXPECT_GT(state.report.largest_strain, 0.2);
    const auto exact = find_equilibrium_in_contact(body, materials, loads, stations, as_tight).value();
    ASSERT_TRUE(exact.result.may_be_used()) << exact.result.why_stopped;
    const VectorXd u_mm = nodal_displacements(body.layout, exact.result);
    // Each presses at places of its own.
    const double moved_mm = u_mm.cwiseAbs().maxCoeff();
    EXPECT_GT(moved_mm, 4);
    const auto exact_mm = displacement_at(body, exact.result, places_);
    for (std::size_t w = 0; w < places_.size(); ++w) {
      EXPECT_LT((state.watched_mm[w] - exact_mm[w]).norm(), 0.1);  // of 0.6 to 3.4 mm; 0.08 and less was seen
    }
    EXPECT_LT((state.u_mm - u_mm).cwiseAbs().maxCoeff(), 0.03 * moved_mm);
    EXPECT_NEAR(state.tools[0].force_mN.z() / exact.tools[0].force_mN.z(), 1, 0.05);
  }
}

// Not among the paths that the safety was found on.
TEST_F(LiveBlock, EveryFirstPictureLiesWithinItsBound) {
  for (const ChosenLaw& law : {neo_hookean, stiffening}) {
    const LiveBody block = live(law);
    LiveState state = block.untouched();
    int pictures = 0, within = 0;
    for (int step = 1; step <= 24; ++step) {
      const double push_mN = std::min(300.0, 75.0 * step);
      const std::vector<ContactTool> tools = {probe({46 - 0.6 * step, 22 + 0.7 * step, 45}, push_mN)};
      state = block.step(state, tools).value();
      const LiveState rest = block.settle(state, tools).value();
      ASSERT_TRUE(rest.settled) << step;
      ++pictures;
      within += farthest_mm(state, rest) <= state.error_bound_mm ? 1 : 0;
      EXPECT_NEAR(-rest.tools[0].force_mN.z(), push_mN, 0.02 * push_mN);
    }
    EXPECT_EQ(within, pictures);
  }
}

TEST_F(LiveBlock, JawsDrawWhatTheyHoldAndTheSameStepsGiveTheSameBits) {
  const LiveBody block = live(neo_hookean);
  const auto jaws = [](double height_mm) {
    return ContactTool{"jaws", Grasp{{45, 30, 30}, 9, Vector3d(0, 0, height_mm), {0, 0, 1}}};
  };
  const auto drawn = [&] {
    LiveState state = block.untouched();
    for (int step = 1; step <= 4; ++step) state = block.step(state, {probe({20, 30, 37}), jaws(1.5 * step)}).value();
    return state;
  };
  const LiveState once = drawn(), again = drawn();
  EXPECT_TRUE((once.u_mm.array() == again.u_mm.array()).all());
  const LiveState rest = block.settle(once, {probe({20, 30, 37}), jaws(6)}).value();
  ASSERT_TRUE(rest.settled);
  EXPECT_GT(rest.tools[1].force_mN.z(), 50);
  EXPECT_LT(farthest_mm(once, rest), once.error_bound_mm);
  // What it pulls with is what the supports bear: nothing is lost between.
  const StaticResult whole = block.whole_result(rest);
  Vector3d sum = whole.fixed_reaction_mN + whole.foundation_reaction_mN + whole.applied_force_mN;
  for (const ToolContact& tool : rest.tools) sum += tool.force_mN;
  EXPECT_LT(sum.norm(), 0.02 * rest.tools[1].force_mN.norm());
}

// A force spread over a patch is a dead load: the same that a scenario's tool is, over the same faces.
TEST_F(LiveBlock, UnderAPatchItRestsWhereTheScenarioDoes) {
  Scenario scenario;
  scenario.material = MaterialLaw::neo_hookean;
  scenario.poisson_ratio = options_.poisson_ratio;
  scenario.supports = supports_;
  for (std::size_t w = 0; w < places_.size(); ++w) {
    Vector3d position_mm = Vector3d::Zero();
    for (int i = 0; i < 4; ++i) {
      const auto cell = static_cast<std::size_t>(places_[w].cell);
      position_mm += places_[w].barycentric[i] *
                     mesh_.points_mm[static_cast<std::size_t>(mesh_.cells[cell][static_cast<std::size_t>(i)])];
    }
    scenario.landmarks.push_back({"place-" + std::to_string(w + 1), position_mm});
  }
  scenario.loads = loads_;
  const ToolLoad patch{{40, 30, 30}, 14, {450, 0, -1100}};
  scenario.loads.emplace_back(patch);
  geometry::TetMesh mesh = mesh_;
  mesh.cell_fields.push_back({youngs_modulus_field, 1, youngs_kPa_});
  const Simulation exact = simulate(mesh, scenario).value();
  ASSERT_TRUE(validity_of(exact).usable());
  EXPECT_GT(exact.result.largest_strain, small_strain_limit);

  const LiveBody block = live(neo_hookean);
  LiveState state = block.untouched();
  for (int step = 1; step <= 8; ++step) {
    ToolLoad part = patch;
    part.force_mN *= 0.125 * step;
    state = block.step(state, {{"patch", part}}).value();
  }
  const LiveState rest = block.settle(state, {{"patch", patch}}).value();
  ASSERT_TRUE(rest.settled);
  EXPECT_LT(farthest_mm(state, rest), state.error_bound_mm);
  for (std::size_t w = 0; w < places_.size(); ++w) {
    const Vector3d exact_mm = exact.landmarks[w].displaced_mm - exact.landmarks[w].rest_mm;
    EXPECT_LT((rest.watched_mm[w] - exact_mm).norm(), 0.02) << w;
  }
  EXPECT_NEAR(rest.report.largest_strain, exact.result.largest_strain, 0.3 * exact.result.largest_strain);
  EXPECT_TRUE(rest.tools[0].force_mN.isApprox(patch.force_mN, 1e-9));
  // Linear elasticity is elsewhere: what is asked here is not small.
  scenario.material = MaterialLaw::linear;
  const Simulation linear = simulate(mesh, scenario).value();
  double apart_mm = 0;
  for (std::size_t w = 0; w < places_.size(); ++w) {
    apart_mm = std::max(apart_mm, (linear.landmarks[w].displaced_mm - exact.landmarks[w].displaced_mm).norm());
  }
  EXPECT_GT(apart_mm, 0.2);
}

// On cells as large as the probe a smooth one rests too deep by the stiffness that settling begins with.
TEST_F(LiveBlock, ASmoothProbeOnCoarseCellsIsPressedHarderUntilItRestsOnTheSurface) {
  mesh_ = test::box(6, 4, 4, {120, 80, 80});
  test::name_points(mesh_, "ground", [](const Vector3d& p) { return p.x() < 1e-9; });
  youngs_kPa_ = test::uniform(mesh_, 4);
  supports_ = {test::fixed("ground")};
  options_ = {};
  loads_ = {};
  places_ = locate_points(mesh_, {{100, 40, 40}, {8, 40, 40}});
  const LiveBody block = live(neo_hookean);
  const std::vector<ContactTool> probe{
      {"probe", TouchingTool{palpation_probe(), pose_towards({140, 40, 40}, {-1, 0, 0}), 1000.0}}};
  const LiveState rest = block.settle(block.step(block.untouched(), probe).value(), probe).value();
  ASSERT_TRUE(rest.settled) << rest.report.penetration_mm;
  EXPECT_GT(rest.stiffer, 1);
  EXPECT_LE(rest.report.penetration_mm, LiveOptions().penetration_tolerance_mm);
  EXPECT_NEAR(rest.tools[0].force_mN.x(), -1000, 5);
  // At rest it stays, also where it is settled again.
  const LiveState again = block.settle(rest, probe).value();
  EXPECT_TRUE(again.settled);
  EXPECT_LT(farthest_mm(rest, again), 0.01);
}

// Over the edge of the block: held on its way it shows how much that edge can bear.
TEST_F(LiveBlock, AToolThatIsPushedHarderThanTheBodyBearsSlidesPastAndSaysSo) {
  const LiveBody block = live(neo_hookean);
  const auto across = [](double x_mm, std::optional<double> push_mN) {
    const Pose pose = pose_towards({x_mm, 30, 34}, {1, 0, 0});
    return std::vector<ContactTool>{{"probe", TouchingTool{palpation_probe(8), pose, push_mN}}};
  };
  double most_mN = 0;
  LiveState held = block.untouched();
  for (double x_mm = -10; x_mm <= 20; x_mm += 1) {
    held = block.settle(block.step(held, across(x_mm, {})).value(), across(x_mm, {})).value();
    ASSERT_TRUE(held.settled) << x_mm;
    most_mN = std::max(most_mN, held.tools[0].force_mN.x());
  }
  ASSERT_GT(most_mN, 5);
  RecordProperty("most_mN", std::to_string(most_mN));

  const auto gently = across(-20, most_mN / 2);
  const LiveState rest = block.settle(block.step(block.untouched(), gently).value(), gently).value();
  EXPECT_TRUE(rest.settled);
  EXPECT_NEAR(rest.tools[0].force_mN.x(), most_mN / 2, 0.01 * most_mN);

  Result<LiveState> pushed = block.untouched();
  for (int step = 1; step <= 40 && pushed; ++step) pushed = block.step(*pushed, across(-20, 2 * most_mN));
  ASSERT_FALSE(pushed);
  EXPECT_EQ(pushed.error().code, "not-converged");
  EXPECT_THAT(pushed.error().message(), HasSubstr("The tool probe slides past the body"));
}

TEST_F(LiveBlock, SaysWhatItDoesNotKnow) {
  auto model = StaticModel::create(mesh_, youngs_kPa_, supports_, options_).value();
  const auto refused = LiveBody::create(model, MaterialLaw::corotational, supports_, {}, places_, 3);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, "not-available");
  EXPECT_THAT(refused.error().message(), HasSubstr("neo-Hookean"));
}

}  // namespace
}  // namespace glisson::mechanics
