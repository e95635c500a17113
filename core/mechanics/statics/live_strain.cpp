#include "mechanics/statics/live_strain.h"

#include <array>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "base/parallel.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::mechanics {
namespace {

double largest_principal(const Eigen::Matrix3d& strain) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal;
  principal.computeDirect(strain, Eigen::EigenvaluesOnly);
  return principal.eigenvalues().cwiseAbs().maxCoeff();
}

// `take(k, gradients)` at every corner k, of each column of displacements.
template <int columns, typename Take>
void for_corners(const StaticModel& model, const Eigen::Ref<const Eigen::MatrixXd>& u_mm, const Take& take) {
  parallel_for(model.mesh().cells.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      const CellGeometry shape = cell_geometry(model.mesh(), cell);
      std::array<std::array<Eigen::Matrix3d, 4>, columns> of_column;
      for (int a = 0; a < columns; ++a) {
        of_column[static_cast<std::size_t>(a)] = corner_gradients(shape, model.nodes(), cell, u_mm.col(a));
      }
      for (std::size_t corner = 0; corner < 4; ++corner) {
        std::array<Eigen::Matrix3d, columns> gradients;
        for (std::size_t a = 0; a < columns; ++a) gradients[a] = of_column[a][corner];
        take(static_cast<Eigen::Index>(4 * cell + corner), gradients);
      }
    }
  });
}

}  // namespace

LiveStrain::LiveStrain(StaticModel model, Eigen::VectorXd standing_mm) {
  const auto corners = 4 * static_cast<Eigen::Index>(model.mesh().cells.size());
  Standing standing{std::move(model), std::move(standing_mm), Eigen::ArrayXd(corners)};
  for_corners<1>(standing.model, standing.mm, [&](Eigen::Index k, const std::array<Eigen::Matrix3d, 1>& gradient) {
    standing.bound[k] = largest_principal(small_strain(gradient[0]));
  });
  per_N_mm_ = Eigen::MatrixXd::Zero(standing.mm.size(), 3);
  per_N_bound_ = Eigen::ArrayXd::Zero(corners);
  standing_ = std::make_shared<const Standing>(std::move(standing));
}

LiveStrain LiveStrain::with_force(Eigen::MatrixXd per_N_mm) const {
  LiveStrain with = *this;
  with.per_N_mm_ = std::move(per_N_mm);
  for_corners<3>(standing_->model, with.per_N_mm_,
                 [&](Eigen::Index k, const std::array<Eigen::Matrix3d, 3>& gradients) {
                   Eigen::Matrix3d products;
                   std::array<Eigen::Matrix3d, 3> strain_per_N;
                   for (std::size_t a = 0; a < 3; ++a) {
                     strain_per_N[a] = small_strain(gradients[a]);
                     for (std::size_t b = 0; b <= a; ++b) {
                       const double product = strain_per_N[a].cwiseProduct(strain_per_N[b]).sum();
                       products(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = product;
                       products(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(a)) = product;
                     }
                   }
                   with.per_N_bound_[k] = std::sqrt(largest_principal(products));
                 });
  return with;
}

Eigen::ArrayXd LiveStrain::bounds(const Eigen::Vector3d& force_N) const {
  return standing_->bound + force_N.norm() * per_N_bound_;
}

double LiveStrain::largest(const Eigen::Vector3d& force_N) const {
  if (per_N_bound_.size() == 0) return 0;
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

// Corner k is of cell k / 4.
Eigen::Matrix3d LiveStrain::gradient(Eigen::Index corner, const Eigen::Vector3d& force_N) const {
  const StaticModel& model = standing_->model;
  const auto cell = static_cast<std::size_t>(corner / 4), at = static_cast<std::size_t>(corner % 4);
  const CellGeometry shape = cell_geometry(model.mesh(), cell);
  Eigen::Matrix3d sum = corner_gradients(shape, model.nodes(), cell, standing_->mm)[at];
  for (int axis = 0; axis < 3; ++axis) {
    sum += force_N[axis] * corner_gradients(shape, model.nodes(), cell, per_N_mm_.col(axis))[at];
  }
  return sum;
}

}  // namespace glisson::mechanics
