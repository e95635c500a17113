#pragma once
// Where to begin the search for an effect of a specimen's structure: by what small amounts of it would do to the
// markers, which the factor at hand gives cheaply, held against what is left unexplained. A hidden inclusion is looked
// for everywhere at once: adjoint solves (one a marker and direction) give each cell's influence on every marker, sums
// over spheres of cells give the influence of a lump (Born's approximation). Inside of this room.

#include <Eigen/Core>
#include <vector>

#include "closedloop/experiment/forward_model.h"
#include "closedloop/palpation/internal/solver.h"
#include "closedloop/palpation/internal/state.h"

namespace glisson::closedloop {

// What a state leaves unexplained, in the specimen's frame.
struct ResidualField {
  Eigen::MatrixXd residual_mm;  // measured - predicted: 3 rows a place, a column a shot; zero where not seen
  Eigen::MatrixXd seen;         // 1 where seen
  Eigen::MatrixXd amounts;      // of each unit load (rows) at each shot, divided by the state's stiffness factor
};

// How much of a change of what is seen explains the residual best, and how much of its square that takes away.
struct Match {
  double amount = 0;
  double gain_mm2 = 0;
};
// A row a place's coordinate, a column a shot.
[[nodiscard]] Match match(const ResidualField& left, const Eigen::MatrixXd& change_mm);

// Whether what is left bends with the load: the part of it along the square of the load, besides a constant and what is
// proportional, of each marker's coordinate in each trial, is more than noise would show.
[[nodiscard]] bool bends_with_the_load(const ResidualField& left, double noise_mm);

// Best first, their promises in mm2; empty where the effect's own starts serve as well.
[[nodiscard]] std::vector<Start> palpation_starts(const Effect& effect, const PalpationSolver& solver,
                                                  const PalpationState& state, const ResidualField& left);

}  // namespace glisson::closedloop
