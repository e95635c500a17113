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

TEST(GreyContrast, IsThatOfSomeValuesWhereThereAreMany) {
  std::mt19937 random(5);
  std::vector<float> values(6'000'000);
  for (float& value : values) value = std::normal_distribution<float>(40, 20)(random);
  const GreyContrast contrast = contrast_of_values(values);
  // The fiftieths of a normal distribution lie 2.0537 deviations off; a million and a half tell them to a hundredth.
  EXPECT_NEAR(contrast.low, 40 - 2.0537 * 20, 0.01 * 20);
  EXPECT_NEAR(contrast.high, 40 + 2.0537 * 20, 0.01 * 20);
}

}  // namespace glisson::segmentation
