// Pairs of pictures from two videos or from one that shows both eyes.

#include "vision/stereo_source.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "vision/calibration.h"
#include "vision/stereo.h"

namespace glisson::vision {
namespace {

// No two pixels and no two channels alike.
Frame picture(int width, int height, int first) {
  Frame frame{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) frame.rgb.push_back(static_cast<std::uint8_t>((first + i) % 256));
  return frame;
}

Frame joined(const Frame& a, const Frame& b, bool above) {
  Frame both{above ? a.width : 2 * a.width, above ? 2 * a.height : a.height, {}};
  both.rgb.resize(2 * a.rgb.size());
  for (int y = 0; y < a.height; ++y) {
    std::copy_n(a.at(0, y), 3 * a.width, both.at(0, y));
    std::copy_n(b.at(0, y), 3 * a.width, above ? both.at(0, y + a.height) : both.at(a.width, y));
  }
  return both;
}

class StereoFolders : public testing::Test {
 protected:
  std::filesystem::path folder(const std::string& name, const std::vector<Frame>& frames) {
    const auto made = folder_.path() / name;
    std::filesystem::create_directories(made);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_TRUE(write_frame(frames[i], made / (std::to_string(i) + ".png")));
    }
    return made;
  }
  TemporaryFolder folder_;
};

TEST_F(StereoFolders, GiveTheSamePairsTogetherAndApart) {
  std::vector<Frame> left, right, beside, exchanged, above;
  for (int i = 0; i < 3; ++i) {
    left.push_back(picture(7, 5, 10 * i));
    right.push_back(picture(7, 5, 100 + 10 * i));
    beside.push_back(joined(left.back(), right.back(), false));
    exchanged.push_back(joined(right.back(), left.back(), false));
    above.push_back(joined(left.back(), right.back(), true));
  }
  const std::vector<StereoFiles> all{{folder("left", left), folder("right", right)},
                                     {folder("beside", beside), {}, Shared::left_then_right},
                                     {folder("exchanged", exchanged), {}, Shared::right_then_left},
                                     {folder("above", above), {}, Shared::left_above_right}};
  for (const StereoFiles& files : all) {
    auto source = StereoSource::open(files).value();
    EXPECT_EQ(source.count(), 3);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto pair = source.next().value();
      ASSERT_TRUE(pair.has_value()) << files.left;
      EXPECT_EQ(pair->left.width, 7);
      EXPECT_EQ(pair->left.rgb, left[i].rgb) << files.left;
      EXPECT_EQ(pair->right.rgb, right[i].rgb) << files.left;
    }
    EXPECT_FALSE(source.next().value().has_value());
    const std::string first = "0.png";
    const StereoPair one =
        read_pair({files.left / first, files.in_one() ? "" : files.right / first, files.shared}).value();
    EXPECT_EQ(one.right.rgb, right[0].rgb);
  }
}

TEST_F(StereoFolders, SayWhatIsNoPair) {
  const std::vector<Frame> six(6, picture(8, 6, 0)), three(3, picture(8, 6, 9));
  const auto long_one = folder("long", six), short_one = folder("short", three);
  auto source = StereoSource::open({long_one, short_one}).value();
  EXPECT_TRUE(source.has(3).has_value());
  EXPECT_EQ(source.has(4).error().code, "sequence-lengths");  // before anything is read
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(source.next().value().has_value());
  EXPECT_EQ(source.next().error().code, "sequence-lengths");
  auto sizes = StereoSource::open({short_one, folder("small", {picture(8, 4, 0)})}).value();
  EXPECT_EQ(sizes.next().error().code, "stereo-image-sizes");
  auto odd = StereoSource::open({folder("odd", {picture(7, 6, 0)}), {}}).value();
  EXPECT_EQ(odd.next().error().code, "picture-of-one-eye");
  EXPECT_EQ(halves(picture(4, 1, 0), Shared::left_above_right).error().code, "picture-of-one-eye");
}

TEST(Calibration, KeepsAndHoldsToTheSizeItIsOf) {
  const TemporaryFolder folder;
  StereoCalibration calibration;
  calibration.left.matrix << 500, 0, 320, 0, 500, 240, 0, 0, 1;
  calibration.right = calibration.left;
  calibration.left_to_right.translation() = Eigen::Vector3d(-5, 0, 0);
  const auto file = folder.path() / "camera.json";
  ASSERT_TRUE(write_stereo_calibration(file, calibration));
  EXPECT_EQ(read_stereo_calibration(file).value().width, 0);
  EXPECT_TRUE(StereoMatcher::prepare(calibration, 1280, 960).has_value());  // nothing says that it is not
  EXPECT_FALSE(may_be_of_size(calibration, 1280, 960));
  EXPECT_TRUE(may_be_of_size(calibration, 640, 480));
  calibration.width = 640;
  calibration.height = 480;
  ASSERT_TRUE(write_stereo_calibration(file, calibration));
  const StereoCalibration read = read_stereo_calibration(file).value();
  EXPECT_EQ(read.width, 640);
  EXPECT_EQ(read.height, 480);
  EXPECT_TRUE(StereoMatcher::prepare(read, 640, 480).has_value());
  EXPECT_EQ(StereoMatcher::prepare(read, 1280, 960).error().code, "stereo-calibration-size");
  EXPECT_EQ(read.simulated, "");
  calibration.simulated = "SIMULATED: by hand.";
  ASSERT_TRUE(write_stereo_calibration(file, calibration));
  EXPECT_EQ(read_stereo_calibration(file)->simulated, "SIMULATED: by hand.");
  std::string text = read_text_file(file).value();
  text.replace(text.find("\"SIMULATED: by hand.\""), 21, "true");
  ASSERT_TRUE(write_text_file(file, text));
  EXPECT_EQ(read_stereo_calibration(file).error().code, "calibration-invalid");
  calibration.simulated.clear();
  ASSERT_TRUE(write_stereo_calibration(file, calibration));
  text = read_text_file(file).value();
  text.replace(text.find("640"), 3, "-64");
  ASSERT_TRUE(write_text_file(file, text));
  EXPECT_EQ(read_stereo_calibration(file).error().code, "calibration-invalid");
}

}  // namespace
}  // namespace glisson::vision
