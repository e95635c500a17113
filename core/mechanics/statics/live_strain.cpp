#include "mechanics/statics/live_strain.h"

#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "base/parallel.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::mechanics {
namespace {

// 3 a node, in the order of the layout.
Eigen::VectorXd of_nodes(const NodeLayout& layout, const StaticResult& result) {
  Eigen::VectorXd u_mm(3 * Eigen::Index{layout.nodes()});
  for (std::size_t p = 0; p < result.displacement_mm.size(); ++p) {
    if (layout.node_of_point[p] >= 0) u_mm.segment<3>(3 * layout.node_of_point[p]) = result.displacement_mm[p];
  }
  for (std::size_t e = 0; e < result.mid_side_displacement_mm.size(); ++e) {
    u_mm.segment<3>(3 * (layout.corner_nodes + static_cast<int>(e))) = result.mid_side_displacement_mm[e];
  }
  return u_mm;
}

double largest_principal(const Eigen::Matrix3d& strain) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal;
  principal.computeDirect(strain, Eigen::EigenvaluesOnly);
  return principal.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

LiveStrain::LiveStrain(const StaticModel& model, const StaticResult& standing,
                       const std::array<const StaticResult*, 3>& per_N)
    : corners_(4 * model.mesh().cells.size()), standing_bound_(corners_.size()), per_N_bound_(corners_.size()) {
  const NodeLayout& layout = model.nodes();
  const Eigen::VectorXd u_standing = of_nodes(layout, standing);
  std::array<Eigen::VectorXd, 3> u_per_N;
  for (std::size_t axis = 0; axis < 3; ++axis) u_per_N[axis] = of_nodes(layout, *per_N[axis]);
  parallel_for(model.mesh().cells.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = 4 * begin; k < 4 * end; ++k) {
      const auto gradient_of = [&](const Eigen::VectorXd& u_mm) {
        return displacement_gradient(model.mesh(), layout, k / 4,
                                     Eigen::Vector4d::Unit(static_cast<Eigen::Index>(k % 4)), u_mm);
      };
      Corner& corner = corners_[k];
      corner.standing = gradient_of(u_standing);
      Eigen::Matrix3d products;
      std::array<Eigen::Matrix3d, 3> strain_per_N;
      for (int a = 0; a < 3; ++a) {
        corner.per_N[a] = gradient_of(u_per_N[a]);
        strain_per_N[a] = small_strain(corner.per_N[a]);
        for (int b = 0; b <= a; ++b) {
          products(a, b) = products(b, a) = strain_per_N[a].cwiseProduct(strain_per_N[b]).sum();
        }
      }
      standing_bound_[static_cast<Eigen::Index>(k)] = largest_principal(small_strain(corner.standing));
      per_N_bound_[static_cast<Eigen::Index>(k)] = std::sqrt(largest_principal(products));
    }
  });
}

Eigen::ArrayXd LiveStrain::bounds(const Eigen::Vector3d& force_N) const {
  return standing_bound_ + force_N.norm() * per_N_bound_;
}

double LiveStrain::largest(const Eigen::Vector3d& force_N) const {
  if (corners_.empty()) return 0;
  const Eigen::ArrayXd bound = bounds(force_N);
  const auto largest_at = [&](Eigen::Index k) {
    return largest_principal(small_strain(corners_[static_cast<std::size_t>(k)].gradient(force_N)));
  };
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
  for (std::size_t cell = 0; 4 * cell < corners_.size(); ++cell) {
    bool inverted = false;
    for (std::size_t k = 4 * cell; k < 4 * cell + 4 && !inverted; ++k) {
      inverted = bound[static_cast<Eigen::Index>(k)] >= 1 &&
                 (Eigen::Matrix3d::Identity() + corners_[k].gradient(force_N)).determinant() <= 0;
    }
    range.inverted_cells += inverted ? 1 : 0;
  }
  return range;
}

Eigen::Matrix3d LiveStrain::Corner::gradient(const Eigen::Vector3d& force_N) const {
  return standing + force_N[0] * per_N[0] + force_N[1] * per_N[1] + force_N[2] * per_N[2];
}

}  // namespace glisson::mechanics
