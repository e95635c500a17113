#pragma once
// A tied pad that a tool pulls before a camera: what the tests of guidance look at.

#include <random>
#include <string>

#include "closedloop/palpation_bodies.h"

namespace glisson::closedloop::test {

// A pad that is held below and tied at a part of one side; each frame is one pull of a tool, seen by landmarks.
inline Guidance guided_pad(const std::array<int, 3>& bricks = {4, 4, 2}) {
  Guidance guidance;
  guidance.organ = test::pad({.bricks = bricks, .markers = 80, .forces_N = {0.8, 1.6}, .hold_on = false});
  mechanics::test::name_points(guidance.organ.mesh, "tie",
                               [](const Eigen::Vector3d& p) { return p.x() < 1e-9 && p.y() < 31; });
  guidance.organ.supports.push_back(mechanics::test::fixed("tie"));
  std::vector<PalpationTrial> frames;
  for (const PalpationTrial& trial : guidance.organ.trials) {
    GuidanceTrial pull{trial.id, {}};
    for (std::size_t s = 1; s < trial.samples.size(); ++s) {
      pull.frames.push_back(frames.size());
      frames.push_back(trial);
      frames.back().id += "-" + std::to_string(s);
      frames.back().samples = {PalpationSample{}, trial.samples[s]};
      guidance.time_s.push_back(trial.samples[s].time_s);
    }
    guidance.trials.push_back(std::move(pull));
  }
  guidance.organ.trials = std::move(frames);
  guidance.points_mm.resize(guidance.organ.trials.size());
  guidance.targets.resize(guidance.organ.trials.size());
  guidance.landmark_noise_mm = guidance.organ.noise_mm;
  return guidance;
}

// The landmarks as they move, in place of what was measured: most of them as points of the surface without names.
inline Guidance seen_as(Guidance guidance, const Eigen::VectorXd& displacement_mm, double noise_mm) {
  constexpr std::size_t named = 8;
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, noise_mm);
  Eigen::Index row = 0;
  for (std::size_t f = 0; f < guidance.organ.trials.size(); ++f) {
    auto& markers = guidance.organ.trials[f].samples.back().markers;
    for (Marker& marker : markers) {
      marker.position_mm = marker.rest_mm + displacement_mm.segment<3>(row);
      for (int d = 0; d < 3; ++d) marker.position_mm[d] += normal(random);
      row += 3;
    }
    for (std::size_t m = named; m < markers.size(); ++m) guidance.points_mm[f].push_back(markers[m].position_mm);
    markers.resize(named);
  }
  guidance.organ.noise_mm = guidance.landmark_noise_mm = noise_mm;
  return guidance;
}

}  // namespace glisson::closedloop::test
