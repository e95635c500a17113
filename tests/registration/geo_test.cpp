// Matching by geodesic distances, on shapes whose true correspondence is known: vertex i is vertex i.

#include "registration/geo.h"

#include <gtest/gtest.h>
#include <cmath>

#include "geometry/mesh_file.h"
#include "registration/breathing_liver.h"
#include "support/data.h"

namespace glisson::registration {
namespace {

using geometry::Surface;

Surface shape(const char* folder, const std::string& file) {
  return geometry::read_surface(glisson::test::shared_data() / folder / file).value();
}

// As the benchmarks of shape matching count it, but through space, which is shorter than along the surface by little
// for errors this small: the distance between where point i was led and where it belongs, over the square root of the
// area.
double mean_relative_error(const std::vector<int>& points, const std::vector<int>& led_to, const Surface& target) {
  double sum_mm = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum_mm +=
        (target.points_mm[static_cast<std::size_t>(points[i])] - target.points_mm[static_cast<std::size_t>(led_to[i])])
            .norm();
  }
  return sum_mm / static_cast<double>(points.size()) / std::sqrt(geometry::area_mm2(target));
}

TEST(Samples, CoverTheSurfaceEvenly) {
  GLISSON_NEEDS_DATA("tosca_nonrigid_shapes");
  const Surface wolf = shape("tosca_nonrigid_shapes", "wolf0.off");
  const GeodesicSamples samples = sample_surface(wolf, 50).value();
  // Farthest points: every two samples are at least as far apart as the worst-covered point is from its nearest.
  for (Eigen::Index i = 0; i < 50; ++i)
    for (Eigen::Index j = 0; j < i; ++j) EXPECT_GE(samples.between_mm(i, j), 0.95 * samples.covering_radius_mm);
  EXPECT_EQ(sample_surface(wolf, 4345).error().code, "too-few-points");
}

// The samples of the two surfaces are chosen apart, so that even the best match is off by about half their spacing,
// 0.04 here; a mirrored or reversed matching is off by 0.13 or more.
TEST(Geo, FindsAWolfInAnotherPose) {
  GLISSON_NEEDS_DATA("tosca_nonrigid_shapes");
  const Surface source = shape("tosca_nonrigid_shapes", "wolf0.off");
  const Surface target = shape("tosca_nonrigid_shapes", "wolf1.off");
  GeoOptions options;
  options.points = 64;
  const SurfaceMatch match = match_surfaces(source, target, options).value();
  EXPECT_LT(mean_relative_error(match.source_points, match.target_points, target), 0.06);
  EXPECT_GT(match.orientation_kept, 0.8);

  const std::vector<int> dense = densify(match);
  ASSERT_EQ(dense.size(), source.points_mm.size());
  std::vector<int> all(dense.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  EXPECT_LT(mean_relative_error(all, dense, target), 0.04);
}

TEST(Geo, FindsPartOfALiverInTheWholeWhenRoughlyAligned) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Surface whole = shape("pbsm_liver_insilico/Liver1", "src.ply");
  const Surface part = shape("pbsm_liver_insilico/Liver1", "tgt.ply");
  const Surface truth = shape("pbsm_liver_insilico/Liver1", "gt.ply");  // the whole, where the part was cut from
  GeoOptions options;
  options.points = 64;
  options.prior = Prior::positions;
  const SurfaceMatch match = match_surfaces(whole, part, options).value();
  EXPECT_TRUE(match.swapped);
  double sum_mm = 0;
  for (std::size_t i = 0; i < match.source_points.size(); ++i) {
    sum_mm += (truth.points_mm[static_cast<std::size_t>(match.source_points[i])] -
               part.points_mm[static_cast<std::size_t>(match.target_points[i])])
                  .norm();
  }
  EXPECT_LT(sum_mm / 64, match.source_samples.covering_radius_mm);
}

GeoOptions of_a_video() {
  GeoOptions options;
  options.points = 64;
  options.prior = Prior::positions;
  return options;
}

// Judged by matching each frame anew, which takes five times as long.
TEST(FrameMatcher, FollowsABreathingLiverAsWellAsEachFrameAnew) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Surface liver = shape("pbsm_liver_insilico/Liver1", "src.ply");
  const GeoOptions options = of_a_video();
  FrameMatcher matcher = FrameMatcher::create(liver, options).value();
  double followed_mm = 0, anew_mm = 0;
  for (int frame = 0; frame < 10; ++frame) {
    const test::SeenFrame seen = test::breathing_liver(liver, frame, 0.3);
    const SurfaceMatch match = matcher.match(seen.surface).value();
    EXPECT_EQ(matcher.searched(), frame == 0) << frame;
    EXPECT_GT(match.orientation_kept, 0.8) << frame;
    followed_mm += test::mean_error_mm(liver, seen, match.source_points, match.target_points);
    const SurfaceMatch anew = match_surfaces(seen.surface, liver, options).value();
    anew_mm += test::mean_error_mm(liver, seen, anew.source_points, anew.target_points);
  }
  EXPECT_LT(followed_mm, 1.05 * anew_mm);
}

TEST(FrameMatcher, LooksAnewWhereTheLastFrameLeadsAstray) {
  GLISSON_NEEDS_DATA("pbsm_liver_insilico");
  const Surface liver = shape("pbsm_liver_insilico/Liver1", "src.ply");
  FrameMatcher matcher = FrameMatcher::create(liver, of_a_video()).value();
  const test::SeenFrame seen = test::breathing_liver(liver, 0, 0.3);
  ASSERT_TRUE(matcher.match(seen.surface).has_value());
  Surface turned = seen.surface;  // a camera that was put in anew, the other way round
  const Eigen::Vector3d middle_mm = geometry::bounding_box(turned.points_mm).center_mm();
  for (Eigen::Vector3d& point : turned.points_mm) {
    point = middle_mm + Eigen::Vector3d(-1, 1, -1).cwiseProduct(point - middle_mm);
  }
  ASSERT_TRUE(matcher.match(turned).has_value());
  EXPECT_TRUE(matcher.searched());
}

}  // namespace
}  // namespace glisson::registration
