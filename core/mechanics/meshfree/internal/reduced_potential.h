#pragma once
// A potential energy over places as one over the handles that they follow, with the springs of what is held. Inside of
// this room.

#include "mechanics/meshfree/internal/meshfree_body.h"
#include "mechanics/meshfree/internal/reduced_solver.h"
#include "mechanics/statics/internal/elastic_potential.h"

namespace glisson::mechanics {

class ReducedPotential : public Potential {
 public:
  ReducedPotential(const MeshfreeBody& handles, const Potential& of_places)
      : handles_(handles), of_places_(of_places) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& q_mm) const override {
    const Eigen::VectorXd u_mm = handles_.basis->displacement(q_mm);
    return of_places_.energy_uJ(u_mm) - 0.5 * u_mm.dot(handles_.holding_force_mN(u_mm));
  }
  [[nodiscard]] Eigen::VectorXd force_mN(const Eigen::VectorXd& q_mm) const override {
    const Eigen::VectorXd u_mm = handles_.basis->displacement(q_mm);
    return handles_.basis->reduce(of_places_.force_mN(u_mm) + handles_.holding_force_mN(u_mm));
  }
  [[nodiscard]] Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& q_mm, Tangent which) const override {
    // Newton factorises: assembled, whatever the number of handles.
    return positive_definite(handles_.assembled(of_places_.tangent(handles_.basis->displacement(q_mm), which)).lower());
  }
  [[nodiscard]] double energy_scale_uJ(const Eigen::VectorXd& q_mm) const override {
    return of_places_.energy_scale_uJ(handles_.basis->displacement(q_mm));
  }
  // What the loads are over handles: at rest nothing else pushes but the gas.
  [[nodiscard]] double scale_mN() const { return force_mN(Eigen::VectorXd::Zero(handles_.basis->unknowns())).norm(); }

 private:
  const MeshfreeBody& handles_;
  const Potential& of_places_;
};

}  // namespace glisson::mechanics
