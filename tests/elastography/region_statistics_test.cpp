#include "elastography/region_statistics.h"

#include <gtest/gtest.h>
#include <cmath>

#include "imaging/volume_file.h"
#include "support/data.h"

namespace glisson::elastography {
namespace {

TEST(RegionStatistics, OfKnownNumbers) {
  std::vector<double> values;
  for (int n = 100; n >= 0; --n) values.push_back(n);
  values.push_back(std::nan(""));
  const auto found = statistics_of(values);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->voxels, 101U);
  EXPECT_EQ(found->voxels_left_out, 1U);
  EXPECT_DOUBLE_EQ(found->mean, 50);
  // sum of n^2 from -50 to 50 is 85850; / 100
  EXPECT_DOUBLE_EQ(found->sd, std::sqrt(858.5));
  EXPECT_DOUBLE_EQ(found->percentile_5, 5);
  EXPECT_DOUBLE_EQ(found->median, 50);
  EXPECT_DOUBLE_EQ(found->percentile_95, 95);
  EXPECT_EQ(found->min, 0);
  EXPECT_EQ(found->max, 100);
}

TEST(RegionStatistics, RefusesAnEmptyRegionAndAnotherGrid) {
  imaging::Volume map;
  map.grid.size = {2, 2, 2};
  map.values.assign(8, 1.0F);
  imaging::Mask region{map.grid, std::vector<std::uint8_t>(8, 0)};
  EXPECT_EQ(region_statistics(map, region).error().code, "region-empty");
  region.grid.origin_mm.x() = 5;
  EXPECT_EQ(region_statistics(map, region).error().code, "region-grids-differ");
}

// Brains of healthy adults at 50 Hz: about 2.5 to 3.5 kPa (Hiscox et al. 2020). The files hold Pa.
TEST(RegionStatistics, OfARealStiffnessMapArePlausible) {
  GLISSON_NEEDS_DATA("mre134_brain_maps");
  std::size_t maps = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(test::shared_data() / "mre134_brain_maps" / "individual")) {
    const std::string name = entry.path().filename().string();
    if (name.find("tiff") == std::string::npos || !name.ends_with(".nii.gz")) continue;
    const auto map = imaging::read_volume_file(entry.path());
    ASSERT_TRUE(map) << map.error().message();
    imaging::Mask brain{map->grid, std::vector<std::uint8_t>(map->values.size())};
    for (std::size_t voxel = 0; voxel < brain.values.size(); ++voxel) brain.values[voxel] = map->values[voxel] > 0;
    const auto found = region_statistics(*map, brain);
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_GT(found->voxels, 100000U) << name;  // 1.2 l of brain in voxels of 8 mm3
    EXPECT_GT(found->median, 2000) << name;
    EXPECT_LT(found->median, 4000) << name;
    EXPECT_LT(found->percentile_5, found->percentile_95);
    ++maps;
  }
  EXPECT_GT(maps, 0U);
}

}  // namespace
}  // namespace glisson::elastography
