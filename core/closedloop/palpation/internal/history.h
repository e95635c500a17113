#pragma once
// The load that a creeping specimen feels: what was put on, by its creep function J(t)/J(0) = 1 + sum a (1 - e^(-t/T)).
// In linear viscoelasticity with one creep function for the whole body, displacements follow the load
//   F(t) + sum a y(t),   T y' + y = F,   y = 0 before the first sample
// as elastic ones follow F (the correspondence principle; e.g. R. M. Christensen, Theory of Viscoelasticity, 2.1).
// F is piecewise linear between samples, for which y is exact; it starts with the first sample, with a step where that
// is not zero.

#include <Eigen/Core>
#include <vector>

#include "closedloop/palpation/internal/state.h"

namespace glisson::closedloop {

// F + sum a y at the samples.
[[nodiscard]] Eigen::VectorXd effective_load(const Eigen::VectorXd& time_s, const Eigen::VectorXd& load,
                                             const std::vector<CreepTerm>& creep);

// Of one term: y at the samples, and dy/dT.
struct DelayedLoad {
  Eigen::VectorXd value;
  Eigen::VectorXd by_time;
};
[[nodiscard]] DelayedLoad delayed_load(const Eigen::VectorXd& time_s, const Eigen::VectorXd& load, double delay_s);

}  // namespace glisson::closedloop
