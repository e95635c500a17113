// The verdict is a function of what is left of the error: each of its three answers, at the bounds between them.

#include "closedloop/inference/verdict.h"

#include <gtest/gtest.h>

namespace glisson::closedloop {
namespace {

constexpr DiagnosisOptions options;

Remainder left_by(std::size_t effects, double rms_in_noise) { return {effects, false, rms_in_noise, {}}; }

TEST(Verdict, TheDeclaredModelMissesNothingUpToWhatTheNoiseIsKnownTo) {
  EXPECT_EQ(verdict_of(left_by(0, 1.049), options), Verdict::nothing_missing);
  EXPECT_EQ(verdict_of(left_by(0, 1.051), options), Verdict::unexplained);
  Remainder as_the_mesh = left_by(0, 3);
  as_the_mesh.leaves_nothing = true;
  EXPECT_EQ(verdict_of(as_the_mesh, options), Verdict::nothing_missing);
}

TEST(Verdict, EffectsMustComeCloserToTheNoiseTheMoreTheyAre) {
  EXPECT_TRUE(reaches_noise(left_by(1, 1.149), options));
  EXPECT_FALSE(reaches_noise(left_by(1, 1.151), options));
  EXPECT_TRUE(reaches_noise(left_by(3, 1.049), options));
  EXPECT_FALSE(reaches_noise(left_by(3, 1.051), options));
}

TEST(Verdict, EffectsExplainOnlyWhereTheyAreBetterEvidenceThanASmoothFunction) {
  Remainder left = left_by(2, 1);
  EXPECT_EQ(verdict_of(left, options), Verdict::unexplained) << "not weighed";
  left.evidence_over_smooth = options.alike_bic - 0.1;
  EXPECT_EQ(verdict_of(left, options), Verdict::unexplained);
  left.evidence_over_smooth = options.alike_bic;
  EXPECT_EQ(verdict_of(left, options), Verdict::explained);
  left.rms_in_noise = 2;
  EXPECT_EQ(verdict_of(left, options), Verdict::unexplained) << "evidence does not make up for what is left";
}

}  // namespace
}  // namespace glisson::closedloop
