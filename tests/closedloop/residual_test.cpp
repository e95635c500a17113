// The tests of a residual alarm on structure, and leave noise alone.

#include "closedloop/experiment/residual.h"

#include <gmock/gmock.h>
#include <Eigen/Eigenvalues>
#include <random>

#include "closedloop/experiment/whitening.h"

namespace glisson::closedloop {
namespace {

// Markers on a pad, pressed with growing force in some trials.
Observations pad(int trials, int samples, int side) {
  Observations all;
  all.unit = "mm";
  all.directions = {"x", "y", "z"};
  int points = 0;
  for (int t = 0; t < trials; ++t) {
    all.trials.push_back(std::to_string(t));
    std::vector<Observation> rows;
    for (int s = 0; s < samples; ++s) {
      for (int m = 0; m < side * side; ++m, ++points) {
        const Eigen::Vector3d place_mm(5 * (m % side), 5 * (m / side), 0);
        for (int d = 0; d < 3; ++d) rows.push_back({0, 0.1, t, s, d, points, double(s), 1.0 + s, place_mm, {}});
      }
    }
    all.add(rows);
  }
  return all;
}

Eigen::VectorXd white_noise(Eigen::Index size, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
}

TEST(Residual, NoiseIsCalledNoise) {
  const Observations all = pad(3, 3, 6);
  int alarms = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    alarms +=
        residual_diagnostics(all, white_noise(all.rows(), seed), Eigen::VectorXd::Zero(all.rows())).is_noise ? 0 : 1;
  }
  EXPECT_LE(alarms, 2);  // one in a thousand is expected
}

// Ten forces beside thousands of points.
TEST(Residual, AFewRowsOfAnotherQuantityAreNotLostAmongMany) {
  Observations all;
  all.unit = "noise";
  all.directions = {"ux", "fx"};
  all.trials = {"a"};
  std::vector<Observation> rows;
  for (int row = 0; row < 3000; ++row)
    rows.push_back({.noise = 1, .direction = row % 300 == 0 ? 1 : 0, .point = row, .load = 1});
  all.add(rows);
  Eigen::VectorXd white = white_noise(all.rows(), 3);
  for (Eigen::Index row = 0; row < white.size(); row += 300) white[row] = row % 600 == 0 ? 2.5 : -2.5;
  const auto is_noise = [&] { return residual_diagnostics(all, white, Eigen::VectorXd::Zero(all.rows())).is_noise; };
  EXPECT_TRUE(is_noise());
  EXPECT_EQ(rms_of_worst_quantity(all, white), 0);
  all.quantities = {0, 1};
  EXPECT_FALSE(is_noise());
  EXPECT_GT(rms_of_worst_quantity(all, white), 1.15);
  EXPECT_LT(rms_of_worst_quantity(all, white_noise(all.rows(), 3)), 1.15);
}

TEST(Residual, StructureFarBelowTheNoiseOfAPointIsFound) {
  const Observations all = pad(3, 3, 6);
  const Eigen::VectorXd noise = white_noise(all.rows(), 7);
  const auto said = [&](const Eigen::VectorXd& structure) {
    const ResidualDiagnostics diagnostics =
        residual_diagnostics(all, noise + structure, Eigen::VectorXd::Zero(all.rows()));
    return diagnostics.is_noise ? "noise" : diagnostics.shape().front();
  };
  EXPECT_EQ(said(0.3 * (all.load.array() - 2).matrix()), "it changes with the load");
  // A bump: neither trend nor mean, but neighbours agree.
  const Eigen::VectorXd bump = Eigen::VectorXd::NullaryExpr(all.rows(), [&](Eigen::Index row) {
    const auto i = static_cast<std::size_t>(row);
    return std::sin(all.place_mm(row, 0) / 8 + all.trial[i]) * std::cos(all.place_mm(row, 1) / 8 + all.sample[i]);
  });
  EXPECT_EQ(said(bump), "neighbours are off in the same way");
}

TEST(Residual, RowsThatAreAddedLeaveThoseBeforeAsTheyAre) {
  Observations all;
  all.add({{.measured = 1, .noise = 0.1, .load = 2, .conditions = {7, 8}}});
  all.add({});
  all.add({{.measured = 3, .noise = 0.2, .trial = 1, .point = 1, .time_s = 4, .conditions = {9, 10}}});
  EXPECT_EQ(all.measured, Eigen::Vector2d(1, 3));
  EXPECT_EQ(all.noise, Eigen::Vector2d(0.1, 0.2));
  EXPECT_EQ(all.trial, (std::vector{0, 1}));
  EXPECT_EQ(all.time_s, Eigen::Vector2d(0, 4));
  EXPECT_EQ(all.load, Eigen::Vector2d(2, 0));
  EXPECT_EQ(all.conditions, (Eigen::Matrix2d() << 7, 8, 9, 10).finished());
  EXPECT_FALSE(all.has_places());
}

TEST(Residual, FiguresAreOverCoordinatesAndOverMarkers) {
  Observations all = pad(1, 1, 1);
  all.measured << 3, 0, 4;
  const ErrorFigures figures = error_figures(all, Eigen::VectorXd::Zero(3));
  EXPECT_DOUBLE_EQ(figures.rms, 5 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(figures.mean, 5);
  EXPECT_DOUBLE_EQ(figures.noise, 0.1);
}

TEST(Residual, NeighboursInTimeThatRepeatEachOtherCountLess) {
  Observations all = pad(1, 1, 40);
  all.directions = {"x"};
  std::fill(all.direction.begin(), all.direction.end(), 0);
  all.place_mm.resize(0, 3);  // one history, not one of each marker
  Eigen::VectorXd series = white_noise(all.rows(), 3);
  EXPECT_NEAR(correlation_length(all, series), 1, 0.2);
  constexpr double memory = 0.9;
  for (Eigen::Index i = 1; i < series.size(); ++i) series[i] += memory * series[i - 1];
  EXPECT_NEAR(correlation_length(all, series), (1 + memory) / (1 - memory), 7);  // of a first-order process: 19
}

// r^T C^-1 r with C = N^2 + V V^T + U U^T formed and inverted whole.
TEST(Whitening, IsASquareRootOfTheInverseCovariance) {
  const Eigen::VectorXd noise = Eigen::VectorXd::LinSpaced(12, 0.5, 2);
  const Eigen::MatrixXd directions = Eigen::MatrixXd::Random(12, 2) * 3;
  const Eigen::VectorXd shared = Eigen::VectorXd::Random(12);
  const std::vector<int> group{0, 0, 0, 1, 1, 1, 2, 2, 2, 0, 1, 2};
  const Eigen::VectorXd residual = Eigen::VectorXd::Random(12);
  const std::vector<Eigen::Index> rows{0, 2, 3, 5, 7, 8, 11};
  const Eigen::VectorXd white = Whitening(noise, {directions, shared, group, {}}, rows).whiten(residual);
  Eigen::MatrixXd systematic = Eigen::MatrixXd::Zero(12, 5);
  systematic.leftCols(2) = directions;
  for (Eigen::Index row = 0; row < 12; ++row) systematic(row, 2 + group[static_cast<std::size_t>(row)]) = shared[row];
  Eigen::MatrixXd covariance = systematic(rows, Eigen::all) * systematic(rows, Eigen::all).transpose();
  covariance.diagonal() += Eigen::VectorXd(noise(rows).array().square());
  const Eigen::VectorXd r = residual(rows);
  EXPECT_NEAR(white.squaredNorm(), r.dot(covariance.inverse() * r), 1e-10);
}

// Two trials of one series.
Observations recording(int samples) {
  Observations all;
  all.unit = "kPa";
  all.directions = {"stress"};
  for (int t = 0; t < 2; ++t) {
    all.trials.push_back(std::to_string(t));
    std::vector<Observation> rows;
    for (int s = 0; s < samples; ++s) rows.push_back({0, 0.1, t, s, 0, t * samples + s, double(s), 1.0 + s, {}, {}});
    all.add(rows);
  }
  return all;
}

TEST(ImpossibleNoise, IsToldWhereItIsLargerOrSmallerThanStatedAndNotElse) {
  const Observations all = recording(400);
  const Eigen::VectorXd noise = 0.1 * white_noise(all.rows(), 4);
  EXPECT_FALSE(impossible_noise(all, noise));
  EXPECT_NEAR(impossible_noise(all, 1.5 * noise).value(), 1.5, 0.2);
  EXPECT_NEAR(impossible_noise(all, 0.7 * noise).value(), 0.7, 0.05);
  // Something smooth that is missing, a few wild values, and noise that repeats itself say nothing of its size.
  EXPECT_FALSE(impossible_noise(all, noise + 0.01 * all.time_s));
  Eigen::VectorXd wild = noise, repeating = noise;
  for (Eigen::Index i = 0; i < wild.size(); i += 50) wild[i] *= 10;
  for (Eigen::Index i = 1; i < repeating.size(); ++i)
    repeating[i] = 0.5 * repeating[i - 1] + std::sqrt(0.75) * repeating[i];
  EXPECT_FALSE(impossible_noise(all, wild));
  EXPECT_FALSE(impossible_noise(all, repeating));
  EXPECT_FALSE(impossible_noise(recording(10), 3 * Eigen::VectorXd::Ones(20)));
  int alarms = 0;
  for (unsigned seed = 1; seed <= 500; ++seed) {
    const Observations few = recording(20 + int(seed % 100));
    alarms += impossible_noise(few, 0.1 * white_noise(few.rows(), seed)).has_value() ? 1 : 0;
  }
  EXPECT_EQ(alarms, 0);
}

}  // namespace
}  // namespace glisson::closedloop
