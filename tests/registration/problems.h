#pragma once
// Matching problems whose nature is known, for the tests of the solvers.

#include <algorithm>
#include <numeric>
#include <random>

#include "registration/mrf.h"

namespace glisson::registration::test {

inline Eigen::MatrixXd distances_mm(const Eigen::MatrixXd& points_mm) {  // points are rows
  Eigen::MatrixXd distances(points_mm.rows(), points_mm.rows());
  for (Eigen::Index i = 0; i < points_mm.rows(); ++i)
    for (Eigen::Index j = 0; j < points_mm.rows(); ++j) distances(i, j) = (points_mm.row(i) - points_mm.row(j)).norm();
  return distances;
}

// Points scattered in a 100 mm cube, each moved by noise and shuffled: node i's true label is truth[i].
struct ShuffledPoints {
  MatchingProblem problem;
  Labelling truth;
};
inline ShuffledPoints shuffled_points(int count, double noise_mm, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> in_cube(0, 100);
  std::normal_distribution<double> noise(0, 1);
  Eigen::MatrixXd source(count, 3), target(count, 3);
  ShuffledPoints shuffled;
  shuffled.truth.resize(static_cast<std::size_t>(count));
  std::iota(shuffled.truth.begin(), shuffled.truth.end(), 0);
  std::shuffle(shuffled.truth.begin(), shuffled.truth.end(), random);
  for (int i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) source(i, axis) = in_cube(random);
    for (int axis = 0; axis < 3; ++axis) {
      target(shuffled.truth[static_cast<std::size_t>(i)], axis) = source(i, axis) + noise_mm * noise(random);
    }
  }
  shuffled.problem.source_mm = distances_mm(source);
  shuffled.problem.target_mm = distances_mm(target);
  shuffled.problem.sigma_mm = 50;
  shuffled.problem.tau_mm = 30;
  return shuffled;
}

// The cheapest of all labelings, by trying them all.
inline double minimum_energy(const MatchingProblem& problem) {
  const MatchingEnergy energy(problem);
  Labelling labels(static_cast<std::size_t>(problem.nodes()), 0);
  double minimum = energy(labels);
  for (;;) {
    std::size_t node = 0;
    while (node < labels.size() && ++labels[node] == problem.labels()) labels[node++] = 0;
    if (node == labels.size()) return minimum;
    minimum = std::min(minimum, energy(labels));
  }
}

}  // namespace glisson::registration::test
