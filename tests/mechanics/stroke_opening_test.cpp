// A cut drawn by hand: a line that grows while it is cut along, against the plane and the sheet that were there
// beforehand, and against the bar meshed with the cut.

#include <gtest/gtest.h>

#include <algorithm>
#include <Eigen/Geometry>

#include "cut_bar.h"
#include "mechanics/contact/contact.h"
#include "mechanics/contact/live_body.h"
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
using test::cut_x_mm;
using test::displaced;
using test::loads;
using test::nothing_open;
using test::on_front_mm;
using test::wall;

StaticModel held_bar(geometry::TetMesh mesh) {
  test::name_supports_of_bar(mesh);
  const std::size_t cells = mesh.cells.size();
  return StaticModel::create(std::move(mesh), std::vector<double>(cells, test::youngs_kPa), test::supports_of_bar())
      .value();
}

// Over the bar's top from one side to the other, downwards along the oblique cut.
constexpr double top_mm = 40, front_mm = 21;
Vector3d down_to(double z_mm) { return {cut_x_mm(z_mm) - cut_x_mm(top_mm), 0, z_mm - top_mm}; }
std::vector<Vector3d> line_over(double until_y_mm, double bulge_mm = 0) {
  std::vector<Vector3d> line_mm;
  for (double y = -1; y < until_y_mm + 1e-9; y += 1) {
    const double within = std::clamp(y, 0.0, test::size_mm.y());
    line_mm.emplace_back(cut_x_mm(top_mm, within, bulge_mm), y, top_mm);
  }
  return line_mm;
}

// As a hand draws: each advance knows the line a little further than it cuts.
Opening drawn(const StaticModel& model, double bulge_mm, double ahead_mm = 4) {
  Opening opening = nothing_open(model);
  for (double y = -1; y < 25; y += 4) {
    const auto line = line_over(std::min(25.0, y + 4 + ahead_mm), bulge_mm);
    const auto surface = geometry::CutSurface::swept(line, down_to(front_mm)).value();
    const auto at = [&](double at_y_mm) {
      return line[std::min(line.size() - 1, std::size_t(std::lround(at_y_mm + 1)))];
    };
    auto next = opening.advanced({surface, at(y), at(y + 4)});
    if (!next) {
      ADD_FAILURE() << "at y " << y << ": " << next.error().message();
      return opening;
    }
    opening = std::move(*next);
  }
  return opening;
}

TEST(StrokeOpening, AStraightStrokeOpensWhatThePlaneCutTwoWaysDoes) {
  const StaticModel whole = held_bar(bar(20, 6, 9));
  const Opening plane = nothing_open(whole).advanced({wall, on_front_mm(top_mm), on_front_mm(front_mm)}).value();
  const Opening stroke = drawn(whole, 0);
  EXPECT_NEAR(stroke.open_mm2(), plane.open_mm2(), 1e-3 * plane.open_mm2());
  EXPECT_EQ(stroke.whole_mm2(), 0);
  EXPECT_EQ(stroke.points().size(), plane.points().size());
  // The same walls by other sums: that of which places lie behind the front differs at its edge alone.
  const Vector3d expected_mm = at_corner(whole.mesh(), displaced(whole, plane));
  const Vector3d reached_mm = at_corner(whole.mesh(), displaced(whole, stroke));
  EXPECT_LT((reached_mm - expected_mm).norm(), 1e-3 * expected_mm.norm())
      << reached_mm.transpose() << " and " << expected_mm.transpose();
}

// It bulges by 5 mm over 24, at its sharpest with a radius of 12 mm on cells of 4: as the sheet through all of it does,
// within 1.5 % of the way, and as the bar meshed with the cut, within 5 % (the sheet: 4).
TEST(StrokeOpening, ACurvedStrokeOpensWhatTheSheetDrawnBeforehandDoes) {
  constexpr double bulge_mm = 5;
  const StaticModel whole = held_bar(bar(20, 6, 9));
  const Opening sheet =
      nothing_open(whole).advanced({test::curved_wall(bulge_mm), {45, 12, top_mm}, {45, 12, front_mm}}).value();
  const Opening stroke = drawn(whole, bulge_mm);
  EXPECT_NEAR(stroke.open_mm2(), sheet.open_mm2(), 0.05 * sheet.open_mm2());
  const Vector3d uncut_mm = at_corner(whole.mesh(), whole.solve(loads)->displacement_mm);
  const Vector3d by_sheet_mm = at_corner(whole.mesh(), displaced(whole, sheet));
  const Vector3d reached_mm = at_corner(whole.mesh(), displaced(whole, stroke));
  const StaticModel reference = held_bar(test::meshed_with_the_cut(20, 5, 40, front_mm, bulge_mm).mesh);
  const Vector3d expected_mm = at_corner(reference.mesh(), reference.solve(loads)->displacement_mm);
  EXPECT_GT((expected_mm - uncut_mm).norm(), 0.05 * expected_mm.norm());
  EXPECT_LT((reached_mm - by_sheet_mm).norm(), 0.015 * by_sheet_mm.norm())
      << reached_mm.transpose() << " and " << by_sheet_mm.transpose();
  EXPECT_LT((reached_mm - expected_mm).norm(), 0.05 * expected_mm.norm())
      << reached_mm.transpose() << " and " << expected_mm.transpose();
}

