// The trial to make next: its information against an integral, and what making it does to a doubt.

#include "closedloop/inference/next_trial.h"

#include <gmock/gmock.h>
#include <cmath>
#include <numbers>

#include "base/json.h"
#include "closedloop/inference/diagnosis.h"
#include "closedloop/material/model.h"
#include "made_up_tests.h"

namespace glisson::closedloop {
namespace {

constexpr int draws = 4000;

ExpectedMeasurement normal(std::vector<double> mean, const Eigen::MatrixXd& spread = {}) {
  const auto rows = static_cast<Eigen::Index>(mean.size());
  return {Eigen::VectorXd::Map(mean.data(), rows), spread.size() > 0 ? spread : Eigen::MatrixXd(rows, 0)};
}

// Of two normals in one dimension, by the trapezoidal rule.
double integrated_information(double p, double distance, double deviation) {
  const auto density = [](double y, double sd) {
    return std::exp(-0.5 * y * y / (sd * sd)) / (sd * std::sqrt(2 * std::numbers::pi));
  };
  double sum = 0;
  constexpr double step = 1e-3;
  for (double y = -30; y < 30; y += step) {
    const double first = p * density(y, 1), second = (1 - p) * density(y - distance, deviation);
    const double both = first + second;
    if (first > 1e-300) sum += step * first * std::log(first / both / p);
    if (second > 1e-300) sum += step * second * std::log(second / both / (1 - p));
  }
  return sum;
}

TEST(ExpectedInformation, IsThatOfAnIntegral) {
  for (const double distance : {0.0, 0.5, 1.0, 2.0, 6.0}) {
    const double information = expected_information({0.7, 0.3}, {normal({0}), normal({distance})}, draws);
    EXPECT_NEAR(information, integrated_information(0.7, distance, 1), 0.02) << distance;
  }
  const double doubt = -0.7 * std::log(0.7) - 0.3 * std::log(0.3);
  EXPECT_NEAR(expected_information({0.7, 0.3}, {normal({0, 0}), normal({9, 9})}, draws), doubt, 1e-6);
}

TEST(ExpectedInformation, IsLessWhereParametersCouldMakeUpTheDifference) {
  // A deviation of sqrt(1 + 2^2) in place of 1.
  const double open =
      expected_information({0.5, 0.5}, {normal({0}), normal({3}, Eigen::MatrixXd::Constant(1, 1, 2))}, draws);
  EXPECT_NEAR(open, integrated_information(0.5, 3, std::sqrt(5.0)), 0.02);
  EXPECT_LT(open, expected_information({0.5, 0.5}, {normal({0}), normal({3})}, draws));
}

double doubt(const Posterior& posterior) {
  double sum = 0;
  for (const WeighedExplanation& one : posterior) sum -= one.probability * std::log(one.probability);
  return sum;
}

TEST(NextTrials, TakeTheDoubtAwayThatTheyPromiseTo) {
  // One quick ramp cannot tell a tissue that is softer from one that relaxes.
  const test::Answer relaxing = [](const auto& trial) {
    return test::relaxing(test::straight_line(trial), trial.time_s, 0.3, 4);
  };
  Material material = test::compression_tests(relaxing, 0.3);
  material.trials.resize(1);
  const Explanation first = diagnose(*material_model(material).value()).value();
  ASSERT_FALSE(first.next.to_make.empty());
  EXPECT_LT(first.posterior.front().probability, 0.8);
  const NextMeasurement& next = first.next.to_make.front();
  EXPECT_GT(next.doubt_removed, 0.3);
  for (std::size_t i = 1; i < first.next.to_make.size(); ++i)
    EXPECT_GT(first.next.to_make[i].doubt_removed, first.next.to_make[i - 1].doubt_removed);

  // By itself the first is worth what it is worth before the others, and none is worth more by much.
  const auto& possible = first.next.possible;
  ASSERT_GT(possible.size(), first.next.to_make.size());
  for (const PossibleTrial& one : possible) {
    EXPECT_LE(one.doubt_removed, next.doubt_removed + DiagnosisOptions{}.next_trial.about_as_good + 1e-9);
    EXPECT_FALSE(one.separations.empty());
    if (one.conditions == next.conditions) {
      EXPECT_EQ(one.doubt_removed, next.doubt_removed);
    }
  }

  // Made as its conditions say; the answer is the formula's above.
  const auto column = [&](const char* name) {
    const auto values = next.conditions->at(name).get<std::vector<double>>();
    return Eigen::VectorXd(Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  MaterialTrial made{"next", column("time_s"), column("stretch"), {}};
  made.stress_kPa = relaxing(made);
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0, material.noise_kPa);
  for (double& value : made.stress_kPa) value += noise(random);
  material.trials.push_back(made);
  const Explanation second = diagnose(*material_model(material).value()).value();
  EXPECT_EQ(second.posterior.front().kinds, std::vector<std::string>{"viscoelastic-creep"});
  EXPECT_LT(doubt(second.posterior), 0.7 * doubt(first.posterior));
}

TEST(NextTrials, AreNoneWhereThereIsNoDoubt) {
  const Explanation creep =
      diagnose(*material_model(test::compression_tests(
                                   [](const auto& trial) {
                                     return test::relaxing(test::straight_line(trial), trial.time_s, 0.3, 12);
                                   },
                                   0.1))
                    .value())
          .value();
  EXPECT_TRUE(creep.next.to_make.empty());
}

}  // namespace
}  // namespace glisson::closedloop
