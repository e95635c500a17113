// What is kept of earlier answers while trials are added.

#include "closedloop/posterior_history.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "base/json.h"
#include "base/write_file.h"

namespace glisson::closedloop {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class History : public testing::Test {
 protected:
  // Answers on these trials, and leaves a report.
  PosteriorHistory answer(const std::vector<std::string>& trials, double of_creep) {
    Observations observations;
    observations.trials = trials;
    Explanation explanation;
    explanation.posterior = {{{"viscoelastic-creep"}, false, of_creep}, {{}, true, 1 - of_creep}};
    const PosteriorHistory history = history_after(report_, explanation, observations);
    EXPECT_TRUE(write_file(report_, Json{{"history", json_of(history)}}.dump()));
    return history;
  }

  TemporaryFolder folder_;
  std::filesystem::path report_ = folder_.path() / "report.json";
};

TEST_F(History, GrowsWithTheTrials) {
  answer({"a"}, 0.4);
  answer({"a", "b"}, 0.7);
  const PosteriorHistory history = answer({"b", "a", "c"}, 0.9);
  ASSERT_EQ(history.size(), 3u);
  EXPECT_THAT(history[0].trials, ElementsAre("a"));
  EXPECT_DOUBLE_EQ(history[1].posterior[0].probability, 0.7);
  EXPECT_THAT(history[1].posterior[0].kinds, ElementsAre("viscoelastic-creep"));
  EXPECT_TRUE(history[1].posterior[1].something_else);
  EXPECT_DOUBLE_EQ(history[2].posterior[0].probability, 0.9);
}

TEST_F(History, AnAnswerOnTheSameTrialsTakesThePlaceOfTheLast) {
  answer({"a"}, 0.4);
  answer({"a", "b"}, 0.7);
  const PosteriorHistory history = answer({"a", "b"}, 0.8);
  ASSERT_EQ(history.size(), 2u);
  EXPECT_DOUBLE_EQ(history[1].posterior[0].probability, 0.8);
}

TEST_F(History, ForgetsTrialsThatAreGoneAndReportsOfSomethingElse) {
  answer({"a"}, 0.4);
  answer({"a", "b"}, 0.7);
  EXPECT_EQ(answer({"a", "c", "d"}, 0.5).size(), 2u);  // "b" is gone, "a" alone is on record
  EXPECT_EQ(answer({"x", "y"}, 0.5).size(), 1u);
  for (const char* text : {"", "[]", "{\"history\": 3}", "{\"history\": [{\"trials\": [1]}]}", "{\"history\": [[]]}"}) {
    ASSERT_TRUE(write_file(report_, text));
    EXPECT_EQ(answer({"a", "b"}, 0.5).size(), 1u) << text;
  }
}

}  // namespace
}  // namespace glisson::closedloop
