// The gate: its statistics against enumeration, its rates of right and false alarms, and what it does with bad results.

#include "studies/gate/gate.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <cmath>
#include <random>

#include "base/files.h"
#include "base/json.h"
#include "studies/gate/paired_test.h"
#include "support/folders.h"
#include "vision/frame.h"
#include "vision/similarity.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;

// All 2^n choices of signs, ranks by counting: the slow way.
double enumerated_p_greater(const std::vector<double>& differences) {
  std::vector<double> ranks;
  double positive = 0;
  for (const double one : differences) {
    if (one == 0) continue;
    double rank = 0.5;
    for (const double other : differences) {
      if (std::abs(other) < std::abs(one)) rank += 1;
      if (std::abs(other) == std::abs(one)) rank += 0.5;
    }
    ranks.push_back(rank);
    if (one > 0) positive += rank;
  }
  int reached = 0;
  const int choices = 1 << ranks.size();
  for (int choice = 0; choice < choices; ++choice) {
    double sum = 0;
    for (std::size_t k = 0; k < ranks.size(); ++k) sum += (choice >> k & 1) != 0 ? ranks[k] : 0;
    reached += sum >= positive - 1e-9;
  }
  return static_cast<double>(reached) / choices;
}

TEST(PairedChange, IsThatOfAllChoicesOfSigns) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> differences;
    for (int k = 0; k < 10; ++k) differences.push_back(static_cast<int>(random() % 9) - 3);  // ties and zeros
    const double p = enumerated_p_greater(differences);
    EXPECT_NEAR(paired_change(differences).p_greater, p, 1e-12) << testing::PrintToString(differences);
  }
}

TEST(PairedChange, FollowsAShiftAndAScaleAndItsIntervalHoldsAsOftenAsItSays) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  int held = 0;
  constexpr int trials = 600;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> differences;
    for (int k = 0; k < 30; ++k) differences.push_back(3 + 2 * normal(random));
    const PairedChange change = paired_change(differences);
    held += change.interval[0] <= 3 && 3 <= change.interval[1];
    for (double& one : differences) one = 10 * one - 4;
    EXPECT_NEAR(paired_change(differences).change, 10 * change.change - 4, 1e-9);
  }
  EXPECT_NEAR(static_cast<double>(held) / trials, 0.95, 0.025);
}

// Registration errors of 30 cases that differ fivefold, and a new version's own scatter of 7 %.
Results simulated(std::mt19937& random, int metrics, double factor, const Results* base = nullptr) {
  std::normal_distribution<double> normal;
  Results results;
  for (int k = 0; k < 30; ++k) results.cases.push_back(fmt::format("p{}", k));
  for (int m = 0; m < metrics; ++m) {
    std::vector<double>& values = results.metrics[fmt::format("error{}_mm", m)];
    for (int k = 0; k < 30; ++k) {
      const double level =
          base ? base->metrics.at(fmt::format("error{}_mm", m))[k] : 4 * std::exp(0.8 * normal(random));
      values.push_back(level * (base && m == 0 ? factor : 1) * std::exp((base ? 0.07 : 0) * normal(random)));
    }
  }
  return results;
}

TEST(Gate, CatchesFivePercentInThirtyCasesAndSeldomCriesWolf) {
  std::mt19937 random(3);
  constexpr int trials = 1000, metrics = 5;
  int caught = 0, false_alarms = 0, false_alarms_usual = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Results base = simulated(random, metrics, 1);
    caught += compare_results(base, simulated(random, metrics, 1.05, &base))->metrics[0].verdict == GateVerdict::worse;
    GateOptions strict;  // with no tolerance, statistics alone hold back
    for (const auto& [name, values] : base.metrics) strict.metrics[name].percent = 0;
    const Results as_good = simulated(random, metrics, 1, &base);
    false_alarms += compare_results(base, as_good, strict)->verdict == GateVerdict::worse;
    false_alarms_usual += compare_results(base, as_good)->verdict == GateVerdict::worse;
  }
  EXPECT_GE(caught, 0.8 * trials);
  EXPECT_LE(false_alarms, 0.05 * trials + 2 * std::sqrt(0.05 * 0.95 * trials));
  EXPECT_LE(false_alarms_usual, false_alarms);
  RecordProperty("caught", caught);
  RecordProperty("false_alarms_usual", false_alarms_usual);
  RecordProperty("false_alarms", false_alarms);
}

Results of(const std::vector<std::pair<std::string, double>>& values, const std::string& metric = "tre_mm") {
  Results results;
  for (const auto& [id, value] : values) {
    results.cases.push_back(id);
    results.metrics[metric].push_back(value);
  }
  return results;
}

