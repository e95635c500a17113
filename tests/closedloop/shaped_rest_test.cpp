// Is something of given shapes in what a model leaves? On five presses of a specimen with forty markers, whose errors
// are known.

#include "closedloop/inference/shaped_rest.h"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <random>

namespace glisson::closedloop {
namespace {

constexpr int trials = 5, samples = 8, markers = 40;

Observations presses() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> within(-1, 1);
  std::vector<Eigen::Vector3d> places;
  for (int m = 0; m < markers; ++m) places.emplace_back(within(random), within(random), within(random));
  Observations all;
  all.directions = {"x", "y", "z"};
  std::vector<Observation> rows;
  for (int trial = 0; trial < trials; ++trial) {
    all.trials.push_back(std::to_string(trial));
    for (int sample = 0; sample < samples; ++sample)
      for (int m = 0; m < markers; ++m)
        for (int direction = 0; direction < 3; ++direction) {
          Observation row;
          row.noise = 1;
          row.trial = trial;
          row.sample = sample;
          row.direction = direction;
          row.point = (trial * samples + sample) * markers + m;
          row.time_s = row.load = sample;
          row.place_mm = places[static_cast<std::size_t>(m)];
          rows.push_back(row);
        }
  }
  all.add(rows);
  return all;
}

// Load, and load times place, in each trial.
Eigen::MatrixXd shapes_of(const Observations& all) {
  Eigen::MatrixXd shapes = Eigen::MatrixXd::Zero(all.rows(), 4L * trials);
  for (Eigen::Index row = 0; row < all.rows(); ++row) {
    const Eigen::Index first = 4L * all.trial[static_cast<std::size_t>(row)];
    shapes(row, first) = all.load[row];
    shapes.row(row).segment<3>(first + 1) = all.load[row] * all.place_mm.row(row);
  }
  return shapes;
}

// One number a row, by which the standard normal ones are changed.
Eigen::VectorXd noise(const Observations& all, const std::function<double(double normal, double uniform)>& changed) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  Eigen::VectorXd values(all.rows());
  for (double& value : values) value = changed(normal(random), uniform(random));
  return values;
}

const auto as_stated = [](double normal, double) { return normal; };
constexpr Amplitude any{3, 1.2};

// Of a root mean square of so many noises.
Eigen::VectorXd rest(const Observations& all, double noises) {
  const Eigen::VectorXd shape = all.load.cwiseProduct(all.place_mm.col(0));
  return noises * std::sqrt(double(shape.size())) / shape.norm() * shape;
}

TEST(ShapedRest, IsSeenWhereItIsAFifthOfTheNoise) {
  const Observations all = presses();
  const PosteriorOptions options;
  const ShapedRest shaped(all, shapes_of(all), options);
  const Eigen::VectorXd white = noise(all, as_stated);
  EXPECT_LT(shaped.log_odds(white, any), -2);
  EXPECT_GT(shaped.log_odds(white + rest(all, 0.2), any), 10);
}

TEST(ShapedRest, IsNotSeenInWildValuesOrInNoiseThatIsStatedWronglyOrRepeatsItself) {
  const Observations all = presses();
  const PosteriorOptions options;
  const ShapedRest shaped(all, shapes_of(all), options);
  const auto of = [&](const auto& changed) { return shaped.log_odds(noise(all, changed), any); };
  EXPECT_LT(of([](double normal, double uniform) { return uniform < 0.01 ? 10 * normal : normal; }), -2);
  EXPECT_LT(of([](double normal, double) { return 1.5 * normal; }), -2);
  EXPECT_LT(of([](double normal, double) { return 0.7 * normal; }), -2);
  Eigen::VectorXd repeating = noise(all, as_stated);
  constexpr Eigen::Index of_a_sample = 3L * markers;
  for (Eigen::Index row = of_a_sample; row < all.rows(); ++row)
    if (all.sample[static_cast<std::size_t>(row)] > 0)
      repeating[row] = 0.5 * repeating[row - of_a_sample] + std::sqrt(0.75) * repeating[row];
  EXPECT_LT(shaped.log_odds(repeating, any), 0);
}

TEST(ShapedRest, IsNoSignOfAnythingAsLargeAsThePredictionsOwnError) {
  const Observations all = presses();
  const PosteriorOptions options;
  const ShapedRest shaped(all, shapes_of(all), options);
  const Eigen::VectorXd white = noise(all, as_stated) + rest(all, 0.3);
  const Amplitude likeness{1.5, 0.7};  // half of three noises
  EXPECT_GT(shaped.log_odds(white, likeness, {0.03, 0.4}), 3);
  EXPECT_LT(shaped.log_odds(white, likeness, {0.3, 0.4}), 0);
}

// Two shapes that are one say nothing more than one does.
TEST(ShapedRest, CountsDependentShapesOnce) {
  const Observations all = presses();
  const PosteriorOptions options;
  const Eigen::MatrixXd once = shapes_of(all);
  Eigen::MatrixXd twice(once.rows(), 2 * once.cols());
  twice << once, 3 * once;
  const Eigen::VectorXd white = noise(all, as_stated) + rest(all, 0.2);
  EXPECT_NEAR(ShapedRest(all, twice, options).log_odds(white, any), ShapedRest(all, once, options).log_odds(white, any),
              0.01);
}

}  // namespace
}  // namespace glisson::closedloop
