// A cut drawn freehand: how places under a hand become advances, and what a session makes of them.

#include "rehearsal/stroke.h"

#include <gmock/gmock.h>
#include <cmath>

#include "mechanics/bodies.h"
#include "rehearsal/session.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

const Vector3d into_mm(0, 2, -12);

// Over the top of the block below, bent to one side; about 0.7 mm from place to place, as a mouse tells them.
Vector3d hand(double share) { return {8 + 62 * share, 40 + 9 * std::sin(3 * share), 40}; }

std::vector<mechanics::CutStrip> advances(Stroke& stroke, double until_share, bool lifts) {
  std::vector<mechanics::CutStrip> strips;
  for (double share = stroke.length_mm() / 70; share < until_share; share += 0.01) {
    EXPECT_TRUE(stroke.draw_to(hand(share)));
    while (auto strip = stroke.next_advance(Stroke::Hand::draws)) strips.push_back(*std::move(strip));
  }
  while (lifts) {
    auto strip = stroke.next_advance(Stroke::Hand::lifted);
    if (!strip) break;
    strips.push_back(*std::move(strip));
  }
  return strips;
}

TEST(Stroke, ItsAdvancesFollowEachOtherAlongOneLineThatGrows) {
  Stroke stroke(hand(0), into_mm);
  const auto strips = advances(stroke, 1, true);
  ASSERT_GT(strips.size(), std::size_t{6});
  EXPECT_LT((strips.front().from_mm - hand(0)).norm(), 1e-12);
  for (std::size_t n = 1; n < strips.size(); ++n) {
    EXPECT_LT((strips[n].from_mm - strips[n - 1].to_mm).norm(), 1e-9);
    EXPECT_TRUE(strips[n].surface.goes_on(strips[n - 1].surface));
  }
  for (const mechanics::CutStrip& strip : strips) {
    const double from = strip.surface.on_line(strip.from_mm).along_mm, to = strip.surface.on_line(strip.to_mm).along_mm;
    EXPECT_LE(to - from, Stroke::longest_advance_mm + 1e-9);
    EXPECT_GT(to - from, 1);
  }
  EXPECT_NEAR(strips.back().surface.on_line(strips.back().to_mm).along_mm, stroke.length_mm(), 1e-9);
  EXPECT_EQ(stroke.cut_mm(), stroke.length_mm());
  // Every place of the line is one that the hand was at, and no two are nearer than told.
  for (std::size_t p = 1; p < stroke.line_mm().size(); ++p) {
    const Vector3d way_mm = stroke.line_mm()[p] - stroke.line_mm()[p - 1];
    const double across_mm = way_mm.cross(into_mm).norm() / into_mm.norm();
    EXPECT_GE(across_mm, Stroke::apart_mm);
    EXPECT_LT(across_mm, Stroke::apart_mm + 1);
  }
}

TEST(Stroke, TheFrontStaysBehindTheHandUntilItIsLifted) {
  Stroke stroke(hand(0), into_mm);
  for (double share = 0; share < 0.5; share += 0.01) {
    ASSERT_TRUE(stroke.draw_to(hand(share)));
    while (stroke.next_advance(Stroke::Hand::draws)) continue;
    EXPECT_LE(stroke.cut_mm(), std::max(0.0, stroke.length_mm() - Stroke::behind_mm));
    EXPECT_GT(stroke.cut_mm(), stroke.length_mm() - Stroke::behind_mm - Stroke::shortest_advance_mm - 1e-9);
  }
  EXPECT_FALSE(Stroke(hand(0), into_mm).next_advance(Stroke::Hand::lifted));  // a click cuts nothing
}

TEST(Stroke, GoesOnFromWhereTheLastOneWasLifted) {
  Stroke first(hand(0), into_mm);
  const auto begun = advances(first, 0.4, true);
  Stroke second = Stroke::going_on(begun.back());
  EXPECT_EQ(second.line_mm(), first.line_mm());
  EXPECT_NEAR(second.cut_mm(), first.cut_mm(), 1e-9);
  const auto more = advances(second, 0.8, true);
  ASSERT_FALSE(more.empty());
  EXPECT_TRUE(more.front().surface.goes_on(begun.back().surface));
  EXPECT_LT((more.front().from_mm - begun.back().to_mm).norm(), 1e-9);
}

TEST(Stroke, SaysWhenItTurnsBackOrLeavesTheSurfaceAndLosesNothing) {
  Stroke stroke({0, 0, 0}, {0, 0, -10});
  ASSERT_TRUE(stroke.draw_to({5, 0, 0}));
  ASSERT_TRUE(stroke.draw_to({10, 3, 0}));
  const auto line_mm = stroke.line_mm();
  EXPECT_EQ(stroke.draw_to({7, 0, 0}).error().code, "stroke-turns");
  EXPECT_EQ(stroke.draw_to({13, 4, -40}).error().code, "stroke-leaves");
  EXPECT_EQ(stroke.line_mm(), line_mm);
  EXPECT_TRUE(stroke.draw_to({14, 4, -6}));  // down a slope
}

