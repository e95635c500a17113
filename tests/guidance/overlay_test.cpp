// Outlines over a frame, and an organ laid over it by hand: against what the camera shows of known bodies.

#include "guidance/overlay.h"

#include <gmock/gmock.h>
#include <cmath>

#include "guidance/hand_pose.h"
#include "support/shapes.h"

namespace glisson::guidance {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int width = 320, height = 240;

vision::Camera camera() {
  vision::Camera made;
  made.matrix << 300, 0, width / 2.0, 0, 300, height / 2.0, 0, 0, 1;
  return made;
}

// A block of 60 x 40 x 40 mm whose middle lies 200 mm before the camera, a small one within it 5 mm under its front.
class Overlay : public testing::Test {
 protected:
  Overlay() {
    structures_.push_back(embedded("liver", {245, 240, 230}, geometry::boundary_surface(mesh_), mesh_));
    geometry::Surface small = structures_.front().at_rest;
    for (Vector3d& point : small.points_mm) point = Vector3d(25, 15, 5) + point / 6;
    structures_.push_back(embedded("tumour-1", {255, 214, 40}, small, mesh_));
  }
  [[nodiscard]] ElasticPlacement placed(const Vector3d& shift_mm = {0, 0, 0}) const {
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() = Vector3d(-30, -20, 180) + shift_mm;
    return rigid_placement(pose, mesh_);
  }
  [[nodiscard]] std::vector<PlacedOutline> outlines(const ElasticPlacement& placement,
                                                    const std::vector<std::uint8_t>& hidden = {}) const {
    return placed_outlines(camera(), width, height, mesh_, structures_, placement, hidden);
  }
  static const PlacedOutline& of(const std::vector<PlacedOutline>& outlines, std::size_t structure) {
    return *std::find_if(outlines.begin(), outlines.end(), [&](const auto& one) { return one.structure == structure; });
  }

