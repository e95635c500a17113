// A pose from one picture: lines of an egg seen through a lens that bends, its silhouette, and what cannot be told.

#include "guidance/contour_pose.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"
#include "geometry/mesh_file.h"
#include "guidance/contour_file.h"
#include "support/egg.h"
#include "vision/draw.h"

namespace glisson::guidance {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

vision::Camera bent_lens() {
  vision::Camera lens;
  lens.matrix << 900, 0, 480, 0, 900, 270, 0, 0, 1;
  lens.distortion = {-0.1, 0.02, 0, 0, 0};
  return lens;
}

Isometry3d truth() {
  return Eigen::Translation3d(6, -4, 170) * Eigen::AngleAxisd(0.35, Vector3d(1, 0.3, 0.4).normalized());
}

// Where the lower side of the egg lies at (x, y): a laparoscope looks up at it.
Vector3d on_lower_side(double x_mm, double y_mm) {
  const double y = y_mm / 30, x = x_mm / (40 * (1 + 0.25 * y));
  return {x_mm, y_mm, -20 * std::sqrt(std::max(0.0, 1 - x * x - y * y))};
}

std::vector<Vector2d> seen(const std::vector<Vector3d>& places_mm) {
  std::vector<Vector3d> there;
  for (const Vector3d& place : places_mm) there.emplace_back(truth() * place);
  std::vector<Vector2d> pixels;
  for (const auto& pixel : vision::project(bent_lens(), there)) {
    if (pixel) pixels.push_back(*pixel);
  }
  return pixels;
}

// A line along the egg and one across it; of each, a part is seen.
std::vector<SeenContour> two_lines() {
  std::vector<Vector3d> along, across;
  for (int n = -28; n <= 28; n += 2) along.push_back(on_lower_side(n, 6 + 0.2 * n));
  for (int n = -20; n <= 20; n += 2) across.push_back(on_lower_side(10 - 0.01 * n * n, n));
  return {{"ridge", along, seen({along.begin() + 4, along.end()})},
          {"falciform", across, seen({across.begin(), across.end() - 4})}};
}

double off_mm(const Isometry3d& pose) {
  double largest = 0;
  for (const Vector3d& place : {Vector3d(30, 0, 0), Vector3d(-30, 5, 0), Vector3d(0, 0, 15), Vector3d(0, 20, 0)}) {
    largest = std::max(largest, (pose * place - truth() * place).norm());
  }
  return largest;
}

TEST(ContourPose, TwoLinesOfAPictureTellThePose) {
  const auto found = pose_of_contours(geometry::boundary_surface(egg()), bent_lens(), two_lines());
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_LT(off_mm(found->pose), 4);
  ASSERT_EQ(found->off.size(), 2u);
  for (const auto& off : found->off) {
    ASSERT_TRUE(off);
    EXPECT_LT(off->px, 3);
    EXPECT_LT(off->mm, 0.6);
  }
}

TEST(ContourPose, ASilhouetteIsWhereTheSurfaceTurnsAway) {
  const geometry::Surface organ = geometry::boundary_surface(egg());
  SeenContour silhouette{"silhouette", {}, {}};
  for (int n = 0; n < 60; ++n) {  // an ellipsoid's outline, nearly: from where the camera looks along z
    const double angle = 2 * 3.14159265 * n / 60;
    const double y_mm = 30 * std::sin(angle);
    silhouette.seen_px.push_back(seen({{40 * (1 + 0.25 * y_mm / 30) * std::cos(angle), y_mm, 0}}).front());
  }
  const ContourError here = error_of(silhouette, organ, bent_lens(), truth()).value();
  EXPECT_LT(here.px, 25);  // turned by some degrees, and faceted
  Isometry3d beside = truth();
  beside.pretranslate(Vector3d(25, 0, 0));
  EXPECT_GT(error_of(silhouette, organ, bent_lens(), beside).value().px, 2 * here.px);
  std::vector<SeenContour> contours = two_lines();
  contours.push_back(silhouette);
  const auto found = pose_of_contours(organ, bent_lens(), contours);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_LT(off_mm(found->pose), 8);
}

// The polynomial of a real laparoscope turns back before the picture's corner (P2ILF's camera).
TEST(ContourPose, WhereALensTellsNoDirectionNothingIsUsed) {
  vision::Camera lens = bent_lens();
  lens.distortion = {-0.23, 0.34, 0, 0, -0.24};
  EXPECT_FALSE(vision::rays(lens, {{480 + 900 * 1.03, 270}}).front());
  const auto ray = vision::rays(lens, {{480 + 900 * 0.5, 270 - 900 * 0.3}}).front();
  ASSERT_TRUE(ray);
  EXPECT_LT((vision::project(lens, {*ray}).front().value() - Vector2d(930, 0)).norm(), 0.01);
  std::vector<SeenContour> contours = two_lines();
  contours.push_back({"corner", contours[0].at_rest_mm, {{480 + 900 * 1.02, 270}, {480 + 900 * 1.03, 275}}});
  const auto found = pose_of_contours(geometry::boundary_surface(egg()), lens, contours);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_FALSE(found->off.back());
}

TEST(ContourPose, OneLineTellsNone) {
  std::vector<SeenContour> one{two_lines().front()};
  const auto found = pose_of_contours(geometry::boundary_surface(egg()), bent_lens(), one);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "pose-not-found");
  EXPECT_THAT(found.error().message(), testing::HasSubstr("two lines"));
  // But from a guess it is refined.
  Isometry3d guess = truth();
  guess.pretranslate(Vector3d(4, -3, 10));
  EXPECT_TRUE(pose_of_contours(geometry::boundary_surface(egg()), bent_lens(), one, guess));
}

