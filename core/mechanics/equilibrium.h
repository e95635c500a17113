#pragma once
// Equilibrium at large deformation: the displacement at which what the body and its foundations resist with balances
// dead loads. Newton's method on the total energy with a line search (Nocedal and Wright, Numerical Optimization,
// 3.1 and 3.4), on an exact tangent where it is positive definite and on its positive part where it is not; the load
// is put on in parts where all of it at once does not converge.

#include <Eigen/Core>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/body.h"
#include "mechanics/large_deformation.h"
#include "mechanics/static_result.h"

namespace glisson::mechanics {

struct NewtonOptions {
  double relative_tolerance = 1e-6;  // of the loads; Newton's last step usually leaves far less
  int max_steps = 40;                // for each part of the load: what needs more is better loaded in smaller parts
  int max_halvings = 6;              // of the load: no part is smaller than 1/64 of it
};

// The result's `iterations` are Newton steps, all parts of the load together; `external_work_uJ` is f.u, of dead loads;
// `largest_strain` measures stretch. A result that did not converge holds the last equilibrium found, and `why_stopped`
// says under how much of the load. Failures: those of load_vector; "too-large", "factorisation-failed", "cancelled".
Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials, const Loads& loads,
                                      const NewtonOptions& options = {}, const Progress& progress = {});

// The same under given forces on the nodes (mN, 3 a node, finite).
Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials,
                                      const Eigen::VectorXd& force_mN, const NewtonOptions& options = {},
                                      const Progress& progress = {});

}  // namespace glisson::mechanics
