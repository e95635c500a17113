// The cohort's statistics on maps whose statistics are known, on a simulated cohort, and on measured brains.

#include "studies/dissertation/cohort.h"

#include <gmock/gmock.h>
#include <fstream>

#include "base/files.h"
#include "imaging/volume_file.h"
#include "support/data.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Half the voxels at mean + sd and half at mean - sd.
void write_map(const fs::path& file, double mean_kPa, double sd_kPa) {
  imaging::Volume map;
  map.unit = "kPa";
  map.grid.size = {4, 4, 2};
  for (int v = 0; v < 32; ++v) map.values.push_back(static_cast<float>(mean_kPa + (v % 2 == 0 ? sd_kPa : -sd_kPa)));
  ASSERT_TRUE(imaging::write_volume_file(file, map));
}

TEST(Cohort, CountsPatientsAgainstTheReferenceBody) {
  const TemporaryFolder folder;
  const fs::path maps = folder.path() / "maps";
  fs::create_directories(maps);
  const std::vector<double> means{2.2, 2.4, 2.6, 2.8, 3.0, 4.0, 8.0};
  for (std::size_t n = 0; n < means.size(); ++n) {
    write_map(maps / ("p" + std::to_string(n) + "-stiffness.nrrd"), means[n], 0.1 * means[n]);
  }
  std::ofstream(maps / "p9-stiffness.nrrd") << "NRRD0004\n# cut off";
  const auto summary = run_cohort(maps, folder.path() / "out");
  ASSERT_TRUE(summary.has_value()) << summary.error().message();
  EXPECT_EQ(summary->patients, 7u);
  EXPECT_NEAR(summary->median_kPa, 2.8, 1e-6);
  EXPECT_NEAR(summary->mean_kPa, 25.0 / 7, 1e-6);
  EXPECT_NEAR(summary->in_reference_fraction, 5.0 / 7, 1e-9);    // 2.1 to 3.1 kPa
  EXPECT_NEAR(summary->like_reference_fraction, 4.0 / 7, 1e-9);  // 2.3 to 3.3 kPa
  EXPECT_NEAR(summary->rank_correlation, 1, 1e-12);
  ASSERT_FALSE(summary->bins.empty());
  EXPECT_NEAR(summary->bins.front().low_kPa, 2.1, 1e-9);
  EXPECT_EQ(summary->bins.front().patients, 5u);
  // Sample standard deviation of 32 values at +-s.
  EXPECT_NEAR(summary->bins.front().mean_sd_kPa, 0.26 * std::sqrt(32.0 / 31), 1e-6);
  for (const char* file : {"cohort.csv", "summary.json", "report.html"}) {
    EXPECT_TRUE(fs::exists(folder.path() / "out" / file)) << file;
  }
  const std::string page = read_text_file(folder.path() / "out" / "report.html").value();
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(page, HasSubstr("95 % of the atlas&#39;s patients"));
  EXPECT_THAT(page, HasSubstr("95 % of these patients"));
}

TEST(Cohort, TheSimulatedOneFollowsTheReportedFiguresAndSaysWhatItIs) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_simulated_cohort(folder.path() / "maps", 119, 1));
  CohortOptions options;
  options.warning = cohort_warning(folder.path() / "maps");
  EXPECT_EQ(cohort_warning(folder.path()), "");
  const auto summary = run_cohort(folder.path() / "maps", folder.path() / "out", options);
  ASSERT_TRUE(summary.has_value()) << summary.error().message();
  EXPECT_EQ(summary->patients, 119u);
  // Of 119 draws at 64 % one standard deviation is 4.4 %; of the 97.5th percentile of a long tail about a quarter.
  const auto means = column_of(summary->rows, "mean_kPa");
  const auto typical = std::count_if(means.begin(), means.end(), [](double kPa) { return std::abs(kPa - 2.1) <= 0.5; });
  EXPECT_NEAR(static_cast<double>(typical) / 119, 0.64, 3 * 0.044);
  EXPECT_NEAR(summary->upper_limit_ratio, 4.8, 2.4);
  EXPECT_GT(summary->rank_correlation, 0.8);
  EXPECT_THAT(read_text_file(folder.path() / "out" / "report.html").value(), HasSubstr("SIMULATED"));
  const auto again = run_cohort(folder.path() / "maps", folder.path() / "out", options);
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->reused, 119u);
  EXPECT_EQ(again->mean_kPa, summary->mean_kPa);
}

TEST(Cohort, MeasuredBrainsInPascalComeOutInKilopascal) {
  GLISSON_NEEDS_DATA("mre134_brain_maps");
  const TemporaryFolder folder;
  const auto summary = run_cohort(test::shared_data() / "mre134_brain_maps" / "individual", folder.path());
  ASSERT_TRUE(summary.has_value()) << summary.error().message();
  EXPECT_EQ(summary->failed, 0u);
  EXPECT_GT(summary->patients, 0u);
  for (const double kPa : column_of(summary->rows, "mean_kPa")) {
    EXPECT_GT(kPa, 2.0);
    EXPECT_LT(kPa, 4.0);
  }
}

}  // namespace
}  // namespace glisson::studies
