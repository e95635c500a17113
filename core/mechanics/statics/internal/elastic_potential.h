#pragma once
// One body under its loads as the potential energy whose minimum is its equilibrium. Inside of this room.

#include "mechanics/elements/boundary_potential.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/solvers/internal/newton.h"

namespace glisson::mechanics {

class ElasticPotential : public Potential {
 public:
  ElasticPotential(const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads,
                   double part = 1.0)
      : body_(body),
        materials_(materials),
        dead_mN_(part * loads.dead_mN),
        follower_pressure_kPa_(part * loads.follower_pressure_kPa) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override {
    return strain_energy_uJ(body_, materials_, u_mm) + boundary_energy_uJ(body_, follower_pressure_kPa_, u_mm) -
           dead_mN_.dot(u_mm);
  }
  [[nodiscard]] Eigen::VectorXd force_mN(const Eigen::VectorXd& u_mm) const override {
    return dead_mN_ + boundary_force_mN(body_, follower_pressure_kPa_, u_mm) -
           internal_force_mN(body_, materials_, u_mm);
  }
  [[nodiscard]] Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& u_mm, Tangent which) const override {
    return tangent_stiffness(body_, materials_, u_mm, which, follower_pressure_kPa_);
  }
  [[nodiscard]] double energy_scale_uJ(const Eigen::VectorXd& u_mm) const override {
    return std::abs(dead_mN_.dot(u_mm)) + std::abs(follower_pressure_kPa_) * geometry::volume_mm3(body_.mesh);
  }
  // At rest ligaments and capsule pull at nothing: what is left is the load.
  [[nodiscard]] double scale_mN() const {
    return free_values(body_.resolved.fixed, dead_mN_ + boundary_force_mN(body_, follower_pressure_kPa_,
                                                                          Eigen::VectorXd::Zero(dead_mN_.size())))
        .norm();
  }

 private:
  const Body& body_;
  const std::vector<Material>& materials_;
  Eigen::VectorXd dead_mN_;
  double follower_pressure_kPa_;
};

}  // namespace glisson::mechanics
