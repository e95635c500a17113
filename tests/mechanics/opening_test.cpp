// A cut that opens step by step on the kept factor, against the body meshed with the cut.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "cut_bar.h"
#include "mechanics/contact/contact.h"
#include "mechanics/cutting/opened_surface.h"
#include "mechanics/cutting/opening.h"
#include "mechanics/statics/static_model.h"
#include "opened_bar.h"

namespace glisson::mechanics {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::at_corner;
using test::bar;
using test::cut_x_mm;
using test::displaced;
using test::loads;
using test::meshed_with_the_cut;
using test::MeshedCut;
using test::nothing_open;
using test::on_front_mm;
using test::size_mm;
using test::wall;
using test::youngs_kPa;

StaticModel model_of(geometry::TetMesh mesh, const std::vector<int>& wall_points = {}) {
  test::name_supports_of_bar(mesh);
  const std::size_t cells = mesh.cells.size();
  return StaticModel::create(std::move(mesh), std::vector<double>(cells, youngs_kPa), test::supports_of_bar(), {}, {},
                             wall_points)
      .value();
}

TEST(Opening, ACutInStepsMovesTheBarAsAMeshWithTheCutDoes) {
  const StaticModel whole = model_of(bar(20, 6, 9));
  const Vector3d uncut_mm = at_corner(whole.mesh(), whole.solve(loads)->displacement_mm);
  Opening opening = nothing_open(whole);
  for (const auto& [from_mm, to_mm] : {std::pair{40.0, 21.0}, {21.0, 15.0}}) {
    opening = opening.advanced({wall, on_front_mm(from_mm), on_front_mm(to_mm)}).value();
    const StaticModel reference = model_of(meshed_with_the_cut(20, 5, 40, to_mm).mesh);
    const Vector3d expected_mm = at_corner(reference.mesh(), reference.solve(loads)->displacement_mm);
    const Vector3d reached_mm = at_corner(whole.mesh(), displaced(whole, opening));
    EXPECT_GT((expected_mm - uncut_mm).norm(), 0.05 * expected_mm.norm());
    EXPECT_LT((reached_mm - expected_mm).norm(), 0.02 * expected_mm.norm())
        << "at " << to_mm << ": " << reached_mm.transpose() << " and " << expected_mm.transpose() << " uncut "
        << uncut_mm.transpose();
  }
}

// Along a sheet that somebody drew, which bulges by 5 mm over the bar's width of 24. The front within cells costs more
// than along a plane: 2.2 % of the end's way here (docs/decisions/first-pictures.md, where a cut ends).
TEST(Opening, ACurvedCutInStepsMovesTheBarAsAMeshWithTheCutDoes) {
  constexpr double bulge_mm = 5;
  const StaticModel whole = model_of(bar(20, 6, 9));
  const Vector3d uncut_mm = at_corner(whole.mesh(), whole.solve(loads)->displacement_mm);
  const geometry::CutSurface sheet = test::curved_wall(bulge_mm);
  Opening opening = nothing_open(whole);
  for (const auto& [from_mm, to_mm] : {std::pair{40.0, 21.0}, {21.0, 15.0}}) {
    opening = opening.advanced({sheet, {45, 12, from_mm}, {45, 12, to_mm}}).value();
    const StaticModel reference = model_of(meshed_with_the_cut(20, 5, 40, to_mm, bulge_mm).mesh);
    const Vector3d expected_mm = at_corner(reference.mesh(), reference.solve(loads)->displacement_mm);
    const Vector3d reached_mm = at_corner(whole.mesh(), displaced(whole, opening));
    EXPECT_GT((expected_mm - uncut_mm).norm(), 0.05 * expected_mm.norm());
    EXPECT_LT((reached_mm - expected_mm).norm(), 0.04 * expected_mm.norm())
        << "at " << to_mm << ": " << reached_mm.transpose() << " and " << expected_mm.transpose() << " uncut "
        << uncut_mm.transpose();
  }
}

TEST(Opening, IsTheSameHoweverManyAdvancesLedToIt) {
  const StaticModel whole = model_of(bar(10, 4, 5));
  const Opening at_once = nothing_open(whole).advanced({wall, on_front_mm(40), on_front_mm(18)}).value();
  Opening in_steps = nothing_open(whole);
  for (double z = 40; z > 18.5; z -= 5.5) {
    in_steps = in_steps.advanced({wall, on_front_mm(z), on_front_mm(z - 5.5)}).value();
  }
  ASSERT_EQ(at_once.points().size(), in_steps.points().size());
  const auto a_mm = displaced(whole, at_once), b_mm = displaced(whole, in_steps);
  for (std::size_t p = 0; p < a_mm.size(); ++p) EXPECT_LT((a_mm[p] - b_mm[p]).norm(), 1e-7);
}

TEST(Opening, WhatWasPreparedOpensToTheSameBitsAndIsNotSolvedAgain) {
  const StaticModel whole = model_of(bar(10, 4, 5));
  const Opening first = nothing_open(whole).advanced({wall, on_front_mm(40), on_front_mm(30)}).value();
  const CutStrip next{wall, on_front_mm(30), on_front_mm(20)};
  const Opening unprepared =
      nothing_open(whole).advanced({wall, on_front_mm(40), on_front_mm(30)})->advanced(next).value();
  int groups = 0;
  while (first.prepare(next).value()) ++groups;
  EXPECT_GT(groups, 0);
  const Opening prepared = first.advanced(next).value();
  EXPECT_EQ(prepared.amplitudes_mm(prepared.standing_load()), unprepared.amplitudes_mm(unprepared.standing_load()));
  EXPECT_FALSE(nothing_open(whole).prepare(next).value());
}

// Undo is the value before.
TEST(Opening, AnAdvanceLeavesTheOneBeforeAsItWas) {
  const StaticModel whole = model_of(bar(10, 4, 5));
  const Opening before = nothing_open(whole).advanced({wall, on_front_mm(40), on_front_mm(30)}).value();
  const VectorXd jumps_mm = before.amplitudes_mm(before.standing_load());
  ASSERT_TRUE(before.advanced({wall, on_front_mm(30), on_front_mm(20)}));
  EXPECT_EQ(before.amplitudes_mm(before.standing_load()), jumps_mm);
}

// What the jumps push on the nodes with displaces the whole body as the cut one.
TEST(Opening, ItsForcesOnTheNodesDisplaceTheWholeBodyAlike) {
  const StaticModel whole = model_of(bar(10, 4, 5));
  const Opening opening = nothing_open(whole).advanced({wall, on_front_mm(40), on_front_mm(18)}).value();
  const VectorXd jumps_mm = opening.amplitudes_mm(opening.standing_load());
  const auto alike = whole.solve_nodal({opening.force_on_nodes_mN(jumps_mm), {}}).value();
  const VectorXd seen_mm = opening.seen_mm(jumps_mm);
  for (std::size_t p = 0; p < alike.displacement_mm.size(); ++p) {
    EXPECT_LT((alike.displacement_mm[p] - seen_mm.segment<3>(3 * static_cast<Eigen::Index>(p))).norm(), 1e-6);
  }
}

TEST(Opening, RefusesWhatItCannotOpen) {
  const StaticModel whole = model_of(bar(10, 4, 5));
  const Opening none = nothing_open(whole);
  EXPECT_EQ(none.advanced({wall, on_front_mm(40), on_front_mm(40)}).error().code, "cut-invalid");
  EXPECT_EQ(none.advanced({wall, on_front_mm(60), on_front_mm(50)}).error().code, "cut-misses");
  const Opening half = none.advanced({wall, on_front_mm(40), on_front_mm(20)}).value();
  EXPECT_EQ(half.advanced({wall, on_front_mm(40), on_front_mm(25)}).error().code, "cut-misses");
  const auto across = geometry::CutSurface::plane({0, 12, 0}, {0, 1, 0}).value();
  EXPECT_EQ(half.advanced({across, {0, 12, 40}, {0, 12, 20}}).error().code, "cuts-meet");
}

// The springs of the bed end at x = 60 mm: beyond that nothing holds the free end.
TEST(Opening, RefusesToSeparateWhatNothingHolds) {
  const StaticModel whole = model_of(bar(10, 4, 5));
  const auto behind = geometry::CutSurface::plane({66.1, 0, 0}, {1, 0, 0}).value();
  const Opening most = nothing_open(whole).advanced({behind, {66.1, 0, 40}, {66.1, 0, 8}}).value();
  EXPECT_EQ(most.advanced({behind, {66.1, 0, 8}, {66.1, 0, 0}}).error().code, "cut-frees-part");
}

Vector3d corner_of(const ContactBody& body, const ContactState& state) {
  return at_corner({body.surface().points_mm, {}, {}, {}}, state.surface_mm);
}

// Jaws at the cut's edge draw the free part away. Ten times as far as without the cut: all of it is the cut's. Which
// faces they grip is not quite the same on both meshes.
TEST(OpeningInContact, UnderTractionThePartsOpenAsOnAMeshWithTheCut) {
  const ContactTool jaws{"jaws", Grasp{{cut_x_mm(40) + 8, 12, 40}, 7, 400.0, {1, 0, 0.5}}};
  const auto whole = ContactBody::create(model_of(bar(16, 6, 9)), {}, {}).value();
  const auto cut = whole.opened({wall, on_front_mm(40), on_front_mm(15)}).value();
  const auto reference = ContactBody::create(model_of(meshed_with_the_cut(16, 5, 40, 15).mesh), {}, {}).value();
  const auto reached = cut.solve(cut.untouched(), {jaws}).value();
  ASSERT_TRUE(reached.report.converged);
  EXPECT_LT(reached.report.overlap_mm, 0.001);
  const Vector3d u_mm = corner_of(cut, reached);
  const Vector3d expected_mm = corner_of(reference, reference.solve(reference.untouched(), {jaws}).value());
  EXPECT_LT((u_mm - expected_mm).norm(), 0.1 * expected_mm.norm())
      << u_mm.transpose() << " " << expected_mm.transpose();

  // The whole of it by one more solve, and the way back.
  const auto everywhere = cut.whole_result(reached).value();
  const auto places = geometry::find_field(cut.surface().point_fields, "mesh_point")->values;
  for (std::size_t p = 0; p < places.size(); ++p) {
    EXPECT_LT((everywhere.displacement_mm[static_cast<std::size_t>(places[p])] - reached.surface_mm[p]).norm(), 1e-5);
  }
  const auto again = whole.solve(whole.untouched(), {jaws}).value();
  EXPECT_LT(corner_of(whole, again).norm(), 0.15 * expected_mm.norm());
}

// Drawn, the parts have the volume that the cells have, each open one by both of its sides.
TEST(OpeningInContact, TheSurfaceIsDividedAtTheCutAndClosedByItsWalls) {
  const auto whole = ContactBody::create(model_of(bar(10, 4, 5)), loads, {}).value();
  const auto cut = whole.opened({wall, on_front_mm(40), on_front_mm(17)}).value();
  const geometry::Surface drawn = cut.opened_surface(cut.untouched()).value();
  ASSERT_TRUE(geometry::check_surface(drawn));
  const auto& on_wall = geometry::find_field(drawn.cell_fields, "wall")->values;
  ASSERT_EQ(on_wall.size(), drawn.triangles.size());
  // At rest, with jumps that are put on: what is above moves away by 5 mm in one piece where all of it is open.
  const StaticModel& model = whole.model();
  const Opening opening = nothing_open(model).advanced({wall, on_front_mm(40), on_front_mm(17)}).value();
  const std::vector<Vector3d> still(model.mesh().points_mm.size(), Vector3d::Zero());
  const std::vector<Vector3d> jumps_mm(opening.points().size(), 5.0 * wall.normal());
  const geometry::Surface apart = opened_surface(model.mesh(), whole.surface(), opening.cells(), still, jumps_mm);
  double largest_mm = 0, walls_mm2 = 0;
  for (std::size_t p = whole.surface().points_mm.size(); p < apart.points_mm.size(); ++p) {
    largest_mm = std::max(largest_mm, std::abs(wall.height_mm(apart.points_mm[p])));
  }
  EXPECT_NEAR(largest_mm, 5.0, 0.2);  // points are taken off the cut by up to a hundredth of an edge
  const geometry::Surface together = opened_surface(model.mesh(), whole.surface(), opening.cells(), still,
                                                    std::vector(jumps_mm.size(), Vector3d(0, 0, 0)));
  EXPECT_NEAR(geometry::volume_mm3(together), geometry::volume_mm3(whole.surface()), 1e-3);
  for (std::size_t t = 0; t < together.triangles.size(); ++t) {
    if (on_wall[t] == 0) continue;
    const auto& [a, b, c] = together.triangles[t];
    const auto& points = together.points_mm;
    walls_mm2 += 0.5 * (points[b] - points[a]).cross(points[c] - points[a]).norm();
  }
  EXPECT_GE(0.5 * walls_mm2, opening.open_mm2() - 1e-6);
  EXPECT_NEAR(opening.open_mm2() + opening.whole_mm2(), 24 * 40 * std::sqrt(1.09), 1.0);
  EXPECT_NEAR(opening.open_mm2(), 24 * 23 * std::sqrt(1.09), 24 * 2);
}

// Pressed together the walls slide and carry pressure: against the mesh with the cut, whose points are paired as they
// were one, which holds while they slide by little. Without contact its end would go six times as far.
TEST(OpeningInContact, PressedTogetherTheWallsDoNotPassThroughEachOther) {
  const Loads push{ToolLoad{{cut_x_mm(40) + 8, 12, 40}, 7, {-400, 0, 0}}};
  const MeshedCut with_cut = meshed_with_the_cut(16, 5, 24, 15);
  const StaticModel reference = model_of(with_cut.mesh, with_cut.wall_points);
  const std::vector<Vector3d> free_mm = reference.solve(push)->displacement_mm;
  const auto pairs = static_cast<Eigen::Index>(with_cut.wall_points.size() / 2);
  MatrixXd apart = MatrixXd::Zero(6 * pairs, pairs);
  VectorXd gap_mm(pairs);
  for (Eigen::Index i = 0; i < pairs; ++i) {
    apart.block<3, 1>(6 * i, i) = -wall.normal();
    apart.block<3, 1>(6 * i + 3, i) = wall.normal();
    const auto k = static_cast<std::size_t>(2 * i);
    gap_mm[i] = wall.normal().dot(free_mm[with_cut.wall_points[k + 1]] - free_mm[with_cut.wall_points[k]]);
  }
  const MatrixXd compliance = apart.transpose() * reference.mutual_compliance() * apart;
  const VectorXd force_mN = -compliance.ldlt().solve(gap_mm);
  ASSERT_GT(force_mN.minCoeff(), 0.0);  // all of them press
  const VectorXd on_walls_mN = apart * force_mN;
  VectorXd on_nodes_mN = VectorXd::Zero(3 * static_cast<Eigen::Index>(reference.nodes().nodes()));
  for (std::size_t i = 0; i < with_cut.wall_points.size(); ++i) {
    on_nodes_mN.segment<3>(3 * reference.nodes().node_of_point[with_cut.wall_points[i]]) +=
        on_walls_mN.segment<3>(3 * static_cast<Eigen::Index>(i));
  }
  const Vector3d expected_mm = at_corner(reference.mesh(), free_mm) +
                               at_corner(reference.mesh(), reference.solve_nodal({on_nodes_mN, {}})->displacement_mm);

  const auto whole = ContactBody::create(model_of(bar(20, 6, 9)), push, {}).value();
  const auto cut = whole.opened({wall, on_front_mm(40), on_front_mm(15)}).value();
  EXPECT_TRUE(cut.untouched().report.converged);
  EXPECT_LT(cut.untouched().report.overlap_mm, 0.1);
  EXPECT_GT(cut.untouched().wall_mN.size(), cut.opening()->points().size() / 2);
  const Vector3d u_mm = corner_of(cut, cut.untouched());
  EXPECT_LT((u_mm - expected_mm).norm(), 0.1 * expected_mm.norm())
      << u_mm.transpose() << " " << expected_mm.transpose();
  EXPECT_GT(at_corner(reference.mesh(), free_mm).norm(), 4.0 * expected_mm.norm());
}

}  // namespace
}  // namespace glisson::mechanics
