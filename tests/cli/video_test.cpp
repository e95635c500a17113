// glisson-cli stereo, calibrate, sequence and review, in the contract's words.

#include <gmock/gmock.h>
#include <cmath>

#include "base/files.h"
#include "support/data.h"
#include "support/process.h"
#include "support/stereo_video.h"

namespace glisson::test {
namespace {

std::string heart(const char* file) { return (shared_data() / "hamlyn_heart_stereo" / file).string(); }

TEST(StereoCommand, TurnsARealPairIntoACloudAndAPicture) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const TemporaryFolder folder;
  const auto cloud = folder.path() / "cloud.ply", picture = folder.path() / "depth.png";
  const Finished finished =
      glisson_cli({"stereo", heart("f7_dynamic_deint_L_0100.png"), heart("f7_dynamic_deint_R_0100.png"),
                   "--calibration", heart(""), "--out", cloud.string(), "--picture", picture.string(), "--json"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Json answer = finished.json();
  EXPECT_GT(answer.at("points").get<int>(), 20000);
  EXPECT_GT(answer.at("valid_fraction").get<double>(), 0.4);
  EXPECT_LT(answer.at("epipolar_px").get<double>(), 1);
  EXPECT_TRUE(std::filesystem::exists(cloud));
  EXPECT_TRUE(std::filesystem::exists(picture));
}

TEST(StereoCommand, RefusesExchangedPicturesAndLeavesNothingBehind) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const TemporaryFolder folder;
  const auto cloud = folder.path() / "cloud.ply";
  const Finished finished =
      glisson_cli({"stereo", heart("f7_dynamic_deint_R_0100.png"), heart("f7_dynamic_deint_L_0100.png"),
                   "--calibration", heart(""), "--out", cloud.string(), "--json", "--quiet"});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(finished.json().at("error").at("code"), "calibration-not-of-pictures");
  EXPECT_FALSE(std::filesystem::exists(cloud));
}

// A stereo video with a real picture on breathing tissue; nobody has published a real one with its truth.
TEST(SequenceCommand, LeadsFromAVideoToTwoRegistrationsSideBySide) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const TemporaryFolder folder;
  const auto at = [&](const char* name) { return (folder.path() / name).string(); };
  const StereoVideo video(vision::read_frame(heart("f7_dynamic_deint_L_0100.png")).value());
  std::filesystem::create_directories(at("left"));
  std::filesystem::create_directories(at("right"));
  constexpr int frames = 6;
  for (int t = 0; t < frames; ++t) {
    const std::string name = std::to_string(t) + ".png";
    ASSERT_TRUE(vision::write_frame(video.left(2 * t), folder.path() / "left" / name));
    ASSERT_TRUE(vision::write_frame(video.right(2 * t), folder.path() / "right" / name));
  }
  ASSERT_TRUE(vision::write_stereo_calibration(at("camera.json"), StereoVideo::calibration()));

  const Finished sequence = glisson_cli({"sequence", at("left"), at("right"), "--calibration", at("camera.json"),
                                         "--step", "8", "--out", at("sequence"), "--json", "--quiet"});
  ASSERT_EQ(sequence.exit_code, 0) << sequence.out << sequence.err;
  EXPECT_EQ(sequence.json().at("frames"), frames);
  const std::string document = sequence.json().at("file");
  for (const char* method : {"icp", "geo", "gnra"}) {
    const Finished judged =
        glisson_cli({"sirgn", document, "--method", method, "--pictures", "--out", at(method), "--json", "--quiet"});
    ASSERT_EQ(judged.exit_code, 0) << method << ": " << judged.out << judged.err;
    EXPECT_GT(judged.json().at("triangles").get<int>(), 20);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / method / "frames" / "f005.jpg"));
  }
  const Finished review = glisson_cli({"review", at("icp"), at("geo"), "--out", at("review"), "--json", "--quiet"});
  ASSERT_EQ(review.exit_code, 0) << review.out << review.err;
  EXPECT_EQ(review.json().at("frames"), frames);
  for (const char* name : {"review.html", "a000.jpg", "b005.jpg"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "review" / name)) << name;
  }
}

