// Plane shear waves, whose equation has a closed form, through the model of elastography experiments.

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <random>

#include "closedloop/waves/model.h"

namespace glisson::closedloop {
namespace {

constexpr double density_kg_mm3 = 1e-6, spacing_mm = 2.5, noise = 0.05;

// A wave of amplitude 1 that runs along x and moves tissue along y, in a medium of `shear_kPa`; with noise of the seed.
WaveTrial plane_wave(const imaging::Grid& grid, double frequency_Hz, double shear_kPa, int seed) {
  const double wave_number = 2 * std::numbers::pi * frequency_Hz * std::sqrt(density_kg_mm3 / shear_kPa);
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::normal_distribution<float> scatter(0, noise);
  WaveTrial trial{std::to_string(frequency_Hz), frequency_Hz, noise, {{}}};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const auto wave = std::complex<float>(std::polar(1.0, -wave_number * spacing_mm * i));
        const float real = scatter(random), imaginary = scatter(random);
        trial.components[0].push_back(wave + std::complex<float>(real, imaginary));
      }
  return trial;
}

Elastography experiment(const std::array<int, 3>& size, double declared_kPa, double true_kPa) {
  Elastography waves;
  waves.grid.size = size;
  waves.grid.spacing_mm = {spacing_mm, spacing_mm, spacing_mm};
  waves.region.assign(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1] * size[2]), 1);
  waves.components = {"y"};
  waves.declared.shear_modulus_kPa = declared_kPa;
  waves.declared.density_kg_mm3 = density_kg_mm3;
  waves.trials = {plane_wave(waves.grid, 60, true_kPa, 1), plane_wave(waves.grid, 80, true_kPa, 2)};
  return waves;
}

double mean_square_left(const ForwardModel& model, const Settings& settings) {
  const Eigen::VectorXd left = model.observations().measured - model.predict(settings).value();
  return left.squaredNorm() / static_cast<double>(left.size());
}

TEST(WaveModel, LeavesNoiseOfVarianceOneUnderTheRightLawAlone) {
  const auto right = wave_model(experiment({40, 36, 20}, 2.0, 2.0));
  ASSERT_TRUE(right.has_value()) << right.error().message();
  const auto rows = static_cast<double>((*right)->observations().measured.size());
  EXPECT_GT(rows, 200);
  EXPECT_NEAR(mean_square_left(**right, {}), 1, 4 * std::sqrt(2 / rows));

  const auto wrong = wave_model(experiment({40, 36, 20}, 1.6, 2.0));
  ASSERT_TRUE(wrong.has_value());
  EXPECT_GT(mean_square_left(**wrong, {}), 2);
  // A factor that is wrong the other way round takes it off again.
  const Settings mended{{"stiffness-scale", "", Eigen::VectorXd::Constant(1, 2.0 / 1.6)}};
  EXPECT_NEAR(mean_square_left(**wrong, mended), 1, 4 * std::sqrt(2 / rows));
}

TEST(WaveModel, OffersNoEffectWithoutARange) {
  for (const std::array<int, 3>& size : {std::array{40, 36, 20}, {40, 36, 1}, {14, 14, 1}, {14, 15, 14}}) {
    const auto model = wave_model(experiment(size, 2.0, 2.0));
    ASSERT_TRUE(model.has_value()) << size[0] << " x " << size[1] << " x " << size[2] << ": "
                                   << model.error().message();
    for (const Effect& effect : (*model)->catalogue()) {
      for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
        const Parameter& parameter = effect.parameters[p];
        const std::string name = effect.kind + " " + effect.form + ", " + parameter.name;
        EXPECT_LT(parameter.prior_low, parameter.prior_high) << name;
        EXPECT_LE(parameter.lower, parameter.prior_low) << name;
        EXPECT_GE(parameter.upper, parameter.prior_high) << name;
        EXPECT_GE(parameter.no_effect, parameter.lower) << name;
        EXPECT_LE(parameter.no_effect, parameter.upper) << name;
        for (const Eigen::VectorXd& start : effect.starts) {
          EXPECT_GE(start[static_cast<Eigen::Index>(p)], parameter.lower) << name;
          EXPECT_LE(start[static_cast<Eigen::Index>(p)], parameter.upper) << name;
        }
      }
    }
  }
}

TEST(WaveModel, RefusesImagesThatHoldNoPatch) {
  const auto model = wave_model(experiment({6, 6, 1}, 2.0, 2.0));
  ASSERT_FALSE(model.has_value());
  EXPECT_EQ(model.error().code, "waves-no-patch");
}

}  // namespace
}  // namespace glisson::closedloop
