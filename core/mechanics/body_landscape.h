#pragma once
// One body under its loads as the landscape whose least is its equilibrium. Inside of this room.

#include "mechanics/load_vector.h"
#include "mechanics/newton.h"
#include "mechanics/surroundings.h"

namespace glisson::mechanics {

class BodyLandscape : public Landscape {
 public:
  BodyLandscape(const Body& body, const std::vector<Material>& materials, const AppliedLoads& loads, double part = 1.0)
      : body_(body), materials_(materials), dead_mN_(part * loads.dead_mN), gas_kPa_(part * loads.gas_kPa) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override {
    return strain_energy_uJ(body_, materials_, u_mm) + surroundings_energy_uJ(body_, gas_kPa_, u_mm) -
           dead_mN_.dot(u_mm);
  }
  [[nodiscard]] Eigen::VectorXd force_mN(const Eigen::VectorXd& u_mm) const override {
    return dead_mN_ + surroundings_force_mN(body_, gas_kPa_, u_mm) - internal_force_mN(body_, materials_, u_mm);
  }
  [[nodiscard]] Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& u_mm, Tangent which) const override {
    return tangent_stiffness(body_, materials_, u_mm, which, gas_kPa_);
  }
  [[nodiscard]] double energy_scale_uJ(const Eigen::VectorXd& u_mm) const override {
    return std::abs(dead_mN_.dot(u_mm)) + std::abs(gas_kPa_) * geometry::volume_mm3(body_.mesh);
  }
  // At rest ligaments and capsule pull at nothing: what is left is the load.
  [[nodiscard]] double scale_mN() const {
    return of_the_free(body_.resolved.held,
                       dead_mN_ + surroundings_force_mN(body_, gas_kPa_, Eigen::VectorXd::Zero(dead_mN_.size())))
        .norm();
  }

 private:
  const Body& body_;
  const std::vector<Material>& materials_;
  Eigen::VectorXd dead_mN_;
  double gas_kPa_;
};

}  // namespace glisson::mechanics
