#pragma once
// Material tests with a known undeclared effect, from formulas written down here and not taken from the room under
// test.

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "closedloop/experiment/experiment.h"

namespace glisson::closedloop::test {

// Strain by time; straight lines between (seconds, strain).
using Path = std::vector<std::pair<double, double>>;

inline MaterialTrial along(const Path& path, const std::string& id, int samples) {
  MaterialTrial trial{id, Eigen::VectorXd::LinSpaced(samples, 0, path.back().first), {}, {}};
  trial.stretch.resize(samples);
  for (Eigen::Index i = 0; i < samples; ++i) {
    std::size_t piece = 1;
    while (piece + 1 < path.size() && trial.time_s[i] > path[piece].first) ++piece;
    const auto& [t0, e0] = path[piece - 1];
    const auto& [t1, e1] = path[piece];
    trial.stretch[i] = 1 + e0 + (e1 - e0) * (trial.time_s[i] - t0) / (t1 - t0);
  }
  trial.stress_kPa = Eigen::VectorXd::Zero(samples);
  return trial;
}

// Ramps at two speeds, two that are held and two with cycles; in compression. `stress` gets the whole trial.
using Answer = std::function<Eigen::VectorXd(const MaterialTrial&)>;
inline Material compression_tests(const Answer& stress, double noise_kPa, unsigned seed = 1) {
  Material material;
  material.specimen = {1000.0, 30.0};
  material.young_kPa = 20;
  material.noise_kPa = noise_kPa;
  material.trials = {along({{0, 0}, {5, -0.3}}, "fast", 60),
                     along({{0, 0}, {60, -0.3}}, "slow", 60),
                     along({{0, 0}, {2, -0.2}, {60, -0.2}}, "held", 80),
                     along({{0, 0}, {3, -0.3}, {50, -0.3}}, "held-far", 80),
                     along({{0, 0}, {10, -0.2}, {20, 0}, {30, -0.2}, {40, 0}}, "cycles", 90),
                     along({{0, 0}, {8, -0.15}, {16, 0}, {30, -0.28}, {44, 0}}, "cycles-far", 90)};
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, noise_kPa);
  for (auto& trial : material.trials) {
    trial.stress_kPa = stress(trial);
    for (double& value : trial.stress_kPa) value += noise(random);
  }
  return material;
}

inline Eigen::VectorXd straight_line(const MaterialTrial& trial) { return 20 * (trial.stretch.array() - 1); }

// One Maxwell element beside a spring, in a thousand steps between samples (explicit Euler).
inline Eigen::VectorXd relaxing(const Eigen::VectorXd& elastic, const Eigen::VectorXd& time_s, double share,
                                double constant_s) {
  Eigen::VectorXd stress = elastic;
  double maxwell = elastic[0];
  for (Eigen::Index i = 1; i < elastic.size(); ++i) {
    constexpr int steps = 1000;
    const double dt = (time_s[i] - time_s[i - 1]) / steps;
    for (int step = 0; step < steps; ++step)
      maxwell += (elastic[i] - elastic[i - 1]) / steps - dt * maxwell / constant_s;
    stress[i] = (1 - share) * elastic[i] + share * maxwell;
  }
  return stress;
}

}  // namespace glisson::closedloop::test
