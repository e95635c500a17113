#pragma once
// What Newton's method minimises: a function of n unknowns with its slope and the slope of that.

#include <Eigen/SparseCore>

namespace glisson::mechanics {

// `exact` is the slope of the force, and may not be positive definite; `positive` drops the negative curvature of each
// material point, which leaves a direction of descent (Teran et al. 2005, Robust Quasistatic Finite Elements). `warped`
// is the small-strain stiffness turned with each point, R C R^T, as in corotational.h. It leaves out what stress adds.
// A step in time that is solved once would take that for a brake on turning.
enum class Tangent { exact, positive, warped };

// Unknowns in mm, energies in uJ, forces in mN.
class Objective {
 public:
  virtual ~Objective() = default;
  [[nodiscard]] virtual double energy_uJ(const Eigen::VectorXd& x_mm) const = 0;
  [[nodiscard]] virtual Eigen::VectorXd force_mN(const Eigen::VectorXd& x_mm) const = 0;  // minus the slope
  // Lower triangle (mN/mm).
  [[nodiscard]] virtual Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& x_mm, Tangent which) const = 0;
  // The size of the terms that the energy is the difference of, which its rounding is measured by.
  [[nodiscard]] virtual double energy_scale_uJ(const Eigen::VectorXd& x_mm) const = 0;
};

}  // namespace glisson::mechanics