RehearsalSetup block() {
  RehearsalSetup setup;
  setup.mesh = mechanics::test::box(12, 12, 6, {80, 80, 40});
  mechanics::test::name_points(setup.mesh, "ground", [](const Vector3d& p) { return p.z() == 0; });
  setup.patient_youngs_kPa.assign(setup.mesh.cells.size(), 4);
  setup.reference_youngs_kPa = 6;
  setup.supports = {mechanics::test::fixed("ground")};
  setup.landmarks = {{"tumour-1", {35, 40, 34}}};
  // Two triangles across the stroke: one as deep as it goes, one below.
  for (const double z_mm : {33.0, 20.0}) {
    geometry::Surface across;
    across.points_mm = {{50, 30, z_mm}, {54, 30, z_mm}, {52, 60, z_mm}};
    across.triangles = {{0, 1, 2}};
    setup.structures.push_back(across);
  }
  return setup;
}

// Jaws lift one side while the stroke is drawn: each advance opens more, what lies deeper than the knife is not
// crossed, the file holds the line itself, and replay and undo are the same to the bit.
TEST(StrokeInSession, OpensAdvanceByAdvanceReplaysThroughItsFileAndIsTakenBack) {
  auto engine = SessionEngine::create(block()).value();
  Recording recording;
  std::vector<std::string> digests;
  double open_mm2 = 0, opening_mm = 0;
  const auto step = [&](const SessionCommand& command) -> const SessionState& {
    const SessionState& state = engine.step(command);
    EXPECT_EQ(state.refused, "");
    recording.emplace_back(command, state.digest);
    digests.push_back(state.digest);
    return state;
  };
  step(HoldTool{{"jaws", mechanics::Grasp{{40, 56, 40}, 9, 600.0, {0, 0.6, 1}}}});
  Stroke stroke(hand(0), into_mm);
  for (const mechanics::CutStrip& strip : advances(stroke, 1, true)) {
    const SessionState& state = step(AdvanceCut{strip});
    ASSERT_NE(state.cut, nullptr);
    EXPECT_GT(state.cut->open_mm2, open_mm2 + 10);
    open_mm2 = state.cut->open_mm2;
    opening_mm = std::max(opening_mm, state.cut->largest_opening_mm);
    EXPECT_TRUE(geometry::check_surface(state.cut->patient));
  }
  EXPECT_GT(opening_mm, 1);
  // As long as the line and as deep as the knife went, but for what of it lies within cells.
  const double expected_mm2 = stroke.length_mm() * into_mm.norm();
  EXPECT_NEAR(open_mm2, expected_mm2, 0.05 * expected_mm2);
  EXPECT_EQ(engine.state().cut->crossed, std::vector<std::size_t>{0});

  const std::string text = recording_text(recording);
  EXPECT_THAT(text, HasSubstr("into_mm"));
  auto again = SessionEngine::create(block()).value();
  EXPECT_FALSE(replay(again, parse_recording(text).value()).has_value());

  const std::size_t advanced = digests.size() - 1;
  for (std::size_t n = 0; n < advanced; ++n) step(Undo{});
  for (std::size_t n = 0; n <= advanced; ++n) EXPECT_EQ(digests[advanced + n], digests[advanced - n]) << n;
  EXPECT_EQ(engine.state().cut, nullptr);
}

TEST(StrokeInSession, IsRefusedInOneSentenceAndWhatWasCutStays) {
  auto engine = SessionEngine::create(block()).value();
  Stroke stroke(hand(0), into_mm);
  for (const mechanics::CutStrip& strip : advances(stroke, 0.5, true)) engine.step(AdvanceCut{strip});
  const SessionState before = engine.state();
  ASSERT_NE(before.cut, nullptr);
  // Another stroke across it.
  const auto across = geometry::CutSurface::swept({{20, 30, 40}, {20, 40, 40}, {20, 50, 40}}, {0, 0, -12}).value();
  const SessionState& refused = engine.step(AdvanceCut{{across, {20, 30, 40}, {20, 50, 40}}});
  EXPECT_THAT(refused.refused, HasSubstr("crosses an earlier one"));
  ASSERT_TRUE(refused.refusal);
  EXPECT_EQ(refused.refusal->code, "cuts-meet");
  EXPECT_EQ(refused.digest, before.digest);
  EXPECT_THAT(parse_recording(R"({"format": "glisson-session/1", "commands": [{"cut": {"points_mm": [[0, 0, 0], [1, 0,
                               0]], "into_mm": [1, 0, 0], "from_mm": [0, 0, 0], "to_mm": [1, 0, 0]}}]})")
                  .error()
                  .message(),
              HasSubstr("Places 1 and 2"));
}

}  // namespace
}  // namespace glisson::rehearsal
