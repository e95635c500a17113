// The frequency, direction and instant that an elastography image was made for, from what its header says.

#include "imaging/internal/motion_encoding.h"

#include <gtest/gtest.h>

namespace glisson::imaging {
namespace {

TEST(MotionEncoding, FrequenciesAreFoundInFreeText) {
  EXPECT_EQ(frequency_in_text_Hz("MRE liver 60 Hz"), 60.0);
  EXPECT_EQ(frequency_in_text_Hz("ep2d_mre_50Hz_wave"), 50.0);
  EXPECT_EQ(frequency_in_text_Hz("f37.5hz"), 37.5);
  EXPECT_EQ(frequency_in_text_Hz("80_Hz"), 80.0);
}

TEST(MotionEncoding, OtherQuantitiesAreNoVibration) {
  EXPECT_FALSE(frequency_in_text_Hz("").has_value());
  EXPECT_FALSE(frequency_in_text_Hz("Hz").has_value());
  EXPECT_FALSE(frequency_in_text_Hz("bandwidth 250 kHz").has_value());
  EXPECT_FALSE(frequency_in_text_Hz("128 MHz").has_value());
  EXPECT_FALSE(frequency_in_text_Hz("0 Hz").has_value());
  EXPECT_FALSE(frequency_in_text_Hz("60 Hzoom").has_value());
}

TEST(MotionEncoding, CommentsThatAreCutOffOrForeignSayNothing) {
  EXPECT_FALSE(motion_in_comments("fI[0]dI[1]tI[2]VP[20000]").direction.has_value());
  const MotionEncoding cut = motion_in_comments("MRE: fI[0]dI[1]az[");
  EXPECT_EQ(cut.direction, 1);
  EXPECT_FALSE(cut.along.has_value());
  EXPECT_FALSE(cut.frequency_Hz.has_value());
  EXPECT_FALSE(motion_in_comments("MRE: dI[-3]VP[0]tI[1e99]").offset.has_value());
}

}  // namespace
}  // namespace glisson::imaging