TEST(Gate, CountsWhatHasNoNumberAndNeverAveragesIt) {
  const double none = std::nan("");
  const Results base = of({{"a", 1}, {"b", 2}, {"c", none}, {"d", none}, {"e", 5}});
  const Results now = of({{"a", 1}, {"b", none}, {"c", 3}, {"d", none}, {"f", 1}});
  const auto gate = compare_results(base, now);
  ASSERT_TRUE(gate);
  const MetricChange& change = gate->metrics.front();
  EXPECT_EQ(change.cases, 1);
  EXPECT_THAT(change.lost, testing::ElementsAre("b"));
  EXPECT_THAT(change.gained, testing::ElementsAre("c"));
  EXPECT_EQ(change.without, 1);
  EXPECT_THAT(gate->only_base, testing::ElementsAre("e"));
  EXPECT_THAT(gate->only_now, testing::ElementsAre("f"));
  EXPECT_EQ(change.base, 1);
  EXPECT_EQ(gate->verdict, GateVerdict::worse);
  EXPECT_THAT(sentence_of(change),
              testing::HasSubstr("1 without a number now, 1 with a number that had none, 1 without "
                                 "a number in both"));
}

TEST(Gate, SaysWhereResultsDoNotGoTogether) {
  const auto notes = [](Results base, Results now) {
    base.cases = now.cases = {"a"};
    base.metrics["tre_mm"] = now.metrics["tre_mm"] = {1};
    return compare_results(base, now)->notes;
  };
  const auto about = [](const char* program, const char* version, const char* data) {
    return Results{{}, program, version, data, {}, {}, {}};
  };
  using testing::ElementsAre;
  using testing::HasSubstr;
  EXPECT_THAT(notes(about("ours", "1", "spring"), about("ours", "2", "spring")), ElementsAre());
  EXPECT_THAT(notes({}, {}), ElementsAre());
  EXPECT_THAT(notes(about("ours", "1", ""), about("theirs", "1", "")), ElementsAre(HasSubstr("two programs")));
  EXPECT_THAT(notes(about("ours", "1", "spring"), about("ours", "1", "")),
              ElementsAre(HasSubstr("Only base says on which data"), HasSubstr("the same version, 1")));
  EXPECT_THAT(notes(about("ours", "", ""), about("ours", "2", "")),
              ElementsAre(HasSubstr("Only new says its version")));
}

TEST(Gate, JudgesDeterministicResultsAndFewCasesEachByItself) {
  const Results base = of({{"a", 1}, {"b", 2}, {"c", 4}});
  EXPECT_EQ(compare_results(base, base)->verdict, GateVerdict::same);
  EXPECT_EQ(compare_results(base, of({{"a", 1.01}, {"b", 2}, {"c", 4}}))->verdict, GateVerdict::same);
  const auto worse = compare_results(base, of({{"a", 1}, {"b", 2.3}, {"c", 3}}));
  EXPECT_EQ(worse->verdict, GateVerdict::worse);
  ASSERT_EQ(worse->worst.size(), 1u);
  EXPECT_EQ(worse->worst.front().id, "b");
  EXPECT_EQ(compare_results(base, of({{"a", 0.5}, {"b", 2}, {"c", 4}}))->verdict, GateVerdict::better);
  const auto dice = [&](double value) {
    return compare_results(of({{"a", 0.9}}, "dice"), of({{"a", value}}, "dice"))->verdict;
  };
  EXPECT_EQ(dice(0.8), GateVerdict::worse);
  EXPECT_EQ(dice(0.95), GateVerdict::better);
}

TEST(Gate, HoldsWhatIsToStayTheSameToItsToleranceEitherWay) {
  GateOptions options;
  options.metrics["tre_mm"].better = MetricTolerance::Better::same;
  options.metrics["tre_mm"].percent = 1;
  const auto verdict = [&](double factor, int cases) {
    std::vector<std::pair<std::string, double>> one, other;
    for (int k = 0; k < cases; ++k) {
      one.emplace_back(fmt::format("{}", k), 2 + k);
      other.emplace_back(fmt::format("{}", k), factor * (2 + k));
    }
    return compare_results(of(one), of(other), options)->verdict;
  };
  for (const int cases : {2, 12}) {
    EXPECT_EQ(verdict(1, cases), GateVerdict::same);
    EXPECT_EQ(verdict(1.005, cases), GateVerdict::same);
    EXPECT_EQ(verdict(1.05, cases), GateVerdict::worse);
    EXPECT_EQ(verdict(0.95, cases), GateVerdict::worse);
  }
}

TEST(Gate, TakesNumbersOfAnySizeWithoutVariance) {
  std::vector<std::pair<std::string, double>> one, other, huge;
  for (int k = 0; k < 12; ++k) {
    one.emplace_back(fmt::format("{}", k), 2);
    other.emplace_back(fmt::format("{}", k), 2.5);
    huge.emplace_back(fmt::format("{}", k), k % 2 == 0 ? 1e308 : 1e-308);
  }
  EXPECT_EQ(compare_results(of(one), of(one))->verdict, GateVerdict::same);
  const auto worse = compare_results(of(one), of(other));
  EXPECT_EQ(worse->verdict, GateVerdict::worse);
  EXPECT_NEAR(worse->metrics[0].difference, 0.5, 1e-9);
  EXPECT_LT(worse->metrics[0].p, 0.001);
  EXPECT_TRUE(all_numbers_finite(json_of(*compare_results(of(huge), of(one)))));
  EXPECT_TRUE(all_numbers_finite(json_of(*compare_results(of(one), of(huge)))));
}

