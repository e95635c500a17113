// A session: the same commands give the same bits, undo goes back to them, and nobody waits.

#include "rehearsal/session.h"

#include <gmock/gmock.h>
#include <chrono>
#include <cmath>
#include <thread>

#include "mechanics/bodies.h"
#include "rehearsal/cut_course.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::ContactTool;
using mechanics::Grasp;
using mechanics::TouchingTool;
using testing::HasSubstr;

RehearsalSetup whole_block() {
  RehearsalSetup setup;
  setup.mesh = mechanics::test::box(6, 6, 3, {80, 80, 40});
  mechanics::test::name_points(setup.mesh, "ground", [](const Vector3d& p) { return p.z() == 0; });
  for (std::size_t c = 0; c < setup.mesh.cells.size(); ++c) {
    setup.patient_youngs_kPa.push_back(geometry::cell_centroid_mm(setup.mesh, c).x() < 40 ? 4 : 12);
  }
  setup.reference_youngs_kPa = 6;
  setup.supports = {mechanics::test::fixed("ground")};
  setup.landmarks = {{"tumour-1", {35, 40, 34}}, {"tumour-2", {70, 70, 20}}};
  geometry::Surface triangle;
  triangle.points_mm = {{30, 30, 30}, {50, 30, 30}, {40, 50, 30}};
  triangle.triangles = {{0, 1, 2}};
  setup.structures = {triangle};
  return setup;
}

ContactTool probe(const Vector3d& center_mm, std::optional<double> push_mN = {}) {
  return {"probe",
          TouchingTool{mechanics::palpation_probe(8), mechanics::pose_towards(center_mm, {0, 0, -1}), push_mN}};
}
ContactTool jaws(const Vector3d& drawn_mm) { return {"grasper", Grasp{{66, 40, 40}, 15, drawn_mm, {0, 0, 1}}}; }

TEST(Session, FollowsLandmarksAndStructuresAndComparesWithTheReferenceBody) {
  auto engine = SessionEngine::create(whole_block()).value();
  EXPECT_EQ(engine.state().patient.max_displacement_mm, 0);
  const SessionState& state = engine.step(HoldTool{probe({35, 40, 40})});
  EXPECT_EQ(state.refused, "");
  EXPECT_TRUE(state.patient_step.report.converged);
  EXPECT_LE(state.patient_step.report.penetration_mm, 0.1);
  EXPECT_EQ(state.patient_step.report.inverted_cells, 0);
  EXPECT_TRUE(state.validity.usable());
  // By corners: no more than the whole solve finds at the corners of quadratic cells, and not far from it.
  const double whole_strain = engine.whole_result()->largest_strain;
  EXPECT_LE(state.validity.largest_strain, whole_strain);
  EXPECT_GT(state.validity.largest_strain, 0.4 * whole_strain);
  EXPECT_GT(state.patient_step.report.energy_uJ, 0);
  EXPECT_LT(state.patient_step.report.relative_residual, 1e-8);
  EXPECT_GT(state.patient.landmarks[0].displacement_mm, 2);
  EXPECT_LT(state.patient.landmarks[1].displacement_mm, 1);
  EXPECT_LT(state.patient.structures_mm[0][0].z(), 30);
  // The tool is placed alike in both; the force that this takes is not.
  EXPECT_GT(std::abs(state.patient_step.tools[0].force_mN.z() - state.reference_step->tools[0].force_mN.z()), 30);
  // Under the same force they give way differently.
  const SessionState& pushed = engine.step(HoldTool{probe({35, 40, 60}, 600.0)});
  EXPECT_EQ(pushed.refused, "");
  EXPECT_NEAR(pushed.patient_step.tools[0].force_mN.z(), -600, 1);
  EXPECT_GT(std::abs(pushed.patient_step.tools[0].advance_mm - pushed.reference_step->tools[0].advance_mm), 0.1);
  EXPECT_EQ(pushed.differences[0].significant(), pushed.differences[0].difference_mm >= 5);
  // What is shown is what a whole solve under the same forces finds.
  const auto whole = engine.whole_result().value();
  const auto& mesh_point = engine.surface().point_fields[0].values;
  for (std::size_t p = 0; p < mesh_point.size(); ++p) {
    const Vector3d shown = pushed.patient.surface_mm[p] - engine.surface().points_mm[p];
    EXPECT_LT((shown - whole.displacement_mm[static_cast<std::size_t>(mesh_point[p])]).norm(), 1e-6);
  }
}

