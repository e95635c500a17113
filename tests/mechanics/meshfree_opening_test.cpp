// A cut that opens step by step through a meshfree body, against finite elements meshed with the cut.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "cut_bar.h"
#include "mechanics/contact/contact.h"
#include "mechanics/cutting/opening.h"
#include "mechanics/meshfree/meshfree_model.h"
#include "mechanics/statics/static_model.h"
#include "opened_bar.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using test::at_corner;
using test::bar;
using test::displaced;
using test::loads;
using test::meshed_with_the_cut;
using test::nothing_open;
using test::on_front_mm;
using test::wall;
using test::youngs_kPa;

StaticModel by_elements(geometry::TetMesh mesh) {
  test::name_supports_of_bar(mesh);
  const std::size_t cells = mesh.cells.size();
  return StaticModel::create(std::move(mesh), std::vector<double>(cells, youngs_kPa), test::supports_of_bar()).value();
}

StaticModel meshfree(geometry::TetMesh mesh, int nodes) {
  test::name_supports_of_bar(mesh);
  const std::vector<double> moduli(mesh.cells.size(), youngs_kPa);
  return MeshfreeModel::create(mesh, moduli, test::supports_of_bar(), MaterialLaw::linear, {}, {.nodes = nodes})
      ->static_model()
      .value();
}

Vector3d corner_of(const StaticModel& model, const Opening& opening) {
  return at_corner(model.mesh(), displaced(model, opening));
}

// Nodes whose shapes are a subset of the finite elements' are stiffer, the fewer the more: 8 and 5 % of the uncut bar.
// The bridges' stiffness is that of finite elements, chosen on another block.
TEST(MeshfreeOpening, ACutInStepsMovesTheBarAsFiniteElementsMeshedWithTheCut) {
  const std::vector<double> fronts_mm{21.0, 15.0};
  std::vector<Vector3d> expected_mm;
  for (const double front_mm : fronts_mm) {
    const StaticModel reference = by_elements(meshed_with_the_cut(20, 5, 40, front_mm).mesh);
    expected_mm.push_back(at_corner(reference.mesh(), reference.solve(loads)->displacement_mm));
  }
  for (const auto& [nodes, share] : {std::pair{100, 0.12}, {250, 0.06}}) {
    const StaticModel model = meshfree(bar(20, 6, 9), nodes);
    const Vector3d uncut_mm = at_corner(model.mesh(), model.solve(loads)->displacement_mm);
    Opening opening = nothing_open(model);
    double from_mm = 40;
    for (std::size_t k = 0; k < fronts_mm.size(); ++k) {
      opening = opening.advanced({wall, on_front_mm(from_mm), on_front_mm(fronts_mm[k])}).value();
      from_mm = fronts_mm[k];
      const Vector3d reached_mm = corner_of(model, opening);
      EXPECT_GT((expected_mm[k] - uncut_mm).norm(), 0.5 * expected_mm[k].norm());
      EXPECT_LT((reached_mm - expected_mm[k]).norm(), share * expected_mm[k].norm())
          << nodes << " nodes at " << from_mm << ": " << reached_mm.transpose() << " and "
          << expected_mm[k].transpose();
    }
  }
}

TEST(MeshfreeOpening, IsTheSameHoweverManyAdvancesLedToIt) {
  const StaticModel model = meshfree(bar(10, 4, 5), 40);
  const Opening at_once = nothing_open(model).advanced({wall, on_front_mm(40), on_front_mm(18)}).value();
  Opening in_steps = nothing_open(model);
  for (double z = 40; z > 18.5; z -= 5.5) {
    in_steps = in_steps.advanced({wall, on_front_mm(z), on_front_mm(z - 5.5)}).value();
  }
  ASSERT_EQ(at_once.points().size(), in_steps.points().size());
  const auto a_mm = displaced(model, at_once), b_mm = displaced(model, in_steps);
  for (std::size_t p = 0; p < a_mm.size(); ++p) EXPECT_LT((a_mm[p] - b_mm[p]).norm(), 1e-5);
}

