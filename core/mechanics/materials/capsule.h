#pragma once
// Glisson's capsule as a membrane: the skin's law, as functions of how a point of it is mapped from its rest plane into
// space. F is 3x2: its columns are where two orthogonal unit vectors of the rest plane go.
//
// An incompressible Neo-Hookean sheet in plane stress, whose third stretch makes up for the other two:
//   energy per rest area = t mu / 2 (tr C + 1 / det C - 3),   C = F^T F,   mu = E / 3
// (e.g. Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, 6.6.3). It has no bending stiffness,
// and resists compression in its plane, which a real skin would answer with wrinkles.

#include <Eigen/Core>

namespace glisson::mechanics {

// Glisson's capsule: a skin over the whole boundary that resists being stretched in its plane.
struct Capsule {
  double youngs_modulus_kPa = 8220;  // at small strain, porcine: 8.22 (sd 3.42) MPa, Umale et al. 2011 (J. Biomech. 44)
  double thickness_mm = 0;
};

using Matrix32d = Eigen::Matrix<double, 3, 2>;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// uJ/mm2; infinite where the sheet is crushed to nothing.
[[nodiscard]] double energy_per_area(const Capsule& capsule, const Matrix32d& f);
// Its slope by F, mN/mm.
[[nodiscard]] Matrix32d membrane_stress(const Capsule& capsule, const Matrix32d& f);
// The slope of that, mN/mm, in the order of F's columns.
[[nodiscard]] Matrix6d membrane_tangent(const Capsule& capsule, const Matrix32d& f);

}  // namespace glisson::mechanics
