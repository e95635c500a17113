#pragma once
// Isotropic linear elasticity: energy, stress and tangent at one point, and the 3x3 stiffness of a pair of nodes.
// Source: any text, e.g. A. F. Bower, Applied Mechanics of Solids, 3.2. Strains and stresses are symmetric 3x3.

#include <cmath>
#include <Eigen/Core>

namespace glisson::mechanics {

// Lame's constants (kPa).
struct Lame {
  double lambda_kPa = 0;
  double mu_kPa = 0;
};

// Valid for youngs > 0 and -1 < nu < 1/2.
inline Lame lame_from_youngs(double youngs_kPa, double poisson_ratio) {
  return {youngs_kPa * poisson_ratio / ((1.0 + poisson_ratio) * (1.0 - 2.0 * poisson_ratio)),
          youngs_kPa / (2.0 * (1.0 + poisson_ratio))};
}

inline Eigen::Matrix3d small_strain(const Eigen::Matrix3d& displacement_gradient) {
  return 0.5 * (displacement_gradient + displacement_gradient.transpose());
}

inline Eigen::Matrix3d stress_kPa(const Lame& material, const Eigen::Matrix3d& strain) {
  return material.lambda_kPa * strain.trace() * Eigen::Matrix3d::Identity() + 2.0 * material.mu_kPa * strain;
}

// uJ per mm3, which is kPa.
inline double energy_density_kPa(const Lame& material, const Eigen::Matrix3d& strain) {
  return 0.5 * material.lambda_kPa * strain.trace() * strain.trace() + material.mu_kPa * strain.squaredNorm();
}

// How much force (per volume) a displacement of node b puts on node a, from the gradients of their shape functions:
// K_ab = lambda g_a g_b^T + mu (g_b g_a^T + (g_a . g_b) I).
inline Eigen::Matrix3d stiffness_of_pair(const Lame& material, const Eigen::Vector3d& gradient_a,
                                         const Eigen::Vector3d& gradient_b) {
  Eigen::Matrix3d block =
      material.lambda_kPa * gradient_a * gradient_b.transpose() + material.mu_kPa * gradient_b * gradient_a.transpose();
  block.diagonal().array() += material.mu_kPa * gradient_a.dot(gradient_b);
  return block;
}

// Von Mises' equivalent stress, sqrt(3/2 s:s) with s the deviator.
inline double von_mises(const Eigen::Matrix3d& stress) {
  const Eigen::Matrix3d deviator = stress - stress.trace() / 3.0 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5 * deviator.squaredNorm());
}

}  // namespace glisson::mechanics
