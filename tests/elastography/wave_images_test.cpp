// Phase images into directions and instants, by what the headers say and what a person adds.

#include "elastography/wave_images.h"

#include <gmock/gmock.h>
#include <numbers>

namespace glisson::elastography {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

// A volume of one voxel that holds `value`.
PhaseImage image(float value, imaging::MotionEncoding motion = {}, int series = 0, const std::string& unit = "rad") {
  PhaseImage made;
  made.volume.grid.size = {1, 1, 1};
  made.volume.values = {value};
  made.volume.unit = unit;
  made.motion = std::move(motion);
  made.series = series;
  return made;
}

imaging::MotionEncoding motion(double frequency_Hz, int direction, int offset) {
  return {frequency_Hz, direction, Eigen::Vector3d::Unit(direction), offset};
}

TEST(SortWaves, FollowsTheHeadersWhateverTheOrderOfTheVolumes) {
  std::vector<PhaseImage> images;
  for (int offset = 3; offset >= 0; --offset) {
    for (const int direction : {1, 0}) {
      images.push_back(image(static_cast<float>(10 * direction + offset), motion(50, direction, offset)));
    }
  }
  const auto sorted = sort_waves(images);
  ASSERT_TRUE(sorted.has_value()) << sorted.error().message();
  ASSERT_THAT(sorted->frequencies, SizeIs(1));
  const WaveImages& waves = sorted->frequencies.front();
  EXPECT_EQ(waves.frequency_Hz, 50);
  ASSERT_THAT(waves.phase_rad, SizeIs(2));
  for (std::size_t direction = 0; direction < 2; ++direction) {
    for (std::size_t offset = 0; offset < 4; ++offset) {
      EXPECT_EQ(waves.phase_rad[direction][offset][0], static_cast<float>(10 * direction + offset));
    }
    EXPECT_EQ(waves.along[direction], Eigen::Vector3d::Unit(static_cast<int>(direction)));
  }
  EXPECT_THAT(messages(sorted->notes), testing::IsEmpty());
}

TEST(SortWaves, PartsSeveralFrequencies) {
  std::vector<PhaseImage> images;
  for (const double frequency_Hz : {60.0, 40.0}) {
    for (int offset = 0; offset < 4; ++offset) {
      images.push_back(image(static_cast<float>(frequency_Hz), motion(frequency_Hz, 0, offset)));
    }
  }
  const auto sorted = sort_waves(images, {.frequency_Hz = 99});  // stands against one frequency only
  ASSERT_TRUE(sorted.has_value());
  ASSERT_THAT(sorted->frequencies, SizeIs(2));
  EXPECT_EQ(sorted->frequencies[0].phase_rad[0][0][0], 40);
  EXPECT_EQ(sorted->frequencies[1].phase_rad[0][0][0], 60);
}

TEST(SortWaves, AsksForAFrequencyThatNoHeaderGives) {
  std::vector<PhaseImage> images(4, image(0));
  const auto refused = sort_waves(images);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, "waves-no-frequency");
  EXPECT_THAT(refused.error().advice(), HasSubstr("--frequency-Hz"));
  const auto sorted = sort_waves(images, {.frequency_Hz = 60});
  ASSERT_TRUE(sorted.has_value());
  EXPECT_EQ(sorted->frequencies[0].frequency_Hz, 60);
}

TEST(SortWaves, OneSeriesADirectionNeedsNoAsking) {
  std::vector<PhaseImage> images;
  for (int series = 0; series < 3; ++series) {
    for (int offset = 0; offset < 4; ++offset) images.push_back(image(static_cast<float>(series), {}, series));
  }
  const auto sorted = sort_waves(images, {.frequency_Hz = 60});
  ASSERT_TRUE(sorted.has_value());
  ASSERT_THAT(sorted->frequencies[0].phase_rad, SizeIs(3));
  for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(sorted->frequencies[0].phase_rad[d][3][0], static_cast<float>(d));
  EXPECT_THAT(sorted->frequencies[0].along, testing::IsEmpty());
}

TEST(SortWaves, AsksHowManyDirectionsALongSeriesHolds) {
  std::vector<PhaseImage> images;
  for (int v = 0; v < 24; ++v) images.push_back(image(static_cast<float>(v)));
  EXPECT_EQ(sort_waves(images, {.frequency_Hz = 60}).error().code, "waves-no-directions");
  EXPECT_EQ(sort_waves(images, {.frequency_Hz = 60, .directions = 5}).error().code, "waves-uneven");
  const auto sorted = sort_waves(images, {.frequency_Hz = 60, .directions = 3});
  ASSERT_TRUE(sorted.has_value());
  EXPECT_EQ(sorted->frequencies[0].phase_rad[2][7][0], 23);
  EXPECT_THAT(messages(sorted->notes), ElementsAre(HasSubstr("3 x 8")));
}

TEST(SortWaves, PhaseWithoutAUnitIsScaledToOneTurnAndSaysSo) {
  std::vector<PhaseImage> images;
  for (const float value : {0.0F, 1024.0F, 2048.0F, 4096.0F}) images.push_back(image(value, {}, 0, ""));
  const auto sorted = sort_waves(images, {.frequency_Hz = 60});
  ASSERT_TRUE(sorted.has_value());
  const auto& phase = sorted->frequencies[0].phase_rad[0];
  EXPECT_NEAR(phase[0][0], -std::numbers::pi, 1e-6);
  EXPECT_NEAR(phase[2][0], 0, 1e-6);
  EXPECT_NEAR(phase[3][0], std::numbers::pi, 1e-6);
  EXPECT_THAT(messages(sorted->notes), testing::Contains(HasSubstr("one turn")));
}

TEST(SortWaves, RefusesWhatIsNoWholeWave) {
  EXPECT_EQ(sort_waves({}).error().code, "waves-none");
  std::vector<PhaseImage> three;
  for (int offset = 0; offset < 3; ++offset) three.push_back(image(0, motion(60, 0, offset)));
  EXPECT_EQ(sort_waves(three).error().code, "waves-too-few-offsets");
  std::vector<PhaseImage> uneven;
  for (int offset = 0; offset < 9; ++offset) uneven.push_back(image(0, motion(60, offset / 5, offset % 5)));
  EXPECT_EQ(sort_waves(uneven).error().code, "waves-uneven");
  std::vector<PhaseImage> apart(4, image(0, motion(60, 0, 0)));
  apart[2].volume.grid.origin_mm.x() = 50;
  EXPECT_EQ(sort_waves(apart).error().code, "waves-grids-differ");
}

}  // namespace
}  // namespace glisson::elastography
