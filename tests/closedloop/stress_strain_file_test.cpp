// Strain and stress for the data-driven solver, out of tables and experiments.

#include "closedloop/material/stress_strain_file.h"

#include <gmock/gmock.h>

#include "base/files.h"

namespace glisson::closedloop {
namespace {

TEST(StressStrainFile, ATableAndAnExperimentOfTheSameTestGiveTheSame) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "plain.csv", "strain,stress_kPa\n0,0\n-0.1,-0.7\n-0.2,-1.6\n"));
  ASSERT_TRUE(write_text_file(folder.path() / "a1.csv", "Time,stretch,stress\n0,1,0\n1,0.9,-0.7\n2,0.8,-1.6\n"));
  ASSERT_TRUE(write_text_file(folder.path() / "test.json", R"({"format": "glisson-experiment/1", "kind": "material",
      "title": "squeezed", "specimen": {"shape": "cylinder", "diameter_mm": 50, "height_mm": 30}, "mode": "compression",
      "declared": {"law": "linear", "youngs_modulus_kPa": 7}, "noise_kPa": 0.1,
      "trials": [{"id": "a1", "file": "a1.csv",
                  "columns": {"time_s": "Time", "stretch": "stretch", "stress_kPa": "stress"}}]})"));
  const auto table = read_stress_strain(folder.path() / "plain.csv");
  const auto experiment = read_stress_strain(folder.path() / "test.json");
  ASSERT_TRUE(table) << table.error().message();
  ASSERT_TRUE(experiment) << experiment.error().message();
  ASSERT_EQ(table->size(), 3u);
  ASSERT_EQ(experiment->size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR((*table)[i].strain, (*experiment)[i].strain, 1e-12);
    EXPECT_NEAR((*table)[i].stress_kPa, (*experiment)[i].stress_kPa, 1e-12);
  }
}

TEST(StressStrainFile, ATableWithoutTheColumnsIsRefusedWithThoseThereAre) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "other.csv", "strain,load_N\n0,0\n-0.1,-0.7\n"));
  const auto refused = read_stress_strain(folder.path() / "other.csv");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message() + refused.error().advice(), testing::HasSubstr("load_N"));
  EXPECT_EQ(refused.error().file, folder.path() / "other.csv");
}

}  // namespace
}  // namespace glisson::closedloop
