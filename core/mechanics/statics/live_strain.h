#pragma once
// The strain of a body whose displacements are linear in one force, exactly and in microseconds. It is what
// `strain_range` would say of the whole solve, at small strain, over the corners of all cells.
//
// So is the strain: at each corner eps(F) = eps_0 + sum over axes of F_a eps_a. Its largest eigenvalue in magnitude is
// at most |eps_0| + |F| k, with k^2 the largest eigenvalue of the 3x3 products eps_a : eps_b. So of tens of thousands
// of corners a few hundred may be the worst. Only their eigenvalues are computed. Nor can a cell be turned inside out
// where no strain reaches 1.

#include <array>
#include <Eigen/Core>

#include "mechanics/elements/strain.h"
#include "mechanics/statics/static_model.h"
#include "mechanics/statics/static_result.h"

namespace glisson::mechanics {

class LiveStrain {
 public:
  // Of a body under `standing` and, for each 1 N along an axis, `per_N` more.
  LiveStrain(const StaticModel& model, const StaticResult& standing, const std::array<const StaticResult*, 3>& per_N);

  [[nodiscard]] StrainRange under(const Eigen::Vector3d& force_N) const;
  [[nodiscard]] double largest(const Eigen::Vector3d& force_N) const;

 private:
  [[nodiscard]] Eigen::Matrix3d gradient(Eigen::Index corner, const Eigen::Vector3d& force_N) const;
  [[nodiscard]] Eigen::ArrayXd bounds(const Eigen::Vector3d& force_N) const;

  StaticModel model_;  // shared with whoever else has it
  Eigen::VectorXd standing_mm_;
  std::array<Eigen::VectorXd, 3> per_N_mm_;      // of the nodes, 3 each
  Eigen::ArrayXd standing_bound_, per_N_bound_;  // |eps_0| and k of each corner, 4 a cell
};

}  // namespace glisson::mechanics
