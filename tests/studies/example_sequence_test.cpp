// The example sequence: judged as any other, it shows the fault that was put into it, and where.

#include "studies/review/example_sequence.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/json.h"
#include "registration_quality/register_sequence.h"
#include "support/folders.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;

ExampleSequenceOptions small_sequence() {
  ExampleSequenceOptions options;
  options.frames = 20;  // one breath
  options.step_px = 14;
  options.outlier_share = 0;
  return options;
}

// Mean correlation within the fault's radius, and on the other side of the picture (deep behind the fault lies what few
// frames show, judged badly for reasons of its own).
std::pair<double, double> near_and_far(const registration_quality::Quality& quality, const Eigen::Vector3d& fault_mm,
                                       double radius_mm) {
  double sum[2] = {0, 0};
  int count[2] = {0, 0};
  for (std::size_t k = 0; k < quality.correlation.size(); ++k) {
    if (quality.frames_seen[k] < registration_quality::fewest_frames) continue;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int corner : quality.mesh.triangles[k])
      middle += quality.mesh.points_mm[static_cast<std::size_t>(corner)] / 3;
    const bool near = (middle - fault_mm).norm()<radius_mm, far = middle.x()> fault_mm.x() + 2 * radius_mm;
    if (!near && !far) continue;
    const int side = near ? 0 : 1;
    sum[side] += quality.correlation[k];
    ++count[side];
  }
  EXPECT_GT(count[0], 5);
  EXPECT_GT(count[1], 5);
  return {sum[0] / count[0], sum[1] / count[1]};
}

TEST(ExampleSequence, ShowsSirgnTheFaultThatItHolds) {
  const TemporaryFolder folder;
  const auto file = write_example_sequence(folder.path() / "example", small_sequence());
  ASSERT_TRUE(file.has_value()) << file.error().message();
  const auto files = registration_quality::read_sequence(*file);
  ASSERT_TRUE(files.has_value()) << files.error().message();
  EXPECT_TRUE(files->simulated.starts_with("SIMULATED"));
  EXPECT_EQ(files->clouds.size(), 20u);
  EXPECT_TRUE(files->camera.has_value());
  for (const auto& image : files->images) EXPECT_TRUE(fs::exists(image));

  const auto registered = registration_quality::register_sequence(*files, registration_quality::SequenceMethod::given);
  ASSERT_TRUE(registered.has_value()) << registered.error().message();
  const auto quality = registration_quality::sirgn(*registered);
  ASSERT_TRUE(quality.has_value()) << quality.error().message();
  const Json truth = read_json_file(file->parent_path() / "truth.json").value();
  const auto center = truth.at("fault_center_mm").get<std::vector<double>>();
  const auto [near, far] =
      near_and_far(*quality, {center[0], center[1], center[2]}, truth.at("fault_radius_mm").get<double>());
  EXPECT_LT(near, far - 0.25);
}

TEST(ExampleSequence, WithoutAFaultIsRegisteredTruly) {
  const TemporaryFolder folder;
  ExampleSequenceOptions options = small_sequence();
  options.fault_mm = 0;
  const auto file = write_example_sequence(folder.path() / "example", options).value();
  const auto registered = registration_quality::register_sequence(registration_quality::read_sequence(file).value(),
                                                                  registration_quality::SequenceMethod::given)
                              .value();
  const registration_quality::Quality quality = registration_quality::sirgn(registered).value();
  // What is left is the noise of clouds and tracks, 0.3 mm a coordinate, and what lies between a cloud's points.
  for (const double tre_mm : quality.tre_mm) EXPECT_LT(tre_mm, 1.0);
  EXPECT_GT(quality.mean_correlation, 0.9);
}

TEST(ExampleSequence, IsTheSameFromTheSameSeed) {
  const TemporaryFolder folder;
  ExampleSequenceOptions options = small_sequence();
  options.frames = 3;
  const auto a = write_example_sequence(folder.path() / "a", options).value();
  const auto b = write_example_sequence(folder.path() / "b", options).value();
  for (const char* name : {"tracks.csv", "f002.ply", "f002.jpg", "r002.ply"}) {
    EXPECT_EQ(sha256_of_file(a.parent_path() / name).value(), sha256_of_file(b.parent_path() / name).value()) << name;
  }
}

TEST(ExampleSequence, LeavesNothingBehindWhenItIsCancelled) {
  const TemporaryFolder folder;
  std::stop_source stop;
  const Progress progress([&](double, std::string_view) { stop.request_stop(); }, stop.get_token());
  const auto file = write_example_sequence(folder.path() / "example", small_sequence(), progress);
  ASSERT_FALSE(file.has_value());
  EXPECT_EQ(file.error().code, "cancelled");
  EXPECT_FALSE(fs::exists(folder.path() / "example"));
  // And a folder that holds something is not written into.
  ASSERT_TRUE(write_text_file(folder.path() / "mine.txt", "mine"));
  EXPECT_EQ(write_example_sequence(folder.path(), small_sequence()).error().code, "sequence-folder-not-empty");
  EXPECT_TRUE(fs::exists(folder.path() / "mine.txt"));
}

}  // namespace
}  // namespace glisson::studies
