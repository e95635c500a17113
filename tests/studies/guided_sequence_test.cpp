// A patient's liver on a laparoscope's pictures: places that no picture shows are found where they truly are, and
// drawn.

#include "casefile/guided_sequence.h"

#include <gmock/gmock.h>
#include <numeric>

#include "anatomy/patient.h"
#include "base/files.h"
#include "base/json.h"
#include "guidance/guidance_answer.h"
#include "guidance/pose_search.h"
#include "studies/review/example_sequence.h"
#include "support/folders.h"
#include "support/liver_on_video.h"
#include "vision/masks.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr std::uint64_t patient_seed = 4;  // none that guidance was tuned with
constexpr int frames = 11;                 // half a breath: from rest to where it lies lowest
constexpr std::size_t every = 2;

registration_quality::SequenceFiles every_second(const registration_quality::SequenceFiles& all) {
  registration_quality::SequenceFiles some;
  some.camera = all.camera;
  for (const auto& track : all.landmarks) some.landmarks.push_back({track.id, {}});
  for (std::size_t f = 0; f < all.clouds.size(); f += every) {
    some.clouds.push_back(all.clouds[f]);
    some.images.push_back(all.images[f]);
    for (std::size_t k = 0; k < all.landmarks.size(); ++k) {
      some.landmarks[k].positions_mm.push_back(all.landmarks[k].positions_mm[f]);
    }
  }
  return some;
}

class GuidedSequenceTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    ExampleSequenceOptions options;
    options.frames = frames;
    options.patient = patient_seed;
    const auto file = write_example_sequence(folder_->path() / "video", options);
    ASSERT_TRUE(file) << file.error().message();
    sequence_ = registration_quality::read_sequence(*file).value();
    anatomy::PatientOptions patient;
    patient.seed = patient_seed;
    model_ = test::liver_model(anatomy::make_liver_surface(patient).value(), 6000,
                               test::places_in(file->parent_path() / "hidden.csv"));
    truth_mm_ = test::places_in(file->parent_path() / "hidden-truth.csv");
    const Json truth = read_json_file(file->parent_path() / "truth.json").value();
    pose_ = *guidance::rigid_pose(truth["patient_to_camera"].get<std::vector<double>>());
  }
  static void TearDownTestSuite() { folder_.reset(); }

  // Distance of each hidden place of a frame from where it truly is.
  static std::vector<double> errors_mm(std::size_t frame, const std::vector<Vector3d>& found_mm) {
    std::vector<double> errors;
    const std::size_t places = truth_mm_.size() / frames;
    for (std::size_t k = 0; k < places; ++k) errors.push_back((found_mm[k] - truth_mm_[frame * places + k]).norm());
    return errors;
  }
  static double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline registration_quality::SequenceFiles sequence_;
  static inline casefile::PatientModel model_;
  static inline std::vector<Vector3d> truth_mm_;
  static inline Isometry3d pose_;
};

TEST_F(GuidedSequenceTest, FollowsWhatNoPictureShowsFromFrameToFrame) {
  Isometry3d about = pose_;  // as somebody would lay it on the picture by hand
  about.rotate(Eigen::AngleAxisd(0.1, Vector3d(1, -1, 2).normalized()));
  about.pretranslate(pose_ * model_.landmarks.front().position_mm - about * model_.landmarks.front().position_mm);
  about.pretranslate(Vector3d(5, -4, 6));
  const registration_quality::SequenceFiles some = every_second(sequence_);
  const auto guided = casefile::guided_sequence(model_, some, about);
  ASSERT_TRUE(guided) << guided.error().message();
  const auto answer = guidance::answer(guided->guidance);
  ASSERT_TRUE(answer) << answer.error().message();
  ASSERT_EQ(answer->frames.size(), some.clouds.size());
  std::vector<guidance::ElasticPlacement> placements;
  double guided_mm = 0, left_mm = 0, worst_mm = 0;
  int within = 0, all = 0;
  for (std::size_t f = 0; f < answer->frames.size(); ++f) {
    const guidance::ElasticPlacement& placed = answer->frames[f].placement;
    ASSERT_TRUE(placed.converged) << placed.why_not.message();
    const std::vector<double> errors = errors_mm(every * f, placed.target_mm);
    std::vector<Vector3d> at_rest;
    for (const auto& landmark : model_.landmarks) at_rest.push_back(pose_ * landmark.position_mm);
    const double left = mean(errors_mm(every * f, at_rest));
    guided_mm += mean(errors) / static_cast<double>(some.clouds.size());
    worst_mm = std::max(worst_mm, mean(errors));
    left_mm += left / static_cast<double>(some.clouds.size());
    for (std::size_t k = 0; k < errors.size(); ++k, ++all) within += errors[k] < 2.5 * placed.target_sd_mm[k] ? 1 : 0;
    std::printf("frame %zu: error %.2f mm, at rest %.2f mm, %.2f s\n", f, mean(errors), left,
                answer->frames[f].seconds);
    placements.push_back(placed);
  }
  std::printf("mean %.2f mm, worst %.2f mm (left at rest: %.2f), %d of %d within 2.5 sd\n", guided_mm, worst_mm,
              left_mm, within, all);
  EXPECT_LT(guided_mm, 5.0);            // the line that matters
  EXPECT_LT(guided_mm, 0.7 * left_mm);  // than leaving it where it lay
  EXPECT_GT(within, all * 8 / 10);

  const auto pictures = casefile::write_overlays(folder_->path() / "drawn", *guided, some, placements);
  ASSERT_TRUE(pictures) << pictures.error().message();
  ASSERT_EQ(pictures->size(), some.images.size());
  const vision::Frame before = vision::read_frame(sequence_.images.front()).value();
  const vision::Frame drawn = vision::read_frame(pictures->front()).value();
  std::size_t changed = 0;
  for (std::size_t i = 0; i < before.rgb.size(); i += 3) {
    changed += std::abs(before.rgb[i] - drawn.rgb[i]) + std::abs(before.rgb[i + 1] - drawn.rgb[i + 1]) > 24 ? 1 : 0;
  }
  EXPECT_GT(changed, 300u);                       // a line around the liver
  EXPECT_LT(changed, before.rgb.size() / 3 / 5);  // and no more than lines
}

