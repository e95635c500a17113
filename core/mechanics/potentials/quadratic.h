#pragma once
// c |u - u0|^2_A / 2 with a constant symmetric matrix A: inertia and Rayleigh's damping in a step of implicit Euler
// (newton_implicit_euler.h).

#include "mechanics/potentials/potential.h"

namespace glisson::mechanics {

class QuadraticPotential : public Potential {
 public:
  // `lower` is A's lower triangle over the nodes and must outlive it; c A is in mN/mm.
  QuadraticPotential(double c, const Eigen::SparseMatrix<double>& lower, Eigen::VectorXd u0_mm)
      : c_(c), lower_(lower), u0_mm_(std::move(u0_mm)) {}

  [[nodiscard]] double energy_uJ(const Eigen::VectorXd& u_mm) const override {
    return 0.5 * c_ * (u_mm - u0_mm_).dot(times_a(u_mm - u0_mm_));
  }
  void add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN) const override {
    force_mN -= c_ * times_a(u_mm - u0_mm_);
  }
  void add_tangent(const Eigen::VectorXd& /*u_mm*/, Tangent /*which*/, TangentSum& sum) const override {
    sum.add(c_, lower_);
  }
  [[nodiscard]] double scale_uJ(const Eigen::VectorXd& u_mm) const override { return energy_uJ(u_mm); }

 private:
  [[nodiscard]] Eigen::VectorXd times_a(const Eigen::VectorXd& x) const {
    return lower_.selfadjointView<Eigen::Lower>() * x;
  }

  double c_;
  const Eigen::SparseMatrix<double>& lower_;
  Eigen::VectorXd u0_mm_;
};

}  // namespace glisson::mechanics
