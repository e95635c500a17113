#pragma once
// Loads that stay as they are while the body moves under them: -f.u.

#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class DeadLoad : public Potential {
 public:
  // Forces on the nodes (mN, 3 a node).
  explicit DeadLoad(Eigen::VectorXd load_mN) : load_mN_(std::move(load_mN)) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override { return -load_mN_.dot(u_mm); }
  void add_force(const Eigen::VectorXd& /*u_mm*/, Eigen::VectorXd& force_mN) const override { force_mN += load_mN_; }
  void add_tangent(const Eigen::VectorXd& /*u_mm*/, Tangent /*which*/, TangentSum& /*sum*/) const override {}
  [[nodiscard]] double scale_uJ(const Eigen::VectorXd& u_mm) const override { return std::abs(load_mN_.dot(u_mm)); }

 private:
  Eigen::VectorXd load_mN_;
};

}  // namespace glisson::mechanics