class GateFolders : public testing::Test {
 protected:
  fs::path write(const char* name, const std::string& metrics) const {
    fs::path folder = room_.path() / name;
    EXPECT_TRUE(write_text_file(folder / "metrics.csv", metrics));
    return folder;
  }
  std::string refusal(const char* name, const std::string& metrics) const {
    const auto results = read_results(write(name, metrics));
    return results ? "" : results.error().code + ": " + results.error().message();
  }
  [[nodiscard]] fs::path at(const char* name) const { return room_.path() / name; }

 private:
  TemporaryFolder room_;
};

TEST_F(GateFolders, AreReadAsOtherProgramsWriteThem) {
  // As Python's csv module and spreadsheets do: CR LF, quotes, exponents, blanks for what failed.
  const auto results =
      read_results(write("other", "\"case\",\"tre_mm\",dice\r\n\"p 1\",1.25e+00,0.91\r\np2,nan,\r\np3,inf,0.9\r\n"));
  ASSERT_TRUE(results) << results.error().message();
  EXPECT_THAT(results->cases, testing::ElementsAre("p 1", "p2", "p3"));
  EXPECT_EQ(results->metrics.at("tre_mm")[0], 1.25);
  EXPECT_TRUE(std::isnan(results->metrics.at("tre_mm")[1]) && std::isnan(results->metrics.at("tre_mm")[2]));
  EXPECT_TRUE(std::isnan(results->metrics.at("dice")[1]));
  EXPECT_EQ(results->metrics.at("dice")[2], 0.9);
}

TEST_F(GateFolders, AreRefusedWithTheLineThatIsWrong) {
  EXPECT_THAT(refusal("a", "id,tre_mm\na,1\n"), testing::HasSubstr("must begin with a line case,METRIC"));
  EXPECT_THAT(refusal("b", "case,tre_mm\na,1\na,2\n"), testing::HasSubstr("Line 3"));
  EXPECT_THAT(refusal("c", "case,tre_mm,tre_mm\na,1,2\n"), testing::HasSubstr("Column 3"));
  EXPECT_THAT(refusal("d", "case,tre_mm\na,1,2\n"), testing::HasSubstr("Line 2"));
  EXPECT_THAT(refusal("e", "case,tre_mm\n"), testing::HasSubstr("holds no case"));
  EXPECT_THAT(read_results(at("nowhere")).error().code, "results-missing");
  const auto one = read_results(write("one", "case,tre_mm\na,1\n")),
             two = read_results(write("two", "case,tre_mm\nb,1\n"));
  EXPECT_EQ(compare_results(*one, *two).error().code, "results-no-common-case");
  GateOptions options;
  options.metrics["tre"] = {};
  EXPECT_EQ(compare_results(*one, *one, options).error().code, "tolerance-without-metric");
  EXPECT_TRUE(write_text_file(at("one") / "about.json", R"({"data": "march"})"));
  EXPECT_TRUE(write_text_file(at("two") / "about.json", R"({"data": "april"})"));
  EXPECT_EQ(compare_results(*read_results(at("one")), *read_results(at("two"))).error().code, "results-other-data");
}

// As two drivers differ: edges moved by a third of a pixel, and the last bits of each colour.
TEST(PictureSimilarity, SurvivesAnotherDriverAndSeesAMissingPart) {
  const vision::Frame organ = vision::read_frame(test::source_folder() / "tests" / "baselines" / "organ.png").value();
  vision::Frame other = organ;
  std::mt19937 random(4);
  for (int y = 0; y < organ.height; ++y) {
    for (int x = 1; x < organ.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double value =
            (2.0 * organ.at(x, y)[c] + organ.at(x - 1, y)[c]) / 3 + static_cast<double>(random() % 5) - 2;
        other.at(x, y)[c] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
      }
    }
  }
  EXPECT_GT(vision::similarity_of(organ, other)->worst, GateOptions().similarity);
  EXPECT_NEAR(vision::similarity_of(organ, organ)->worst, 1, 1e-6);

  vision::Frame hidden = organ, mask{organ.width, organ.height, std::vector<std::uint8_t>(organ.rgb.size(), 255)};
  for (int y = organ.height / 2; y < organ.height / 2 + 20; ++y) {
    std::fill_n(hidden.at(organ.width / 2, y), 3 * 20, std::uint8_t{0});
    std::fill_n(mask.at(organ.width / 2 - 20, y), 3 * 60, std::uint8_t{0});
  }
  for (int y = organ.height / 2 - 20; y < organ.height / 2 + 40; ++y)
    std::fill_n(mask.at(organ.width / 2 - 20, y), 3 * 60, std::uint8_t{0});
  EXPECT_LT(vision::similarity_of(organ, hidden)->worst, GateOptions().similarity);
  EXPECT_GT(vision::similarity_of(organ, hidden, mask)->worst, GateOptions().similarity);
  mask.width = 3;
  EXPECT_EQ(vision::similarity_of(organ, hidden, mask).error().code, "pictures-differ-in-size");
}

}  // namespace
}  // namespace glisson::studies
