// Wild values among measured ones: how probable they are against a plain sum over all that may be, and that they are
// taken neither for an effect nor for something else, nor an effect for them.

#include "closedloop/inference/internal/wild_values.h"

#include <gmock/gmock.h>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "closedloop/hardware/behaviour.h"
#include "closedloop/inference/diagnosis.h"
#include "closedloop/inference/internal/log_sum.h"
#include "closedloop/inference/posterior.h"
#include "closedloop/material/model.h"
#include "made_up_tests.h"

namespace glisson::closedloop {
namespace {

const PosteriorOptions wild_options;

Eigen::VectorXd standard_normal(Eigen::Index rows, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd values(rows);
  for (double& value : values) value = normal(random);
  return values;
}

// ln of how probable a residual is: each row of one of two normals, summed over their share and over the noise's size.
double log_probability_of_mixture(const Eigen::VectorXd& white) {
  constexpr int shares = 60, sizes = 200;
  const double others = 1 / wild_options.wild_share - 1, wide = wild_options.wild_times;
  std::vector<double> logs;
  for (int s = 0; s < shares; ++s) {
    const double share = 0.1 * (s + 0.5) / shares;
    for (int k = 0; k < sizes; ++k) {
      const double log_size = -1 + 2 * (k + 0.5) / sizes, size = std::exp(log_size);
      double log = std::log(others) + (others - 1) * std::log(1 - share) + std::log(0.1 / shares) +
                   log_density_of_noise_scale(log_size, wild_options).value + std::log(2.0 / sizes);
      for (const double value : white) {
        const auto normal = [&](double of) { return std::exp(-0.5 * value * value / of / of) / of; };
        log += std::log((1 - share) * normal(size) + share * normal(wide * size));
      }
      logs.push_back(log);
    }
  }
  return log_sum(logs);
}

// The same by what wild_values says.
double log_probability_by_worth(const Eigen::VectorXd& white) {
  const WildValues wild = wild_values(white, wild_options);
  constexpr int sizes = 2000;
  std::vector<double> logs;
  for (int k = 0; k < sizes; ++k) {
    const double log_size = -1 + 2 * (k + 0.5) / sizes;
    logs.push_back(log_density_of_noise_scale(log_size, wild_options).value + std::log(2.0 / sizes) -
                   double(white.size()) * log_size - 0.5 * wild.worth.dot(white.cwiseAbs2()) * std::exp(-2 * log_size));
  }
  return log_sum(logs) + wild.log_probability;
}

TEST(WildValues, AreAsProbableAsASumOverAllThatMayBeWildSays) {
  for (const int wild : {0, 1, 4, 12}) {
    Eigen::VectorXd white = standard_normal(400, 11);
    for (int i = 0; i < wild; ++i) white[30 * i + 7] = (i % 2 == 0 ? 1 : -1) * (5 + i);
    const double exact = log_probability_of_mixture(white), bound = log_probability_by_worth(white);
    EXPECT_LT(bound, exact + 0.1) << wild;
    EXPECT_GT(bound, exact - 1) << wild;
  }
}

TEST(WildValues, CountLittleAndTheOthersAllTheSame) {
  Eigen::VectorXd white = 1.5 * standard_normal(300, 3).cwiseMax(-2.5).cwiseMin(2.5);
  white[40] = 12;
  white[200] = -30;
  const Eigen::VectorXd worth = wild_values(white, wild_options).worth;
  EXPECT_LT(worth[40], 0.05);
  EXPECT_LT(worth[200], 0.05);
  EXPECT_EQ((worth.array() > 0.7).count(), 298);
}

// Two in a hundred six or twenty times as large: otherwise than the options have it.
Material with_wild_values(const test::Answer& answer, double times, unsigned seed) {
  Material material = test::compression_tests(answer, 0.1, seed);
  std::mt19937 random(seed + 100);
  std::normal_distribution<double> normal(0, 0.1 * times);
  for (MaterialTrial& trial : material.trials)
    for (Eigen::Index i = Eigen::Index(random() % 50); i < trial.stress_kPa.size(); i += 50)
      trial.stress_kPa[i] += normal(random);
  return material;
}

TEST(WildValues, AreNoSignOfAnythingAndHideNoEffect) {
  for (const double times : {6.0, 20.0}) {
    for (const unsigned seed : {1u, 2u}) {
      const auto nothing =
          diagnose(*material_model(with_wild_values(test::straight_line, times, seed)).value()).value();
      EXPECT_EQ(nothing.verdict, Verdict::nothing_missing) << times << " " << posterior_sentence(nothing).message();
    }
    const auto relaxing = [](const auto& trial) {
      return test::relaxing(test::straight_line(trial), trial.time_s, 0.1, 12);
    };
    const auto creep = diagnose(*material_model(with_wild_values(relaxing, times, 4)).value()).value();
    EXPECT_EQ(creep.posterior.front().kinds, std::vector<std::string>{"viscoelastic-creep"}) << times;
    EXPECT_GT(creep.posterior.front().probability, 0.9) << times;
    // Nothing explains what is left where wild values make it more than one and a half of the noise.
    EXPECT_EQ(creep.verdict, times < 10 ? Verdict::explained : Verdict::unexplained);
  }
}

TEST(WildValues, AtTheBeginningOfARecordingDoNotWarmIt) {
  Hardware hardware;
  hardware.idle_W = 2;
  hardware.thermal_resistance_C_per_W = 5;
  hardware.time_constant_s = 120;
  hardware.noise_C = 0.2;
  HardwareTrial trial;
  trial.ambient_C = 23;
  trial.time_s = Eigen::VectorXd::LinSpaced(4, 0, 15);
  trial.load = Eigen::VectorXd::Zero(4);
  trial.temperature_C = Eigen::Vector4d(27.5, 23.4, 23.8, 24.1);
  const auto first = [&] { return readings(declared_behaviour(hardware), hardware, trial).temperature_C[0]; };
  EXPECT_EQ(first(), 23);
  trial.temperature_C = Eigen::Vector4d(27.5, 27.8, 28.0, 28.2);
  EXPECT_EQ(first(), 27.5);
}

}  // namespace
}  // namespace glisson::closedloop
