#include "vision/stereo.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/files.h"
#include "base/json.h"
#include "support/data.h"
#include "support/stereo_video.h"
#include "vision/picture_check.h"

namespace glisson::vision {
namespace {

constexpr int width = 480, height = 240;
constexpr double focal_px = 400, baseline_mm = 5;

StereoCalibration side_by_side() {
  StereoCalibration calibration;
  calibration.left.matrix << focal_px, 0, width / 2.0, 0, focal_px, height / 2.0, 0, 0, 1;
  calibration.right = calibration.left;
  calibration.left_to_right.translation() = Eigen::Vector3d(-baseline_mm, 0, 0);
  return calibration;
}

// A wall of random texture before both eyes: each pixel of the right picture shows what lies `px` to its right in the
// left one. A depth z is seen with px = focal baseline / z.
void write_pair(const std::filesystem::path& folder, int px_above, int px_below, bool highlight = false) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> grey(30, 220);
  std::vector<std::vector<int>> texture(height, std::vector<int>(width + 100));
  for (auto& row : texture)
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = x % 2 == 1 ? row[x - 1] : grey(random);
  const auto write = [&](const char* name, auto&& shift) {
    std::string image = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const bool shines = highlight && x > 200 && x < 240 && y > 20 && y < 60;
        const auto from = static_cast<std::size_t>(x + shift(y));
        image += static_cast<char>(shines ? 255 : texture[static_cast<std::size_t>(y)][from]);
      }
    ASSERT_TRUE(write_text_file(folder / name, image));
  };
  write("left.pgm", [](int) { return 0; });
  write("right.pgm", [&](int y) { return y < height / 2 ? px_above : px_below; });
}

std::filesystem::path heart(const char* file) { return glisson::test::shared_data() / "hamlyn_heart_stereo" / file; }

class StereoSize : public ::testing::TestWithParam<MatchingSize> {};
INSTANTIATE_TEST_SUITE_P(Sizes, StereoSize, ::testing::Values(MatchingSize::full, MatchingSize::half));

TEST_P(StereoSize, SeesTwoWallsWhereTheyStand) {
  const TemporaryFolder folder;
  write_pair(folder.path(), 20, 40);  // 100 mm and 50 mm
  StereoOptions options;
  options.size = GetParam();
  const StereoCloud cloud =
      stereo_cloud(folder.path() / "left.pgm", folder.path() / "right.pgm", side_by_side(), options).value();
  ASSERT_GT(cloud.points_mm.size(), 50000u);
  EXPECT_EQ(cloud.confidence.size(), cloud.points_mm.size());
  std::size_t off = 0;
  for (const auto& point : cloud.points_mm) {
    const double expected_mm = point.y() < 0 ? 100 : 50;
    if (std::abs(point.z() - expected_mm) > 0.02 * expected_mm) ++off;
  }
  // Along the seam between the walls, smoothing decides for some pixels either way.
  EXPECT_LT(static_cast<double>(off), 0.03 * static_cast<double>(cloud.points_mm.size()));
  EXPECT_GT(cloud.valid_fraction, 0.6);  // the left edge is not seen by the right eye
  for (const auto& [a, b, c] : cloud.triangles) {
    const auto at = [&](int i) { return cloud.points_mm[static_cast<std::size_t>(i)]; };
    ASSERT_LT((at(b) - at(a)).cross(at(c) - at(a)).dot(at(a)), 0) << "a triangle looks away from the camera";
  }
}

TEST(Stereo, LeavesHighlightsOut) {
  const TemporaryFolder folder;
  write_pair(folder.path(), 20, 20, true);
  const StereoCloud cloud =
      stereo_cloud(folder.path() / "left.pgm", folder.path() / "right.pgm", side_by_side()).value();
  for (std::size_t i = 0; i < cloud.points_mm.size(); ++i) EXPECT_LT(cloud.colour[i][0], 240);
}