TEST(Session, UndoGoesBackToTheSameBits) {
  auto engine = SessionEngine::create(whole_block()).value();
  const std::string untouched = engine.state().digest;
  const std::string one = engine.step(HoldTool{probe({35, 40, 44})}).digest;
  const std::string two = engine.step(HoldTool{jaws({0, 0, 4})}).digest;
  EXPECT_NE(one, two);
  EXPECT_EQ(engine.step(Undo{}).digest, one);
  EXPECT_EQ(engine.step(HoldTool{jaws({0, 0, 4})}).digest, two);
  engine.step(Undo{});
  EXPECT_EQ(engine.step(Undo{}).digest, untouched);
  EXPECT_THAT(engine.step(Undo{}).refused, HasSubstr("nothing to undo"));
  EXPECT_EQ(engine.state().digest, untouched);
}

TEST(Session, ARecordingReplaysToTheBitThroughItsFile) {
  auto engine = SessionEngine::create(whole_block()).value();
  Recording recording;
  const std::vector<SessionCommand> commands{HoldTool{probe({35.1, 40, 45})},
                                             HoldTool{probe({37.7, 41.3, 42})},
                                             HoldTool{jaws({1, 0.3, 5})},
                                             HoldTool{probe({40, 40, 60}, 120.0)},
                                             Undo{},
                                             ReleaseTool{"probe"},
                                             ReleaseTool{"nothing such"}};
  for (const SessionCommand& command : commands) recording.emplace_back(command, engine.step(command).digest);
  EXPECT_THAT(engine.state().refused, HasSubstr("no tool nothing such"));

  const auto read = parse_recording(recording_text(recording)).value();
  auto again = SessionEngine::create(whole_block()).value();
  EXPECT_FALSE(replay(again, read).has_value());
  auto altered = read;
  std::get<TouchingTool>(std::get<HoldTool>(altered[1].first).tool.what).pose.position_mm.x() += 1e-9;
  auto other = SessionEngine::create(whole_block()).value();
  EXPECT_EQ(replay(other, altered), std::optional<std::size_t>(1));
}

// Along a sheet the walls open step by step; its points go through the file to the bit.
TEST(Session, ACurvedCutAdvancesAndReplaysThroughItsFile) {
  const auto sheet = geometry::CutSurface::through(
                         {{5, 40.7, 0}, {40, 43.1, 2}, {75, 41.3, 0}, {5, 40.2, 38}, {40, 44, 41}, {75, 41, 40}})
                         .value();
  auto engine = SessionEngine::create(whole_block()).value();
  Recording recording;
  const std::vector<SessionCommand> commands{HoldTool{jaws({0, 0, 4})}, AdvanceCut{{sheet, {0, 41, 20}, {12, 41, 20}}},
                                             AdvanceCut{{sheet, {12, 41, 20}, {20, 41, 20}}}};
  double open_mm2 = 0;
  for (const SessionCommand& command : commands) {
    const SessionState& state = engine.step(command);
    ASSERT_EQ(state.refused, "");
    recording.emplace_back(command, state.digest);
    if (!state.cut) continue;
    EXPECT_GT(state.cut->open_mm2, open_mm2 + 100);
    open_mm2 = state.cut->open_mm2;
  }
  const auto read = parse_recording(recording_text(recording)).value();
  auto again = SessionEngine::create(whole_block()).value();
  EXPECT_FALSE(replay(again, read).has_value());
  EXPECT_THAT(parse_recording(R"({"format": "glisson-session/1", "commands": [{"cut": {"points_mm": [[0, 0, 0]],
                               "from_mm": [0, 0, 0], "to_mm": [1, 0, 0]}}]})")
                  .error()
                  .message(),
              HasSubstr("needs 3 to 2000 points; there are 1"));
}

