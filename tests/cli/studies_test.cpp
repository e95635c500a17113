// The dissertation's studies through glisson-cli.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <filesystem>
#include <fstream>

#include "answer.h"
#include "base/files.h"
#include "support/data.h"
#include "support/folders.h"
#include "support/process.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;

TEST(Study, ACohortIsRunOneJobAPatientAndThenAsAWhole) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  answer({"study", "cohort", "--simulated", "12", "--out", out});
  const std::string maps = (fs::path(out) / "simulated").string();
  const std::string jobs = (folder.path() / "jobs").string();
  const Json one = answer({"study", "cohort", maps, "--out", jobs, "--patient", "simulated-003-stiffness"});
  EXPECT_EQ(one.at("patients"), 1);
  const Json all = answer({"study", "cohort", maps, "--out", jobs});
  EXPECT_EQ(all.at("patients"), 12);
  EXPECT_EQ(all.at("reused"), 1);
  EXPECT_EQ(all.at("rows").size(), 12u);
  EXPECT_TRUE(fs::exists(fs::path(jobs) / "report.html"));
}

TEST(Study, ACohortInChunksGivesTheSameBytes) {
  const TemporaryFolder folder;
  const fs::path whole = folder.path() / "whole", chunks = folder.path() / "chunks";
  answer({"study", "cohort", "--simulated", "11", "--out", whole.string()});
  const std::string maps = (whole / "simulated").string();
  for (const std::string chunk : {"2/3", "3/3", "1/3"})
    answer({"study", "cohort", maps, "--out", chunks.string(), "--chunk", chunk});
  EXPECT_FALSE(fs::exists(chunks / "cohort.csv"));
  EXPECT_EQ(answer({"study", "cohort", maps, "--out", chunks.string()}).at("reused"), 11);
  for (const char* file : {"cohort.csv", "summary.json"})
    EXPECT_EQ(read_text_file(chunks / file).value(), read_text_file(whole / file).value()) << file;
  for (const std::string wrong : {"0/3", "4/3", "3", "a/b", "1/3x", "1/100001"}) {
    const Finished refused = glisson_cli({"study", "cohort", maps, "--out", chunks.string(), "--chunk", wrong});
    EXPECT_EQ(refused.exit_code, 2) << wrong;
    EXPECT_THAT(refused.err, testing::HasSubstr("K/N, as 3/20")) << wrong;
  }
}

// The workflow that clusters run, with the cores of this machine: two jobs at once, killed and taken up again.
TEST(Study, ACohortRunsInAWorkflowThatIsKilledAndTakenUpAgain) {
  const fs::path snakemake = "/usr/bin/snakemake";
  if (!fs::exists(snakemake)) GTEST_SKIP() << "snakemake is not installed";
  const TemporaryFolder folder;
  const std::string maker = (folder.path() / "maker").string();
  answer({"study", "cohort", "--simulated", "16", "--out", maker});
  const std::string maps = (fs::path(maker) / "simulated").string();
  const fs::path out = folder.path() / "out";
  const std::vector<std::string> workflow{
      snakemake.string(),
      "--snakefile",
      glisson::test::source_folder().string() + "/packaging/cohort/Snakefile",
      "--directory",
      folder.path().string(),
      "--cores",
      "2",
      "--nolock",
      "--rerun-incomplete",
      "--config",
      "folder=" + maps,
      "out=" + out.string(),
      "per_job=2",
      std::string("glisson_cli=") + glisson::test::build_folder().string() + "/bin/glisson-cli"};
  const auto chunks = [&] {
    std::error_code problem;
    const fs::directory_iterator files(out / "chunks", problem);
    return problem ? 0 : std::distance(begin(files), end(files));
  };
  // Killed again and again, a little later each time, until it was killed in the middle.
  std::ptrdiff_t done = 0;
  for (int seconds = 3; seconds <= 30 && done == 0; seconds += 2) {
    std::vector<std::string> arguments{"-s", "KILL", std::to_string(seconds)};
    arguments.insert(arguments.end(), workflow.begin(), workflow.end());
    run("/usr/bin/timeout", arguments);
    done = chunks();
  }
  ASSERT_GT(done, 0);
  EXPECT_FALSE(fs::exists(out / "summary.json") && done < 8);
  const Finished finished = run(snakemake, {workflow.begin() + 1, workflow.end()});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(chunks(), 8);
  EXPECT_TRUE(fs::exists(out / "report.html"));
  const Json whole = answer({"study", "cohort", maps, "--out", maker});
  EXPECT_EQ(parse_json(read_text_file(out / "summary.json").value()).value().at("mean_kPa"), whole.at("mean_kPa"));
}

