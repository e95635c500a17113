#include "closedloop/waves/internal/wave_law.h"

#include <Eigen/Cholesky>

namespace glisson::closedloop {
namespace {

double permutation(int a, int b, int c) { return (a - b) * (b - c) * (c - a) / 2.0; }

// Coefficients of moments, a row of them.
class Row {
 public:
  Row(Eigen::MatrixXcd& rows, Eigen::Index row) : rows_(rows), row_(row) {}
  void add(int component, const Derivative& derivative, std::complex<double> value) {
    rows_(row_, component * moments_of_a_component + place_of(derivative)) += value;
  }
  // (axis . grad)^2, and the Laplacian.
  void add_along(int component, const Derivative& derivative, const Eigen::Vector3d& axis, std::complex<double> value) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) add(component, plus(plus(derivative, a), b), value * axis[a] * axis[b]);
  }
  void add_laplacian(int component, const Derivative& derivative, std::complex<double> value) {
    for (int a = 0; a < 3; ++a) add(component, plus(plus(derivative, a), a), value);
  }

 private:
  Eigen::MatrixXcd& rows_;
  Eigen::Index row_;
};

// Each component by itself.
void by_component(const Medium& medium, int component, const Derivative& w, Row row) {
  row.add(component, w, medium.inertia);
  row.add_laplacian(component, w, medium.shear_kPa);
  if (medium.ratio != 1) row.add_along(component, w, medium.axis, (medium.ratio - 1) * medium.shear_kPa);
}

// w = curl(bump e). Transversely isotropic and incompressible: with s = a . w and d = a . grad, the stress that fibres
// along a add gives (ratio - 1) G (a laplacian s + d^2 w + grad d s).
void by_curl(const Medium& medium, int along, Row row) {
  for (int c = 0; c < 3; ++c) {
    for (int j = 0; j < 3; ++j) {
      const double sign = permutation(c, j, along);
      if (sign == 0) continue;
      const Derivative w = plus({0, 0, 0}, j);
      row.add(c, w, sign * medium.inertia);
      row.add_laplacian(c, w, sign * medium.shear_kPa);
      if (medium.ratio == 1) continue;
      const std::complex<double> more = sign * (medium.ratio - 1) * medium.shear_kPa;
      row.add_along(c, w, medium.axis, more);
      for (int i = 0; i < 3; ++i) {
        row.add_laplacian(i, w, more * medium.axis[c] * medium.axis[i]);
        for (int a = 0; a < 3; ++a) row.add(i, plus(plus(w, a), i), more * medium.axis[c] * medium.axis[a]);
      }
    }
  }
}

}  // namespace

Eigen::MatrixXcd WeakForms::rows(const Medium& medium) const {
  Eigen::MatrixXcd rows = Eigen::MatrixXcd::Zero(count(), Eigen::Index{components} * moments_of_a_component);
  for (int c = 0; c < components; ++c) {
    if (pressure_is_free) {
      by_curl(medium, c, Row(rows, c));
      continue;
    }
    for (int group = 0; group < groups(); ++group) {
      const Derivative w = group == 0 ? Derivative{0, 0, 0} : plus({0, 0, 0}, group - 1);
      by_component(medium, c, w, Row(rows, Eigen::Index{c} * groups() + group));
    }
  }
  return rows;
}

Eigen::MatrixXcd covariance_of(const Eigen::MatrixXcd& rows, const Eigen::MatrixXd& gram) {
  Eigen::MatrixXcd covariance = Eigen::MatrixXcd::Zero(rows.rows(), rows.rows());
  for (Eigen::Index first = 0; first < rows.cols(); first += gram.rows()) {
    const auto block = rows.middleCols(first, gram.rows());
    covariance += block * gram.cast<std::complex<double>>() * block.adjoint();
  }
  return covariance;
}

Eigen::MatrixXcd whitened_rows(const Eigen::MatrixXcd& covariance, const Eigen::MatrixXcd& rows) {
  const Eigen::VectorXd inverse = covariance.diagonal().real().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXcd scaled = inverse.asDiagonal() * covariance * inverse.asDiagonal();
  return scaled.llt().matrixL().solve(inverse.asDiagonal() * rows);
}

}  // namespace glisson::closedloop