TEST(CutCourse, LeadsFromTheLowerFrontEdgeOfThePlaneThroughTheBody) {
  const geometry::TetMesh body = mechanics::test::box(6, 6, 3, {80, 80, 40});
  const auto plane = geometry::CutSurface::plane({31, 99, 7}, {1, 0, 0}).value();
  const CutCourse course = course_of(body, plane).value();
  EXPECT_NEAR(course.forward.y(), std::sqrt(0.5), 1e-12);  // to the back
  EXPECT_NEAR(course.forward.z(), std::sqrt(0.5), 1e-12);  // and the head
  EXPECT_NEAR(course.length_mm, 120 * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(course.begin_mm.x(), 31, 1e-12);
  EXPECT_NEAR(course.begin_mm.dot(course.forward), 0, 1e-9);  // the lower front edge is at y = z = 0
  const auto strip = course.strip(5, 10);
  EXPECT_NEAR((strip.to_mm - strip.from_mm).norm(), 5, 1e-12);
  // Across that way, to the left.
  const auto across = geometry::CutSurface::plane({40, 40, 20}, {0, 1, 1}).value();
  EXPECT_NEAR(course_of(body, across)->forward.x(), 1, 1e-12);
  EXPECT_EQ(course_of(body, geometry::CutSurface::plane({90, 0, 0}, {1, 0, 0}).value()).error().code, "cut-misses");
  const auto sheet = geometry::CutSurface::through({{10, 10, 10}, {70, 10, 12}, {10, 70, 12}, {70, 70, 20}}).value();
  const CutCourse along_sheet = course_of(body, sheet).value();
  EXPECT_NEAR(along_sheet.forward.dot(sheet.normal()), 0, 1e-12);
  EXPECT_GT(along_sheet.length_mm, 80);
}

AdvanceCut advance(double from_x_mm, double to_x_mm) {
  return {
      {geometry::CutSurface::plane({0, 40.7, 0}, {0, 1, 0.05}).value(), {from_x_mm, 40.7, 20}, {to_x_mm, 40.7, 20}}};
}

// A grasper holds one side up while the cut advances from the block's edge towards it and past it.
TEST(Session, ACutOpensUnderTractionStepByStepAndBackAgain) {
  auto engine = SessionEngine::create(whole_block()).value();
  const ContactTool lifting{"grasper", Grasp{{30, 56, 40}, 9, 800.0, {0, 0.6, 1}}};
  Recording recording;
  const auto carry_out = [&](const SessionCommand& command) -> const SessionState& {
    const SessionState& state = engine.step(command);
    EXPECT_EQ(state.refused, "");
    recording.emplace_back(command, state.digest);
    return state;
  };
  const SessionState uncut = carry_out(HoldTool{lifting});
  EXPECT_EQ(uncut.cut, nullptr);
  const SessionState first = carry_out(advance(80, 55));
  const SessionState second = carry_out(advance(55, 25));
  ASSERT_TRUE(first.cut && second.cut);
  EXPECT_GT(second.cut->open_mm2, first.cut->open_mm2);
  EXPECT_NEAR(second.cut->open_mm2 + second.cut->bridge_mm2, first.cut->open_mm2 + first.cut->bridge_mm2, 1e-6);
  EXPECT_GT(second.cut->largest_opening_mm, first.cut->largest_opening_mm);
  EXPECT_GT(second.patient.max_displacement_mm, uncut.patient.max_displacement_mm);
  EXPECT_LE(second.patient_step.report.overlap_mm, 0.1);
  // The triangle that hangs in the block lies across the second advance alone.
  EXPECT_TRUE(first.cut->crossed.empty());
  EXPECT_EQ(second.cut->crossed, std::vector<std::size_t>{0});
  // What is shown is what a whole solve under the same forces and jumps finds.
  const auto whole = engine.whole_result().value();
  const auto& mesh_point = engine.surface().point_fields[0].values;
  for (std::size_t p = 0; p < mesh_point.size(); ++p) {
    const Vector3d shown = second.patient.surface_mm[p] - engine.surface().points_mm[p];
    EXPECT_LT((shown - whole.displacement_mm[static_cast<std::size_t>(mesh_point[p])]).norm(), 1e-5);
  }

  const SessionState& back = carry_out(Undo{});
  EXPECT_EQ(back.digest, first.digest);
  EXPECT_EQ(carry_out(advance(55, 25)).digest, second.digest);
  const SessionState& beside = engine.step(advance(-20, -30));
  EXPECT_THAT(beside.refused, HasSubstr("opens nothing"));
  EXPECT_EQ(beside.digest, second.digest);

  auto again = SessionEngine::create(whole_block()).value();
  EXPECT_FALSE(replay(again, parse_recording(recording_text(recording)).value()).has_value());
}

TEST(Session, ACommandThatCannotBeCarriedOutLeavesWhatWasAndSaysWhy) {
  auto engine = SessionEngine::create(whole_block()).value();
  const std::string before = engine.step(HoldTool{probe({35, 40, 44})}).digest;
  ContactTool lost = probe({35, 40, -60}, 100.0);  // under the ground, going away
  lost.id = "lost";
  const SessionState& refused = engine.step(HoldTool{lost});
  EXPECT_THAT(refused.refused, HasSubstr("meets no surface"));
  EXPECT_EQ(refused.digest, before);
  EXPECT_THAT(parse_recording("{}").error().message(), HasSubstr("glisson-session/1"));
  EXPECT_THAT(parse_recording(R"({"format": "glisson-session/1", "commands": [{"hold": {"id": "a", "rod": []}}]})")
                  .error()
                  .message(),
              HasSubstr("Command 1 of the session cannot be read: it has an unknown key \"rod\""));
  EXPECT_THAT(parse_recording(R"({"format": "glisson-session/1", "commands": [{"cut": {"plane": [0, 0, 0, 0, 0]}}]})")
                  .error()
                  .message(),
              HasSubstr("plane must be six numbers"));
}

RehearsalSetup soft_block() {
  RehearsalSetup setup = whole_block();
  setup.law = mechanics::MaterialLaw::neo_hookean;
  return setup;
}

TEST(SessionAtLargeStrain, ShowsAFirstPictureWithABoundAndSettlesToRest) {
  auto engine = SessionEngine::create(soft_block()).value();
  EXPECT_TRUE(engine.state().settled);
  for (int i = 0; i < 6; ++i) {
    const SessionState state = engine.step(HoldTool{probe({35.0 + i, 40, 44.0 - 0.5 * i})});
    ASSERT_EQ(state.refused, "");
    EXPECT_FALSE(state.settled);
    EXPECT_TRUE(state.validity.usable());
    ASSERT_TRUE(state.error_bound_mm.has_value());
    const SessionState rest = engine.settled_state();
    EXPECT_TRUE(rest.settled);
    EXPECT_LE(rest.patient_step.report.penetration_mm, 0.1);
    for (std::size_t l = 0; l < state.patient.landmarks.size(); ++l) {
      const auto off_mm = [&](const RehearsalBody& shown, const RehearsalBody& settled) {
        return (shown.landmarks[l].displaced_mm - settled.landmarks[l].displaced_mm).norm();
      };
      EXPECT_LE(off_mm(state.patient, rest.patient), *state.error_bound_mm);
      EXPECT_LE(off_mm(*state.reference, *rest.reference), *state.error_bound_mm);
    }
    EXPECT_EQ(engine.state().digest, state.digest);  // to look at rest moves nothing
  }
  // Settle after settle comes to the same rest, to the bit.
  const std::string rest = engine.settled_state().digest;
  for (int i = 0; i < SessionEngine::most_settles && !engine.state().settled; ++i) engine.step(Settle{});
  EXPECT_EQ(engine.state().digest, rest);
  EXPECT_EQ(engine.step(Settle{}).digest, rest);
  // A ball turns about nothing: its contacts' moment about it is little beside its force times its radius.
  const SessionStep& step = engine.state().patient_step;
  EXPECT_LT(step.torque_mNmm.norm(), 0.05 * 8 * step.tools[0].force_mN.norm());
}

TEST(SessionAtLargeStrain, IsWhatSmallStrainSaysWhereStrainIsSmall) {
  auto small = SessionEngine::create(whole_block()).value();
  auto large = SessionEngine::create(soft_block()).value();
  const HoldTool light{probe({35, 40, 60}, 20.0)};
  small.step(light);
  large.step(light);
  const SessionState rest = large.settled_state();
  ASSERT_TRUE(rest.settled);
  EXPECT_LT(rest.validity.largest_strain, 0.1);
  for (std::size_t l = 0; l < rest.patient.landmarks.size(); ++l) {
    EXPECT_NEAR(rest.patient.landmarks[l].displacement_mm, small.state().patient.landmarks[l].displacement_mm, 0.1);
  }
}

TEST(SessionAtLargeStrain, ReplaysToTheBitWithItsSettling) {
  auto engine = SessionEngine::create(soft_block()).value();
  Recording recording;
  const std::vector<SessionCommand> commands{HoldTool{probe({35.1, 40, 45})},
                                             Settle{},
                                             HoldTool{probe({37.7, 41.3, 44})},
                                             HoldTool{jaws({1, 0.3, 3})},
                                             Settle{},
                                             Undo{},
                                             ReleaseTool{"probe"}};
  for (const SessionCommand& command : commands) recording.emplace_back(command, engine.step(command).digest);
  EXPECT_EQ(recording[5].second, recording[2].second);  // undone
  const auto read = parse_recording(recording_text(recording)).value();
  auto again = SessionEngine::create(soft_block()).value();
  EXPECT_FALSE(replay(again, read).has_value());
}

// The same as at small strain: a grasper holds one side up while the cut advances towards it and past it, and every
// advance goes back to the bit.
TEST(SessionAtLargeStrain, ACutOpensUnderTractionStepByStepAndBackAgain) {
  auto engine = SessionEngine::create(soft_block()).value();
  Recording recording;
  const auto carry_out = [&](const SessionCommand& command) {
    const SessionState& state = engine.step(command);
    EXPECT_EQ(state.refused, "");
    recording.emplace_back(command, state.digest);
    return state;
  };
  const auto come_to_rest = [&] {
    for (int i = 0; i < SessionEngine::most_settles && !engine.state().settled; ++i) carry_out(Settle{});
    EXPECT_TRUE(engine.state().settled);
    return engine.state();
  };
  carry_out(HoldTool{{"grasper", Grasp{{30, 56, 40}, 9, 300.0, {0, 0.6, 1}}}});
  const SessionState uncut = come_to_rest();
  EXPECT_EQ(uncut.cut, nullptr);
  const SessionState picture = carry_out(advance(80, 55));
  ASSERT_TRUE(picture.error_bound_mm.has_value());
  EXPECT_FALSE(picture.settled);
  const SessionState first = come_to_rest();
  for (std::size_t l = 0; l < first.patient.landmarks.size(); ++l) {
    EXPECT_LE((picture.patient.landmarks[l].displaced_mm - first.patient.landmarks[l].displaced_mm).norm(),
              *picture.error_bound_mm);
  }
  while (engine.prepare()) continue;
  carry_out(advance(55, 25));
  const SessionState second = come_to_rest();
  ASSERT_TRUE(first.cut && second.cut);
  EXPECT_GT(second.cut->open_mm2, first.cut->open_mm2);
  EXPECT_GT(second.cut->largest_opening_mm, first.cut->largest_opening_mm);
  EXPECT_GT(second.patient.max_displacement_mm, uncut.patient.max_displacement_mm);
  EXPECT_LE(second.patient_step.report.overlap_mm, 0.1);
  EXPECT_TRUE(geometry::check_surface(second.cut->patient));
  EXPECT_TRUE(second.reference.has_value());
  carry_out(Undo{});
  EXPECT_EQ(engine.state().digest, first.digest);
  carry_out(Undo{});
  EXPECT_EQ(engine.state().digest, uncut.digest);
  EXPECT_EQ(engine.state().cut, nullptr);
  const auto read = parse_recording(recording_text(recording)).value();
  auto again = SessionEngine::create(soft_block()).value();
  EXPECT_FALSE(replay(again, read).has_value());
}

// Pressed in and drawn along; where it was stuck to is in the recording's bits, and undo goes back to it.
TEST(SessionAtLargeStrain, AToolWithFrictionPullsAlongAndReplaysToTheBit) {
  const auto drawn = [](double way_mm, double friction) {
    ContactTool tool = probe({35 + way_mm, 40, 44});
    std::get<TouchingTool>(tool.what).friction = friction;
    return HoldTool{std::move(tool)};
  };
  auto engine = SessionEngine::create(soft_block()).value();
  Recording recording;
  for (const SessionCommand& command : std::vector<SessionCommand>{drawn(0, 0.3), Settle{}, drawn(1, 0.3), Settle{},
                                                                   drawn(2, 0.3), Undo{}, drawn(2, 0.3)}) {
    recording.emplace_back(command, engine.step(command).digest);
  }
  EXPECT_EQ(recording[5].second, recording[3].second);
  EXPECT_EQ(recording[6].second, recording[4].second);
  const SessionState rest = engine.settled_state();
  ASSERT_TRUE(rest.settled);
  const mechanics::ToolContact& tool = rest.patient_step.tools[0];
  EXPECT_GT(tool.sticking + tool.slipping, 0);
  EXPECT_GT(tool.force_mN.x(), 0.1 * -tool.force_mN.z());

  const auto read = parse_recording(recording_text(recording)).value();
  auto again = SessionEngine::create(soft_block()).value();
  EXPECT_FALSE(replay(again, read).has_value());
  auto smooth = SessionEngine::create(soft_block()).value();
  for (const double way_mm : {0.0, 1.0, 2.0}) smooth.step(drawn(way_mm, 0));
  const mechanics::ToolContact without = smooth.settled_state().patient_step.tools[0];
  EXPECT_EQ(without.sticking + without.slipping, 0);
  EXPECT_LT(without.force_mN.x(), tool.force_mN.x() + 0.1 * tool.force_mN.z());
}

TEST(Session, AToolIsSmoothUnlessItSaysOtherwise) {
  const auto read = [](const std::string& friction) {
    return parse_recording(
        R"({"format": "glisson-session/1", "commands": [{"hold": {"id": "a", "shape": "palpation-probe",
      "position_mm": [0, 0, 0], "direction": [0, 0, 1])" +
        friction + "}}]}");
  };
  const auto friction_of = [&](const std::string& said) {
    return std::get<TouchingTool>(std::get<HoldTool>(read(said).value()[0].first).tool.what).friction;
  };
  EXPECT_EQ(friction_of(""), 0);
  EXPECT_EQ(friction_of(R"(, "friction": 0.25)"), 0.25);
  EXPECT_FALSE(read(R"(, "friction": -0.1)").has_value());
}