TEST(Stereo, SeesASiliconeHeart) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const StereoCalibration calibration = read_stereo_calibration(heart("")).value();  // a folder of text files
  EXPECT_NEAR(calibration.baseline_mm(), 5.52, 0.01);
  const auto cloud =
      stereo_cloud(heart("f7_dynamic_deint_L_0100.png"), heart("f7_dynamic_deint_R_0100.png"), calibration);
  ASSERT_TRUE(cloud.has_value()) << cloud.error().message();
  EXPECT_EQ(cloud->pixels.size(), cloud->points_mm.size());
  // There is no truth with it: most of the picture must be seen, at depths that a heart in front of a scope has.
  EXPECT_GT(cloud->valid_fraction, 0.4);
  std::vector<double> depths_mm;
  for (const auto& point : cloud->points_mm) depths_mm.push_back(point.z());
  std::nth_element(depths_mm.begin(), depths_mm.begin() + static_cast<std::ptrdiff_t>(depths_mm.size() / 2),
                   depths_mm.end());
  RecordProperty("valid_fraction", std::to_string(cloud->valid_fraction));
  RecordProperty("median_depth_mm", std::to_string(depths_mm[depths_mm.size() / 2]));
  EXPECT_GT(depths_mm[depths_mm.size() / 2], 40);
  EXPECT_LT(depths_mm[depths_mm.size() / 2], 150);
}

// Against the truth, with a real picture of tissue on a surface that is known. A pixel of disparity is 2.2 mm of depth.
TEST(Stereo, MeasuresTissueWhoseDepthIsKnown) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  using glisson::test::StereoVideo;
  const StereoVideo video(read_frame(heart("f7_dynamic_deint_L_0100.png")).value());
  constexpr int frame = 3;
  StereoOptions options;
  options.size = MatchingSize::full;
  auto matcher =
      StereoMatcher::prepare(StereoVideo::calibration(), StereoVideo::width, StereoVideo::height, options).value();
  const StereoCloud cloud = matcher.cloud(video.left(frame), video.right(frame)).value();
  EXPECT_GT(cloud.valid_fraction, 0.5);
  std::vector<double> off_mm;
  for (const auto& point : cloud.points_mm) {
    const Eigen::Vector2d rest_mm = StereoVideo::rest_mm(point, frame);
    off_mm.push_back(std::abs(point.z() - StereoVideo::place_mm(rest_mm.x(), rest_mm.y(), frame).z()));
  }
  std::sort(off_mm.begin(), off_mm.end());
  fmt::print("depth off, mm (median, 95 %): {:.2f}, {:.2f}\n", off_mm[off_mm.size() / 2],
             off_mm[off_mm.size() * 95 / 100]);
  EXPECT_LT(off_mm[off_mm.size() / 2], 0.5);
  EXPECT_LT(off_mm[off_mm.size() * 95 / 100], 2.2);
  // Another size than was prepared for.
  const Frame small{320, 240, std::vector<std::uint8_t>(3 * 320 * 240)};
  EXPECT_EQ(matcher.cloud(small, small).error().code, "stereo-image-sizes");
}

TEST(Stereo, RefusesACalibrationOfAnotherSize) {
  StereoCalibration calibration = side_by_side();
  calibration.left.matrix(0, 2) = width + 10;
  EXPECT_EQ(StereoMatcher::prepare(calibration, width, height).error().code, "stereo-calibration-size");
}

TEST(Stereo, RefusesPicturesThatDoNotPair) {
  const TemporaryFolder folder;
  write_pair(folder.path(), 20, 20);
  ASSERT_TRUE(write_text_file(folder.path() / "small.pgm", "P5\n2 2\n255\nabcd"));
  ASSERT_TRUE(write_text_file(folder.path() / "broken.png", "not a picture"));
  const auto code = [&](const char* left, const char* right) {
    return stereo_cloud(folder.path() / left, folder.path() / right, side_by_side()).error().code;
  };
  EXPECT_EQ(code("left.pgm", "small.pgm"), "stereo-image-sizes");
  EXPECT_EQ(code("left.pgm", "broken.png"), "image-not-readable");
  EXPECT_EQ(code("nowhere.png", "right.pgm"), "image-not-readable");
}

