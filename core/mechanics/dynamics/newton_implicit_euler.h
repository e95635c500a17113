#pragma once
// Implicit Euler for a body of any material, by Newton's method. It does what ImplicitEuler cannot (hyperelastic laws,
// ligaments, a capsule, follower pressure), and is slower by far.
//
// A step h from u_n, v_n is the minimum of an incremental potential (e.g. Gast et al. 2015, Optimization Integrator for
// Large Time Steps); then v = (u - u_n) / h:
//   E(u) - f.u + |u - u_n - h v_n|^2_M / (2 h^2) + alpha |u - u_n|^2_M / (2 h) + beta |u - u_n|^2_K / (2 h)
// - E: the potential energy of body and supports (total_potential.h), f the loads.
// - M: the mass, lumped at the nodes; K: the positive part of the tangent at u_n.
// - alpha, beta: Rayleigh damping.
// Of a body that relaxes (materials/relaxation.h), E is of tissue with `share_within` of its moduli, and what is left
// of older stresses is one term more (stress_history.h).
//
// Lengths mm, velocities mm/s, forces mN; values of nodes are 3 a node, in the order of NodeLayout.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/dynamics/implicit_euler.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/materials/material.h"

namespace glisson::mechanics {

struct BodyProblem;

class NewtonImplicitEuler {
 public:
  // At rest and still, under loads that stay. The body must be laid out with linear cells. The options' tolerance is of
  // the forces at the step's start; `max_iterations` is of Newton steps. Failures: those of
  // check_dynamics_options.
  static Result<NewtonImplicitEuler> create(Body body, std::vector<Material> materials, AppliedLoads loads,
                                            const DynamicsOptions& options);

  // The report's `iterations` are Newton steps, its strain energy that of the body alone. A step that does not converge
  // moves nothing. Failures: "too-large", "factorisation-failed", "cancelled".
  Result<StepReport> step(const Progress& progress = {});

  // The same in contact: `minimise_with_tools` finds the minimum of the step's potential energy with the tools' terms
  // (augmented_lagrangian.h). Failures: those of `minimise_with_tools`.
  using MinimiseWithTools = std::function<Result<bool>(const BodyProblem& problem)>;
  Result<StepReport> step(const AppliedLoads& loads, const MinimiseWithTools& minimise_with_tools,
                          const Progress& progress = {});

  void set_velocity(const Eigen::VectorXd& velocity_mm_s);
  [[nodiscard]] const Eigen::VectorXd& displacement_mm() const { return u_mm_; }
  [[nodiscard]] const Eigen::VectorXd& velocity_mm_s() const { return v_mm_s_; }
  [[nodiscard]] const Body& body() const { return body_; }
  // None where nothing relaxes.
  [[nodiscard]] const StressHistory* history() const { return history_ ? &*history_ : nullptr; }

 private:
  NewtonImplicitEuler() = default;
  [[nodiscard]] Potentials older() const;  // stresses, where the body relaxes
  [[nodiscard]] StepReport moved_to(const Eigen::VectorXd& u_mm, StepReport report);

  Body body_;
  std::vector<Material> materials_;       // of a step
  std::optional<StressHistory> history_;  // where the body relaxes
  AppliedLoads loads_;
  DynamicsOptions options_;
  Eigen::SparseMatrix<double> mass_kg_;  // diagonal
  Eigen::VectorXd u_mm_, v_mm_s_;
};

// Mass lumped at the nodes of linear cells (kg), 3 equal values a node.
[[nodiscard]] Eigen::VectorXd lumped_mass_kg(const Body& body);

}  // namespace glisson::mechanics
