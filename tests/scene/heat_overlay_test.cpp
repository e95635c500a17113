// The heat mesh lies where the camera shows it, in the shared scale's colours.

#include "scene/heat_overlay.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace glisson::scene {
namespace {

vision::Camera camera() {
  vision::Camera camera;
  camera.matrix << 200, 0, 160, 0, 200, 120, 0, 0, 1;
  return camera;
}

vision::Frame black() { return {320, 240, std::vector<std::uint8_t>(3 * 320 * 240, 0)}; }

// A square of two triangles at 100 mm, from pixel (120, 80) to (200, 160).
HeatMesh square() {
  HeatMesh mesh;
  mesh.points_mm = {{-20, -20, 100}, {20, -20, 100}, {20, 20, 100}, {-20, 20, 100}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.values = {1, 0};
  mesh.verdicts = {HeatMesh::Verdict::accepted, HeatMesh::Verdict::accepted};
  return mesh;
}

TEST(HeatOverlay, ShowsGoodTrianglesLightGreenBadOnesBlueAndRejectedOnesGrey) {
  HeatScale scale;
  scale.opacity = 1;
  vision::Frame drawn = heat_overlay(black(), camera(), square(), scale);
  const std::uint8_t* good = drawn.at(180, 100);  // above the diagonal: the first triangle
  const std::uint8_t* bad = drawn.at(140, 140);
  EXPECT_GT(good[1], 240);
  EXPECT_GT(good[1], good[0] + 100);
  EXPECT_GT(good[1], good[2] + 100);
  EXPECT_GT(bad[2], bad[1] + 100);
  EXPECT_GT(bad[2], bad[0] + 100);
  EXPECT_EQ(drawn.at(110, 100)[1], 0);  // beside it nothing

  HeatMesh mesh = square();
  mesh.verdicts[1] = HeatMesh::Verdict::rejected;
  drawn = heat_overlay(black(), camera(), mesh, scale);
  bad = drawn.at(140, 140);
  EXPECT_EQ(bad[0], bad[1]);
  EXPECT_EQ(bad[1], bad[2]);
  EXPECT_GT(bad[0], 100);

  mesh.verdicts[1] = HeatMesh::Verdict::none;
  drawn = heat_overlay(black(), camera(), mesh, scale);
  EXPECT_EQ(*drawn.at(140, 140), 0);
}

TEST(HeatOverlay, BendsAsTheLensDoes) {
  vision::Camera barrel = camera();
  barrel.distortion = {-1.5, 0, 0, 0};
  HeatScale scale;
  scale.opacity = 1;
  const vision::Frame straight = heat_overlay(black(), camera(), square(), scale);
  const vision::Frame bent = heat_overlay(black(), barrel, square(), scale);
  const auto light = [](const vision::Frame& frame) {
    const std::uint8_t* pixel = frame.at(122, 82);
    return pixel[0] + pixel[1] + pixel[2];
  };
  EXPECT_GT(light(straight), 50);
  EXPECT_EQ(light(bent), 0);  // the corner is drawn five pixels inwards
}

TEST(HeatOverlay, LeavesOutWhatIsBehindTheCamera) {
  HeatMesh mesh = square();
  mesh.points_mm[0].z() = -5;
  mesh.points_mm[2].z() = -5;
  vision::Frame frame = black();
  HeatScale scale;
  const vision::Frame drawn = heat_overlay(frame, camera(), mesh, scale);
  EXPECT_EQ(drawn.at(160, 120)[0] + drawn.at(160, 120)[1] + drawn.at(160, 120)[2], 0);
}

TEST(HeatScale, SpansBothAlgorithmsAndForgetsOutliers) {
  std::vector<double> a(100, 0.4), b(100, 0.9);
  a[0] = -50;
  const HeatScale scale = shared_scale(a, b, HeatScale::Good::high, "correlation");
  EXPECT_EQ(scale.range, (std::array<double, 2>{0.4, 0.9}));
  EXPECT_GT(shared_scale({1, 1}, {1}, HeatScale::Good::low, "").range[1], 1);
}

}  // namespace
}  // namespace glisson::scene