TEST(StereoCalibration, IsReadFromJsonAndFromOpenCv) {
  const TemporaryFolder folder;
  const auto json = folder.path() / "c.json";
  ASSERT_TRUE(
      write_text_file(json, R"({"left": {"matrix": [[400,0,240],[0,400,120],[0,0,1]], "distortion": [0.1,0,0,0,0]},
    "right": {"matrix": [400,0,240,0,400,120,0,0,1]}, "left_to_right": [[1,0,0,-5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})"));
  const StereoCalibration from_json = read_stereo_calibration(json).value();
  EXPECT_EQ(from_json.left.distortion.size(), 5u);
  EXPECT_EQ(from_json.baseline_mm(), 5);
  EXPECT_TRUE(from_json.notes.empty());

  const auto yaml = folder.path() / "c.yml";
  const auto matrix = [](const char* name, int rows, int columns, const char* data) {
    return std::string(name) + ": !!opencv-matrix\n   rows: " + std::to_string(rows) +
           "\n   cols: " + std::to_string(columns) + "\n   dt: d\n   data: [ " + data + " ]\n";
  };
  ASSERT_TRUE(write_text_file(
      yaml, "%YAML:1.0\n---\n" + matrix("M1", 3, 3, "400,0,240,0,400,120,0,0,1") + matrix("D1", 1, 5, "0.1,0,0,0,0") +
                matrix("M2", 3, 3, "400,0,240,0,400,120,0,0,1") + matrix("D2", 1, 5, "0,0,0,0,0") +
                matrix("R", 3, 3, "1,0,0,0,1,0,0,0,1") + matrix("T", 3, 1, "-5,0,0")));
  const auto from_yaml = read_stereo_calibration(yaml);
  ASSERT_TRUE(from_yaml.has_value()) << from_yaml.error().message();
  EXPECT_TRUE(from_yaml->left_to_right.isApprox(from_json.left_to_right));
  EXPECT_EQ(from_yaml->left.matrix, from_json.left.matrix);
}

TEST(StereoCalibration, TurnsTheWrongDirectionAroundAndSaysSo) {
  StereoCalibration calibration = side_by_side();
  calibration.left_to_right = calibration.left_to_right.inverse();
  const StereoCalibration good = checked(calibration).value();
  EXPECT_LT(good.left_to_right.translation().x(), 0);
  EXPECT_EQ(good.notes.size(), 1u);
}

TEST(PictureCheck, BelievesThePicturesAndNotTheFile) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const StereoCalibration calibration = read_stereo_calibration(heart("")).value();
  const Frame left = read_frame(heart("f7_dynamic_deint_L_0100.png")).value();
  const Frame right = read_frame(heart("f7_dynamic_deint_R_0100.png")).value();
  const PictureCheck check = check_against_pictures(calibration, left, right).value();
  EXPECT_GT(check.matches, 50);
  EXPECT_LT(check.epipolar_px, 1.5);
  EXPECT_GT(check.in_front, 0.9);

  EXPECT_FALSE(check_against_pictures(calibration, right, left).has_value());
  StereoCalibration turned = calibration;
  turned.left_to_right = turned.left_to_right.inverse();
  EXPECT_EQ(check_against_pictures(turned, left, right).error().code, "stereo-eyes-exchanged");
  StereoCalibration other = calibration;
  other.right.matrix(1, 2) += 20;  // as another camera's
  EXPECT_EQ(check_against_pictures(other, left, right).error().code, "calibration-not-of-pictures");
}

TEST(StereoCalibration, OfTextFilesMayGoTheOtherWay) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, const char* text) {
    ASSERT_TRUE(write_text_file(folder.path() / name, text));
  };
  write("calib.left.intrinsics.txt", "400 0 240\n0 400 120\n0 0 1\n");
  write("calib.right.intrinsics.txt", "400, 0, 240, 0, 400, 120, 0, 0, 1");
  EXPECT_EQ(read_stereo_calibration(folder.path()).error().code, "calibration-invalid");
  write("calib.r2l.txt", "1 0 0 5\n0 1 0 0\n0 0 1 0\n0 0 0 1");
  EXPECT_EQ(read_stereo_calibration(folder.path()).value().left_to_right.translation().x(), -5);
  write("calib.r2l.txt", "1 0 0 5\n0 2 0 0\n0 0 1 0\n0 0 0 1");
  EXPECT_EQ(read_stereo_calibration(folder.path()).error().code, "calibration-not-rotation");
  write("calib.r2l.txt", "1 0 0 here");
  EXPECT_EQ(read_stereo_calibration(folder.path()).error().code, "calibration-invalid");
}

