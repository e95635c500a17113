// The pressed phantom: a model on elastography against a truth by another solver, which it can miss.

#include "studies/dissertation/palpation.h"

#include <gmock/gmock.h>
#include <numeric>
#include <set>

#include "base/files.h"
#include "base/json.h"
#include "geometry/mesh_file.h"
#include "studies/dissertation/internal/palpation_trial.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;

// Smaller than any phantom of the study, and of the soft compound.
PalpationSpecimen small_gel() {
  PalpationSpecimen specimen{"small", machine_soft_kPa, machine_soft_kPa};
  specimen.radius_mm = 40;
  specimen.height_mm = 24;
  return specimen;
}
PalpationOptions coarse() {
  PalpationOptions options;
  options.ball_radius_mm = 12;
  options.bricks_across = 8;
  options.bricks_high = 2;
  return options;
}
double value_of(const NamedNumbers& row, const std::string& name) {
  for (const auto& [known, value] : row) {
    if (known == name) return value;
  }
  ADD_FAILURE() << "no " << name;
  return NAN;
}

TEST(Palpation, TheTablesNineErrorsAverageMoreThanTheTextSays) {
  const auto& trials = dissertation_trials();
  ASSERT_EQ(trials.size(), 9u);
  const double sum = std::accumulate(trials.begin(), trials.end(), 0.0, [](double so_far, const PalpationTrial& trial) {
    return so_far + trial.reported_mm.value();
  });
  EXPECT_NEAR(sum / 9, 2.25, 0.005);
}

TEST(Palpation, ThePlanIsTheTableTwoPhantomsMoreAndThreeFaults) {
  std::set<std::string> names;
  int in_table = 0, faults = 0;
  for (const PalpationTrial& trial : palpation_plan()) {
    names.insert(trial.name());
    in_table += trial.reported_mm ? 1 : 0;
    faults += trial.fault != PalpationFault::none ? 1 : 0;
  }
  EXPECT_EQ(names.size(), palpation_plan().size());
  EXPECT_EQ(in_table, 9);
  EXPECT_EQ(faults, 3);
  EXPECT_TRUE(names.contains("A-7.81N-law"));
}

// Elastography, inversion, mesh and contact together miss the other solver's truth by less than the limit, and each
// fault by more. The ball goes deep enough for a law to matter.
TEST(Palpation, AModelThatIsRightHoldsAndWrongModuliAndAWrongLawDoNot) {
  constexpr double force_N = 5;
  const PalpationSpecimen specimen = small_gel();
  const PalpationOptions options = coarse();
  const auto found = elastography_of(specimen, palpation_mesh(specimen, {options.bricks_across, options.bricks_high}),
                                     {}, options.poisson_ratio);
  ASSERT_TRUE(found) << found.error().message();
  const auto truth_with = [&](PalpationFault fault) {
    return truth_of(specimen, fault, options.ball_radius_mm, {force_N}, {.finest_mm = 2.5, .layers = 10});
  };
  const auto truth = truth_with(PalpationFault::none), stiffening = truth_with(PalpationFault::law);
  ASSERT_TRUE(truth) << truth.error().message();
  ASSERT_TRUE(stiffening) << stiffening.error().message();
  const auto row_of = [&](PalpationFault fault) {
    const auto row = judged_trial(specimen, {"small", force_N, {}, fault},
                                  {truth->rest_profile_mm, truth->at_force.front(), *found}, options);
    EXPECT_TRUE(row) << row.error().message();
    return row.value_or(NamedNumbers{});
  };
  const NamedNumbers honest = row_of(PalpationFault::none), modulus = row_of(PalpationFault::modulus);
  EXPECT_LT(std::abs(value_of(honest, "off_percent")), 100 * palpation_limit);
  EXPECT_NEAR(value_of(honest, "soft_kPa"), machine_soft_kPa, 0.15 * machine_soft_kPa);
  EXPECT_LT(value_of(modulus, "off_percent"), -100 * palpation_limit);
  // The model is the same whatever the gel's law is.
  EXPECT_GT(value_of(honest, "depth_mm") / stiffening->at_force.front().depth_mm, 1 + palpation_limit);
}

TEST(Palpation, AStatedModulusThatIsWrongMakesTheStudyFail) {
  const TemporaryFolder folder;
  PalpationOptions options;
  options.bricks_across = 8;
  options.bricks_high = 2;
  options.soft_kPa = 60;
  options.only = {"A-1.69N"};
  const auto summary = run_palpation(folder.path(), options);
  ASSERT_TRUE(summary) << summary.error().message();
  EXPECT_EQ(summary->honest, 1);
  EXPECT_EQ(summary->held, 0);
  EXPECT_FALSE(summary->passed());
  EXPECT_FALSE(read_json_file(folder.path() / "summary.json").value()["passed"].get<bool>());
  const std::string page = read_text_file(folder.path() / "report.html").value();
  EXPECT_THAT(page, testing::HasSubstr("SIMULATED"));
  EXPECT_THAT(page, testing::HasSubstr("does NOT hold"));
}

TEST(Palpation, ScansOfTheModelItselfAreFoundAgain) {
  const TemporaryFolder folder;
  const fs::path scans = folder.path() / "scans";
  fs::create_directories(scans);
  PalpationOptions options;
  options.bricks_across = 8;
  options.bricks_high = 2;
  const auto mesh = palpation_mesh(palpation_specimens()[1], {8, 2});
  const auto truth = press(mesh, std::vector<double>(mesh.cells.size(), 36.81), 0.45, 20, 0.78);
  ASSERT_TRUE(truth) << truth.error().message();
  EXPECT_GT(truth->depth_mm, 0.3);
  ASSERT_TRUE(geometry::write_surface(scans / "B-rest.ply", truth->rest));
  ASSERT_TRUE(geometry::write_surface(scans / "B-0.78N.ply", truth->pressed));
  options.scans = scans;
  const auto summary = run_palpation(folder.path() / "out", options);
  ASSERT_TRUE(summary.has_value()) << summary.error().message();
  ASSERT_EQ(summary->rows.size(), 1u);
  EXPECT_LT(summary->mean_mm, 1e-3);
  EXPECT_FALSE(summary->simulated_scans);
  EXPECT_THAT(read_text_file(folder.path() / "out" / "report.html").value(), testing::HasSubstr("nothing is judged"));
  options.scans = folder.path();
  EXPECT_EQ(run_palpation(folder.path() / "out2", options).error().code, "palpation-no-scans");
}

TEST(Palpation, ATrialThatThereIsNotIsNamed) {
  const TemporaryFolder folder;
  PalpationOptions options;
  options.only = {"C-1.00N"};
  const auto summary = run_palpation(folder.path(), options);
  ASSERT_FALSE(summary);
  EXPECT_EQ(summary.error().code, "palpation-no-trial");
  EXPECT_THAT(summary.error().message(), testing::HasSubstr("C-1.00N"));
}

}  // namespace
}  // namespace glisson::studies