  geometry::TetMesh mesh_ = test::box_of_tetrahedra({6, 4, 4}, {60, 40, 40});
  std::vector<EmbeddedStructure> structures_;
};

TEST_F(Overlay, GoesAroundWhatTheCameraShowsOfEach) {
  const auto drawn = outlines(placed());
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_EQ(drawn.front().structure, 0u);  // the deepest on average first
  for (std::size_t s = 0; s < 2; ++s) {
    Eigen::AlignedBox2d shown, line;
    for (const auto& pixel : vision::project(camera(), placed_points_mm(structures_[s], mesh_, placed()))) {
      shown.extend(*pixel);
    }
    for (const OutlinePiece& piece : of(drawn, s).pieces) {
      for (const Vector2d& pixel : piece.line_px) line.extend(pixel);
    }
    EXPECT_LT((shown.min() - line.min()).cwiseAbs().maxCoeff(), 1.5) << s;
    EXPECT_LT((shown.max() - line.max()).cwiseAbs().maxCoeff(), 1.5) << s;
  }
  EXPECT_FALSE(of(drawn, 0).deep_mm);
  EXPECT_NEAR(of(drawn, 1).deep_mm.value(), 5.0, 0.1);
}

TEST_F(Overlay, KnowsItsErrorOnlyWhereTheFitSaysIt) {
  EXPECT_TRUE(std::isinf(of(outlines(placed()), 1).sd_mm));
  ElasticPlacement fitted = placed();
  structures_[1].first_judged = 1;
  structures_[1].judged = 2;
  fitted.further_mm = {{0, 0, 180}, {-5, 0, 190}, {5, 0, 190}};
  fitted.further_sd_mm = {9.0, 1.0, 3.0};
  const PlacedOutline tumour = of(outlines(fitted), 1);
  EXPECT_EQ(tumour.sd_mm, 3.0);
  for (const OutlinePiece& piece : tumour.pieces) {
    for (std::size_t i = 0; i < piece.line_px.size(); ++i) {
      if (std::abs(piece.line_px[i].x() - width / 2.0) < 1) continue;  // as near to the one as to the other
      EXPECT_EQ(piece.sd_mm[i], piece.line_px[i].x() < width / 2.0 ? 1.0 : 3.0);
    }
  }
}

TEST_F(Overlay, StaysBelowInstrumentsAndDrawsNoLineAlongThePicturesEdge) {
  std::vector<std::uint8_t> hidden(std::size_t{width} * height, 0);
  for (int y = 0; y < height; ++y) {
    for (int x = width / 2; x < width; ++x) hidden[static_cast<std::size_t>(x + width * y)] = 255;
  }
  for (const PlacedOutline& outline : outlines(placed(), hidden)) {
    EXPECT_FALSE(outline.pieces.empty());
    for (const OutlinePiece& piece : outline.pieces) {
      for (const Vector2d& pixel : piece.line_px) EXPECT_LT(pixel.x(), width / 2.0 + 2);
    }
  }
  // Half of it left of the picture.
  for (const PlacedOutline& outline : outlines(placed({-107, 0, 0}))) {
    for (const OutlinePiece& piece : outline.pieces) {
      for (const Vector2d& pixel : piece.line_px) EXPECT_GE(pixel.x(), 1);
      EXPECT_NE(piece.line_px.front(), piece.line_px.back());
    }
  }
  ElasticPlacement unanswered = placed();
  unanswered.converged = false;
  EXPECT_TRUE(outlines(unanswered).empty());
}

TEST_F(Overlay, DrawsItsLinesAndLeavesTheRestOfTheFrame) {
  vision::Frame frame{width, height, std::vector<std::uint8_t>(3 * std::size_t{width} * height, 90)};
  draw_outlines(frame, structures_, outlines(placed()));
  std::size_t yellow = 0, changed = 0;
  for (std::size_t i = 0; i < frame.rgb.size(); i += 3) {
    yellow += frame.rgb[i] > 220 && frame.rgb[i + 2] < 90 ? 1 : 0;
    changed += frame.rgb[i] != 90 ? 1 : 0;
  }
  EXPECT_GT(yellow, 40u);
  EXPECT_LT(changed, frame.rgb.size() / 3 / 10);
}

TEST_F(Overlay, LinesOnTheOrganGoWhereItsFrontGoes) {
  const geometry::Surface& organ = structures_.front().at_rest;
  std::vector<double> heights_mm;
  std::vector<int> labels;
  for (const Vector3d& point : organ.points_mm) {
    heights_mm.push_back(point.x() - 25);
    labels.push_back(point.y() < 15 ? 0 : point.y() < 25 ? 1 : 2);
  }
  EmbeddedStructure cut{"planned-cut", {90, 255, 120}, {}, {}}, segments{"segments", {255, 160, 70}, {}, {}};
  cut.on_organ = zero_lines(organ, heights_mm);
  segments.on_organ = border_lines(organ, labels);
  ASSERT_EQ(cut.on_organ.size(), 1u);  // once around the block
  EXPECT_EQ(cut.on_organ.front().places.size(), cut.on_organ.front().triangles.size() + 1);
  structures_.push_back(cut);
  structures_.push_back(segments);
  ElasticPlacement moved = placed();
  for (Vector3d& u : moved.displacement_mm) u = Vector3d(4, 0, 0);
  const auto drawn = outlines(moved);
  EXPECT_EQ(drawn.back().structure, 3u);  // over all that lies inside
  // On the block's front, at z = 180: the cut at x = 25 + 4 - 30, the border half-way between 20 and 30.
  Eigen::AlignedBox2d of_cut, of_border;
  for (const OutlinePiece& piece : of(drawn, 2).pieces) {
    for (const Vector2d& pixel : piece.line_px) of_cut.extend(pixel);
  }
  for (const OutlinePiece& piece : of(drawn, 3).pieces) {
    for (const Vector2d& pixel : piece.line_px) of_border.extend(pixel);
  }
  const double scale = 300.0 / 180;
  EXPECT_NEAR(of_cut.min().x(), width / 2.0 - scale, 0.5);
  EXPECT_NEAR(of_cut.max().x(), width / 2.0 - scale, 0.5);
  EXPECT_NEAR(of_cut.sizes().y(), scale * 40, 1);
  EXPECT_NEAR(of_border.center().y(), height / 2.0 + scale * 5, scale * 5.1);  // along triangles of 10 mm
  EXPECT_NEAR(of_border.sizes().x(), scale * 60, 1);
}

class HandPose : public Overlay {
 protected:
  [[nodiscard]] Vector2d seen(const Isometry3d& pose, const Vector3d& at_rest_mm) const {
    return *vision::project(camera(), {pose * at_rest_mm}).front();
  }
  const Vector3d middle_{30, 20, 20};
  const Isometry3d pose_ = placed().pose;
};

TEST_F(HandPose, BeginsInTheMiddleOfThePictureAndWithinIt) {
  const Isometry3d pose = pose_before_camera(camera(), width, height, structures_.front().at_rest);
  EXPECT_NEAR(pose.linear().determinant(), 1, 1e-9);
  EXPECT_LT((seen(pose, middle_) - Vector2d(width / 2.0, height / 2.0)).norm(), 1e-6);
  for (const Vector3d& corner : structures_.front().at_rest.points_mm) {
    const Vector2d at = seen(pose, corner);
    EXPECT_TRUE(at.x() > 0 && at.x() < width && at.y() > 0 && at.y() < height) << at.transpose();
  }
  // The patient's left is on the right, what lies to the head is up.
  EXPECT_GT(seen(pose, middle_ + Vector3d(10, 0, 0)).x(), width / 2.0);
  EXPECT_LT(seen(pose, middle_ + Vector3d(0, 0, 10)).y(), height / 2.0);
}

TEST_F(HandPose, FollowsTheHandAndTurnsAboutItsMiddle) {
  const Vector2d before = seen(pose_, middle_);
  const Isometry3d moved = shifted(pose_, middle_, camera(), {17, -9});
  EXPECT_LT((seen(moved, middle_) - before - Vector2d(17, -9)).norm(), 1e-6);
  const Vector3d front = middle_ - Vector3d(0, 0, 15);
  const Isometry3d turned_right = turned(pose_, middle_, 20, 0), turned_down = turned(pose_, middle_, 0, 20);
  for (const Isometry3d& pose : {turned_right, turned_down, rolled(pose_, middle_, 20)}) {
    EXPECT_LT((pose * middle_ - pose_ * middle_).norm(), 1e-9);
    EXPECT_NEAR(pose.linear().determinant(), 1, 1e-9);
  }
  EXPECT_GT(seen(turned_right, front).x(), before.x() + 5);
  EXPECT_GT(seen(turned_down, front).y(), before.y() + 5);
  EXPECT_GT(seen(rolled(pose_, middle_, 20), middle_ + Vector3d(20, 0, 0)).y(), before.y() + 5);
}

TEST_F(HandPose, MovesAlongTheSightAndNeverThroughTheCamera) {
  const Isometry3d nearer = moved_in_depth(pose_, middle_, 0.5);
  EXPECT_LT((seen(nearer, middle_) - seen(pose_, middle_)).norm(), 1e-6);
  EXPECT_NEAR((nearer * middle_).z(), 100, 1e-9);
  EXPECT_NEAR((moved_in_depth(pose_, middle_, 1e-6) * middle_).z(), 20, 1e-9);
}

}  // namespace
}  // namespace glisson::guidance
