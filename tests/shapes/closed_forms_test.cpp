// On ellipsoids whose modes are known: the modes are found, no more than there are, and a completion's standard
// deviation covers.

#include <gmock/gmock.h>

#include "base/files.h"
#include "ellipsoids.h"
#include "geometry/mesh_file.h"
#include "shapes/completion.h"
#include "shapes/model_file.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using geometry::Surface;

const ShapeModel& closed_model() {
  static const ShapeModel made = honest_model(test::ellipsoids(60)).value();
  return made;
}

// Standard deviation of one point's coordinate over the model's livers.
double sd_of(const ShapeModel& of, Eigen::Index point, Eigen::Index axis) {
  return of.modes_mm.row(3 * point + axis).norm();
}

Eigen::Index point_farthest(const Vector3d& direction) {
  Eigen::Index best = 0;
  for (std::size_t p = 0; p < closed_model().mean.points_mm.size(); ++p) {
    if (closed_model().mean.points_mm[p].dot(direction) >
        closed_model().mean.points_mm[static_cast<std::size_t>(best)].dot(direction)) {
      best = static_cast<Eigen::Index>(p);
    }
  }
  return best;
}

Surface without_dome(Surface surface) {
  std::erase_if(surface.triangles, [&](const std::array<int, 3>& triangle) {
    return std::any_of(triangle.begin(), triangle.end(),
                       [&](int p) { return surface.points_mm[static_cast<std::size_t>(p)].z() > 25; });
  });
  return surface;
}

}  // namespace

TEST(Shapes, FindsTheModesThatThereAreAndNoMore) {
  EXPECT_EQ(closed_model().rank(), 3);
  // Sixty livers say a standard deviation to within 1 / sqrt(120), twice that for chance.
  EXPECT_NEAR(sd_of(closed_model(), point_farthest({1, 0, 0}), 0), test::x_sd_mm, 0.2 * test::x_sd_mm);
  EXPECT_NEAR(sd_of(closed_model(), point_farthest({0, 1, 0}), 1), test::y_sd_mm, 0.2 * test::y_sd_mm);
  // Aligning takes a part of a dome that rises: all points follow it by their mean, a tenth of it.
  EXPECT_NEAR(sd_of(closed_model(), point_farthest({0, 0, 1}), 2), 0.9 * test::dome_sd_mm, 0.2 * test::dome_sd_mm);
  EXPECT_NEAR(closed_model().residual_sd_mm.mean(), 0.2, 0.05);  // the noise of each coordinate
}

TEST(Shapes, GeneralisesToLiversLeftOutAsFarAsNoiseLets) {
  const auto aligned = align_shapes(test::ellipsoids(30)).value();
  const RanksJudged judged = judge_ranks(aligned);
  ASSERT_GE(judged.by_modes.size(), 3u);
  EXPECT_GT(judged.by_modes[0].generalisation_mm, 1.0);
  EXPECT_LT(judged.by_modes[2].generalisation_mm, 0.4);
  EXPECT_GT(judged.by_modes[2].compactness, 0.97);
  EXPECT_LT(specificity_mm(calibrated(model_of(aligned, 3), judged), aligned, 50), 6);
}

TEST(Shapes, ACompletionsStandardDeviationCovers) {
  std::size_t missing = 0, within_1 = 0, within_2 = 0;
  double top_sd_mm = 0;
  constexpr int drawn = 24;
  for (int i = 0; i < drawn; ++i) {
    const Surface truth = test::ellipsoid(test::drawn(mixed(99, static_cast<std::uint64_t>(i))));
    const auto completed = complete(closed_model(), without_dome(truth));
    ASSERT_TRUE(completed) << completed.error().message();
    const auto& sd_mm = geometry::find_field(completed->surface.point_fields, "sd_mm")->values;
    const std::vector<Vector3d> normals = geometry::point_normals(completed->surface);
    for (std::size_t p = 0; p < truth.points_mm.size(); ++p) {
      if (truth.points_mm[p].z() < 35) continue;
      const double off = std::abs((truth.points_mm[p] - completed->surface.points_mm[p]).dot(normals[p]));
      ++missing;
      within_1 += off <= sd_mm[p] ? 1 : 0;
      within_2 += off <= 1.96 * sd_mm[p] ? 1 : 0;
    }
    top_sd_mm += sd_mm[static_cast<std::size_t>(point_farthest({0, 0, 1}))] / drawn;
  }
  // What is seen says nothing of the dome: its own spread is the answer's standard deviation.
  EXPECT_NEAR(top_sd_mm, test::dome_sd_mm, 0.3 * test::dome_sd_mm);
  const double n = static_cast<double>(missing);
  EXPECT_GT(static_cast<double>(within_1) / n, 0.5);
  EXPECT_GT(static_cast<double>(within_2) / n, 0.85);
}

TEST(Shapes, WhatIsSeenStays) {
  const Surface truth = test::ellipsoid({1, -1, 0.5});
  const auto completed = complete(closed_model(), without_dome(truth)).value();
  EXPECT_TRUE(is_watertight(completed.surface));
  EXPECT_GT(completed.seen_fraction, 0.5);
  EXPECT_LT(completed.seen_fraction, 0.85);
  const auto& seen = geometry::find_field(completed.surface.point_fields, "seen")->values;
  double farthest_mm = 0;
  for (std::size_t p = 0; p < seen.size(); ++p) {
    if (seen[p] == 1) farthest_mm = std::max(farthest_mm, (completed.surface.points_mm[p] - truth.points_mm[p]).norm());
  }
  EXPECT_LT(farthest_mm, 6);  // along the surface; across it the points lie on what was seen
}

TEST(Shapes, AModelComesBackFromItsFile) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_model(folder.path() / "model.vtp", closed_model()));
  const auto back = read_model(folder.path() / "model.vtp");
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(back->rank(), closed_model().rank());
  EXPECT_EQ(back->livers, 60);
  EXPECT_EQ(back->modes_mm, closed_model().modes_mm);
  EXPECT_EQ(back->residual_sd_mm, closed_model().residual_sd_mm);
  ASSERT_TRUE(geometry::write_surface(folder.path() / "plain.vtp", closed_model().mean));
  const auto plain = read_model(folder.path() / "plain.vtp");
  ASSERT_FALSE(plain);
  EXPECT_EQ(plain.error().code, "shapes-not-a-model");
}

TEST(Shapes, TooFewOrUnlikeShapesAreRefused) {
  EXPECT_EQ(align_shapes(test::ellipsoids(3)).error().code, "shapes-too-few");
  auto unlike = test::ellipsoids(5);
  unlike.back().triangles.pop_back();
  EXPECT_EQ(align_shapes(unlike).error().code, "shapes-do-not-correspond");
}

}  // namespace glisson::shapes