ContactTool patch(const Vector3d& force_mN, const Vector3d& center_mm = {35, 40, 40}) {
  return {"patch", mechanics::ToolLoad{center_mm, 14, force_mN}};
}

// One command of a large force is followed in steps; what is let go, and what is drawn elsewhere, goes as gently.
TEST(SessionAtLargeStrain, AForceSpreadOverAPatchMovesItAndLeavesItWhereItWas) {
  auto engine = SessionEngine::create(soft_block()).value();
  const RehearsalBody before = engine.state().patient;
  ASSERT_EQ(engine.step(HoldTool{patch({0, 0, -1200})}).refused, "");
  const SessionState pressed = engine.settled_state();
  ASSERT_TRUE(pressed.settled);
  EXPECT_GT(pressed.validity.largest_strain, mechanics::small_strain_limit);
  EXPECT_EQ(pressed.validity.state(), mechanics::AnswerState::within);
  EXPECT_NEAR(pressed.patient_step.tools[0].force_mN.z(), -1200, 1e-6);
  ASSERT_EQ(engine.step(HoldTool{patch({0, 0, 700})}).refused, "");
  ASSERT_EQ(engine.step(HoldTool{patch({0, 0, 700}, {25, 40, 40})}).refused, "");
  const SessionState drawn = engine.settled_state();
  ASSERT_TRUE(drawn.settled);
  EXPECT_EQ(drawn.patient_step.tools.size(), 1u);
  auto there_at_once = SessionEngine::create(soft_block()).value();
  there_at_once.step(HoldTool{patch({0, 0, 700}, {25, 40, 40})});
  const SessionState same = there_at_once.settled_state();
  for (std::size_t l = 0; l < same.patient.landmarks.size(); ++l) {
    EXPECT_LT((same.patient.landmarks[l].displaced_mm - drawn.patient.landmarks[l].displaced_mm).norm(), 0.05);
  }
  ASSERT_EQ(engine.step(ReleaseTool{"patch"}).refused, "");
  const SessionState free = engine.settled_state();
  ASSERT_TRUE(free.settled);
  for (std::size_t l = 0; l < free.patient.landmarks.size(); ++l) {
    EXPECT_LT((free.patient.landmarks[l].displaced_mm - before.landmarks[l].displaced_mm).norm(), 0.05);
  }
}

