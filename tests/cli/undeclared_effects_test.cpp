// `explain` and `predict` on experiments that were made elsewhere (tests/support/undeclared: CalculiX with other elements
// on another mesh, curves by time stepping), with an effect that their files do not declare. Small cases; the table over
// all kinds, sizes and specimens is printed by tests/benchmarks/closed_loop.sh.

#include <gtest/gtest.h>
#include <cstdlib>
#include <set>

#include "base/files.h"
#include "support/process.h"

namespace glisson {
namespace {

using test::Finished;

const std::filesystem::path generator = std::filesystem::path(GLISSON_SOURCE_DIR) / "tests/support/undeclared";

#define GLISSON_NEEDS_GENERATOR()                                                                        \
  if (std::system("command -v ccx > /dev/null 2>&1 && /usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) \
  GTEST_SKIP() << "experiments are made by CalculiX and Python: apt-get install calculix-ccx python3-numpy"

// A folder of one case: experiment.json, heldout.json.
std::filesystem::path made(const std::string& script, const TemporaryFolder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {(generator / script).string(), folder.path().string()});
  const Finished finished = test::run("/usr/bin/python3", words);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) return entry.path();
  ADD_FAILURE() << script << " made no case";
  return {};
}

struct Answer {
  Json report;
  double noise = 0;
  double unseen_before = 0;  // in units of the noise
  double unseen_after = 0;

  [[nodiscard]] std::string verdict() const { return report.value("verdict", ""); }
  // Some effect of the answer is of this kind, or says that the data cannot tell it from this kind.
  [[nodiscard]] bool names(const std::string& kind) const {
    for (const Json& effect : report["effects"]) {
      if (effect["kind"] == kind) return true;
      for (const Json& other : effect.value("alike", Json::array()))
        if (other == kind) return true;
    }
    return false;
  }
  // Kinds that claim a cause.
  [[nodiscard]] std::multiset<std::string> causes() const {
    std::multiset<std::string> kinds;
    for (const Json& effect : report["effects"])
      if (effect["kind"] != "smooth-correction") kinds.insert(effect["kind"].get<std::string>());
    return kinds;
  }
};

double rms_of(const Json& prediction) { return prediction.value("rms_mm", prediction.value("rms", NAN)); }

Answer explained(const std::filesystem::path& experiment) {
  const std::filesystem::path out = experiment / "out";
  const Finished explained =
      test::glisson_cli({"explain", (experiment / "experiment.json").string(), "--out", out.string(), "--json", "--quiet"});
  EXPECT_EQ(explained.exit_code, 0) << explained.out << explained.err;
  Answer answer;
  answer.report = explained.json();
  const Json declared = parse_json(read_text_file(experiment / "experiment.json").value()).value();
  answer.noise = declared.value("noise_mm", declared.value("noise_kPa", 1.0));
  const std::string unseen = (experiment / "heldout.json").string();
  answer.unseen_before = rms_of(test::glisson_cli({"predict", unseen, "--json", "--quiet"}).json()) / answer.noise;
  answer.unseen_after =
      rms_of(test::glisson_cli({"predict", unseen, "--with", (out / "model.json").string(), "--json", "--quiet"}).json()) /
      answer.noise;
  return answer;
}

// What noise alone gives, with a little room for the few numbers of the trials and for the parameters' uncertainty.
constexpr double noise_floor = 1.3;

class UndeclaredInPalpation : public testing::TestWithParam<std::string> {};

TEST_P(UndeclaredInPalpation, EffectOfSixNoisesIsNamedAndUnseenTrialsArePredictedToTheNoise) {
  GLISSON_NEEDS_GENERATOR();
  const TemporaryFolder folder;
  const Answer answer = explained(
      made("make_palpation.py", folder, {"--specimens", "small", "--kinds", GetParam(), "--sizes", "6"}));
  EXPECT_EQ(answer.verdict(), "explained");
  EXPECT_TRUE(answer.names(GetParam())) << answer.report["effects"].dump(1);
  EXPECT_EQ(answer.causes().size(), 1) << answer.report["effects"].dump(1);
  EXPECT_GT(answer.unseen_before, 2 * noise_floor);
  EXPECT_LT(answer.unseen_after, noise_floor);
}

INSTANTIATE_TEST_SUITE_P(, UndeclaredInPalpation,
                         testing::Values("stiffness-scale", "support-compliance", "viscoelastic-creep", "force-bias",
                                         "frame-misalignment", "capsule"),
                         [](const auto& kind) {
                           std::string name = kind.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(UndeclaredInPalpation, NoiseAloneIsNotExplained) {
  GLISSON_NEEDS_GENERATOR();
  const TemporaryFolder folder;
  const Answer answer = explained(made("make_palpation.py", folder, {"--specimens", "small", "--kinds", "null"}));
  EXPECT_EQ(answer.verdict(), "nothing-missing");
  EXPECT_TRUE(answer.report["effects"].empty()) << answer.report["effects"].dump(1);
  EXPECT_LT(answer.unseen_after, noise_floor);
}

// A tool that slips sideways as it presses harder is in no catalogue.
TEST(UndeclaredInPalpation, SlippingToolIsGivenNoConfidentName) {
  GLISSON_NEEDS_GENERATOR();
  const TemporaryFolder folder;
  const Answer answer = explained(
      made("make_palpation.py", folder, {"--specimens", "small", "--kinds", "slipping-tool", "--sizes", "6"}));
  EXPECT_TRUE(answer.verdict() == "unexplained" || answer.causes().empty()) << answer.report["effects"].dump(1);
}

class UndeclaredInMaterial : public testing::TestWithParam<std::string> {};

TEST_P(UndeclaredInMaterial, EffectOfEightNoisesIsNamedAndUnseenTrialsArePredictedToTheNoise) {
  GLISSON_NEEDS_GENERATOR();
  const TemporaryFolder folder;
  const Answer answer = explained(made("make_material.py", folder, {"--kinds", GetParam(), "--sizes", "8"}));
  EXPECT_EQ(answer.verdict(), "explained");
  EXPECT_TRUE(answer.names(GetParam())) << answer.report["effects"].dump(1);
  EXPECT_EQ(answer.causes().size(), 1) << answer.report["effects"].dump(1);
  EXPECT_LT(answer.unseen_after, noise_floor);
}

INSTANTIATE_TEST_SUITE_P(, UndeclaredInMaterial,
                         testing::Values("stiffness-scale", "viscoelastic-creep", "strain-stiffening"),
                         [](const auto& kind) {
                           std::string name = kind.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(UndeclaredInMaterial, NoiseAloneIsNotExplained) {
  GLISSON_NEEDS_GENERATOR();
  const TemporaryFolder folder;
  const Answer answer = explained(made("make_material.py", folder, {"--kinds", "null"}));
  EXPECT_EQ(answer.verdict(), "nothing-missing");
  EXPECT_TRUE(answer.report["effects"].empty()) << answer.report["effects"].dump(1);
}

}  // namespace
}  // namespace glisson
