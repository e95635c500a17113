// Orders of steps: what each asks of the liver is what its states say, and the strain of walls is that of closed forms.

#include "rehearsal/orders.h"

#include <gmock/gmock.h>
#include <cmath>
#include <Eigen/Geometry>

#include "base/json_reading.h"
#include "mechanics/bodies.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::TouchingTool;

// A tube along x, of radius 4 mm.
geometry::Surface tube() {
  geometry::Surface surface;
  constexpr int around = 24, along = 10;
  for (int i = 0; i <= along; ++i) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * M_PI * k / around;
      surface.points_mm.emplace_back(30 + 2.0 * i, 40 + 4 * std::cos(angle), 20 + 4 * std::sin(angle));
    }
  }
  for (int i = 0; i < along; ++i) {
    for (int k = 0; k < around; ++k) {
      const int a = i * around + k, b = i * around + (k + 1) % around;
      surface.triangles.push_back({a, b, a + around});
      surface.triangles.push_back({b, b + around, a + around});
    }
  }
  return surface;
}

std::vector<Vector3d> moved(const geometry::Surface& surface, const Eigen::Affine3d& motion) {
  std::vector<Vector3d> points_mm;
  for (const Vector3d& point : surface.points_mm) points_mm.emplace_back(motion * point);
  return points_mm;
}

TEST(WallStrain, IsThatOfTheStretchWhereverTheWallIsTurned) {
  const geometry::Surface vessel = tube();
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Vector3d(1, 2, -1).normalized())).translate(Vector3d(5, -9, 30));
  EXPECT_NEAR(wall_strain(vessel, moved(vessel, motion)), 0, 1e-12);
  motion.scale(Vector3d(1.12, 1, 1));  // along the tube
  EXPECT_NEAR(wall_strain(vessel, moved(vessel, motion)), 0.12, 1e-9);
  geometry::Surface flat = vessel;
  for (Vector3d& point : flat.points_mm) point = Vector3d(1, 2, 3);
  EXPECT_EQ(wall_strain(flat, vessel.points_mm), 0);
}

class Ordering : public testing::Test {
 protected:
  Ordering() {
    setup.mesh = mechanics::test::box(6, 6, 3, {80, 80, 40});
    mechanics::test::name_points(setup.mesh, "ground", [](const Vector3d& p) { return p.z() == 0; });
    setup.patient_youngs_kPa.assign(setup.mesh.cells.size(), 5.0);
    setup.supports = {mechanics::test::fixed("ground")};
    setup.landmarks = {{"tumour-1", {35, 40, 34}}, {"tumour-2", {70, 70, 20}}};
    setup.structures = {tube()};
  }
  static SessionCommand pushed(double force_mN) {
    return HoldTool{{"probe", TouchingTool{mechanics::palpation_probe(8),
                                           mechanics::pose_towards({35, 40, 60}, {0, 0, -1}), force_mN}}};
  }
  RehearsalSetup setup;
};

TEST_F(Ordering, TakesFromEachStateWhatItSays) {
  const Recording recording{{pushed(200), ""}, {pushed(400), ""}, {Undo{}, ""}, {ReleaseTool{"nothing such"}, ""}};
  const OrderOfSteps order = run_order(setup, {0}, "push", recording).value();
  auto engine = SessionEngine::create(setup).value();
  std::vector<SessionState> states;
  for (const auto& [command, digest] : recording) states.push_back(engine.step(command));

  EXPECT_EQ(order.name, "push");
  ASSERT_EQ(order.force_N.size(), 4U);
  EXPECT_EQ(order.largest_force_N.value, 1e-3 * states[1].patient_step.tools[0].force_mN.norm());
  EXPECT_NEAR(order.largest_force_N.value, 0.4, 0.02);  // along the push, and what the skin pulls sideways
  EXPECT_EQ(order.largest_force_N.step, 2U);
  EXPECT_EQ(order.largest_strain.value, states[1].validity.largest_strain);
  ASSERT_EQ(order.landmarks.size(), 2U);
  EXPECT_EQ(order.landmarks[0].largest_mm.value, states[1].patient.landmarks[0].displacement_mm);
  EXPECT_EQ(order.landmarks[0].largest_mm.step, 2U);
  EXPECT_EQ(order.landmarks[0].end_mm, states[0].patient.landmarks[0].displacement_mm);  // undone
  ASSERT_TRUE(order.vessel_strain.has_value());
  EXPECT_EQ(order.vessel_strain->value, wall_strain(setup.structures[0], states[1].patient.structures_mm[0]));
  EXPECT_GT(order.vessel_strain->value, 0.01);
  EXPECT_EQ(order.refused, std::vector<std::size_t>{4});
  EXPECT_TRUE(order.unusable.empty());
}

TEST_F(Ordering, AreReadBackAsTheyWereWritten) {
  const Recording recording{{pushed(200), ""}, {ReleaseTool{"nothing such"}, ""}, {pushed(1e5), ""}};
  const OrderOfSteps order = run_order(setup, {0}, "push", recording).value();
  const Json written = json_of(order);
  const auto read = reading("orders-invalid", {}, [&] { return order_from(written, "order 1"); });
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(json_of(*read), written);
  EXPECT_EQ(read->largest_force_N.step, order.largest_force_N.step);
  EXPECT_EQ(read->refused, order.refused);

  for (const char* key : {"name", "landmarks", "largest_force_N", "vessel_strain_at_step", "open_mm2", "forces_N"}) {
    for (const Json& wrong : {Json("x"), Json(-1), Json{{"a", 1}}}) {
      Json broken = written;
      broken[key] = wrong;
      if (json_of(order)[key] == wrong || (std::string(key) == "name" && wrong.is_string())) continue;
      if (std::string(key) == "largest_force_N" && wrong.is_number()) continue;  // any number may stand there
      const auto refused = reading("orders-invalid", {}, [&] { return order_from(broken, "order 1"); });
      ASSERT_FALSE(refused.has_value()) << key << " " << wrong;
      EXPECT_THAT(refused.error().message(), testing::HasSubstr("order 1")) << key;
    }
  }
}

TEST_F(Ordering, AStepThatIsNoNumberIsRefused) {
  const Json written = json_of(run_order(setup, {}, "push", {{pushed(200), ""}}).value());
  for (const Json& wrong : {Json(), Json(0), Json("1")}) {
    Json broken = written;
    broken["refused"] = Json::array({wrong});
    EXPECT_FALSE(reading("orders-invalid", {}, [&] { return order_from(broken, "order 1"); }).has_value()) << wrong;
  }
}

TEST_F(Ordering, TakesNoFigureFromAStateThatMayNotBeUsed) {
  const Recording recording{{pushed(100), ""}, {pushed(1e5), ""}};
  const OrderOfSteps order = run_order(setup, {}, "far too much", recording).value();
  EXPECT_FALSE(order.vessel_strain.has_value());
  // Either it was refused, and the state before stands, or its cells are inside out.
  EXPECT_EQ(order.refused.size() + order.unusable.size(), 1U);
  EXPECT_EQ(order.largest_force_N.step, 1U);
  EXPECT_NEAR(order.largest_force_N.value, 0.1, 1e-3);
}

}  // namespace
}  // namespace glisson::rehearsal
