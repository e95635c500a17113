// How a specimen answers a prescribed stretch, against plain time stepping.

#include "closedloop/material/behaviour.h"

#include <gtest/gtest.h>
#include <cmath>

namespace glisson::closedloop {
namespace {

// To and fro, with turns half way.
Eigen::VectorXd path(Eigen::Index samples) {
  Eigen::VectorXd stretch(samples);
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double t = 12.0 * double(i) / double(samples - 1);
    stretch[i] = 1 + 0.1 * std::sin(t) + 0.04 * std::sin(3.7 * t);
  }
  return stretch;
}

Eigen::VectorXd friction_alone(const Eigen::VectorXd& stretch, HysteresisLaw law, double exponent) {
  MaterialBehaviour behaviour;
  behaviour.mode = Mode::shear;
  behaviour.young_kPa = 0;
  behaviour.hysteresis = law;
  behaviour.friction_kPa = 1;
  behaviour.slip_strain = 0.02;
  behaviour.dahl_exponent = exponent;
  return reading_kPa(behaviour, Eigen::VectorXd::LinSpaced(stretch.size(), 0, 1), stretch);
}

TEST(Hysteresis, DahlsLawIsItsDifferentialEquation) {
  constexpr int steps = 200000;
  const Eigen::VectorXd fine = path(steps + 1);
  for (const double exponent : {0.5, 1.0, 1.5, 2.0, 3.0}) {
    const Eigen::VectorXd reading = friction_alone(path(401), HysteresisLaw::dahl, exponent);
    double f = 0, largest = 0;
    for (int i = 1; i <= steps; ++i) {
      const double de = fine[i] - fine[i - 1];
      const double sign = de > 0 ? 1 : -1;
      f += sign * std::pow(std::max(0.0, 1 - f * sign), exponent) * std::abs(de) / 0.02;
      if (i % (steps / 400) == 0) largest = std::max(largest, std::abs(f - reading[i / (steps / 400)]));
    }
    // Samples turn up to a four-hundredth of the way away from where the path does.
    EXPECT_LT(largest, 0.05) << exponent;
  }
}

TEST(Hysteresis, DahlsLawOfExponentNoneIsTheSlider) {
  const Eigen::VectorXd stretch = path(401);
  const Eigen::VectorXd dahl = friction_alone(stretch, HysteresisLaw::dahl, 0);
  const Eigen::VectorXd slider = friction_alone(stretch, HysteresisLaw::friction, 1);
  EXPECT_LT((dahl - slider).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace glisson::closedloop