TEST(Study, LandmarksRunInTheSameWorkflow) {
  const fs::path snakemake = "/usr/bin/snakemake";
  if (!fs::exists(snakemake)) GTEST_SKIP() << "snakemake is not installed";
  const TemporaryFolder folder;
  const std::string maker = (folder.path() / "maker").string();
  answer({"study", "cohort", "--simulated", "2", "--out", maker});
  const fs::path out = folder.path() / "out";
  const Finished finished =
      run(snakemake,
          {"--snakefile", glisson::test::source_folder().string() + "/packaging/cohort/Snakefile", "--directory",
           folder.path().string(), "--cores", "2", "--config", "study=landmarks",
           "folder=" + (fs::path(maker) / "simulated").string(), "out=" + out.string(), "options=--target-cells 800",
           std::string("glisson_cli=") + glisson::test::build_folder().string() + "/bin/glisson-cli"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Json summary = parse_json(read_text_file(out / "summary.json").value()).value();
  EXPECT_EQ(summary.at("patients"), 2);
  EXPECT_EQ(summary.at("intra_organ").size(), 3u);
  EXPECT_TRUE(fs::exists(out / "landmarks.csv"));
}

// Real livers whose stiffness is drawn are no cohort of maps.
TEST(Study, LandmarksAreAskedOfLiversOrOfACohortAndNotOfBoth) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string(), livers = (folder.path() / "livers").string();
  fs::create_directories(livers);
  const Finished empty = glisson_cli({"study", "landmarks", "--livers", livers, "--out", out, "--json", "--quiet"});
  EXPECT_EQ(empty.exit_code, 1);
  EXPECT_EQ(empty.json().at("error").at("code"), "shapes-no-livers");
  EXPECT_EQ(glisson_cli({"study", "landmarks", livers, "--livers", livers, "--out", out}).exit_code, 2);
  EXPECT_EQ(glisson_cli({"study", "landmarks", "--simulated", "2", "--livers", livers, "--out", out}).exit_code, 2);
  EXPECT_FALSE(fs::exists(out));
  GLISSON_NEEDS_DATA("livers_couinaud");
  const Json real =
      answer({"study", "landmarks", "--livers", (shared_data() / "livers_couinaud").string(), "--out", out, "--list"});
  EXPECT_EQ(real.at("ids").size(), 82u);
}

TEST(Study, ValidatingStiffnessWithoutFilesUsesTheDissertationsFigures) {
  const TemporaryFolder folder;
  const Json validation = answer({"study", "validate-stiffness", "--out", folder.path().string()});
  EXPECT_EQ(validation.at("materials").size(), 2u);
  EXPECT_LT(validation.at("largest_difference_percent").get<double>(), 60);
  const std::string notes = validation.at("notes").dump();
  EXPECT_EQ(validation.at("notes").size(), 3u) << notes;
  EXPECT_THAT(notes, testing::HasSubstr("18.85 kPa is stated of it"));
  EXPECT_THAT(notes, testing::HasSubstr("+53 % off what its samples' own forces"));
}

TEST(Study, ConvergenceMakesACurveThatThePlatformPlanReads) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const Json study = answer(
      {"study", "convergence", "--finest-mm3", "60", "--coarsest-mm3", "165", "--resolutions", "2", "--out", out});
  EXPECT_EQ(study.at("rows").size(), 2u);
  const Json plan = answer({"platform", "plan", "--volume-cm3", "1000", "--accuracy-mm", "10", "--convergence",
                            study.at("convergence").get<std::string>()});
  EXPECT_GT(plan.at("workload").at("resolution_mm3").get<double>(), 60);
  EXPECT_EQ(glisson_cli({"study", "convergence", "--finest-mm3", "0.1", "--out", out}).exit_code, 1);
}

TEST(Study, DataDrivenTakesSomebodysMeasurementsAndRefusesWhatIsNone) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string(), file = (folder.path() / "tests.csv").string();
  std::string table = "strain,stress_kPa\n";
  for (int i = -20; i <= 20; ++i) table += fmt::format("{:.3f},{:.4f}\n", 0.02 * i, 0.1 * i + 1e-4 * i * i * i);
  std::ofstream(file) << table;
  const Json study = answer({"study", "data-driven", "--measured", file, "--target-cells", "400", "--out", out});
  EXPECT_FALSE(study.at("simulated").get<bool>());
  ASSERT_EQ(study.at("rows").size(), 1u);
  const Json& row = study.at("rows")[0];
  EXPECT_EQ(row.at("measurements"), 41);
  EXPECT_GT(row.at("retraction_mm").get<double>(), 1);
  EXPECT_FALSE(row.contains("from_data"));  // nobody knows the truth
  EXPECT_TRUE(fs::exists(study.at("report").get<std::string>()));

  std::ofstream(file) << "strain,stress_kPa\n0.01,-1\n0.1,-2\n0.2,-3\n";
  const Finished falling = glisson_cli({"study", "data-driven", "--measured", file, "--out", out, "--json", "--quiet"});
  EXPECT_EQ(falling.exit_code, 1);
  EXPECT_EQ(falling.json().at("error").at("code"), "data-invalid");
}

TEST(Study, MatchingJudgesBitsOnSimulatedLiversAndRefusesALonelyPose) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const Json study = answer({"study", "matching", "--livers", "1", "--starts", "0", "--points", "16,24", "--passes",
                             "3", "--seconds-a-timing", "0", "--out", out});
  EXPECT_TRUE(study.at("simulated").get<bool>());
  EXPECT_EQ(study.at("problems"), 2);
  EXPECT_EQ(study.at("quality").size(), 6u);
  EXPECT_TRUE(fs::exists(study.at("report").get<std::string>()));
  EXPECT_EQ(glisson_cli({"study", "matching", "one.ply", "--out", out}).exit_code, 1);
}

TEST(Study, NamesItsSubcommands) { EXPECT_EQ(glisson_cli({"study", "--quiet"}).exit_code, 2); }

}  // namespace
}  // namespace glisson::test
