#pragma once
// How displacements change with each parameter of the effects, where no tissue stiffens: one factorisation gives them
// all.

#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "closedloop/experiment/effect.h"
#include "closedloop/palpation/internal/loading.h"
#include "closedloop/palpation/internal/solver.h"
#include "closedloop/palpation/internal/state.h"

namespace glisson::closedloop {

// A matrix a parameter, in the order of the settings: mm per unit of it, 3 rows a marker, a column a shot. Zero for
// what changes the camera's view alone. `state` is that of the settings, `loading` that of the state. Failures: those
// of PalpationSolver.
[[nodiscard]] Result<std::vector<Eigen::MatrixXd>> linear_derivatives(const PalpationSolver& solver,
                                                                      const LoadColumns& columns,
                                                                      const Loading& loading,
                                                                      const PalpationState& state,
                                                                      const Settings& settings);

}  // namespace glisson::closedloop