// One video whose pictures show both eyes side by side comes to the same sequence as two, to the byte.
TEST(SequenceCommand, TakesBothEyesFromOneVideo) {
  const TemporaryFolder folder;
  const auto at = [&](const char* name) { return (folder.path() / name).string(); };
  const Finished made =
      glisson_cli({"study", "example-sequence", "--stereo", "--frames", "6", "--out", at("example"), "--quiet"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto video = folder.path() / "example" / "video";
  std::filesystem::create_directories(at("both"));
  for (int t = 0; t < 6; ++t) {
    const std::string name = "f00" + std::to_string(t) + ".png";
    const vision::Frame left = vision::read_frame(video / "left" / name).value();
    const vision::Frame right = vision::read_frame(video / "right" / name).value();
    vision::Frame both{2 * left.width, left.height, std::vector<std::uint8_t>(2 * left.rgb.size())};
    for (int y = 0; y < left.height; ++y) {
      std::copy_n(left.at(0, y), 3 * left.width, both.at(0, y));
      std::copy_n(right.at(0, y), 3 * left.width, both.at(left.width, y));
    }
    ASSERT_TRUE(vision::write_frame(both, folder.path() / "both" / name));
  }
  const std::string camera = (video / "camera.json").string();
  const auto sequence = [&](std::vector<std::string> from, const char* out) {
    from.insert(from.begin(), "sequence");
    for (const std::string& word : {std::string("--calibration"), camera, std::string("--step"), std::string("8"),
                                    std::string("--out"), at(out), std::string("--json"), std::string("--quiet")}) {
      from.push_back(word);
    }
    return glisson_cli(from);
  };
  const Finished of_two = sequence({(video / "left").string(), (video / "right").string()}, "of-two");
  ASSERT_EQ(of_two.exit_code, 0) << of_two.out << of_two.err;
  EXPECT_GT(of_two.json().at("landmarks").get<int>(), 20);
  const Finished of_one = sequence({at("both"), "--eyes", "left-right"}, "of-one");
  ASSERT_EQ(of_one.exit_code, 0) << of_one.out << of_one.err;
  for (const char* name : {"sequence.json", "tracks.csv", "f000.ply", "f003.ply", "f003.png", "camera.json"}) {
    EXPECT_EQ(read_text_file(folder.path() / "of-one" / name).value(),
              read_text_file(folder.path() / "of-two" / name).value())
        << name;
  }
  EXPECT_EQ(sequence({at("both"), "--eyes", "right-left"}, "exchanged").exit_code, 1);
  EXPECT_EQ(sequence({at("both")}, "one-eye").exit_code, 2);  // nothing says where the other is
  EXPECT_FALSE(std::filesystem::exists(at("exchanged")));
}

TEST(CalibrateCommand, SaysHowFarItIsFromTheKnownLenses) {
  GLISSON_NEEDS_DATA("ucl_stereo_laparoscope_calib");
  const auto folder = shared_data() / "ucl_stereo_laparoscope_calib";
  const TemporaryFolder out;
  const auto file = out.path() / "camera.json";
  std::vector<std::string> words{"calibrate", "--board", "dots",         "--columns", "25",
                                 "--rows",    "18",      "--spacing-mm", "5"};
  for (const char* eye : {"left", "right"}) {
    words.push_back(std::string("--") + eye);
    for (const char* moment : {"08_54_13", "08_54_29", "08_54_44"}) {
      words.push_back((folder / moment / (std::string(eye) + "_image.png")).string());
    }
  }
  for (const std::string& word : {std::string("--known"), folder.string(), std::string("--out"), file.string(),
                                  std::string("--json"), std::string("--quiet")}) {
    words.push_back(word);
  }
  const Finished finished = glisson_cli(words);
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Json answer = finished.json();
  EXPECT_EQ(answer.at("pairs"), 3);
  EXPECT_LT(answer.at("rms_px").get<double>(), 2.5);
  EXPECT_LT(std::abs(answer.at("known").at("left").at("focal_percent").get<double>()), 2.5);
  EXPECT_TRUE(read_json_file(file).value().contains("left_to_right"));
}

}  // namespace
}  // namespace glisson::test