TEST(ContourPose, LinesThatContradictEachOtherAreRefused) {
  std::vector<SeenContour> lines = two_lines();
  for (Vector2d& at : lines[1].seen_px) at += Vector2d(2500, 1800);
  EXPECT_FALSE(pose_of_contours(geometry::boundary_surface(egg()), bent_lens(), lines));
}

// ---- On disk ----

class ContourFile : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(geometry::write_surface(folder_.path() / "egg.ply", geometry::boundary_surface(egg())));
    for (const SeenContour& contour : two_lines()) {
      std::string rest = "x_mm,y_mm,z_mm\n", pixels = "x_px,y_px\n";
      for (const Vector3d& at : contour.at_rest_mm) rest += fmt::format("{},{},{}\n", at.x(), at.y(), at.z());
      for (const Vector2d& at : contour.seen_px) pixels += fmt::format("{},{}\n", at.x(), at.y());
      ASSERT_TRUE(write_text_file(folder_.path() / (contour.id + ".csv"), rest));
      ASSERT_TRUE(write_text_file(folder_.path() / ("f0_" + contour.id + ".csv"), pixels));
    }
    ASSERT_TRUE(write_text_file(folder_.path() / "targets.csv", "id,x_mm,y_mm,z_mm\ndeep,1,2,3\n"));
  }
  Result<ContourCase> read(const std::string& text) {
    EXPECT_TRUE(write_text_file(folder_.path() / "contours.json", text));
    return read_contours(folder_.path() / "contours.json");
  }
  static std::string document() {
    return R"({"format": "glisson-contours/1", "model": {"surface": "egg.ply"},
      "camera": {"matrix": [[900, 0, 480], [0, 900, 270], [0, 0, 1]], "distortion": [-0.1, 0.02, 0, 0, 0]},
      "features": [{"id": "ridge", "points": "ridge.csv"}, {"id": "falciform", "points": "falciform.csv"}],
      "frames": [{"id": "f0", "contours": [{"id": "ridge", "pixels": "f0_ridge.csv"},
                                           {"id": "falciform", "pixels": "f0_falciform.csv"}]}],
      "targets": "targets.csv"})";
  }
  TemporaryFolder folder_;
};

TEST_F(ContourFile, IsAnsweredWithEachContourLeftOut) {
  const auto asked = read(document());
  ASSERT_TRUE(asked) << asked.error().message();
  EXPECT_TRUE(holds_contours(folder_.path() / "contours.json"));
  const auto answers = answer(*asked);
  ASSERT_TRUE(answers);
  const Json json = answer_json(*asked, *answers);
  const Json& frame = json.at("frames").at(0);
  EXPECT_TRUE(frame.at("converged").get<bool>());
  EXPECT_LT(frame.at("contours").at(0).at("off_px").get<double>(), 3);
  EXPECT_GE(frame.at("contours").at(1).at("left_out_px").get<double>(), 0);
  const auto deep = frame.at("targets").at(0).at("position_mm").get<std::vector<double>>();
  EXPECT_LT((Vector3d(deep[0], deep[1], deep[2]) - truth() * Vector3d(1, 2, 3)).norm(), 4);
}

TEST_F(ContourFile, WhatIsWrongIsNamed) {
  const auto without = [](const std::string& part, const std::string& other = "") {
    std::string text = document();
    text.replace(text.find(part), part.size(), other);
    return text;
  };
  const std::vector<std::pair<std::string, std::string>> wrong{
      {without("glisson-contours/1", "glisson-contours/9"), "format"},
      {without("egg.ply", "none.ply"), "none.ply"},
      {without("[0, 0, 1]]", "[0, 0]]"), "3 x 3"},
      {without(R"({"id": "ridge", "pixels")", R"({"id": "crest", "pixels")"), "crest"},
      {without("f0_ridge.csv", "ridge.csv"), "x_px"},
      {without(R"("id": "f0")", R"("id": "../f0")"), "no slashes"},
      {without(R"("frames": [)", R"("frames": [], "more": [)"), "frames"}};
  for (const auto& [text, named] : wrong) {
    const auto asked = read(text);
    ASSERT_FALSE(asked) << text;
    EXPECT_THAT(asked.error().message(), testing::HasSubstr(named));
  }
  EXPECT_FALSE(holds_contours(folder_.path() / "ridge.csv"));
}

}  // namespace
}  // namespace glisson::guidance