// Both parts stand on the bed. What pushes on one is nothing to the other.
TEST(MeshfreeOpening, ACompleteCutLeavesNothingThatReachesAcross) {
  const StaticModel model = meshfree(bar(12, 4, 6), 60);
  const Opening apart = nothing_open(model).advanced({wall, on_front_mm(40), on_front_mm(-1)}).value();
  EXPECT_LT(apart.whole_mm2(), 1e-9);
  const auto corner = 3 * [&] {
    Eigen::Index p = 0;
    while ((model.mesh().points_mm[static_cast<std::size_t>(p)] - test::size_mm).norm() > 1e-6) ++p;
    return p;
  }();
  // By a force on the corner beyond the cut, what the cut adds to what the whole body does.
  VectorXd on_corner = VectorXd::Zero(3 * static_cast<Eigen::Index>(model.nodes().nodes()));
  on_corner.segment<3>(3 * model.nodes().node_of_point[static_cast<std::size_t>(corner / 3)]) = Vector3d(0, 0, -260);
  const auto of_whole = model.solve_nodal({on_corner, {}}).value();
  const VectorXd by_cut_mm = apart.seen_mm(apart.amplitudes_mm(apart.load_of_force(corner, {0, 0, -260})));
  double clamped_side_mm = 0, other_side_mm = 0, whole_mm = 0;
  for (std::size_t p = 0; p < of_whole.displacement_mm.size(); ++p) {
    const double moved_mm =
        (of_whole.displacement_mm[p] + by_cut_mm.segment<3>(3 * static_cast<Eigen::Index>(p))).norm();
    const bool clamped_side = wall.height_mm(model.mesh().points_mm[p]) < 0;
    (clamped_side ? clamped_side_mm : other_side_mm) =
        std::max(clamped_side ? clamped_side_mm : other_side_mm, moved_mm);
    if (clamped_side) whole_mm = std::max(whole_mm, of_whole.displacement_mm[p].norm());
  }
  EXPECT_GT(whole_mm, 1e-3 * other_side_mm);
  EXPECT_LT(clamped_side_mm, 1e-5 * other_side_mm);
}

TEST(MeshfreeOpening, ItsForcesOnTheNodesAndItsOwnPartDisplaceTheWholeBodyAlike) {
  const StaticModel model = meshfree(bar(10, 4, 5), 40);
  const Opening opening = nothing_open(model).advanced({wall, on_front_mm(40), on_front_mm(18)}).value();
  const VectorXd amplitudes_mm = opening.amplitudes_mm(opening.standing_load());
  const auto alike = model.solve_nodal({opening.force_on_nodes_mN(amplitudes_mm), {}}).value();
  const VectorXd seen_mm = opening.seen_mm(amplitudes_mm), own_mm = opening.of_nodes_mm(amplitudes_mm);
  for (std::size_t p = 0; p < alike.displacement_mm.size(); ++p) {
    const Vector3d by_itself_mm = own_mm.segment<3>(3 * model.nodes().node_of_point[p]);
    EXPECT_LT((alike.displacement_mm[p] + by_itself_mm - seen_mm.segment<3>(3 * static_cast<Eigen::Index>(p))).norm(),
              1e-5);
  }
}

TEST(MeshfreeOpening, RefusesWhatItCannotOpen) {
  const StaticModel model = meshfree(bar(10, 4, 5), 40);
  const Opening half = nothing_open(model).advanced({wall, on_front_mm(40), on_front_mm(20)}).value();
  EXPECT_EQ(half.advanced({wall, on_front_mm(40), on_front_mm(25)}).error().code, "cut-misses");
  const auto across = geometry::CutSurface::plane({0, 12, 0}, {0, 1, 0}).value();
  EXPECT_EQ(half.advanced({across, {0, 12, 40}, {0, 12, 20}}).error().code, "cuts-meet");
  // The springs of the bed end at x = 60 mm: beyond that nothing holds the free end.
  const auto behind = geometry::CutSurface::plane({66.1, 0, 0}, {1, 0, 0}).value();
  const Opening most = nothing_open(model).advanced({behind, {66.1, 0, 40}, {66.1, 0, 8}}).value();
  EXPECT_EQ(most.advanced({behind, {66.1, 0, 8}, {66.1, 0, -1}}).error().code, "cut-frees-part");
}

// These loads press the walls together at the top.
TEST(MeshfreeOpening, WallsDoNotPassThroughEachOtherAndTheWholeResultIsTheSame) {
  const auto whole =
      ContactBody::create(meshfree(bar(10, 4, 5), 60), loads, {{0, {0.25, 0.25, 0.25, 0.25}, 0}}).value();
  const auto cut = whole.opened({wall, on_front_mm(40), on_front_mm(15)}).value();
  const ContactState& state = cut.untouched();
  EXPECT_TRUE(state.report.converged);
  EXPECT_LT(state.report.overlap_mm, 0.1);
  EXPECT_FALSE(state.wall_mN.empty());
  const auto everywhere = cut.whole_result(state).value();
  const auto places = geometry::find_field(cut.surface().point_fields, "mesh_point")->values;
  for (std::size_t p = 0; p < places.size(); ++p) {
    EXPECT_LT((everywhere.displacement_mm[static_cast<std::size_t>(places[p])] - state.surface_mm[p]).norm(), 1e-4);
  }
  EXPECT_LT(
      (cut.model().displacement_at(everywhere, {{0, {0.25, 0.25, 0.25, 0.25}, 0}})[0] - state.watched_mm[0]).norm(),
      1e-4);
}

}  // namespace
}  // namespace glisson::mechanics
