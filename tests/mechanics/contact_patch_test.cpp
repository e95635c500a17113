// A flat tool pressed evenly on a block: every engine of large strain must find the same pressure everywhere, on faces
// of any size and shape.

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

#include "mechanics/bodies.h"
#include "mechanics/contact/large_contact.h"
#include "mechanics/contact/live_body.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// 30 x 30 x 15 mm, crooked within, in a smooth box: pressed evenly from above, each of its planes stays plane.
class BoxedBlock : public testing::Test {
 protected:
  static constexpr double side_mm = 30, height_mm = 15, depth_mm = 1, youngs_kPa = 10;

  BoxedBlock()
      : mesh_(test::bent_box(4, 4, 2, [](const Vector3d& unit) {
          const Vector3d wave = 0.05 * (2 * std::numbers::pi * unit).array().sin();
          return Vector3d(side_mm * (unit.x() + wave.x() * std::sin(3 * unit.y())),
                          side_mm * (unit.y() + wave.y() * std::cos(2 * unit.x())), height_mm * unit.z());
        })) {
    test::disturb_inner_points(mesh_, 0.8);
    test::name_points(mesh_, "ground", [](const Vector3d& p) { return p.z() < 1e-9; });
    test::name_points(mesh_, "along x", [](const Vector3d& p) { return p.x() < 1e-9 || p.x() > side_mm - 1e-9; });
    test::name_points(mesh_, "along y", [](const Vector3d& p) { return p.y() < 1e-9 || p.y() > side_mm - 1e-9; });
    supports_ = {test::held_along("ground", false, false, true), test::held_along("along x", true, false, false),
                 test::held_along("along y", false, true, false)};
    options_.poisson_ratio = 0.45;
  }
  // So wide a ball is flat: over the block it falls off by 1e-4 mm.
  static std::vector<ContactTool> plate(double deep_mm) {
    constexpr double radius_mm = 2e6;
    return {
        {"plate", TouchingTool{palpation_probe(radius_mm),
                               pose_towards({side_mm / 2, side_mm / 2, height_mm + radius_mm - deep_mm}, {0, 0, -1}),
                               {}}}};
  }
  // Of all nodes, how far from where an even pressure would take it, as a part of the depth.
  static double unevenness(const NodeLayout& layout, const VectorXd& u_mm) {
    double farthest_mm = 0;
    for (int n = 0; n < layout.nodes(); ++n) {
      const Vector3d even_mm(0, 0, -depth_mm * layout.positions_mm[n].z() / height_mm);
      farthest_mm = std::max(farthest_mm, (u_mm.segment<3>(3 * n) - even_mm).norm());
    }
    return farthest_mm / depth_mm;
  }

  geometry::TetMesh mesh_;
  std::vector<Support> supports_;
  StaticOptions options_;
};

TEST_F(BoxedBlock, IsPressedEvenlyAtLargeStrainByFactorsAndInTheHand) {
  const Body body =
      prepare_body(mesh_, test::uniform(mesh_, youngs_kPa), supports_, options_, Holding::required).value();
  ContactOptions tight;
  tight.penetration_tolerance_mm = 1e-3;
  LiveOptions patient;
  patient.penetration_tolerance_mm = 5e-3;
  for (const ChosenLaw& law : {ChosenLaw(MaterialLaw::neo_hookean), ChosenLaw(MaterialLaw::veronda_westmann, 3)}) {
    const AppliedLoads nothing{VectorXd::Zero(3 * body.layout.nodes()), 0};
    const auto slow = find_equilibrium_in_contact(body, materials_of(body, law.law, law.strain_stiffening), nothing,
                                                  {plate(depth_mm / 2), plate(depth_mm)}, tight)
                          .value();
    ASSERT_TRUE(slow.result.may_be_used()) << slow.result.why_stopped;
    EXPECT_LT(unevenness(body.layout, nodal_displacements(body.layout, slow.result)), 2e-3);

    auto model = StaticModel::create(mesh_, test::uniform(mesh_, youngs_kPa), supports_, options_).value();
    const auto places = locate_points(mesh_, {{15, 15, 12}});
    const LiveBody live = LiveBody::create(std::move(model), law, supports_, {}, places, 1).value();
    LiveState state = live.step(live.untouched(), plate(depth_mm / 2)).value();
    state = live.settle(live.step(state, plate(depth_mm)).value(), plate(depth_mm), patient).value();
    ASSERT_TRUE(state.settled) << state.report.relative_residual << " and " << state.report.penetration_mm << " mm";
    EXPECT_LT(unevenness(body.layout, state.u_mm), 1e-2);
    EXPECT_NEAR(state.tools[0].force_mN.z() / slow.tools[0].force_mN.z(), 1, 1e-2);
  }
}

// The engine of small strain presses on corners, which bear nothing of an even pressure in truth.
TEST_F(BoxedBlock, PressedOnTheCornersOfItsFacesItGivesWayUnevenly) {
  auto model = StaticModel::create(mesh_, test::uniform(mesh_, youngs_kPa), supports_, options_).value();
  const NodeLayout layout = model.nodes();
  const auto body = ContactBody::create(std::move(model), {}, {}).value();
  const auto state = body.solve(body.untouched(), plate(depth_mm)).value();
  ASSERT_TRUE(state.report.converged);
  EXPECT_GT(unevenness(layout, nodal_displacements(layout, body.whole_result(state).value())), 0.05);
}

}  // namespace
}  // namespace glisson::mechanics
