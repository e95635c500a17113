#pragma once
// A body in motion: linear tetrahedra, linear or corotational, implicit Euler, Rayleigh damping.
//
// A step h from u, v solves eq. 4.3 of the dissertation for the change of velocity dv, then v += dv, u += h v:
//   (M - h C - h^2 K) dv = h (f + h K v),   K = df/du,   C = df/dv = -(alpha M) + beta K,
// where f is all forces at u and v. M is the mass lumped at the nodes, and K the warped stiffness of corotational.h
// with its sign. A step is one linear solve, unconditionally stable at small rotations per step. It damps motion faster
// than some tens of steps by itself (Baraff and Witkin 1998). The solve is conjugate gradients in single precision,
// started from the step before. Its residual is formed in double precision without the matrix. It is refined until that
// is within the tolerance. Every step says whether it was.
//
// A body that relaxes (materials/relaxation.h) answers in a step as tissue of `share_within` of its moduli does, and
// what is left of older stresses pushes besides (stress_history.h). K is that tissue's, in the damping too.
//
// Lengths mm, velocities mm/s, forces mN, energies uJ; values of nodes are 3 a mesh point that cells use, in the order
// of NodeLayout. The same steps give the same bits with any number of threads.

#include <cstdint>
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/dynamics/stress_history.h"
#include "mechanics/elements/body.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

struct DynamicsOptions {
  double step_s = 0.02;
  double mass_damping_per_s = 0;   // alpha
  double stiffness_damping_s = 0;  // beta
  Relaxation relaxation = {};
  double relative_tolerance = 1e-4;  // of the right-hand side, in double precision
  int max_iterations = 200;          // as in section 4.2 of the dissertation; most steps need a few dozen
  // Conjugate gradients run on the first OpenCL device whose name contains this, "" for any (device_gradients.h).
  std::optional<std::string> device = std::nullopt;
};

// Failures: "step-invalid" (which number is out of range), "relaxation-invalid".
Result<void> check_dynamics_options(const DynamicsOptions& options);

struct StepReport {
  bool converged = false;
  double relative_residual = 0;  // |A dv - b| / |b|, formed in double precision
  int iterations = 0;            // of conjugate gradients
  int inverted_cells = 0;        // after the step
  double kinetic_energy_uJ = 0;
  double strain_energy_uJ = 0;  // of a body that relaxes its free energy
  double step_ms = 0;
};

class ImplicitEuler {
 public:
  // At rest and still. The body must be laid out with linear cells; the law must be linear or corotational. Failures:
  // "not-available" (another law), those of check_dynamics_options, and those of DeviceGradients::open where a device
  // is asked for.
  static Result<ImplicitEuler> create(Body body, MaterialLaw law, const DynamicsOptions& options);
  ImplicitEuler(ImplicitEuler&&) noexcept;
  ImplicitEuler& operator=(ImplicitEuler&&) noexcept;
  ~ImplicitEuler();

  // One step under dead forces on the nodes (mN). A step that does not converge moves nothing. Where a device fails in
  // the midst of it, the processors take it over, and the steps after it.
  StepReport step(const Eigen::VectorXd& force_mN);

  // Failures: those of load_vector.
  [[nodiscard]] Result<Eigen::VectorXd> force_of(const Loads& loads) const;

  [[nodiscard]] Eigen::VectorXd displacement_mm() const;
  [[nodiscard]] Eigen::VectorXd velocity_mm_s() const;
  // What is fixed keeps its displacement and does not move. A body that relaxes is put there at once.
  void set_state(const Eigen::VectorXd& displacement_mm, const Eigen::VectorXd& velocity_mm_s);

  [[nodiscard]] const Body& body() const;
  [[nodiscard]] const StressHistory* history() const;  // none where nothing relaxes
  [[nodiscard]] Eigen::VectorXd mass_kg() const;       // one a node

  struct Cost {
    std::size_t matrix_blocks = 0;
    std::uint64_t product_bytes = 0;  // moved by one product with the matrix
    std::size_t lattice_points = 0;
    std::string device;  // that conjugate gradients run on; empty for the processors
  };
  [[nodiscard]] Cost cost() const;

 private:
  struct Impl;
  explicit ImplicitEuler(std::unique_ptr<Impl> parts);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::mechanics
