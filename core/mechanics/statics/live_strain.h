#pragma once
// The strain of a body whose displacements are linear in one force, exactly and in microseconds. It is what
// `strain_range` would say of the whole solve, at small strain, over the corners of all cells.
//
// So is the strain: at each corner eps(F) = eps_0 + sum over axes of F_a eps_a. Its largest eigenvalue in magnitude is
// at most |eps_0| + |F| k, with k^2 the largest eigenvalue of the 3x3 products eps_a : eps_b. So of tens of thousands
// of corners a few hundred may be the worst. Only their eigenvalues are computed. Nor can a cell be turned inside out
// where no strain reaches 1.

#include <Eigen/Core>
#include <memory>

#include "mechanics/elements/strain.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {

class LiveStrain {
 public:
  // Of a body under its standing loads alone: displacements of all nodes (mm, 3 each).
  LiveStrain(StaticModel model, Eigen::VectorXd standing_mm);
  // And for each 1 N along an axis so much more, a column an axis.
  [[nodiscard]] LiveStrain with_force(Eigen::MatrixXd per_N_mm) const;

  [[nodiscard]] StrainRange under(const Eigen::Vector3d& force_N) const;
  [[nodiscard]] double largest(const Eigen::Vector3d& force_N) const;

 private:
  struct Standing {
    StaticModel model;
    Eigen::VectorXd mm;
    Eigen::ArrayXd bound;  // |eps_0| of each corner, 4 a cell
  };
  [[nodiscard]] Eigen::Matrix3d gradient(Eigen::Index corner, const Eigen::Vector3d& force_N) const;
  [[nodiscard]] Eigen::ArrayXd bounds(const Eigen::Vector3d& force_N) const;

  std::shared_ptr<const Standing> standing_;  // of every force that the body meets
  Eigen::MatrixXd per_N_mm_;
  Eigen::ArrayXd per_N_bound_;  // k of each corner
};

}  // namespace glisson::mechanics