TEST(SessionAtLargeStrain, APatchIsRecordedAndAtSmallStrainRefused) {
  const Recording recording{{HoldTool{patch({12.5, -3, 250})}, ""}};
  const auto read = parse_recording(recording_text(recording)).value();
  const auto& again = std::get<mechanics::ToolLoad>(std::get<HoldTool>(read[0].first).tool.what);
  EXPECT_EQ(again.force_mN, Vector3d(12.5, -3, 250));
  EXPECT_EQ(again.radius_mm, 14);
  auto small = SessionEngine::create(whole_block()).value();
  EXPECT_THAT(small.step(read[0].first).refused, HasSubstr("at large strain alone"));
}

// Which of a session's states are the same command brought nearer to rest.
TEST(SessionAtLargeStrain, ASettleThatIsGivenUpHasNeverBeen) {
  auto engine = SessionEngine::create(soft_block()).value();
  const SessionState before = engine.step(HoldTool{probe({30, 40, 44})});
  ASSERT_FALSE(before.settled);
  std::stop_source stopped;
  stopped.request_stop();
  const SessionState& after = engine.step(Settle{}, Progress({}, stopped.get_token()));
  EXPECT_EQ(after.digest, before.digest);
  EXPECT_EQ(after.number, before.number);
  EXPECT_EQ(after.refused, "");
  const std::string nearer = engine.step(Settle{}).digest;
  auto other = SessionEngine::create(soft_block()).value();
  other.step(HoldTool{probe({30, 40, 44})});
  EXPECT_EQ(other.step(Settle{}).digest, nearer);
}