// From any frame on: those after it, then those before it.
TEST_F(GuidedSequenceTest, BeginsWhereItWasLaidByHand) {
  registration_quality::SequenceFiles some = every_second(sequence_);
  const auto guided = casefile::guided_sequence(model_, some, pose_, 0.5, 2);
  ASSERT_TRUE(guided) << guided.error().message();
  EXPECT_THAT(guided->frame_of, testing::ElementsAre(2, 3, 4, 5, 1, 0));
  EXPECT_TRUE(guided->guidance.frames.front().pose_guess);
  EXPECT_EQ(guided->guidance.frames.front().id, "f002");
  std::vector<std::string> heard;
  const auto modes = guidance::ForceModes::create(guided->guidance.mesh, guided->guidance.youngs_kPa, 0.45);
  ASSERT_TRUE(modes);
  const auto answer = guidance::answer(*modes, guided->guidance, {}, [&](std::size_t frame, const auto& one) {
    EXPECT_EQ(frame, heard.size());
    heard.push_back(one.id);
    if (!one.placement.converged) return;
    // Each outline knows its error, and it is that of the targets about it.
    const auto overlay = casefile::overlay_of(*guided, some, guided->frame_of[frame], one.placement);
    ASSERT_TRUE(overlay) << overlay.error().message();
    EXPECT_EQ(overlay->width, 640);
    ASSERT_EQ(overlay->outlines.size(), 1u);
    EXPECT_GT(overlay->outlines.front().sd_mm, 0.2);
    EXPECT_LT(overlay->outlines.front().sd_mm, 20);
  });
  ASSERT_TRUE(answer);
  EXPECT_THAT(heard, testing::ElementsAre("f002", "f003", "f004", "f005", "f001", "f000"));
  EXPECT_LT(mean(errors_mm(every * 2, answer->frames.front().placement.target_mm)), 5.0);
  EXPECT_LT(mean(errors_mm(0, answer->frames.back().placement.target_mm)), 5.0);
}

// The laparoscope is drawn out and comes back rolled, where no landmark is followed any more: the liver is lost, and
// found again.
TEST_F(GuidedSequenceTest, FindsALostLiverAgain) {
  auto guided = casefile::guided_sequence(model_, every_second(sequence_), pose_).value();
  const Isometry3d jump(Eigen::AngleAxisd(1.5, Vector3d::UnitZ()));  // of the liver before the camera
  constexpr std::size_t back = 3;
  for (std::size_t f = back; f < guided.guidance.frames.size(); ++f) {
    guidance::SeenFrame& frame = guided.guidance.frames[f];
    for (Vector3d& point : frame.points_mm) point = jump * point;
    frame.tracked.clear();
  }
  const auto answer = guidance::answer(guided.guidance);
  ASSERT_TRUE(answer) << answer.error().message();
  for (std::size_t f = 0; f < answer->frames.size(); ++f) {
    const guidance::ElasticPlacement& placed = answer->frames[f].placement;
    ASSERT_TRUE(placed.converged) << f << ' ' << placed.why_not.message();
    std::vector<Vector3d> found_mm = placed.target_mm;
    if (f >= back) {
      for (Vector3d& place : found_mm) place = jump.inverse() * place;
    }
    std::printf("frame %zu: error %.2f mm\n", f, mean(errors_mm(every * f, found_mm)));
    EXPECT_LT(mean(errors_mm(every * f, found_mm)), f < back ? 5.0 : 12.0);  // by clouds alone it slides unseen
  }
}

