#include "mechanics/statics/live_strain.h"

#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "base/parallel.h"
#include "mechanics/materials/linear_elasticity.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {
namespace {

double largest_principal(const Eigen::Matrix3d& strain) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal;
  principal.computeDirect(strain, Eigen::EigenvaluesOnly);
  return principal.eigenvalues().cwiseAbs().maxCoeff();
}

// Corner k of the list: of cell k / 4.
Eigen::Matrix3d gradient_at(const StaticModel& model, Eigen::Index corner, const Eigen::VectorXd& u_mm) {
  return displacement_gradient(model.mesh(), model.nodes(), static_cast<std::size_t>(corner / 4),
                               Eigen::Vector4d::Unit(corner % 4), u_mm);
}

}  // namespace

LiveStrain::LiveStrain(const StaticModel& model, const StaticResult& standing,
                       const std::array<const StaticResult*, 3>& per_N)
    : model_(model),
      standing_mm_(nodal_displacements(model.nodes(), standing)),
      standing_bound_(4 * static_cast<Eigen::Index>(model.mesh().cells.size())),
      per_N_bound_(standing_bound_.size()) {
  for (std::size_t axis = 0; axis < 3; ++axis) per_N_mm_[axis] = nodal_displacements(model.nodes(), *per_N[axis]);
  parallel_for(model.mesh().cells.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (auto k = static_cast<Eigen::Index>(4 * begin); k < static_cast<Eigen::Index>(4 * end); ++k) {
      Eigen::Matrix3d products;
      std::array<Eigen::Matrix3d, 3> strain_per_N;
      for (int a = 0; a < 3; ++a) {
        strain_per_N[a] = small_strain(gradient_at(model_, k, per_N_mm_[a]));
        for (int b = 0; b <= a; ++b) {
          products(a, b) = products(b, a) = strain_per_N[a].cwiseProduct(strain_per_N[b]).sum();
        }
      }
      standing_bound_[k] = largest_principal(small_strain(gradient_at(model_, k, standing_mm_)));
      per_N_bound_[k] = std::sqrt(largest_principal(products));
    }
  });
}

Eigen::ArrayXd LiveStrain::bounds(const Eigen::Vector3d& force_N) const {
  return standing_bound_ + force_N.norm() * per_N_bound_;
}

double LiveStrain::largest(const Eigen::Vector3d& force_N) const {
  if (standing_bound_.size() == 0) return 0;
  const Eigen::ArrayXd bound = bounds(force_N);
  const auto largest_at = [&](Eigen::Index k) { return largest_principal(small_strain(gradient(k, force_N))); };
  Eigen::Index worst = 0;
  bound.maxCoeff(&worst);
  double largest = largest_at(worst);
  for (Eigen::Index k = 0; k < bound.size(); ++k) {
    if (bound[k] > largest) largest = std::max(largest, largest_at(k));
  }
  return largest;
}

StrainRange LiveStrain::under(const Eigen::Vector3d& force_N) const {
  StrainRange range{largest(force_N), 0};
  if (range.largest_strain < 1) return range;
  const Eigen::ArrayXd bound = bounds(force_N);
  for (Eigen::Index first = 0; first < bound.size(); first += 4) {
    bool inverted = false;
    for (Eigen::Index k = first; k < first + 4 && !inverted; ++k) {
      inverted = bound[k] >= 1 && (Eigen::Matrix3d::Identity() + gradient(k, force_N)).determinant() <= 0;
    }
    range.inverted_cells += inverted ? 1 : 0;
  }
  return range;
}

Eigen::Matrix3d LiveStrain::gradient(Eigen::Index corner, const Eigen::Vector3d& force_N) const {
  Eigen::Matrix3d sum = gradient_at(model_, corner, standing_mm_);
  for (int axis = 0; axis < 3; ++axis) sum += force_N[axis] * gradient_at(model_, corner, per_N_mm_[axis]);
  return sum;
}

}  // namespace glisson::mechanics
