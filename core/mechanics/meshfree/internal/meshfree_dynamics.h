#pragma once
// The meshfree engine in motion: implicit Euler over handles (eq. 4.3 of the dissertation; implicit_euler.h says how),
// conjugate gradients in double precision (eqs. 4.7-4.10). With law linear, mass, stiffness and damping are constant: A
// is assembled and factorised once, offline, and steps need one or two iterations. With the others the stiffness is
// assembled anew each step (warped, see objective.h). The factor of an older step serves until it costs more than 30
// iterations.

#include <functional>
#include <memory>

#include "mechanics/dynamics/implicit_euler.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/meshfree/internal/meshfree_body.h"

namespace glisson::mechanics {

struct BodyProblem;

class MeshfreeImplicitEuler {
 public:
  // At rest and still. Where the options say that it relaxes, the handles' moduli are `share_within` of those at once.
  // Failures: those of check_dynamics_options.
  static Result<MeshfreeImplicitEuler> create(MeshfreeBody handles, const DynamicsOptions& options);
  MeshfreeImplicitEuler(MeshfreeImplicitEuler&&) noexcept;
  MeshfreeImplicitEuler& operator=(MeshfreeImplicitEuler&&) noexcept;
  ~MeshfreeImplicitEuler();

  // One step under loads on the places of the quadratic layout. A step that does not converge moves nothing. The
  // report's residual is that of the handles' equations.
  StepReport step(const AppliedLoads& loads);

  // The same in contact: `minimise_with_tools` finds the minimum of the step's potential energy with the tools' terms
  // (augmented_lagrangian.h).
  // The report's `iterations` are Newton steps. Failures: "too-large", "factorisation-failed", "cancelled", those of
  // `minimise_with_tools`.
  using MinimiseWithTools = std::function<Result<bool>(const BodyProblem& problem)>;
  Result<StepReport> step(const AppliedLoads& loads, const MinimiseWithTools& minimise_with_tools,
                          const Progress& progress = {});

  // Of the places, 3 each.
  [[nodiscard]] Eigen::VectorXd displacement_mm() const;
  [[nodiscard]] Eigen::VectorXd velocity_mm_s() const;
  // Gives every handle the motion of a rigid body: velocity and spin (per second) about the origin.
  void set_rigid_velocity(const Eigen::Vector3d& velocity_mm_s, const Eigen::Vector3d& spin_per_s);

  // What the fixed points push back with, summed.
  [[nodiscard]] Eigen::Vector3d fixed_reaction_mN() const;
  // Of the whole body.
  [[nodiscard]] Eigen::Vector3d momentum_kg_mm_s() const;

  [[nodiscard]] const Body& body() const;
  [[nodiscard]] const StressHistory* history() const;  // none where nothing relaxes

 private:
  struct Impl;
  explicit MeshfreeImplicitEuler(std::unique_ptr<Impl> parts);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::mechanics
