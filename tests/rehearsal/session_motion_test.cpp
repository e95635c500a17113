// A session in motion: it comes to rest where the session at rest is, creeps and comes back, goes back to what moved
// before, and is the same to the bit each time.

#include <gmock/gmock.h>
#include <chrono>
#include <thread>

#include "mechanics/bodies.h"
#include "rehearsal/session.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::ContactTool;
using mechanics::Grasp;
using mechanics::TouchingTool;
using testing::HasSubstr;

RehearsalSetup still_block() {
  RehearsalSetup setup;
  setup.mesh = mechanics::test::box(5, 5, 3, {80, 80, 40});
  mechanics::test::name_points(setup.mesh, "ground", [](const Vector3d& p) { return p.z() == 0; });
  setup.patient_youngs_kPa = mechanics::test::uniform(setup.mesh, 6);
  setup.reference_youngs_kPa = 9;
  setup.supports = {mechanics::test::fixed("ground")};
  setup.standing_loads = {mechanics::GravityLoad{{0, 0, -9810}}};
  setup.landmarks = {{"tumour-1", {35, 40, 34}}, {"tumour-2", {60, 60, 30}}};
  return setup;
}
RehearsalSetup moving_block(double step_s = 0.02, const mechanics::Relaxation& relaxation = {}) {
  RehearsalSetup setup = still_block();
  setup.motion.emplace().step_s = step_s;
  setup.relaxation = relaxation;
  return setup;
}

ContactTool a_probe(double depth_mm, std::optional<double> push_mN = {}) {
  return {"probe", TouchingTool{mechanics::palpation_probe(8),
                                mechanics::pose_towards({35, 40, 48 - depth_mm}, {0, 0, -1}), push_mN}};
}
ContactTool a_grasper(const Vector3d& drawn_mm) { return {"grasper", Grasp{{62, 62, 40}, 14, drawn_mm, {0, 0, 1}}}; }

// By which two searches for contact may differ: a tenth of a millimetre deep, the surface moving by half of that.
constexpr double contact_mm = 0.15;

double apart_mm(const RehearsalBody& a, const RehearsalBody& b) {
  double apart = 0;
  for (std::size_t l = 0; l < a.landmarks.size(); ++l) {
    apart = std::max(apart, (a.landmarks[l].displaced_mm - b.landmarks[l].displaced_mm).norm());
  }
  return apart;
}

TEST(SessionInMotion, ComesToRestWhereTheSessionAtRestIs) {
  auto still = SessionEngine::create(still_block()).value();
  auto moving = SessionEngine::create(moving_block()).value();
  EXPECT_FALSE(still.state().motion.has_value());
  ASSERT_TRUE(moving.state().motion.has_value());
  EXPECT_FALSE(moving.state().motion->moves);
  EXPECT_LT(apart_mm(still.state().patient, moving.state().patient), 1e-6);
  for (const SessionCommand& command :
       std::vector<SessionCommand>{HoldTool{a_probe(6)}, HoldTool{a_grasper({0, 1, 4})}, ReleaseTool{"probe"}}) {
    ASSERT_EQ(still.step(command).refused, "");
    const SessionState first = moving.step(command);
    ASSERT_EQ(first.refused, "");
    EXPECT_TRUE(first.motion->moves);
    EXPECT_GT(first.motion->largest_speed_mm_s, 5);
    for (int i = 0; i < 50 && moving.state().motion->moves; ++i) moving.step(Wait{10});
    const SessionState& rest = moving.state();
    EXPECT_FALSE(rest.motion->moves);
    EXPECT_LT(apart_mm(rest.patient, still.state().patient), contact_mm);
    EXPECT_LT(apart_mm(*rest.reference, *still.state().reference), contact_mm);
    for (std::size_t t = 0; t < rest.tools.size(); ++t) {
      const Vector3d& force_mN = still.state().patient_step.tools[t].force_mN;
      EXPECT_LT((rest.patient_step.tools[t].force_mN - force_mN).norm(), 0.02 * force_mN.norm());
    }
  }
  // As many steps of time have passed as commands had small moves, one at least, and as were waited for.
  EXPECT_NEAR(moving.state().motion->time_s / 0.02, std::round(moving.state().motion->time_s / 0.02), 1e-6);
}

