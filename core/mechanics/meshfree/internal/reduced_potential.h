#pragma once
// A potential energy over places as one over the handles that they follow, with the springs of what is fixed.

#include "mechanics/meshfree/internal/meshfree_body.h"
#include "mechanics/meshfree/internal/reduced_solver.h"
#include "mechanics/statics/internal/unknowns.h"

namespace glisson::mechanics {

class ReducedPotential : public Objective {
 public:
  // Both must outlive it.
  ReducedPotential(const MeshfreeBody& handles, const Objective& of_places)
      : handles_(handles), of_places_(of_places) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& q_mm) const override {
    const Eigen::VectorXd u_mm = handles_.basis->displacement(q_mm);
    return of_places_.energy_uJ(u_mm) - 0.5 * u_mm.dot(handles_.penalty_force_mN(u_mm));
  }
  [[nodiscard]] Eigen::VectorXd force_mN(const Eigen::VectorXd& q_mm) const override {
    const Eigen::VectorXd u_mm = handles_.basis->displacement(q_mm);
    return handles_.basis->reduce(of_places_.force_mN(u_mm) + handles_.penalty_force_mN(u_mm));
  }
  [[nodiscard]] Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& q_mm, Tangent which) const override {
    // Newton factorises: assembled, whatever the number of handles.
    return positive_definite(handles_.assembled(of_places_.tangent(handles_.basis->displacement(q_mm), which)).lower());
  }
  [[nodiscard]] double energy_scale_uJ(const Eigen::VectorXd& q_mm) const override {
    return of_places_.energy_scale_uJ(handles_.basis->displacement(q_mm));
  }

 private:
  const MeshfreeBody& handles_;
  const Objective& of_places_;
};

// The handles of a body, which must outlive it. None is fixed: springs are.
class HandleUnknowns : public Unknowns {
 public:
  explicit HandleUnknowns(const MeshfreeBody& handles) : handles_(handles) {}

  [[nodiscard]] Eigen::VectorXd at_rest() const override { return Eigen::VectorXd::Zero(handles_.basis->unknowns()); }
  [[nodiscard]] Eigen::VectorXd displacement_mm(const Eigen::VectorXd& x_mm) const override {
    return handles_.basis->displacement(x_mm);
  }
  [[nodiscard]] double size_mN(const Eigen::VectorXd& force_mN) const override {
    return handles_.basis->reduce(force_mN).norm();
  }
  [[nodiscard]] Result<NewtonResult> minimum_of(const TotalPotential& potential, double scale_mN,
                                                const Eigen::VectorXd& start_mm, const MinimiseOptions& options,
                                                const Progress& progress) const override {
    const std::vector<std::uint8_t> none_fixed(static_cast<std::size_t>(start_mm.size()), 0);
    return minimise(ReducedPotential(handles_, potential), none_fixed, scale_mN, start_mm, options, progress);
  }

 private:
  const MeshfreeBody& handles_;
};

}  // namespace glisson::mechanics
