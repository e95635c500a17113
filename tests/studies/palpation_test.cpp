// The pressed phantom: mechanics that are known, and scans whose difference from the model is known.

#include "studies/dissertation/palpation.h"

#include <gmock/gmock.h>
#include <numeric>

#include "base/files.h"
#include "geometry/mesh_file.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;

TEST(Palpation, TheTablesNineErrorsAverageMoreThanTheTextSays) {
  const auto& trials = dissertation_trials();
  ASSERT_EQ(trials.size(), 9u);
  const double sum = std::accumulate(trials.begin(), trials.end(), 0.0, [](double so_far, const PalpationTrial& trial) {
    return so_far + trial.reported_mm;
  });
  EXPECT_NEAR(sum / 9, 2.25, 0.005);
}

TEST(Palpation, StifferPhantomsGiveLessAndTwiceTheForceGoesTwiceAsFar) {
  const PalpationOptions options;
  const auto soft = press("A", 2, 17, 37, options);
  const auto layered = press("AB", 2, 17, 37, options);
  const auto stiff = press("B", 2, 17, 37, options);
  const auto harder = press("A", 4, 17, 37, options);
  ASSERT_TRUE(soft && layered && stiff && harder);
  EXPECT_NEAR(soft->depth_mm / stiff->depth_mm, 37.0 / 17, 1e-6);
  EXPECT_NEAR(harder->depth_mm, 2 * soft->depth_mm, 1e-6);
  EXPECT_GT(layered->depth_mm, stiff->depth_mm);
  EXPECT_LT(layered->depth_mm, soft->depth_mm);
  // Far from the edge the layer is stiffer than a half-space under the same disc: 2 (1 - nu2) p a / E in its middle.
  const double pressure_kPa = 2000 / (3.14159 * 20 * 20);
  EXPECT_LT(soft->depth_mm, 2 * (1 - 0.45 * 0.45) * pressure_kPa * 20 / 17);
  EXPECT_GT(soft->depth_mm, 0.3 * 2 * (1 - 0.45 * 0.45) * pressure_kPa * 20 / 17);
}

// Linear elasticity answers any force, also with cells that it turns inside out.
TEST(Palpation, APhantomThatIsTurnedInsideOutIsNoAnswer) {
  const auto overloaded = press("A", 60, 17, 37, {});
  ASSERT_FALSE(overloaded);
  EXPECT_EQ(overloaded.error().code, "palpation-not-converged");
  EXPECT_THAT(overloaded.error().message(), testing::HasSubstr("cells turned inside out"));
}

TEST(Palpation, ScansOfTheModelItselfAreFoundAgain) {
  const TemporaryFolder folder;
  const fs::path scans = folder.path() / "scans";
  fs::create_directories(scans);
  PalpationOptions options;
  const auto truth = press("B", 4.02, options.soft_kPa, options.stiff_kPa, options);
  ASSERT_TRUE(truth.has_value());
  ASSERT_TRUE(geometry::write_surface(scans / "B-rest.ply", truth->rest));
  ASSERT_TRUE(geometry::write_surface(scans / "B-4.02N.ply", truth->pressed));
  options.scans = scans;
  const auto summary = run_palpation(folder.path() / "out", options);
  ASSERT_TRUE(summary.has_value()) << summary.error().message();
  ASSERT_EQ(summary->rows.size(), 1u);
  EXPECT_LT(summary->mean_mm, 1e-3);
  EXPECT_FALSE(summary->simulated_scans);
  options.scans = folder.path();
  EXPECT_EQ(run_palpation(folder.path() / "out2", options).error().code, "palpation-no-scans");
}

// Between MRE and the testing machine there are 4 and 5 % of stiffness, and so of the depth; noise and a partial view
// through a rough placement add about their own size and no more.
TEST(Palpation, SimulatedScansAreCloseToTheModelAndSaidToBeSimulated) {
  const TemporaryFolder folder;
  const auto summary = run_palpation(folder.path());
  ASSERT_TRUE(summary.has_value()) << summary.error().message();
  ASSERT_EQ(summary->rows.size(), 9u);
  EXPECT_GT(summary->mean_mm, 0.02);
  EXPECT_LT(summary->mean_mm, 1.0);
  EXPECT_NEAR(summary->reported_mean_mm, 2.25, 0.005);
  EXPECT_THAT(read_text_file(folder.path() / "report.html").value(), testing::HasSubstr("SIMULATED"));
}

}  // namespace
}  // namespace glisson::studies
