#pragma once
// A law with its numbers at one frequency, as weak forms: rows of coefficients of the moments that a patch has.

#include <complex>

#include "closedloop/waves/internal/test_functions.h"

namespace glisson::closedloop {

// kPa = kg / (mm s^2).
struct Medium {
  std::complex<double> shear_kPa = 0;
  double inertia = 0;  // density times the square of the angular frequency, kPa / mm2
  // Shear waves along `axis` (of length 1, grid) and across it: the modulus along is `ratio` times the other.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  double ratio = 1;
};

struct WeakForms {
  bool pressure_is_free = false;
  int components = 3;
  int axes = 3;  // 2: a single slice, through which nothing changes

  // Test functions by component, then by group: a bump and its derivatives (1 + axes), or the curls (1 each).
  [[nodiscard]] int groups() const { return pressure_is_free ? 1 : 1 + axes; }
  [[nodiscard]] int count() const { return components * groups(); }
  // A row each test function, a column each moment.
  [[nodiscard]] Eigen::MatrixXcd rows(const Medium& medium) const;
};

// rows * (Gram of each component) * rows^H.
[[nodiscard]] Eigen::MatrixXcd covariance_of(const Eigen::MatrixXcd& rows, const Eigen::MatrixXd& gram);
// The inverse of the lower triangular root of `covariance`, times `rows`.
[[nodiscard]] Eigen::MatrixXcd whitened_rows(const Eigen::MatrixXcd& covariance, const Eigen::MatrixXcd& rows);

}  // namespace glisson::closedloop