// What is open keeps its points, its walls and all that was solved for: with an advance's own columns taken away, the
// system is the one before.
TEST(StrokeOpening, LeadingTheLineOnLeavesWhatIsOpenAsItWas) {
  const StaticModel whole = held_bar(bar(10, 4, 5));
  const auto strip = [&](double until_y_mm, double from_y_mm, double to_y_mm) {
    const auto line = line_over(until_y_mm, 3);
    const auto surface = geometry::CutSurface::swept(line, down_to(front_mm)).value();
    return CutStrip{surface, line[std::size_t(from_y_mm + 1)], line[std::size_t(to_y_mm + 1)]};
  };
  const Opening first = nothing_open(whole).advanced(strip(11, -1, 7)).value();
  const VectorXd amplitudes = first.amplitudes_mm(first.standing_load());
  const Opening second = first.advanced(strip(18, 7, 13)).value();
  EXPECT_EQ(first.amplitudes_mm(first.standing_load()), amplitudes);
  ASSERT_GT(second.points().size(), first.points().size());
  for (std::size_t i = 0; i < first.points().size(); ++i) {
    EXPECT_EQ(second.points()[i], first.points()[i]);
    EXPECT_EQ(second.normals()[i], first.normals()[i]);
  }
  EXPECT_EQ(second.standing_load().head(first.standing_load().size()), first.standing_load());
  EXPECT_GT(second.open_mm2(), first.open_mm2());
  // Open cells with all of their points open keep their heights.
  for (const OpenCell& cell : first.cells()) {
    const auto cells = second.cells();
    const auto same = std::find_if(cells.begin(), cells.end(), [&](const auto& one) { return one.cell == cell.cell; });
    ASSERT_NE(same, cells.end());
    EXPECT_EQ(same->height_mm, cell.height_mm);
  }
  // And the same commands again give the same bits.
  const Opening again = nothing_open(whole).advanced(strip(11, -1, 7)).value().advanced(strip(18, 7, 13)).value();
  EXPECT_EQ(again.amplitudes_mm(again.standing_load()), second.amplitudes_mm(second.standing_load()));
}

TEST(StrokeOpening, SaysWhereCellsCannotFollow) {
  const StaticModel whole = held_bar(bar(20, 6, 9));
  const Vector3d into_mm(0, 0, -15);
  const auto along = [&](const std::vector<Vector3d>& line, std::size_t from, std::size_t to) {
    return CutStrip{geometry::CutSurface::swept(line, into_mm).value(), line[from], line[to]};
  };
  std::vector<Vector3d> line;
  for (double y = -1; y < 13; y += 2) line.emplace_back(41.3, y, top_mm);
  const Opening first = nothing_open(whole).advanced(along(line, 0, line.size() - 1)).value();
  const std::size_t corner = line.size() - 1;
  // A right angle within a cell.
  std::vector<Vector3d> sharp = line;
  for (double x = 43; x < 52; x += 2) sharp.emplace_back(x, line.back().y(), top_mm);
  EXPECT_EQ(first.advanced(along(sharp, corner, sharp.size() - 1)).error().code, "cut-turns");
  // Round and across itself.
  std::vector<Vector3d> round = line;
  for (double angle = 0.3; angle < 4.6; angle += 0.3) {
    round.emplace_back(41.3 + 9 * (1 - std::cos(angle)), line.back().y() + 9 * std::sin(angle), top_mm);
  }
  for (double x = round.back().x() - 2; x > 30; x -= 2) round.emplace_back(x, round.back().y(), top_mm);
  Result<Opening> opening = first;
  for (std::size_t n = corner; n + 2 < round.size() && opening; n += 2) {
    opening = opening->advanced(
        along({round.begin(), round.begin() + std::ptrdiff_t(std::min(round.size(), n + 6))}, n, n + 2));
  }
  ASSERT_FALSE(opening);
  EXPECT_EQ(opening.error().code, "cut-turns");
  // Another line that crosses it.
  std::vector<Vector3d> across;
  for (double x = 30; x < 52; x += 2) across.emplace_back(x, 6.2, top_mm);
  EXPECT_EQ(first.advanced(along(across, 0, across.size() - 1)).error().code, "cuts-meet");
  // Beside the body.
  EXPECT_EQ(nothing_open(whole).advanced(along({{90, 0, top_mm}, {90, 20, top_mm}}, 0, 1)).error().code, "cut-misses");
}

