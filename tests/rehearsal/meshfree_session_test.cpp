// A session by the meshfree engine: finite elements stand beside it under the same tools, and every state says how far
// they are apart.

#include <gmock/gmock.h>

#include "mechanics/bodies.h"
#include "rehearsal/session.h"
#include "rehearsal/tool_presets.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::ContactTool;
using testing::HasSubstr;

RehearsalSetup meshfree_block() {
  RehearsalSetup setup;
  setup.mesh = mechanics::test::box(8, 8, 4, {80, 80, 40});
  mechanics::test::name_points(setup.mesh, "ground", [](const Vector3d& p) { return p.z() == 0; });
  for (std::size_t c = 0; c < setup.mesh.cells.size(); ++c) {
    setup.patient_youngs_kPa.push_back(geometry::cell_centroid_mm(setup.mesh, c).x() < 40 ? 4 : 12);
  }
  setup.reference_youngs_kPa = 6;
  setup.supports = {mechanics::test::fixed("ground")};
  setup.landmarks = {{"tumour-1", {35, 40, 34}}, {"tumour-2", {70, 70, 20}}};
  return setup;
}

ContactTool pushed_probe(const Vector3d& center_mm) {
  return {"probe", mechanics::TouchingTool{mechanics::palpation_probe(8),
                                           mechanics::pose_towards(center_mm, {0, 0, -1}), 300.0}};
}

TEST(MeshfreeSession, SaysHowFarFiniteElementsAreApartUnderTheSameTools) {
  auto by_elements = SessionEngine::create(meshfree_block()).value();
  auto meshfree = SessionEngine::create(by_meshfree(meshfree_block(), {.nodes = 40})).value();
  ASSERT_TRUE(meshfree.state().beside_elements.has_value());
  EXPECT_LT(meshfree.state().beside_elements->surface_mm, 1e-9);
  EXPECT_FALSE(by_elements.state().beside_elements.has_value());
  for (const double x : {35.0, 38.0, 41.0}) {
    const SessionState& exact = by_elements.step(HoldTool{pushed_probe({x, 40, 60})});
    const SessionState& state = meshfree.step(HoldTool{pushed_probe({x, 40, 60})});
    EXPECT_EQ(state.refused, "");
    double landmarks_mm = 0, surface_mm = 0;
    for (std::size_t l = 0; l < 2; ++l) {
      landmarks_mm = std::max(
          landmarks_mm, (state.patient.landmarks[l].displaced_mm - exact.patient.landmarks[l].displaced_mm).norm());
    }
    for (std::size_t p = 0; p < state.patient.surface_mm.size(); ++p) {
      surface_mm = std::max(surface_mm, (state.patient.surface_mm[p] - exact.patient.surface_mm[p]).norm());
    }
    ASSERT_TRUE(state.beside_elements.has_value());
    EXPECT_NEAR(state.beside_elements->landmarks_mm, landmarks_mm, 1e-9);
    EXPECT_NEAR(state.beside_elements->surface_mm, surface_mm, 1e-9);
    EXPECT_GT(state.beside_elements->landmarks_mm, 0.01);  // 40 nodes miss something
    EXPECT_GT(state.beside_elements->meshfree_ms, 0);
    EXPECT_GT(state.beside_elements->elements_ms, 0);
    ASSERT_TRUE(state.reference.has_value());  // which is meshfree too
    EXPECT_GT(state.max_difference_mm, 0.1);
  }
}

mechanics::CutStrip strip(double from_z_mm, double to_z_mm) {
  return {geometry::CutSurface::plane({40.3, 0, 0}, {1, 0, 0}).value(), {40, 40, from_z_mm}, {40, 40, to_z_mm}};
}

TEST(MeshfreeSession, IsCutAsFiniteElementsBesideItAndEveryAdvanceIsTakenBack) {
  auto engine = SessionEngine::create(by_meshfree(meshfree_block(), {.nodes = 60})).value();
  Recording recording;
  std::vector<std::string> digests;
  const auto step = [&](const SessionCommand& command) -> const SessionState& {
    const SessionState& state = engine.step(command);
    EXPECT_EQ(state.refused, "");
    recording.emplace_back(command, state.digest);
    digests.push_back(state.digest);
    return state;
  };
  const ContactTool jaws{"jaws", mechanics::Grasp{{60, 40, 40}, 9, 300.0, {1, 0, 1}}};
  EXPECT_EQ(step(HoldTool{jaws}).cut, nullptr);
  double before_mm = 0;
  for (const double z : {40.0, 32.0, 24.0}) {
    const SessionState& state = step(AdvanceCut{strip(z, z - 8)});
    ASSERT_NE(state.cut, nullptr);
    EXPECT_GT(state.cut->largest_opening_mm, before_mm);
    before_mm = state.cut->largest_opening_mm;
    ASSERT_TRUE(state.beside_elements && state.beside_elements->largest_opening_mm);
    // Of one size; how right it is, meshfree_opening_test says.
    EXPECT_LT(before_mm, 2.0 * *state.beside_elements->largest_opening_mm);
    EXPECT_GT(before_mm, 0.5 * *state.beside_elements->largest_opening_mm);
    EXPECT_TRUE(geometry::check_surface(state.cut->patient));
  }
  for (std::size_t k = 0; k < 3; ++k) step(Undo{});
  EXPECT_EQ(digests[4], digests[2]);
  EXPECT_EQ(digests[5], digests[1]);
  EXPECT_EQ(digests[6], digests[0]);
  EXPECT_EQ(engine.state().cut, nullptr);
  step(AdvanceCut{strip(40, 32)});
  EXPECT_EQ(digests[7], digests[1]);
  EXPECT_THAT(engine.step(AdvanceCut{strip(40, 36)}).refused, HasSubstr("opens nothing"));
  auto again = SessionEngine::create(by_meshfree(meshfree_block(), {.nodes = 60})).value();
  EXPECT_FALSE(replay(again, recording).has_value());
}

TEST(MeshfreeSession, GoesBackAndReplaysToTheBit) {
  auto engine = SessionEngine::create(by_meshfree(meshfree_block(), {.nodes = 30})).value();
  Recording recording;
  for (const SessionCommand& command : {SessionCommand(HoldTool{pushed_probe({35, 40, 60})}),
                                        SessionCommand(HoldTool{pushed_probe({45, 40, 60})}), SessionCommand(Undo{})}) {
    recording.emplace_back(command, engine.step(command).digest);
    EXPECT_EQ(engine.state().refused, "");
  }
  EXPECT_EQ(recording.front().second, recording.back().second);
  EXPECT_NE(recording[0].second, recording[1].second);
  auto again = SessionEngine::create(by_meshfree(meshfree_block(), {.nodes = 30})).value();
  EXPECT_FALSE(replay(again, recording).has_value());
}

TEST(MeshfreeSession, AtLargeStrainIsRefusedBeforeAnythingIsPrepared) {
  RehearsalSetup setup = by_meshfree(meshfree_block(), {});
  setup.law = mechanics::MaterialLaw::neo_hookean;
  const auto refused = SessionEngine::create(setup);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "not-available");
  EXPECT_THAT(refused.error().message(), HasSubstr("linear, isotropic"));
}

}  // namespace
}  // namespace glisson::rehearsal
