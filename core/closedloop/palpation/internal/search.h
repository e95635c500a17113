#pragma once
// Where to begin the search for an effect of a specimen's structure. The factor at hand gives cheaply what small
// amounts of it would do to the markers. That is held against what is left unexplained. A hidden inclusion is looked
// for everywhere at once (ball_search.h).

#include <Eigen/Core>
#include <vector>

#include "closedloop/experiment/forward_model.h"
#include "closedloop/palpation/internal/ball_search.h"
#include "closedloop/palpation/internal/solver.h"
#include "closedloop/palpation/internal/state.h"

namespace glisson::closedloop {

// Where starts are looked for, and how many are worth a fit.
struct PalpationStartOptions {
  // What bends with the load.
  std::size_t fewest_shots = 4;     // of a marker: they leave something to a square beside a line
  double bend_in_deviations = 4;    // of what noise would show: one alarm in some ten thousand
  double minimum_curvature = 1e-6;  // of a square beside a line: below it the loads are too alike to tell
  // Supports: the amount that the first order gives, held near to where it can be believed.
  double minimum_compliance = 1e-2;  // of the usual one: less is a support that holds
  double maximum_compliance = 30;    // of the usual one: far beyond what the first order can say
  double minimum_capsule = 0.1;      // of the usual one: from no capsule at all the search finds no way
  // Fibres.
  std::size_t maximum_axes = 6;       // a strong fibre direction does not act as a weak one: several are looked at
  double worth_of_axis = 0.4;         // of the best one's gain: below it another is not mistaken for it
  double minimum_fibre_ratio = 0.5;   // the first order says little beyond twofold ...
  double maximum_fibre_ratio = 4;     // ... and tissue is seldom more anisotropic
  double away_from_isotropic = 0.02;  // at a ratio of 1 the axis does nothing, and its slope vanishes
  // Inclusions.
  BallSearchOptions balls;
  double worth_if_soft = 0.5;  // lumps are stiff before they are soft: a soft one must explain twice as much
  double minimum_log_ratio = -1, maximum_log_ratio = 1.5;  // Born's approximation holds for small changes only
  double stiff_from = 1.3, soft_to = 0.8;                  // away from 1, where place and size do nothing
  // Attachments: the stiffer the springs, the less a stiffer one changes, so that they are stiffer than the first order
  // says.
  double stiffer_than_first_order = 3;
  Eigen::Index maximum_places = 60;  // an adjoint solve for each coordinate of each; more add little to a start
};

// What a state leaves unexplained, in the specimen's frame.
struct ResidualField {
  Eigen::MatrixXd residual_mm;  // measured - predicted: 3 rows a place, a column a shot; zero where not seen
  Eigen::MatrixXd seen;         // 1 where seen
  Eigen::MatrixXd amounts;      // of each unit load (rows) at each shot, divided by the state's stiffness factor
};

// A row a place's coordinate, a column a shot.
[[nodiscard]] Match match(const ResidualField& left, const Eigen::MatrixXd& change_mm);

// Whether what is left bends with the load. Each marker's coordinate in each trial is split into a constant, a part
// proportional to the load and one along its square. It bends where that last part is more than noise would show.
[[nodiscard]] bool bends_with_the_load(const ResidualField& left, double noise_mm,
                                       const PalpationStartOptions& options = {});

// Best first, their promises in mm2; empty where the effect's own starts serve as well.
[[nodiscard]] std::vector<Start> palpation_starts(const Effect& effect, const PalpationSolver& solver,
                                                  const PalpationState& state, const ResidualField& left,
                                                  const PalpationStartOptions& options = {});

// A lump's, from any numbers that were seen; their promises in the square of these numbers' unit.
[[nodiscard]] std::vector<Start> inclusion_starts(const Effect& effect, const PalpationSolver& solver,
                                                  const PalpationState& state, const SeenNumbers& seen,
                                                  const PalpationStartOptions& options = {});
// An attachment's, alike.
[[nodiscard]] std::vector<Start> attachment_starts(const Effect& effect, const PalpationSolver& solver,
                                                   const PalpationState& state, const SeenNumbers& seen,
                                                   const PalpationStartOptions& options = {});

}  // namespace glisson::closedloop