// The walls part under traction, at small strain and at large, each advance farther.
TEST(StrokeOpening, PartsUnderTractionAtSmallStrainAndAtLarge) {
  const ContactTool jaws{"jaws", Grasp{{cut_x_mm(40) + 8, 12, 40}, 7, 200.0, {1, 0, 0.5}}};
  const auto small = ContactBody::create(held_bar(bar(10, 4, 5)), {}, {}).value();
  std::vector<double> opened_mm;
  const auto strip = [&](double from_y_mm) {
    const auto line = line_over(std::min(25.0, from_y_mm + 14), 2);
    return CutStrip{geometry::CutSurface::swept(line, down_to(front_mm)).value(), line[std::size_t(from_y_mm + 1)],
                    line[std::min(line.size() - 1, std::size_t(from_y_mm + 11))]};
  };
  ContactBody body = small;
  ContactState state = small.solve(small.untouched(), {jaws}).value();
  const auto largest = [](const auto& jumps_mm) {
    double largest_mm = 0;
    for (const Vector3d& jump : jumps_mm) largest_mm = std::max(largest_mm, jump.norm());
    return largest_mm;
  };
  for (const double y : {-1.0, 9.0, 19.0}) {
    body = body.opened(strip(y)).value();
    state = body.solve(state, {jaws}).value();
    ASSERT_TRUE(state.report.converged);
    opened_mm.push_back(largest(state.jumps_mm));
  }
  EXPECT_GT(opened_mm[1], opened_mm[0]);
  EXPECT_GT(opened_mm[2], 1.5 * opened_mm[1]);
  // All the way over it is the plane's cut but for a bulge of 2 mm.
  const auto by_plane = small.opened({wall, on_front_mm(top_mm), on_front_mm(front_mm)}).value();
  const double plane_mm = largest(by_plane.solve(by_plane.untouched(), {jaws})->jumps_mm);
  EXPECT_NEAR(opened_mm[2], plane_mm, 0.15 * plane_mm);

  const auto large =
      LiveBody::create(held_bar(bar(10, 4, 5)), MaterialLaw::neo_hookean, test::supports_of_bar(), {}, {}, 0).value();
  LiveBody live = large;
  LiveState lying = large.step(large.untouched(), {jaws}).value();
  double before_mm = 0;
  for (const double y : {-1.0, 9.0, 19.0}) {
    live = live.opened(strip(y)).value();
    lying = live.step(lying, {jaws}).value();
    for (int settle = 0; settle < 20 && !lying.settled; ++settle) lying = live.settle(lying, {jaws}).value();
    const double now_mm = largest(live.jumps_mm(lying));
    EXPECT_GT(now_mm, before_mm);
    before_mm = now_mm;
  }
  EXPECT_NEAR(before_mm, opened_mm[2], 0.3 * opened_mm[2]);
}

// Meshfree nodes are split by all of a line before its first advance, as by a plane.
TEST(StrokeOpening, MeshfreeNodesAreSplitByAWholeLine) {
  geometry::TetMesh mesh = bar(20, 6, 9);
  test::name_supports_of_bar(mesh);
  const std::vector<double> moduli(mesh.cells.size(), test::youngs_kPa);
  const StaticModel model =
      MeshfreeModel::create(mesh, moduli, test::supports_of_bar(), MaterialLaw::linear, {}, {.nodes = 100})
          ->static_model()
          .value();
  const auto line = line_over(25);
  const auto surface = geometry::CutSurface::swept(line, down_to(front_mm)).value();
  Opening opening = nothing_open(model);
  for (const auto& [from, to] : {std::pair{0, 9}, {9, 18}, {18, 26}}) {
    opening = opening.advanced({surface, line[std::size_t(from)], line[std::size_t(to)]}).value();
  }
  const Opening plane = nothing_open(model).advanced({wall, on_front_mm(top_mm), on_front_mm(front_mm)}).value();
  const Vector3d expected_mm = at_corner(model.mesh(), displaced(model, plane));
  const Vector3d reached_mm = at_corner(model.mesh(), displaced(model, opening));
  // Less of each node is split: the plane goes on to the bar's bottom, the line's end stops at its depth.
  EXPECT_LT((reached_mm - expected_mm).norm(), 0.05 * expected_mm.norm())
      << reached_mm.transpose() << " and " << expected_mm.transpose();
  const auto begun = geometry::CutSurface::swept({line.begin(), line.begin() + 12}, down_to(front_mm)).value();
  const Opening half = nothing_open(model).advanced({begun, line[0], line[9]}).value();
  EXPECT_EQ(half.advanced({surface, line[9], line[18]}).error().code, "not-available");
}

}  // namespace
}  // namespace glisson::mechanics
