// Landmarks followed through a stereo video whose truth is known, with a real picture of tissue as its texture.

#include "vision/tracks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>

#include "support/data.h"
#include "support/stereo_video.h"

namespace glisson::vision {
namespace {

using glisson::test::StereoVideo;

StereoVideo video() {
  return StereoVideo(
      read_frame(glisson::test::shared_data() / "hamlyn_heart_stereo" / "f7_dynamic_deint_L_0100.png").value());
}

// How far each sighting is from where the place of the track's first sighting has gone.
std::vector<double> errors_mm(const Track& track) {
  std::vector<double> errors;
  std::optional<Eigen::Vector2d> rest_mm;
  for (int t = 0; t < static_cast<int>(track.positions_mm.size()); ++t) {
    const auto& seen = track.positions_mm[static_cast<std::size_t>(t)];
    if (!seen) continue;
    if (!rest_mm) rest_mm = StereoVideo::rest_mm(*seen, t);
    errors.push_back((*seen - StereoVideo::place_mm(rest_mm->x(), rest_mm->y(), t)).norm());
  }
  return errors;
}

// A pixel of disparity is 2 mm of depth here, and SIFT finds a feature to some tenths of a pixel.
TEST(Tracks, FollowTissueThatBreathes) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const StereoVideo seen = video();
  LandmarkTracker tracker(StereoVideo::calibration());
  constexpr int frames = 12;
  for (int t = 0; t < frames; ++t) ASSERT_TRUE(tracker.add(seen.left(t), seen.right(t)));
  const auto tracks = tracker.tracks();
  ASSERT_GT(tracks.size(), 60u);
  std::vector<double> errors;
  std::size_t sightings = 0;
  for (const Track& track : tracks) {
    ASSERT_EQ(track.positions_mm.size(), static_cast<std::size_t>(frames));
    const auto of_track = errors_mm(track);
    sightings += of_track.size();
    errors.insert(errors.end(), of_track.begin(), of_track.end());
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.7);
  EXPECT_LT(errors[errors.size() * 95 / 100], 3);
  EXPECT_GT(static_cast<double>(sightings) / static_cast<double>(tracks.size()), 0.6 * frames);
  fmt::print("landmarks off, mm (median, 95 %) of {}: {:.2f}, {:.2f}\n", tracks.size(), errors[errors.size() / 2],
             errors[errors.size() * 95 / 100]);
}

// A grey bar before the left third of both pictures, for three frames.
TEST(Tracks, SurviveAToolThatPasses) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const StereoVideo seen = video();
  LandmarkTracker tracker(StereoVideo::calibration(), {.shortest_track = 4});
  const auto hide = [](Frame frame) {
    for (int y = 0; y < frame.height; ++y)
      for (int x = 150; x < 330; ++x) std::fill_n(frame.at(x, y), 3, std::uint8_t{128});
    return frame;
  };
  for (int t = 0; t < 9; ++t) {
    const bool hidden = t >= 3 && t < 6;
    ASSERT_TRUE(tracker.add(hidden ? hide(seen.left(t)) : seen.left(t), hidden ? hide(seen.right(t)) : seen.right(t)));
  }
  int bridged = 0, wrong = 0;
  for (const Track& track : tracker.tracks()) {
    const auto was_seen = [&](int from, int to) {
      return std::any_of(track.positions_mm.begin() + from, track.positions_mm.begin() + to,
                         [](const auto& position) { return position.has_value(); });
    };
    if (!was_seen(0, 3) || was_seen(3, 6) || !was_seen(6, 9)) continue;
    ++bridged;
    const auto errors = errors_mm(track);
    if (errors.back() > 4) ++wrong;
  }
  EXPECT_GT(bridged, 15);
  EXPECT_LE(wrong, bridged / 20);
}

TEST(Tracks, OfNothingAreNone) {
  LandmarkTracker tracker(StereoVideo::calibration());
  const Frame blank{64, 48, std::vector<std::uint8_t>(3 * 64 * 48, 90)};
  EXPECT_TRUE(tracker.add(blank, blank));
  EXPECT_TRUE(tracker.tracks().empty());
  const Frame small{32, 24, std::vector<std::uint8_t>(3 * 32 * 24, 90)};
  EXPECT_EQ(tracker.add(blank, small).error().code, "stereo-image-sizes");
}

}  // namespace
}  // namespace glisson::vision
