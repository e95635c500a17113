#pragma once
// A landscape over places as one over the frames that they follow, with the springs of what is held. Inside of this
// room.

#include "mechanics/body_landscape.h"
#include "mechanics/frame_solver.h"
#include "mechanics/meshfree_body.h"

namespace glisson::mechanics {

class FrameLandscape : public Landscape {
 public:
  FrameLandscape(const MeshfreeBody& frames, const Landscape& of_places) : frames_(frames), of_places_(of_places) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& q_mm) const override {
    const Eigen::VectorXd u_mm = frames_.basis->displacement(q_mm);
    return of_places_.energy_uJ(u_mm) - 0.5 * u_mm.dot(frames_.holding_force_mN(u_mm));
  }
  [[nodiscard]] Eigen::VectorXd force_mN(const Eigen::VectorXd& q_mm) const override {
    const Eigen::VectorXd u_mm = frames_.basis->displacement(q_mm);
    return frames_.basis->reduce(of_places_.force_mN(u_mm) + frames_.holding_force_mN(u_mm));
  }
  [[nodiscard]] Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& q_mm, Tangent which) const override {
    // Newton factorises: assembled, whatever the number of frames.
    return positive_definite(frames_.assembled(of_places_.tangent(frames_.basis->displacement(q_mm), which)).lower());
  }
  [[nodiscard]] double energy_scale_uJ(const Eigen::VectorXd& q_mm) const override {
    return of_places_.energy_scale_uJ(frames_.basis->displacement(q_mm));
  }
  // What the loads are over frames: at rest nothing else pushes but the gas.
  [[nodiscard]] double scale_mN() const { return force_mN(Eigen::VectorXd::Zero(frames_.basis->unknowns())).norm(); }

 private:
  const MeshfreeBody& frames_;
  const Landscape& of_places_;
};

}  // namespace glisson::mechanics
