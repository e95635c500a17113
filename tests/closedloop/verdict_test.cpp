// The verdict is what is expected to cost the minimum: each of its three answers, at the bounds between them.

#include "closedloop/inference/verdict.h"

#include <gtest/gtest.h>

namespace glisson::closedloop {
namespace {

constexpr VerdictCosts costs{.unnamed = 1, .overlooked = 2, .wrong_name = 3, .false_alarm = 10};

// Of nothing, of one cause, and the rest of something else.
Posterior believed(double nothing, double cause) {
  return {{{}, false, nothing}, {{"preload"}, false, cause}, {{}, true, 1 - nothing - cause}};
}

Verdict verdict_at(double nothing, double cause) { return verdict_of(believed(nothing, cause), cause, costs); }

TEST(Verdict, OfNothingIsChosenUntilSomethingElseIsFiveTimesAsProbable) {
  EXPECT_EQ(verdict_at(0.9, 0.05), Verdict::nothing_missing);
  EXPECT_EQ(verdict_at(1 / 5.9, 0), Verdict::nothing_missing);
  EXPECT_EQ(verdict_at(1 / 6.1, 0), Verdict::unexplained);
}

TEST(Verdict, NamesACauseFromThreeQuartersOn) {
  EXPECT_EQ(verdict_at(0, 0.76), Verdict::explained);
  EXPECT_EQ(verdict_at(0, 0.74), Verdict::unexplained);
}

TEST(Verdict, FollowsTheCosts) {
  VerdictCosts careful = costs;
  careful.wrong_name = 20;
  EXPECT_EQ(verdict_of(believed(0, 0.9), 0.9, careful), Verdict::unexplained);
  EXPECT_EQ(verdict_of(believed(0, 0.96), 0.96, careful), Verdict::explained);
}

TEST(Verdict, NamesNothingWhereNoCauseMayBeNamed) {
  EXPECT_EQ(verdict_of(believed(0, 0.99), 0, costs), Verdict::unexplained);
  EXPECT_EQ(verdict_of(believed(1, 0), 0, costs), Verdict::nothing_missing);
}

TEST(Verdict, CausesThatTheDataCannotTellApartCountTogether) {
  const Posterior posterior{{{"force-bias"}, false, 0.4},
                            {{"stiffness-scale"}, false, 0.35},
                            {{"preload", "stiffness-scale"}, false, 0.15},
                            {{}, true, 0.1}};
  EXPECT_NEAR(probability_of(posterior, {{"force-bias"}, {{}}}), 0.4, 1e-12);
  EXPECT_NEAR(probability_of(posterior, {{"force-bias"}, {{"stiffness-scale"}}}), 0.75, 1e-12);
  EXPECT_NEAR(probability_of(posterior, {{"force-bias", "preload"}, {{"stiffness-scale"}, {}}}), 0.15, 1e-12);
  // One may not stand for two.
  EXPECT_EQ(probability_of(posterior, {{"preload", "creep"}, {{"stiffness-scale"}, {}}}), 0);
}

}  // namespace
}  // namespace glisson::closedloop
