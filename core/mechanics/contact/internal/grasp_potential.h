#pragma once
// Jaws that hold the mean of some nodes at a displacement: (|p - k d|^2 - |p|^2) / (2 k), d being how far it is off.

#include <vector>

#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

// The nodes with their weights, where their mean should be, and the multiplier: the force found so far.
struct PrescribedPatch {
  std::size_t tool;
  std::vector<int> nodes;
  std::vector<double> weights;
  Eigen::Vector3d from_mm{0, 0, 0};  // where the mean was when they closed
  Eigen::Vector3d wanted_mm{0, 0, 0};
  Eigen::Vector3d multiplier_mN{0, 0, 0};

  // How far the mean is from where it should be.
  [[nodiscard]] Eigen::Vector3d off_mm(const Eigen::VectorXd& u_mm) const;
  // What the jaws pull with, by springs of stiffness k.
  [[nodiscard]] Eigen::Vector3d pull_mN(double k_mN_mm, const Eigen::VectorXd& u_mm) const {
    return multiplier_mN - k_mN_mm * off_mm(u_mm);
  }
};

class GraspPotential : public Potential {
 public:
  // The patches must outlive it.
  GraspPotential(const std::vector<PrescribedPatch>& patches, double k_mN_mm) : patches_(patches), k_(k_mN_mm) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override;
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override;
  void add_tangent(const Eigen::VectorXd& u_mm, Tangent which, TangentSum& sum) const override;
  [[nodiscard]] double scale_uJ(const Eigen::VectorXd& u_mm) const override;

 private:
  const std::vector<PrescribedPatch>& patches_;
  double k_;
};

}  // namespace glisson::mechanics
