#pragma once
// A linear body in motion under rigid tools and jaws, at the speed of a hand: implicit Euler, Rayleigh's damping,
// tissue that relaxes. Quadratic tetrahedra and the contact of contact.h, so that what comes to rest is at rest there.
//
// A step h from u, v looks for the change d of the nodes' displacements:
//   ((1/h^2 + alpha/h) M + (1 + beta/h) (S + B)) d = f + c + M v / h - T - B u,   u += d,   v = d / h.
// - M: the consistent mass; B: the stiffness of foundations and capsule; f: the standing loads; c: tools' forces.
// - S: tissue with `share_within` of its moduli at once (materials/relaxation.h); T: what it resists with if nothing
//   moves within the step.
// - alpha, beta: Rayleigh's damping.
// It is the step of newton_implicit_euler.h, for a linear body. All moduli relax alike, so a term of relaxation is one
// vector w of all nodes: its stress H is the elastic one, at once, of the displacement w. Over a step
// w = decay w + share d. With g the shares of all terms, T is what the displacement (1 - sum g) u + sum decay w makes.
//
// The matrix is factorised once, in single precision. Each step solves for the change that what is left of the balance
// asks for, in double precision: what rounding leaves of one step the next makes good. Contact forces come from the
// factor's answers, as those of a body at rest do. A tool meets the body within a step and takes its speed from it
// there: nothing bounces.
//
// Valid as far as small strain is. Lengths mm, velocities mm/s, forces mN, energies uJ.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "mechanics/contact/contact.h"
#include "mechanics/dynamics/implicit_euler.h"

namespace glisson::mechanics {

// How a body moves, of either strain.
struct Movement {
  double time_s = 0;
  double largest_speed_mm_s = 0;  // of any node
  int quiet_steps = 0;            // of late, in which no node moved but by what is nothing to see
  bool moves = false;             // not where half a second of steps, ten at least, were quiet
};

// The report's `relative_residual` is of the step's solves; its energy is not computed.
struct MovingState : ContactState, Movement {
  Eigen::VectorXd u_mm, v_mm_s;           // 3 values a node
  std::vector<Eigen::VectorXd> older_mm;  // w, one a term of relaxation
};

class MovingBody {
 public:
  // `at_rest` has the moduli that are left after long, and the supports; the body begins where it rests under the
  // standing loads, relaxed. Of the options, tolerance, iterations and device are not read. Failures:
  // "not-available" (a body of other elements than quadratic ones), those of check_dynamics_options,
  // ConstrainedSystem::create and ContactBody::create.
  static Result<MovingBody> create(const StaticModel& at_rest, const Loads& standing_loads,
                                   std::vector<PointInMesh> watched, std::size_t judged, const DynamicsOptions& options,
                                   const Progress& progress = {});

  [[nodiscard]] const MovingState& untouched() const;

  // One step, at whose end the tools are where they are given; between two none should move by more than
  // ContactOptions::largest_move_mm. The same beginning and tools give the same bits. A state whose contact did not
  // converge says so and must not be shown. Failures: those of ContactBody::solve.
  [[nodiscard]] Result<MovingState> step(const MovingState& from, const std::vector<ContactTool>& tools) const;

  // Kinetic, and what tissue and supports hold beyond where the body rests.
  [[nodiscard]] double energy_uJ(const MovingState& state) const;

  // ContactBody's.
  [[nodiscard]] Result<bool> prepare_touch(const ContactState& state, const std::vector<ContactTool>& tools) const;
  [[nodiscard]] const geometry::Surface& surface() const;
  // Every mesh point's displacement (mm), as the body flies by.
  [[nodiscard]] StaticResult whole_result(const MovingState& state) const;

 private:
  struct Impl;
  explicit MovingBody(std::shared_ptr<const Impl> parts) : impl_(std::move(parts)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glisson::mechanics
