// What an answer is worth: the worst of what is known of it decides.

#include "mechanics/statics/validity.h"

#include <gmock/gmock.h>

#include "mechanics/simulation.h"

namespace glisson::mechanics {
namespace {

using testing::HasSubstr;

TEST(Validity, TheWorstDecides) {
  EXPECT_EQ((Validity{true, 0.2, 0}).state(), AnswerState::within);
  EXPECT_EQ((Validity{true, 0.21, 0}).state(), AnswerState::outside_of_the_model);
  EXPECT_EQ((Validity{true, 0.21, 1}).state(), AnswerState::unusable);
  EXPECT_EQ((Validity{false, 0.1, 1}).state(), AnswerState::not_converged);
  EXPECT_TRUE((Validity{true, 0.9, 0}).usable());
  EXPECT_FALSE((Validity{true, 0.1, 1}).usable());
  EXPECT_FALSE(Validity{}.usable());
}

TEST(Validity, HyperelasticLawsKnowLargeStrain) {
  StaticResult result;
  result.status = SolveStatus::converged;
  result.largest_strain = 0.6;
  EXPECT_EQ(validity_of(result, MaterialLaw::linear).state(), AnswerState::outside_of_the_model);
  EXPECT_EQ(validity_of(result, MaterialLaw::corotational).state(), AnswerState::outside_of_the_model);
  EXPECT_EQ(validity_of(result, MaterialLaw::neo_hookean).state(), AnswerState::within);
  EXPECT_TRUE(result.may_be_used());
  result.inverted_cells = 2;
  EXPECT_TRUE(result.converged());
  EXPECT_FALSE(result.may_be_used());
  EXPECT_EQ(why_not_used(result), "cells turned inside out: 2");
  EXPECT_EQ(validity_of(result, MaterialLaw::neo_hookean).state(), AnswerState::unusable);
}

TEST(Validity, AMotionIsWorthItsWorstStep) {
  Simulation simulation;
  simulation.result.status = SolveStatus::converged;
  simulation.result.largest_strain = 0.1;
  simulation.steps.resize(3);
  simulation.steps[1].largest_strain = 0.3;
  EXPECT_EQ(validity_of(simulation).state(), AnswerState::outside_of_the_model);
  EXPECT_EQ(validity_of(simulation).largest_strain, 0.3);
  simulation.steps[1].report.inverted_cells = 4;
  EXPECT_EQ(validity_of(simulation).state(), AnswerState::unusable);
}

TEST(Validity, SaysWhyInASentence) {
  EXPECT_THAT((Validity{true, 0.42, 0}).sentence().message(), HasSubstr("strains reach 42 %, and beyond 20 %"));
  EXPECT_THAT((Validity{true, 2.1, 7}).sentence().message(), HasSubstr("inside out: 7"));
  EXPECT_EQ((Validity{true, 2.1, 7}).why_not().message(), "cells turned inside out: 7");
  EXPECT_EQ(to_string((Validity{true, 0.42, 0}).state()), "outside-of-the-model");
}

}  // namespace
}  // namespace glisson::mechanics