TEST(SessionAtLargeStrain, AToolIsShownOnItsWayAndComesToTheSameBits) {
  const auto pressed = [](double push_mN) {
    return HoldTool{{"probe", mechanics::TouchingTool{mechanics::palpation_probe(),
                                                      mechanics::pose_towards({35, 40, 70}, {0, 0, -1}), push_mN}}};
  };
  auto engine = SessionEngine::create(soft_block()).value(), alone = SessionEngine::create(soft_block()).value();
  std::vector<std::shared_ptr<const SessionState>> on_the_way;
  const SessionState there =
      engine.step(pressed(600), {}, [&](std::shared_ptr<const SessionState> state) { on_the_way.push_back(state); });
  ASSERT_EQ(there.refused, "");
  EXPECT_EQ(there.on_the_way, 0);
  EXPECT_EQ(there.digest, alone.step(pressed(600)).digest);
  ASSERT_EQ(on_the_way.size(), 2u);
  for (std::size_t move = 0; move < on_the_way.size(); ++move) {
    EXPECT_EQ(on_the_way[move]->on_the_way, static_cast<int>(move) + 1);
    EXPECT_EQ(on_the_way[move]->number, there.number - 1);
    EXPECT_TRUE(on_the_way[move]->error_bound_mm);
    const double before_mm = move == 0 ? 0 : on_the_way[move - 1]->patient.max_displacement_mm;
    EXPECT_GT(on_the_way[move]->patient.max_displacement_mm, before_mm);
    EXPECT_LT(on_the_way[move]->patient.max_displacement_mm, there.patient.max_displacement_mm);
  }
}

