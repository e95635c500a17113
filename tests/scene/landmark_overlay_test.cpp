// Predicted landmarks over a scan: each circle stands in the picture where its position is, in its colour.

#include "scene/landmark_overlay.h"

#include <gtest/gtest.h>
#include <functional>

#include "scene/bodies.h"
#include "support/folders.h"

namespace glisson::scene {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::shared_ptr<const imaging::Volume> grey_scan() {
  auto scan = std::make_shared<imaging::Volume>();
  scan->grid.size = {100, 100, 100};
  scan->grid.spacing_mm = {2, 2, 2};
  scan->grid.origin_mm = {-100, -100, -100};
  scan->values.resize(scan->grid.voxels());
  for (std::size_t i = 0; i < scan->values.size(); ++i) scan->values[i] = static_cast<float>(i % 7);
  return scan;
}

// A vein of two forks in one slice and one far off it, and a tumour that moves towards the front and the head.
std::vector<PredictedLandmark> landmarks() {
  return {{"hepatic-vein-1", {20, 10, 0}, {30, -10, 1}, Vector3d(38, -16, 1)},
          {"hepatic-vein-2", {-10, 20, 3}, {-8, 14, 3}, Vector3d(-7, 12, 3)},
          {"hepatic-vein-3", {0, 0, 60}, {1, 0, 60}, Vector3d(1, 1, 60)},
          {"tumour-1", {-30, 0, 10}, {-31, -12, 22}, {}}};
}

Vector2d pixel_of(const Vector3d& position_mm, const Camera& camera, int width, int height) {
  const Vector3d from = position_mm - camera.focus_mm;
  const double pixels_per_mm = height / camera.visible_height_mm;
  return {width / 2.0 + pixels_per_mm * from.dot(camera.sight.cross(camera.up)),
          height / 2.0 - pixels_per_mm * from.dot(camera.up)};
}

// The middle of the box around the pixels near the place that are of a colour; none: far off.
Vector2d middle_of(const Picture& picture, const Vector2d& near, double reach_px,
                   const std::function<bool(int, int, int)>& is_colour) {
  Vector2d minimum(1e9, 1e9), maximum(-1e9, -1e9);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if ((Vector2d(x, y) - near).cwiseAbs().maxCoeff() > reach_px) continue;
      const std::uint8_t* rgb = picture.at(x, y);
      if (!is_colour(rgb[0], rgb[1], rgb[2])) continue;
      minimum = minimum.cwiseMin(Vector2d(x, y));
      maximum = maximum.cwiseMax(Vector2d(x, y));
    }
  }
  return (minimum + maximum) / 2;
}

TEST(LandmarkOverlay, CirclesStandWhereTheLandmarksAre) {
  const auto overlays = landmark_overlays(grey_scan(), {}, landmarks());
  ASSERT_EQ(overlays.size(), 2u);
  const LandmarkOverlay& vein = overlays[0];
  EXPECT_EQ(vein.group, "hepatic-vein");
  EXPECT_EQ(vein.shown, 2);  // the third is 60 mm off the slice
  EXPECT_EQ(vein.of, 3);
  // hepatic-vein-1, which the atlas misplaces most, moves least along z: a transverse slice through where it rests.
  EXPECT_EQ(vein.scene.slices[0].normal, Vector3d::UnitZ());
  EXPECT_EQ(vein.scene.slices[0].center_mm, Vector3d(20, 10, 0));
  constexpr int width = 900, height = 900;
  const auto picture = draw(vein.scene, width, height);
  ASSERT_TRUE(picture) << picture.error().message();
  const double reach_px = 5.5 * height / vein.scene.camera->visible_height_mm;  // a circle is 4.9 mm
  const auto expect_at = [&](const Vector3d& position_mm, const std::function<bool(int, int, int)>& is_colour) {
    const Vector2d there = pixel_of(position_mm, *vein.scene.camera, width, height);
    // A pixel and a half: the half of one, the edge's anti-aliasing, and 48 corners in place of a circle.
    EXPECT_LT((middle_of(*picture, there, reach_px, is_colour) - there).norm(), 1.5) << position_mm.transpose();
  };
  expect_at({20, 10, 0}, [](int r, int g, int b) { return r > 100 && g > 80 && b < r / 2; });
  expect_at({30, -10, 0}, [](int r, int, int b) { return b > 100 && r < b / 2; });
  expect_at({38, -16, 0}, [](int r, int g, int) { return r > 100 && g < r / 2; });
}

TEST(LandmarkOverlay, WithoutAReferenceBodyThereIsNoRedAndTheSliceFollowsTheMotion) {
  const LandmarkOverlay tumour = landmark_overlays(grey_scan(), {}, landmarks()).at(1);
  EXPECT_EQ(tumour.group, "tumour");
  EXPECT_EQ(tumour.scene.slices[0].normal, Vector3d::UnitX());  // it moves along y and z
  EXPECT_EQ(tumour.scene.annotations.key.size(), 2u);
  for (const SurfaceItem& item : tumour.scene.surfaces) EXPECT_NE(item.name, "atlas");
  EXPECT_TRUE(check_scene(tumour.scene));
}

TEST(LandmarkOverlay, ResultOutsideACaseIsRefused) {
  const auto overlays = landmark_overlays(std::filesystem::path("/no/such/result"), {});
  ASSERT_FALSE(overlays);
  EXPECT_FALSE(overlays.error().message().empty());
}

}  // namespace
}  // namespace glisson::scene