// Held by a force the patient's tissue goes on giving way to where it lies after long, and is long in coming back; the
// reference body, which is elastic, is there at once.
TEST(SessionInMotion, TissueThatRelaxesCreepsUnderAHeldForceAndComesBackSlowly) {
  const mechanics::Relaxation relaxation{{0.5, 1.0}};  // creeps by as much again, in two seconds
  auto still = SessionEngine::create(still_block()).value();
  auto moving = SessionEngine::create(moving_block(0.02, relaxation)).value();
  const HoldTool pushed{a_probe(-5, 400.0)};
  const double before_mm = still.state().patient.landmarks[0].displaced_mm.z();
  const double after_long_mm = still.step(pushed).patient.landmarks[0].displaced_mm.z() - before_mm;
  const auto depth_mm = [&](const RehearsalBody& body) { return body.landmarks[0].displaced_mm.z() - before_mm; };
  ASSERT_EQ(moving.step(pushed).refused, "");
  const double at_once = depth_mm(moving.step(Wait{20}).patient) / after_long_mm;
  EXPECT_GT(at_once, 0.5);
  EXPECT_LT(at_once, 0.75);
  const double later = depth_mm(moving.step(Wait{80}).patient) / after_long_mm;
  EXPECT_GT(later, at_once + 0.1);
  EXPECT_LT(later, 0.95);
  for (int i = 0; i < 100 && moving.state().motion->moves; ++i) moving.step(Wait{20});
  EXPECT_NEAR(depth_mm(moving.state().patient) / after_long_mm, 1, 0.02);
  EXPECT_LT(apart_mm(*moving.state().reference, *still.state().reference), 0.1);

  moving.step(ReleaseTool{"probe"});
  const double left = depth_mm(moving.step(Wait{20}).patient) / after_long_mm;
  EXPECT_GT(left, 0.25);
  EXPECT_LT(left, 0.5);
  for (int i = 0; i < 100 && moving.state().motion->moves; ++i) moving.step(Wait{20});
  EXPECT_NEAR(depth_mm(moving.state().patient), 0, 0.02);
}

TEST(SessionInMotion, UndoGivesBackWhatMovedBefore) {
  auto engine = SessionEngine::create(moving_block()).value();
  engine.step(HoldTool{a_grasper({0, 0, 6})});
  const SessionState swings = engine.step(Wait{2});
  const std::string next = engine.step(ReleaseTool{"grasper"}).digest;
  const std::string later = engine.step(Wait{7}).digest;
  const SessionState back = engine.step(Undo{});
  EXPECT_EQ(back.digest, swings.digest);
  EXPECT_EQ(back.motion->time_s, swings.motion->time_s);
  EXPECT_EQ(back.motion->largest_speed_mm_s, swings.motion->largest_speed_mm_s);
  EXPECT_EQ(engine.step(ReleaseTool{"grasper"}).digest, next);
  EXPECT_EQ(engine.step(Wait{7}).digest, later);
  engine.step(Undo{});
  engine.step(Undo{});
  EXPECT_THAT(engine.step(Undo{}).refused, HasSubstr("nothing to undo"));
}

TEST(SessionInMotion, ReplaysToTheBitThroughItsFile) {
  const auto setup = [] { return moving_block(0.03, {{0.3, 0.5}, {0.2, 4.0}}); };
  auto engine = SessionEngine::create(setup()).value();
  Recording recording;
  for (const SessionCommand& command : std::vector<SessionCommand>{
           HoldTool{a_probe(3.3)}, Wait{4}, HoldTool{a_grasper({0.4, 0, 5.1})}, Wait{}, HoldTool{a_probe(-9, 250.0)},
           Undo{}, Wait{11}, ReleaseTool{"probe"}, Wait{5}, Compare{}, Settle{}}) {
    const SessionState& state = engine.step(command);
    EXPECT_EQ(state.refused, "");
    recording.emplace_back(command, state.digest);
  }
  const auto read = parse_recording(recording_text(recording)).value();
  auto again = SessionEngine::create(setup()).value();
  EXPECT_TRUE(again.prepare());  // what was solved ahead changes no bit
  EXPECT_FALSE(replay(again, read).has_value());
  EXPECT_THAT(parse_recording(R"({"format": "glisson-session/1", "commands": [{"wait_steps": 0}]})").error().message(),
              HasSubstr("wait_steps must be a whole number"));
  EXPECT_THAT(
      parse_recording(R"({"format": "glisson-session/1", "commands": [{"wait_steps": 1e9}]})").error().message(),
      HasSubstr("wait_steps must be a whole number"));
}

