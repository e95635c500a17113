#pragma once
// A hyperelastic body in motion under rigid tools and jaws, at the speed of a hand: implicit Euler at large
// deformation, with what live_body.h knows but cuts. Its counterpart at small strain is moving_body.h.
//
// A step h from u_n, v_n is the minimum of the body's energy under its loads and tools, and of inertia and the mass'
// damping (newton_implicit_euler.h):
//   |u - u_n - h v_n|^2_M / (2 h^2) + alpha |u - u_n|^2_M / (2 h),   then v = (u - u_n) / h.
// M is lumped at the nodes: the diagonal of the consistent mass, scaled to the body's (Hinton, Rock, Zienkiewicz 1976,
// Earthquake Eng. Struct. Dyn. 4:245). It is looked for as a first picture of a body at rest is, by at most eight
// rounds of twelve conjugate gradients. They end before where what is left would move the judged places by less than a
// hundredth of a millimetre. How many was found on the first beam of tests/mechanics/moving_live_body_test.cpp. The
// bound of a state is of its step alone: what steps before it left out is not in it. Tissue does not relax.
//
// Lengths mm, velocities mm/s, forces mN.

#include <memory>
#include <vector>

#include "mechanics/contact/live_body.h"
#include "mechanics/dynamics/moving_body.h"

namespace glisson::mechanics {

struct MovingLiveState : LiveState, Movement {
  Eigen::VectorXd v_mm_s;  // 3 values a node
};

class MovingLiveBody {
 public:
  // `at_rest` is of small strain, on the same mesh, with the same supports but for ligaments. Of the options, step and
  // mass damping are read. Failures: "not-available" (stiffness damping), those of MovingBody::create and of
  // LiveBody::create.
  static Result<MovingLiveBody> create(const StaticModel& at_rest, const ChosenLaw& law,
                                       const std::vector<Support>& supports, const Loads& standing_loads,
                                       std::vector<PointInMesh> watched, std::size_t judged,
                                       const DynamicsOptions& options, const Progress& progress = {});

  [[nodiscard]] const MovingLiveState& untouched() const;
  // One step, at whose end the tools are where they are given. The same beginning and tools give the same bits.
  // Failures: those of LiveBody::step.
  [[nodiscard]] Result<MovingLiveState> step(const MovingLiveState& from, const std::vector<ContactTool>& tools) const;
  [[nodiscard]] const geometry::Surface& surface() const;
  [[nodiscard]] StaticResult whole_result(const MovingLiveState& state) const;

 private:
  struct Impl;
  explicit MovingLiveBody(std::shared_ptr<const Impl> parts) : impl_(std::move(parts)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glisson::mechanics
