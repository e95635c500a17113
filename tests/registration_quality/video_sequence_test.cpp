// A stereo video end to end: pictures to clouds, tracks and model, registered and judged.

#include "registration_quality/video_sequence.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <cstdlib>

#include "base/files.h"
#include "geometry/mesh_file.h"
#include "registration/register.h"
#include "registration_quality/register_sequence.h"
#include "registration_quality/sequence_file.h"
#include "registration_quality/sirgn.h"
#include "support/data.h"
#include "support/stereo_video.h"

namespace glisson::registration_quality {
namespace {

using glisson::test::StereoVideo;

constexpr const char* simulated = "SIMULATED: a real picture on tissue that breathes by a formula.";

// The video's pictures in two folders, the breathing tissue of tests/support with a real picture on it.
class VideoFolders {
 public:
  explicit VideoFolders(int frames) {
    const StereoVideo video(
        vision::read_frame(glisson::test::shared_data() / "hamlyn_heart_stereo" / "f7_dynamic_deint_L_0100.png")
            .value());
    std::filesystem::create_directories(left());
    std::filesystem::create_directories(right());
    for (int t = 0; t < frames; ++t) {
      EXPECT_TRUE(vision::write_frame(video.left(2 * t), left() / ("f" + std::to_string(t) + ".png")));
      EXPECT_TRUE(vision::write_frame(video.right(2 * t), right() / ("f" + std::to_string(t) + ".png")));
    }
  }
  [[nodiscard]] std::filesystem::path left() const { return folder_.path() / "left"; }
  [[nodiscard]] std::filesystem::path right() const { return folder_.path() / "right"; }
  // For docs/examples/python/sequence_from_video.py.
  void keep_in(const std::filesystem::path& folder) const {
    std::filesystem::create_directories(folder);
    std::filesystem::copy(folder_.path(), folder, std::filesystem::copy_options::recursive);
    EXPECT_TRUE(vision::write_stereo_calibration(folder / "camera.json", StereoVideo::calibration()));
  }
  [[nodiscard]] std::filesystem::path out() const { return folder_.path() / "sequence"; }
  [[nodiscard]] Result<VideoSequence> make(const VideoSequenceOptions& options, const Progress& progress = {},
                                           const FrameMatched& matched = {}) const {
    auto video = vision::StereoSource::open({left(), right()}).value();
    vision::StereoCalibration calibration = StereoVideo::calibration();
    calibration.simulated = simulated;
    return make_sequence(video, calibration, out(), options, progress, matched);
  }

 private:
  TemporaryFolder folder_;
};

TEST(VideoSequence, GoesFromPicturesToAJudgedRegistration) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const VideoFolders video(5);
  if (const char* kept = std::getenv("GLISSON_KEEP_SEQUENCES")) video.keep_in(std::filesystem::path(kept) / "video");
  VideoSequenceOptions options;
  options.stereo.step_px = 8;
  const auto made = video.make(options);
  ASSERT_TRUE(made.has_value()) << made.error().message();
  EXPECT_EQ(made->frames, 5);
  EXPECT_GT(made->landmarks, 30);
  EXPECT_LT(made->epipolar_px, 1);
  EXPECT_LT((*made->alignment_rms_mm)[2], (*made->alignment_rms_mm)[0]);
  EXPECT_EQ(vision::read_stereo_calibration(video.out() / "camera.json").value().baseline_mm(),
            StereoVideo::baseline_mm);

  const SequenceFiles files = read_sequence(made->file).value();
  EXPECT_EQ(files.clouds.size(), 5u);
  ASSERT_TRUE(files.camera.has_value());
  EXPECT_EQ(files.camera->matrix(0, 0), StereoVideo::focal_px);
  EXPECT_EQ(files.simulated, simulated);
  RegisteredSequence sequence;
  sequence.landmarks = files.landmarks;
  sequence.model = geometry::read_surface(*files.model).value();
  for (const auto& file : files.clouds) {
    const geometry::Surface cloud = read_cloud(file).value();
    const auto registered = registration::register_surfaces(cloud, *sequence.model).value();
    sequence.frames.push_back({cloud.points_mm, registered.surface.points_mm});
  }
  ASSERT_TRUE(files.benchmark.has_value());
  sequence.benchmark = files.benchmark;
  const auto quality = sirgn(sequence);
  ASSERT_TRUE(quality.has_value()) << quality.error().message();
  EXPECT_TRUE(quality->against_benchmark);
  EXPECT_GT(quality->mesh.triangles.size(), 30u);

  // The alignment that is the benchmark, judged by landmarks that it was not fitted to
  // (docs/figures/stereo-video.json).
  const auto aligned = register_sequence(files, SequenceMethod::gnra);
  ASSERT_TRUE(aligned.has_value()) << aligned.error().message();
  const auto held_out = sirgn(*aligned);
  ASSERT_TRUE(held_out.has_value()) << held_out.error().message();
  EXPECT_FALSE(held_out->against_benchmark);
  double tre_mm = 0;
  for (const double of_frame_mm : held_out->tre_mm) tre_mm += of_frame_mm / 5;
  EXPECT_GT(tre_mm, (*made->alignment_rms_mm)[2]);
  fmt::print("{} landmarks agree within {:.2f} mm ({:.1f} before); icp {:.2f}, held out {:.2f}, {:.2f} mm\n",
             made->landmarks, (*made->alignment_rms_mm)[2], (*made->alignment_rms_mm)[0], quality->mean_correlation,
             held_out->mean_correlation, tre_mm);
}

TEST(VideoSequence, LeavesNothingWhereItFails) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const VideoFolders video(3);
  std::filesystem::remove(video.right() / "f2.png");
  EXPECT_EQ(video.make({}).error().code, "sequence-lengths");
  EXPECT_FALSE(std::filesystem::exists(video.out()));
  std::filesystem::create_directories(video.out());
  ASSERT_TRUE(write_text_file(video.out() / "mine.txt", "kept"));
  EXPECT_EQ(video.make({}).error().code, "sequence-folder-not-empty");
  EXPECT_TRUE(std::filesystem::exists(video.out() / "mine.txt"));
}

TEST(VideoSequence, TellsEachFrameAndLeavesNothingWhereItIsCancelled) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const VideoFolders video(5);
  VideoSequenceOptions options;
  options.stereo.step_px = 8;
  options.skip = 1;
  options.every = 2;
  std::stop_source stop;
  std::vector<int> numbers;
  const auto made = video.make(options, Progress({}, stop.get_token()), [&](const MatchedFrame& frame) {
    numbers.push_back(frame.number);
    EXPECT_GT(frame.cloud.points_mm.size(), 500u);
    EXPECT_EQ(frame.cloud.picture.width, StereoVideo::width);
    EXPECT_EQ(frame.followed > 30, numbers.size() > 1) << frame.followed;
    if (numbers.size() == 2) stop.request_stop();
  });
  EXPECT_EQ(numbers, (std::vector<int>{1, 3}));
  EXPECT_EQ(made.error().code, "cancelled");
  std::size_t left = 0;
  for (const auto& entry : std::filesystem::directory_iterator(video.out().parent_path())) {
    left += entry.path().filename() != "left" && entry.path().filename() != "right" ? 1 : 0;
  }
  EXPECT_EQ(left, 0u);
}

}  // namespace
}  // namespace glisson::registration_quality