TEST(SessionInMotion, SaysWhatItDoesNotKnow) {
  RehearsalSetup meshfree = moving_block();
  meshfree.meshfree.emplace();
  EXPECT_THAT(SessionEngine::create(meshfree).error().message(), HasSubstr("by finite elements"));
  EXPECT_THAT(SessionEngine::create(moving_block(-1)).error().message(), HasSubstr("step"));
  auto engine = SessionEngine::create(moving_block()).value();
  const auto plane = geometry::CutSurface::plane({0, 40, 0}, {0, 1, 0}).value();
  const std::string before = engine.state().digest;
  EXPECT_THAT(engine.step(AdvanceCut{{plane, {80, 40, 20}, {60, 40, 20}}}).refused, HasSubstr("in motion"));
  EXPECT_EQ(engine.state().digest, before);
  // At rest no time passes.
  auto still = SessionEngine::create(still_block()).value();
  const std::string rest = still.step(HoldTool{a_probe(4)}).digest;
  EXPECT_EQ(still.step(Wait{10}).digest, rest);
  EXPECT_EQ(still.state().refused, "");
}

TEST(SessionInMotion, AtLargeStrainItComesToRestWhereTheSessionAtRestIsAndReplays) {
  RehearsalSetup resting = still_block(), swinging = moving_block(0.02);
  resting.law = swinging.law = mechanics::MaterialLaw::neo_hookean;
  auto still = SessionEngine::create(resting).value();
  auto moving = SessionEngine::create(swinging).value();
  Recording recording;
  const auto carry_out = [&](const SessionCommand& command) {
    const SessionState& state = moving.step(command);
    EXPECT_EQ(state.refused, "");
    EXPECT_TRUE(state.settled);  // time goes on, and nothing settles
    recording.emplace_back(command, state.digest);
  };
  for (const SessionCommand& command :
       std::vector<SessionCommand>{HoldTool{a_probe(5)}, HoldTool{a_grasper({0, 1, 4})}, ReleaseTool{"probe"}}) {
    still.step(command);
    const SessionState rest = still.settled_state();
    ASSERT_TRUE(rest.settled);
    carry_out(command);
    EXPECT_TRUE(moving.state().motion->moves);
    for (int i = 0; i < 40 && moving.state().motion->moves; ++i) carry_out(Wait{5});
    EXPECT_FALSE(moving.state().motion->moves);
    EXPECT_LT(apart_mm(moving.state().patient, rest.patient), contact_mm);
    EXPECT_LT(apart_mm(*moving.state().reference, *rest.reference), contact_mm);
  }
  auto again = SessionEngine::create(swinging).value();
  EXPECT_FALSE(replay(again, recording).has_value());
}

TEST(LiveSession, InMotionItGoesOnByItselfUntilNothingMovesAndReplays) {
  LiveSession session(moving_block());
  const auto began = std::chrono::steady_clock::now();
  session.post(HoldTool{a_grasper({0, 0, 6})});
  session.post(ReleaseTool{"grasper"});
  const auto done = [&] {
    return session.phase() == SessionPhase::ready && session.latest()->number > 2 && !session.latest()->motion->moves;
  };
  for (int i = 0; i < 3000 && !done(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(done());
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  EXPECT_GE(took_s, 0.9 * session.latest()->motion->time_s);    // never faster than the clock
  EXPECT_LT(session.latest()->patient.max_displacement_mm, 3);  // it hangs under gravity alone
  const auto recording = session.recording();
  EXPECT_TRUE(std::holds_alternative<Wait>(recording.back().first));
  EXPECT_LE(recording.size(), 4U);  // steps that passed one by one are one wait
  auto engine = SessionEngine::create(moving_block(), {}, reference_in(recording)).value();
  EXPECT_FALSE(replay(engine, recording).has_value());
}

}  // namespace
}  // namespace glisson::rehearsal
