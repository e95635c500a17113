// Which cases a gate runs in so many minutes: by a rule that was written down first, judged by what the gate then
// catches.

#include "studies/gate/choose_cases.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/files.h"
#include "studies/gate/gate.h"

namespace glisson::studies {
namespace {

using testing::ElementsAre;

// Cases whose figures repeat well or badly, and that take short or long, neither by the other.
struct World {
  std::vector<double> level, scatter, minutes;
};
World world(std::mt19937& random, int cases) {
  std::normal_distribution<double> normal;
  World made;
  for (int k = 0; k < cases; ++k) {
    made.level.push_back(4 * std::exp(0.8 * normal(random)));
    made.scatter.push_back(0.05 * std::exp(0.8 * normal(random)));
    made.minutes.push_back(2 * std::exp(0.7 * normal(random)));
  }
  return made;
}

double seen(const World& in, std::size_t k, double factor, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return in.level[k] * factor * std::exp(in.scatter[k] * normal(random));
}

std::vector<CaseHistory> histories(const World& in, int runs, std::mt19937& random) {
  std::vector<CaseHistory> all;
  for (std::size_t k = 0; k < in.level.size(); ++k) {
    CaseHistory& one = all.emplace_back(CaseHistory{fmt::format("p{}", k), {}, {}});
    for (int run = 0; run < runs; ++run) {
      one.seconds.push_back(60 * in.minutes[k]);
      one.metrics["tre_mm"].push_back(seen(in, k, 1, random));
    }
  }
  return all;
}

bool is_caught(const World& in, const std::vector<std::string>& cases, double factor, std::mt19937& random) {
  Results base, now;
  for (const std::string& id : cases) {
    const auto k = static_cast<std::size_t>(std::stoi(id.substr(1)));
    for (Results* results : {&base, &now}) {
      results->cases.push_back(id);
      results->metrics["tre_mm"].push_back(seen(in, k, results == &base ? 1 : factor, random));
    }
  }
  GateOptions strict;
  strict.metrics["tre_mm"].percent = 0;
  return compare_results(base, now, strict)->verdict == GateVerdict::worse;
}

TEST(ChooseCases, CatchesMoreInTheSameMinutesThanAnyCasesOrTheShortest) {
  std::mt19937 random(11);
  constexpr int trials = 300;
  constexpr double budget = 40;
  int by_history = 0, by_chance = 0, by_length = 0, false_alarms = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const World in = world(random, 60);
    const auto choice = choose_cases(histories(in, 6, random), budget);
    ASSERT_TRUE(choice);
    EXPECT_LE(choice->minutes, budget);
    std::vector<std::string> chosen;
    for (const CaseWorth& one : choice->chosen) chosen.push_back(one.id);
    const auto as_many_as_fit = [&](std::vector<std::size_t> order) {
      std::vector<std::string> fitting;
      double minutes = 0;
      for (const std::size_t k : order) {
        if (minutes + in.minutes[k] > budget) continue;
        minutes += in.minutes[k];
        fitting.push_back(fmt::format("p{}", k));
      }
      return fitting;
    };
    std::vector<std::size_t> order(in.level.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::shuffle(order.begin(), order.end(), random);
    by_chance += is_caught(in, as_many_as_fit(order), 1.03, random);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return in.minutes[a] < in.minutes[b]; });
    by_length += is_caught(in, as_many_as_fit(order), 1.03, random);
    by_history += is_caught(in, chosen, 1.03, random);
    false_alarms += is_caught(in, chosen, 1, random);
  }
  RecordProperty("by_history", by_history);
  RecordProperty("by_chance", by_chance);
  RecordProperty("by_length", by_length);
  EXPECT_GT(by_history, by_length);
  EXPECT_GT(by_length, by_chance);
  EXPECT_LE(false_alarms, 0.05 * trials + 2 * std::sqrt(0.05 * 0.95 * trials));
}

CaseHistory of(const std::string& id, double seconds, std::vector<double> values) {
  return {id, std::vector<double>(values.size(), seconds), {{"tre_mm", std::move(values)}}};
}

std::vector<std::string> names(const std::vector<CaseWorth>& cases) {
  std::vector<std::string> all;
  for (const CaseWorth& one : cases) all.push_back(one.id);
  return all;
}

TEST(ChooseCases, TakesWhatWasNeverRunThenWhatGotWorseThenWhatRepeats) {
  const double lost = std::nan("");
  const auto choice = choose_cases({of("steady", 60, {1, 1.01, 0.99, 1, 1.01, 1}),
                                    of("wild", 60, {1, 1.3, 0.8, 1.2, 0.7, 1.1}),
                                    of("regressed", 60, {1, 1.01, 0.99, 1.4, 1.39, 1.4}),
                                    of("fails", 60, {1, lost, 1, 1.01, lost, 1}),
                                    of("slow", 600, {1, 1.01, 0.99, 1, 1.01, 1}),
                                    {"new", {}, {}}},
                                   4.5);
  ASSERT_TRUE(choice);
  EXPECT_THAT(names(choice->chosen), ElementsAre("new", "fails", "regressed", "steady"));
  EXPECT_THAT(names(choice->left_out), testing::UnorderedElementsAre("slow", "wild"));
  EXPECT_EQ(choice->chosen[1].got_worse, 2);
  EXPECT_EQ(choice->chosen[2].got_worse, 1);
  EXPECT_EQ(choice->chosen[0].minutes, 1);  // as the median case
  EXPECT_EQ(choose_cases({of("slow", 600, {1, 1})}, 2).error().code, "gate-budget");
}

TEST(ChooseCases, ReadsAHistoryAndRefusesWhatIsNone) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "history.csv";
  const auto read = [&](const std::string& text) {
    EXPECT_TRUE(write_text_file(file, text));
    return read_gate_history(file);
  };
  const auto all = read("case,seconds,dice,tre_mm\na,60,0.9,2\nb,,0.8,\na,66,0.91,2.1\n");
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 2u);
  EXPECT_THAT(all->front().seconds, ElementsAre(60, 66));
  EXPECT_TRUE(std::isnan(all->back().metrics.at("tre_mm").front()));
  for (const char* bad :
       {"", "case,minutes\na,1\n", "case,seconds,x,x\na,1,2,3\n", "case,seconds\n,1\n", "case,seconds\na,1,2\n"}) {
    EXPECT_EQ(read(bad).error().code, "gate-history-invalid") << bad;
  }
}

TEST(ChooseCases, LeavesOutWhatWasNotChosenAndMissesWhatWas) {
  Results base, now;
  base.cases = {"a", "b", "c"};
  base.metrics["tre_mm"] = {1, 2, 3};
  base.pictures = {{"a/x.png", ""}, {"c/x.png", ""}};
  now.cases = {"b"};
  now.metrics["tre_mm"] = {2};
  const auto chosen = only(base, {"a", "b"});
  EXPECT_THAT(chosen.cases, ElementsAre("a", "b"));
  EXPECT_THAT(chosen.metrics.at("tre_mm"), ElementsAre(1, 2));
  EXPECT_EQ(chosen.pictures.size(), 1u);
  EXPECT_EQ(compare_results(only(base, {"b"}), only(now, {"b"}))->verdict, GateVerdict::same);
  EXPECT_THAT(compare_results(chosen, only(now, {"a", "b"}))->only_base, ElementsAre("a"));
}

}  // namespace
}  // namespace glisson::studies
