#pragma once
// A pad on a table, with markers on its top and sides, pressed at a few places: what the tests of palpation look at.

#include <cmath>
#include <random>

#include "closedloop/experiment/experiment.h"
#include "closedloop/experiment/forward_model.h"
#include "mechanics/bodies.h"

namespace glisson::closedloop::test {

struct PadOptions {
  std::array<int, 3> bricks{5, 5, 3};  // of six cells each
  Eigen::Vector3d size_mm{60, 60, 30};
  int markers = 40;
  std::vector<double> forces_N{0.8, 1.6};  // the watched samples of each trial
  bool hold_on = true;                     // the last force is held, and watched again later
};

inline Palpation pad(const PadOptions& options = {}) {
  Palpation experiment;
  const Eigen::Vector3d& size = options.size_mm;
  experiment.mesh = mechanics::test::box(options.bricks[0], options.bricks[1], options.bricks[2], size);
  mechanics::test::disturb_inner_points(experiment.mesh, 1.0);
  mechanics::test::name_points(experiment.mesh, "fixed", [](const Eigen::Vector3d& p) { return p.z() < 1e-9; });
  experiment.cell_young_kPa.assign(experiment.mesh.cells.size(), 17.5);
  experiment.supports = {mechanics::test::fixed("fixed")};
  experiment.noise_mm = 0.1;

  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.05, 0.95);
  std::vector<Marker> markers;
  for (int m = 0; m < options.markers; ++m) {
    Eigen::Vector3d place(unit(random) * size.x(), unit(random) * size.y(), size.z());
    if (m % 4 == 0) place = {m % 8 == 0 ? 0.0 : size.x(), unit(random) * size.y(), unit(random) * size.z()};
    if (m % 4 == 1) place = {unit(random) * size.x(), m % 8 == 1 ? 0.0 : size.y(), unit(random) * size.z()};
    markers.push_back({"m" + std::to_string(m), place, place});
  }
  const std::array<Eigen::Vector3d, 4> places{
      Eigen::Vector3d{0.3, 0.3, 1}, {0.7, 0.35, 1}, {0.6, 0.7, 1}, {0.3, 0.7, 1}};
  for (std::size_t t = 0; t < places.size(); ++t) {
    PalpationTrial trial;
    trial.id = "p0" + std::to_string(t + 1);
    const Eigen::Vector3d tilt(t == 1 ? 0.3 : 0.0, t == 2 ? -0.3 : 0.0, -1);
    trial.tool = {places[t].cwiseProduct(size), 9.0, tilt.normalized()};
    trial.samples.push_back({0, 0, {}});
    double time_s = 0;
    for (const double force_N : options.forces_N) {
      time_s += 2;
      trial.samples.push_back({time_s, units::mN_from_N(force_N), markers});
    }
    if (options.hold_on) {
      time_s += 8;
      trial.samples.push_back({time_s, trial.samples.back().force_mN, markers});
    }
    experiment.trials.push_back(std::move(trial));
  }
  return experiment;
}

// What a model predicts, put in as if it had been measured.
inline Palpation measured_as(Palpation experiment, const Eigen::VectorXd& displacement_mm, double noise_mm = 0,
                             unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  Eigen::Index row = 0;
  for (PalpationTrial& trial : experiment.trials) {
    for (PalpationSample& sample : trial.samples) {
      for (Marker& marker : sample.markers) {
        marker.position_mm = marker.rest_mm + displacement_mm.segment<3>(row);
        for (int d = 0; d < 3; ++d) marker.position_mm[d] += noise_mm * normal(random);
        row += 3;
      }
    }
  }
  return experiment;
}

}  // namespace glisson::closedloop::test
