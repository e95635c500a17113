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

TEST(MeshfreeSession, GoesBackAndReplaysToTheBit) {
  auto engine = SessionEngine::create(by_meshfree(meshfree_block(), {.nodes = 30})).value();
  Recording recording;
  const mechanics::CutStrip strip{
      geometry::CutSurface::plane({40.3, 0, 0}, {1, 0, 0}).value(), {40, 40, 45}, {40, 40, 25}};
  for (const SessionCommand& command : {SessionCommand(HoldTool{pushed_probe({35, 40, 60})}),
                                        SessionCommand(HoldTool{pushed_probe({45, 40, 60})}), SessionCommand(Undo{})}) {
    recording.emplace_back(command, engine.step(command).digest);
    EXPECT_EQ(engine.state().refused, "");
  }
  EXPECT_THAT(engine.step(AdvanceCut{strip}).refused, HasSubstr("nothing is cut in the hand"));
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
