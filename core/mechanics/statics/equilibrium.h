#pragma once
// Equilibrium at large deformation: the displacement at which what the body and its surroundings resist with balances
// dead loads and the pressure of a gas. Newton's method on the total energy (newton.h); the load is put on in parts
// where all of it at once does not converge.

#include <Eigen/Core>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/statics/static_result.h"

namespace glisson::mechanics {

struct NewtonOptions {
  double relative_tolerance = 1e-6;  // of the loads; Newton's last step usually leaves far less
  int max_steps = 40;                // for each part of the load: what needs more is better loaded in smaller parts
  int max_halvings = 6;              // of the load: no part is smaller than 1/64 of it
  int max_steps_in_all = 600;        // 64 parts of nine steps
};

// The result's `iterations` are Newton steps, all parts of the load together; `external_work_uJ` is f.u, of dead loads,
// and `applied_force_mN` holds the gas too;
// `largest_strain` measures stretch. A result that did not converge holds the last equilibrium found, and `why_stopped`
// says under how much of the load. Failures: those of load_vector; "too-large", "factorisation-failed", "cancelled".
Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials, const Loads& loads,
                                      const NewtonOptions& options = {}, const Progress& progress = {});

// The same under given loads, or under dead forces on the nodes alone (mN, 3 a node, finite).
Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials,
                                      const AppliedLoads& loads, const NewtonOptions& options = {},
                                      const Progress& progress = {});
Result<StaticResult> find_equilibrium(const Body& body, const std::vector<Material>& materials,
                                      const Eigen::VectorXd& force_mN, const NewtonOptions& options = {},
                                      const Progress& progress = {});

// Where the body is when it is moved by u: reactions, energies, strains. Neither a status nor how it was found. What
// `damping_mN` says acts too, beside the loads (zeros in equilibrium).
[[nodiscard]] StaticResult state_of(const Body& body, const std::vector<Material>& materials,
                                    const Eigen::VectorXd& u_mm, const AppliedLoads& loads,
                                    const Eigen::VectorXd& damping_mN);

// The gas follows the surface unless the body is linear elastic.
[[nodiscard]] PressureKind pressure_kind_of(const std::vector<Material>& materials);

}  // namespace glisson::mechanics