// A frame of something else is no place of the liver: nothing is answered, and the next one is followed again.
TEST_F(GuidedSequenceTest, SaysWhereTheLiverIsLost) {
  auto guided = casefile::guided_sequence(model_, every_second(sequence_), pose_).value();
  guidance::SeenFrame& covered = guided.guidance.frames[2];
  covered.tracked.clear();
  for (Vector3d& point : covered.points_mm) point.z() = point.z() * 0.1 + 100;  // a cloth before the lens
  const auto answer = guidance::answer(guided.guidance);
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_FALSE(answer->frames[2].placement.converged);
  EXPECT_FALSE(answer->frames[2].placement.why_not.text.empty());
  ASSERT_TRUE(answer->frames[3].placement.converged);
  EXPECT_LT(mean(errors_mm(every * 3, answer->frames[3].placement.target_mm)), 5.0);
}

// The instrument is told from the tissue as stereo tells it: where the cloud has a hole within the liver, there it is.
TEST_F(GuidedSequenceTest, OutlinesStayBelowTheInstrumentOfThePicture) {
  constexpr int step = 10;  // px between the clouds' points
  std::size_t holes = 0, found = 0, tissue = 0, mistaken = 0;
  for (std::size_t f = 0; f < sequence_.clouds.size(); ++f) {
    const auto cloud = registration_quality::read_cloud(sequence_.clouds[f]).value();
    const vision::Frame picture = vision::read_frame(sequence_.images[f]).value();
    const auto tool = vision::tool_pixels(picture);
    const int columns = picture.width / step, rows = picture.height / step;
    std::vector<bool> seen(static_cast<std::size_t>(columns * rows), false);
    for (const auto& pixel : vision::project(*sequence_.camera, cloud.points_mm)) {
      const auto column = std::lround(pixel->x() / step), row = std::lround(pixel->y() / step);
      if (column < columns && row < rows) seen[static_cast<std::size_t>(column + columns * row)] = true;
    }
    const auto any = [&](int column, int row, int right, int down) {
      for (column += right, row += down; column >= 0 && row >= 0 && column < columns && row < rows;
           column += right, row += down) {
        if (seen[static_cast<std::size_t>(column + columns * row)]) return true;
      }
      return false;
    };
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const bool is_tool = tool[static_cast<std::size_t>(column * step + picture.width * row * step)] != 0;
        if (seen[static_cast<std::size_t>(column + columns * row)]) {
          ++tissue;
          mistaken += is_tool ? 1 : 0;
        } else if (any(column, row, 1, 0) && any(column, row, -1, 0) && any(column, row, 0, 1) &&
                   any(column, row, 0, -1)) {
          ++holes;
          found += is_tool ? 1 : 0;
        }
      }
    }
  }
  std::printf("instrument: %zu of %zu found, %zu of %zu places of tissue taken for it\n", found, holes, mistaken,
              tissue);
  ASSERT_GT(holes, 100u);
  EXPECT_GT(found, holes * 9 / 10);
  EXPECT_LT(mistaken, tissue / 50);
}

// Without a guess each frame by itself says where the liver lies.
TEST_F(GuidedSequenceTest, WithoutAGuessItIsFoundInEachFrame) {
  const geometry::Surface surface = geometry::boundary_surface(model_.mesh);
  const auto guided = casefile::guided_sequence(model_, sequence_, std::nullopt).value();
  for (std::size_t f = 0; f < guided.guidance.frames.size(); f += every) {
    const auto pose = guidance::find_pose(surface, guided.guidance.frames[f]);
    ASSERT_TRUE(pose) << pose.error().message();
    std::vector<Vector3d> found_mm;
    for (const auto& landmark : model_.landmarks) found_mm.push_back(*pose * landmark.position_mm);
    std::printf("frame %zu: first pose %.2f mm off\n", f, mean(errors_mm(f, found_mm)));
    EXPECT_LT(mean(errors_mm(f, found_mm)), 10.0);  // of a pose alone: the liver deforms by up to 12
  }
}

}  // namespace
}  // namespace glisson::studies