TEST(SessionAtLargeStrain, StatesSayHowOftenTheyWereSettled) {
  auto engine = SessionEngine::create(soft_block()).value();
  EXPECT_EQ(engine.step(HoldTool{probe({35, 40, 44})}).settles, 0u);
  EXPECT_EQ(engine.step(Settle{}).settles, 1u);
  EXPECT_EQ(engine.step(Settle{}).settles, 2u);
  EXPECT_EQ(engine.step(HoldTool{probe({36, 40, 44})}).settles, 0u);
}

TEST(SessionAtLargeStrain, AStepThatWouldCrushTheBodyIsRefusedAndLeavesWhatWas) {
  auto engine = SessionEngine::create(soft_block()).value();
  const std::string before = engine.step(HoldTool{probe({35, 40, 46})}).digest;
  const SessionState& crushed = engine.step(HoldTool{probe({35, 40, 0})});
  EXPECT_NE(crushed.refused, "");
  EXPECT_EQ(crushed.digest, before);
}

// A session that begins without its reference body answers of the patient as it would with it. From Compare on it is
// the session that had both from the beginning: to the bit where the tools came straight, and nearly where they were
// drawn.
TEST(Session, TheReferenceBodyMayComeLater) {
  auto with = SessionEngine::create(whole_block()).value();
  auto later = SessionEngine::create(whole_block(), {}, WithReference::when_asked).value();
  EXPECT_TRUE(later.has_reference());
  const std::string untouched = with.state().digest;
  EXPECT_FALSE(later.state().reference);
  const SessionState& alone = later.step(HoldTool{probe({35, 40, 40})});
  const SessionState& both = with.step(HoldTool{probe({35, 40, 40})});
  EXPECT_FALSE(alone.reference);
  EXPECT_TRUE(alone.differences.empty());
  EXPECT_EQ(alone.patient.surface_mm, both.patient.surface_mm);
  ASSERT_TRUE(later.make_reference());
  EXPECT_FALSE(later.state().reference);
  EXPECT_EQ(later.step(Compare{}).digest, with.state().digest);
  EXPECT_EQ(later.state().differences.size(), 2u);
  for (auto* engine : {&with, &later}) {
    EXPECT_EQ(engine->step(HoldTool{probe({36, 40, 40})}).refused, "");
  }
  EXPECT_EQ(later.state().digest, with.state().digest);
  // Back to before the comparison: the reference body is there too.
  later.step(Undo{});
  EXPECT_EQ(later.step(Undo{}).digest, untouched);

  // Drawn over the surface and cut before it is compared.
  for (auto* engine : {&with, &later})
    *engine =
        SessionEngine::create(whole_block(), {}, engine == &with ? WithReference::at_once : WithReference::when_asked)
            .value();
  for (auto* engine : {&with, &later}) {
    for (int i = 0; i < 5; ++i) engine->step(HoldTool{probe({30.0 + 2 * i, 40, 40})});
    EXPECT_EQ(engine->step(advance(0, 20)).refused, "");
  }
  const SessionState& drawn = later.step(Compare{});
  ASSERT_TRUE(drawn.reference);
  for (std::size_t l = 0; l < drawn.reference->landmarks.size(); ++l) {
    EXPECT_LT((drawn.reference->landmarks[l].displaced_mm - with.state().reference->landmarks[l].displaced_mm).norm(),
              0.1);
  }
}

