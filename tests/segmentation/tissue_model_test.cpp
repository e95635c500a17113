// What is learnt of an image's greys, against the same greys sorted.

#include "segmentation/internal/tissue_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace glisson::segmentation {

TEST(GreyContrast, LeavesATailOfFiniteValuesOutOnEitherSide) {
  std::mt19937 random(3);
  for (const std::size_t count : {1U, 2U, 49U, 50U, 101U, 5000U}) {
    std::vector<float> values(count);
    for (float& value : values) value = std::normal_distribution<float>(40, 20)(random);
    std::vector<float> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    values.push_back(std::numeric_limits<float>::quiet_NaN());
    values.push_back(-std::numeric_limits<float>::infinity());
    const GreyContrast contrast = contrast_of_values(values);
    EXPECT_EQ(contrast.low, static_cast<double>(sorted[count / 50])) << count;
    EXPECT_EQ(contrast.high, static_cast<double>(sorted[count - 1 - count / 50])) << count;
    EXPECT_EQ(contrast.has_any, count > 1) << count;
  }
  EXPECT_FALSE(contrast_of_values({NAN}).has_any);
}

}  // namespace glisson::segmentation
