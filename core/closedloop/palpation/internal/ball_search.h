#pragma once
// Where in a specimen a ball of something else explains best what is left: a lump inside, an attachment on the surface.
// Adjoint solves, one a number that was seen, give the influence of each part (a cell, a face) on every number. Sums
// over the parts of a ball give its influence (Born's approximation).

#include <array>
#include <Eigen/Core>
#include <vector>

#include "closedloop/palpation/internal/solver.h"

namespace glisson::closedloop {

// How much of a change of what is seen explains the residual best, and how much of its square that takes away.
struct Match {
  double amount = 0;
  double gain = 0;
};

// What was seen: each number is a weighted sum of displacements, over several shots of several unit loads.
struct SeenNumbers {
  Eigen::MatrixXd weights;          // an unknown of the specimen a row, a number a column
  std::vector<Eigen::Index> loads;  // unit loads that acted at all
  // Of each number, over the shots that saw it, by the loads that acted: what is left of it times their amounts
  // (numbers x loads), and amounts times amounts (loads x loads).
  Eigen::MatrixXd residual_by_load;
  std::vector<Eigen::MatrixXd> load_by_load;
};

// Parts of a specimen, and what a unit of something else in each changes in every number (numbers x loads).
struct PartsInfluence {
  std::vector<Eigen::Vector3d> centroids_mm;
  std::vector<Eigen::MatrixXf> of_part;
};

// The influence of a relative change of each cell's modulus.
[[nodiscard]] PartsInfluence influence_of_cells(const PalpationSolver& solver,
                                                const PalpationSolver::Solution& solution, const SeenNumbers& seen);

// ... of springs of 1 kPa/mm under each face of the boundary that is not held.
[[nodiscard]] PartsInfluence influence_of_faces(const PalpationSolver& solver,
                                                const PalpationSolver::Solution& solution, const SeenNumbers& seen);

// Lengths are shares of the largest radius that is looked for.
struct BallSearchOptions {
  double spacing = 0.25;                        // no further apart than the smallest is wide
  std::array<double, 3> radii{0.25, 0.4, 0.6};  // a ball's gain changes slowly with its radius
  std::size_t maximum_balls = 3;                // each costs a fit of five numbers
  double worth_of_ball = 0.6;                   // of the best one's gain: below it another is not mistaken for it
};

struct FoundBall {
  Eigen::Vector3d center_mm{0, 0, 0};
  double radius_mm = 0;
  Match match;
};

// About the centroids of parts, apart from each other, the best first. `worth_if_negative`: of a ball whose match has a
// negative amount, as a share of its gain.
[[nodiscard]] std::vector<FoundBall> promising_balls(const PartsInfluence& parts, const SeenNumbers& seen,
                                                     double smallest_mm, double largest_mm, double worth_if_negative,
                                                     const BallSearchOptions& options);

}  // namespace glisson::closedloop
