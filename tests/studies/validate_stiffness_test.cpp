// Section 4.6 from its own figures, and from a map whose regions are known.

#include "studies/dissertation/validate_stiffness.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "imaging/volume_file.h"

namespace glisson::studies {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Five of the six moduli that table 4.5 prints follow from its forces, ways and sizes; the sixth does not.
TEST(ValidateStiffness, TheDissertationsSamplesGiveTheModuliThatItPrintsButForOne) {
  const auto samples = dissertation_samples();
  ASSERT_TRUE(samples.has_value()) << samples.error().message();
  ASSERT_EQ(samples->size(), 6u);
  for (std::size_t n = 0; n < 5; ++n) {
    EXPECT_NEAR((*samples)[n].youngs_kPa() / (*samples)[n].stated_kPa, 1, 0.002) << n;
  }
  EXPECT_NEAR((*samples)[5].youngs_kPa(), 24.0, 0.05);  // 42.4 is printed
  const TemporaryFolder folder;
  const auto validation = validate_stiffness(dissertation_regions(), *samples, folder.path());
  ASSERT_TRUE(validation.has_value()) << validation.error().message();
  EXPECT_THAT(
      validation->notes,
      ElementsAre(HasSubstr("18.85 kPa is stated of it, while the median of what is stated of its samples is "
                            "18.16 kPa"),
                  HasSubstr("MRE is +5 % off what is stated, but +53 % off"), HasSubstr("42.40 kPa is stated")));
  ASSERT_EQ(validation->materials.size(), 2u);
  EXPECT_NEAR(validation->materials[0].machine_kPa, 18.163, 0.01);
  EXPECT_NEAR(validation->materials[0].difference_percent, -3.8, 0.1);
  EXPECT_NEAR(validation->materials[0].stated_kPa, 18.85, 1e-9);  // the caption's, which no sample has
  EXPECT_NEAR(validation->materials[0].stated_difference_percent, -7.3, 0.1);
  // By the printed moduli B agrees within 5 %, as the dissertation says; by the samples' own figures it does not.
  EXPECT_NEAR(validation->materials[1].stated_difference_percent, 5.0, 0.1);
  EXPECT_NEAR(validation->materials[1].difference_percent, 53, 1);
  EXPECT_THAT(read_text_file(folder.path() / "report.html").value(), HasSubstr("<svg"));
}

TEST(ValidateStiffness, RegionsOfAMapAreComparedAsYoungsModuli) {
  const TemporaryFolder folder;
  imaging::Volume map;
  map.unit = "kPa";
  map.grid.size = {8, 4, 1};
  imaging::Mask labels{map.grid, {}};
  for (int v = 0; v < 32; ++v) map.values.push_back(v % 8 < 4 ? 6.0F : 12.0F);
  for (int v = 0; v < 32; ++v) labels.values.push_back(v % 8 < 4 ? 1 : 0);
  ASSERT_TRUE(imaging::write_volume_file(folder.path() / "map.nrrd", map));
  ASSERT_TRUE(imaging::write_mask_file(folder.path() / "labels.nrrd", labels, {}));
  const auto regions = regions_of(folder.path() / "map.nrrd", folder.path() / "labels.nrrd", 0.5);
  ASSERT_TRUE(regions.has_value()) << regions.error().message();
  ASSERT_EQ(regions->size(), 1u);
  EXPECT_EQ(regions->front().voxels, 16u);
  EXPECT_NEAR(regions->front().youngs_kPa, 18, 1e-5);
  const CompressedSample sample{"1", 10, 5, 0.5, 141.37, 0};  // 1.8 kPa at a tenth
  const auto validation = validate_stiffness(*regions, {sample}, folder.path());
  ASSERT_TRUE(validation.has_value());
  EXPECT_NEAR(validation->largest_difference_percent, 0, 0.01);
}

TEST(ValidateStiffness, RefusesTestsThatCannotBe) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "tests.csv";
  ASSERT_TRUE(write_text_file(file, "material,diameter_mm,height_mm,displacement_mm,force_N\n1,5,4,0,0.1\n"));
  EXPECT_EQ(read_samples(file).error().code, "samples-impossible");
  ASSERT_TRUE(write_text_file(file, "material,diameter_mm,height_mm,force_N\n1,5,4,0.1\n"));
  EXPECT_THAT(read_samples(file).error().message(), HasSubstr("displacement_mm"));
  EXPECT_EQ(validate_stiffness({{"7", 10, 0, 0}}, {}, folder.path()).error().code, "validation-no-samples");
}

}  // namespace
}  // namespace glisson::studies