TEST(StereoCalibration, RefusesWhatIsNoRotationOrNoPair) {
  StereoCalibration calibration = side_by_side();
  calibration.left_to_right.linear() *= 1.1;
  EXPECT_EQ(checked(calibration).error().code, "calibration-not-rotation");
  calibration = side_by_side();
  calibration.left_to_right.translation().setZero();
  EXPECT_EQ(checked(calibration).error().code, "calibration-no-baseline");
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "c.json", "{\"left\": {}}"));
  EXPECT_EQ(read_stereo_calibration(folder.path() / "c.json").error().code, "calibration-invalid");
}

// A scene that no rule was chosen on: real tissue's picture on a surface whose depths are known.
TEST(Stereo, BringsSparsePointsNearerThanTheSmoothingLeavesThem) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const test::StereoVideo video(
      read_frame(test::shared_data() / "hamlyn_heart_stereo" / "f7_dynamic_deint_L_0100.png").value());
  constexpr int t = 3;
  const auto errors_mm = [&](int step_px) {
    StereoOptions options;
    options.step_px = step_px;
    const Frame left = video.left(t), right = video.right(t);
    auto matcher = StereoMatcher::prepare(test::StereoVideo::calibration(), left.width, left.height, options).value();
    const StereoCloud cloud = matcher.cloud(left, right).value();
    std::vector<double> errors;
    for (std::size_t i = 0; i < cloud.points_mm.size(); ++i) {
      if (cloud.pixels[i][0] % 4 != 0 || cloud.pixels[i][1] % 4 != 0) continue;
      const Eigen::Vector3d& point = cloud.points_mm[i];
      const Eigen::Vector2d rest = test::StereoVideo::rest_mm(point, t);
      errors.push_back(std::abs(point.z() - test::StereoVideo::place_mm(rest.x(), rest.y(), t).z()));
    }
    std::sort(errors.begin(), errors.end());
    return errors;
  };
  const auto smoothed = errors_mm(1), refined = errors_mm(4);
  ASSERT_GT(refined.size(), 2000u);
  EXPECT_NEAR(static_cast<double>(refined.size()), static_cast<double>(smoothed.size()), 0.02 * smoothed.size());
  const auto at = [](const std::vector<double>& errors, double share) {
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
  };
  fmt::print("error in depth, mm (median, 90 %): {:.2f}, {:.2f} smoothed; {:.2f}, {:.2f} refined\n", at(smoothed, 0.5),
             at(smoothed, 0.9), at(refined, 0.5), at(refined, 0.9));
  EXPECT_LT(at(refined, 0.5), 0.6 * at(smoothed, 0.5));
  EXPECT_LT(at(refined, 0.9), 0.8 * at(smoothed, 0.9));
}

}  // namespace
}  // namespace glisson::vision