// What a session did before it compared and after it is the same when it is read from its file and done again.
TEST(Session, AComparisonIsInTheRecording) {
  auto engine = SessionEngine::create(whole_block(), {}, WithReference::when_asked).value();
  Recording recording;
  for (const SessionCommand& command :
       std::vector<SessionCommand>{HoldTool{probe({35, 40, 42})}, Compare{}, HoldTool{probe({35, 40, 40})}}) {
    recording.emplace_back(command, engine.step(command).digest);
  }
  const auto read = parse_recording(recording_text(recording)).value();
  EXPECT_EQ(reference_in(read), WithReference::when_asked);
  auto again = SessionEngine::create(whole_block(), {}, reference_in(read)).value();
  EXPECT_FALSE(replay(again, read).has_value());
  // Where nothing can be compared, that is said and nothing changes.
  RehearsalSetup alone = whole_block();
  alone.reference_youngs_kPa.reset();
  auto single = SessionEngine::create(std::move(alone)).value();
  const std::string before = single.state().digest;
  EXPECT_THAT(single.step(Compare{}).refused, HasSubstr("no reference body"));
  EXPECT_EQ(single.state().digest, before);
}

void wait_for(const LiveSession& session, SessionPhase phase) {
  for (int i = 0; i < 3000 && session.phase() != phase; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_EQ(session.phase(), phase);
}

TEST(LiveSession, NeverKeepsItsCallerWaitingAndRecordsWhatItDid) {
  LiveSession session(whole_block());
  // A drag: many moves, posted faster than they can be made.
  double longest_ms = 0;
  for (int i = 0; i < 200; ++i) {
    const auto before = std::chrono::steady_clock::now();
    session.post(HoldTool{probe({30 + 0.1 * i, 40, 45})});
    longest_ms = std::max(longest_ms,
                          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count());
  }
  EXPECT_LT(longest_ms, 200);  // nothing against a step of this machine at its busiest; a blocked caller waits seconds
  wait_for(session, SessionPhase::ready);
  const auto recording = session.recording();
  ASSERT_FALSE(recording.empty());
  EXPECT_LT(recording.size(), 200u);  // of moves that waited only the last was made
  ASSERT_EQ(session.latest()->digest, recording.back().second);
  const auto& last = std::get<TouchingTool>(session.latest()->tools[0].what);
  EXPECT_EQ(last.pose.position_mm.x(), 30 + 0.1 * 199);
  // The reference body came in at some moment, once, and that is in the recording.
  EXPECT_EQ(std::count_if(recording.begin(), recording.end(),
                          [](const auto& one) { return std::holds_alternative<Compare>(one.first); }),
            1);
  EXPECT_TRUE(session.latest()->reference);
  auto engine = SessionEngine::create(whole_block(), {}, reference_in(recording)).value();
  EXPECT_FALSE(replay(engine, recording).has_value());
}

TEST(LiveSession, AtLargeStrainItComesToRestByItselfAndRecordsHow) {
  LiveSession session(soft_block());
  for (int i = 0; i < 20; ++i) session.post(HoldTool{probe({30 + 0.2 * i, 40, 45})});
  for (int i = 0; i < 3000 && !(session.phase() == SessionPhase::ready && session.latest()->settled &&
                                !session.latest()->tools.empty());
       ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(session.latest()->settled);
  const auto recording = session.recording();
  EXPECT_TRUE(std::holds_alternative<Settle>(recording.back().first));
  EXPECT_TRUE(session.latest()->reference);
  auto engine = SessionEngine::create(soft_block(), {}, reference_in(recording)).value();
  EXPECT_FALSE(replay(engine, recording).has_value());
}

TEST(LiveSession, WhatIsAskedForDoesNotWaitForASettleAndReplaysToTheBit) {
  LiveSession session(soft_block());
  session.post(HoldTool{probe({30, 40, 45})});
  int asked = 1;
  for (int i = 0; i < 3000 && asked < 6; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (session.phase() != SessionPhase::settling) continue;
    session.post(HoldTool{probe({30 + 0.3 * asked, 40, 45})});
    ++asked;
  }
  EXPECT_EQ(asked, 6);
  for (int i = 0; i < 3000 && !(session.phase() == SessionPhase::ready && session.latest()->settled); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(session.latest()->settled);
  const auto recording = session.recording();
  auto engine = SessionEngine::create(soft_block(), {}, reference_in(recording)).value();
  EXPECT_FALSE(replay(engine, recording).has_value());
}

TEST(LiveSession, ASessionThatCannotBeIsFailedAndSaysWhy) {
  RehearsalSetup setup = whole_block();
  setup.supports.clear();
  const LiveSession session(std::move(setup));
  wait_for(session, SessionPhase::failed);
  EXPECT_EQ(session.error()->code, "body-free");
  EXPECT_FALSE(session.latest());
}

}  // namespace
}  // namespace glisson::rehearsal
