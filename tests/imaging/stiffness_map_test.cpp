// Pa or kPa, and never a guess.

#include "imaging/stiffness_map.h"

#include <gmock/gmock.h>

namespace glisson::imaging {
namespace {

using testing::HasSubstr;

Volume map_of(std::vector<float> values, const std::string& unit) {
  Volume volume;
  volume.grid.size = {static_cast<int>(values.size()), 1, 1};
  volume.values = std::move(values);
  volume.unit = unit;
  return volume;
}

TEST(StiffnessMap, TurnsPascalIntoKilopascal) {
  const Result<StiffnessMap> map = stiffness_in_kPa(map_of({0, 2100, 2600}, "Pa"), "RescaleType is Pa");
  ASSERT_TRUE(map.has_value());
  EXPECT_FLOAT_EQ(map->shear_kPa.values[1], 2.1F);
  EXPECT_EQ(map->shear_kPa.unit, "kPa");
  EXPECT_THAT(map->evidence, AllOf(HasSubstr("RescaleType is Pa"), HasSubstr("2600")));
}

TEST(StiffnessMap, TakesTheUnitFromTheSizeOfTheValuesWhereNoneIsGiven) {
  EXPECT_FLOAT_EQ(stiffness_in_kPa(map_of({0, 2.1F, 2.6F}, ""))->shear_kPa.values[2], 2.6F);
  EXPECT_FLOAT_EQ(stiffness_in_kPa(map_of({0, 2100, 2600}, ""))->shear_kPa.values[2], 2.6F);
}

TEST(StiffnessMap, RefusesAUnitThatTheValuesContradict) {
  EXPECT_EQ(stiffness_in_kPa(map_of({2100, 2600}, "kPa")).error().code, "stiffness-unit-contradicted");
  EXPECT_EQ(stiffness_in_kPa(map_of({2.1F, 2.6F}, "Pa")).error().code, "stiffness-unit-contradicted");
}

TEST(StiffnessMap, RefusesWhatCannotBeDecided) {
  // 150 kPa is stiffer than any soft tissue and 150 Pa softer.
  EXPECT_EQ(stiffness_in_kPa(map_of({150, 150}, "")).error().code, "stiffness-unit-unknown");
  EXPECT_EQ(stiffness_in_kPa(map_of({1e6F, 1e6F}, "")).error().code, "stiffness-unit-unknown");
  EXPECT_EQ(stiffness_in_kPa(map_of({2, 3}, "HU")).error().code, "stiffness-unit-foreign");
  EXPECT_EQ(stiffness_in_kPa(map_of({0, -1}, "kPa")).error().code, "stiffness-empty");
}

TEST(StiffnessMap, LeavesZeroWhereNothingWasMeasured) {
  const auto map = stiffness_in_kPa(map_of({-3, std::numeric_limits<float>::quiet_NaN(), 2, 3}, "kPa"));
  ASSERT_TRUE(map.has_value());
  EXPECT_EQ(map->shear_kPa.values[0], 0);
  EXPECT_EQ(map->shear_kPa.values[1], 0);
}

}  // namespace
}  // namespace glisson::imaging
