#include "closedloop/palpation/internal/stretch.h"

#include <array>
#include <cmath>
#include <Eigen/LU>
#include <limits>

#include "mechanics/materials/isochoric.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::closedloop {
namespace {

// dw / de_i and its derivatives, before the volume is taken out.
struct ShapeChange {
  Eigen::Vector3d gradient;
  Eigen::Matrix3d hessian;
};
ShapeChange shape_change(const StretchMaterial& material, const Eigen::Vector3d& e) {
  if (material.law == StretchLaw::ogden) {
    const Eigen::Vector3d grown = (material.coefficient * e.array()).exp();
    return {2.0 * material.shear / material.coefficient * grown,
            (2.0 * material.shear * grown).asDiagonal().toDenseMatrix()};
  }
  const Eigen::Vector3d squared = (2.0 * e.array()).exp();
  const double by_i = 0.5 * material.shear * (1.0 + material.coefficient * (squared.sum() - 3.0));
  Eigen::Matrix3d hessian = 2.0 * material.shear * material.coefficient * squared * squared.transpose();
  hessian.diagonal() += 4.0 * by_i * squared;
  return {2.0 * by_i * squared, hessian};
}

// Eigenvalues and eigenvectors of a symmetric matrix by Jacobi's rotations (Golub and Van Loan, Matrix Computations,
// 8.5), exact to rounding also where eigenvalues are nearly equal, as they are near rest; of 3x3 matrices quicker than
// the usual way by a tridiagonal one.
struct Modes {
  Eigen::Vector3d values;
  Eigen::Matrix3d vectors;
};
Modes modes_of(Eigen::Matrix3d a) {
  Eigen::Matrix3d vectors = Eigen::Matrix3d::Identity();
  const double small = 1e-32 * a.squaredNorm();
  constexpr int maximum_sweeps = 20;  // three or four are usual
  for (int sweep = 0; sweep < maximum_sweeps; ++sweep) {
    if (a(0, 1) * a(0, 1) + a(0, 2) * a(0, 2) + a(1, 2) * a(1, 2) <= small) break;
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (a(p, q) == 0) continue;
        const double tau = (a(q, q) - a(p, p)) / (2 * a(p, q));
        const double tangent = (tau >= 0 ? 1.0 : -1.0) / (std::abs(tau) + std::sqrt(1 + tau * tau));
        const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
        a(p, p) -= tangent * a(p, q);
        a(q, q) += tangent * a(p, q);
        a(p, q) = a(q, p) = 0;
        const int r = 3 - p - q;
        const double of_p = a(r, p), of_q = a(r, q);
        a(r, p) = a(p, r) = cosine * of_p - sine * of_q;
        a(r, q) = a(q, r) = sine * of_p + cosine * of_q;
        for (int k = 0; k < 3; ++k) {
          const double along_p = vectors(k, p), along_q = vectors(k, q);
          vectors(k, p) = cosine * along_p - sine * along_q;
          vectors(k, q) = sine * along_p + cosine * along_q;
        }
      }
    }
  }
  return {a.diagonal(), vectors};
}

constexpr std::array<std::array<int, 2>, 3> pairs{{{1, 2}, {2, 0}, {0, 1}}};

}  // namespace

StretchMaterial stretch_material(StretchLaw law, double coefficient, double poisson_ratio) {
  const mechanics::Lame unit = mechanics::lame_from_youngs(1.0, poisson_ratio);
  return {law, coefficient, unit.mu_kPa, mechanics::bulk_from_lame(unit)};
}

PrincipalState principal_state(const StretchMaterial& material, const Eigen::Matrix3d& f) {
  PrincipalState state;
  const double j = f.determinant();
  if (!(j > 0)) {
    state.stress.setConstant(std::numeric_limits<double>::quiet_NaN());
    state.left = state.right = Eigen::Matrix3d::Identity();
    state.normal_tangent.setConstant(state.stress[0]);
    state.symmetric = state.skew = state.stress;
    return state;
  }
  const Modes modes = modes_of(f.transpose() * f);
  const Eigen::Vector3d stretch = modes.values.cwiseMax(1e-12).cwiseSqrt();
  state.right = modes.vectors;
  state.left = f * state.right * stretch.cwiseInverse().asDiagonal();

  const Eigen::Vector3d logs = stretch.array().log();
  const ShapeChange shape = shape_change(material, logs.array() - logs.sum() / 3.0);
  const Eigen::Matrix3d deviator = Eigen::Matrix3d::Identity() - Eigen::Matrix3d::Constant(1.0 / 3.0);
  const Eigen::Vector3d by_log = (deviator * shape.gradient).array() + material.bulk * (j - 1.0) * j;
  const Eigen::Matrix3d by_logs = (deviator * shape.hessian * deviator).array() + material.bulk * (2.0 * j - 1.0) * j;

  const Eigen::Vector3d inverse = stretch.cwiseInverse();
  state.stress = by_log.cwiseProduct(inverse);
  state.normal_tangent = by_logs;
  state.normal_tangent.diagonal() -= by_log;
  state.normal_tangent = inverse.asDiagonal() * state.normal_tangent * inverse.asDiagonal();
  for (std::size_t p = 0; p < 3; ++p) {
    const auto [a, b] = pairs[p];
    const double apart = stretch[a] - stretch[b];
    const double slope = std::abs(apart) > 1e-6 ? (state.stress[a] - state.stress[b]) / apart
                                                : 0.5 * (state.normal_tangent(a, a) + state.normal_tangent(b, b)) -
                                                      state.normal_tangent(a, b);
    const double mean = (state.stress[a] + state.stress[b]) / (stretch[a] + stretch[b]);
    state.symmetric[static_cast<Eigen::Index>(p)] = 0.5 * (slope + mean);
    state.skew[static_cast<Eigen::Index>(p)] = 0.5 * (slope - mean);
  }
  return state;
}

Eigen::Matrix3d stress_of(const PrincipalState& state) {
  return state.left * state.stress.asDiagonal() * state.right.transpose();
}

Eigen::Matrix3d stress_change(const PrincipalState& state, const Eigen::Matrix3d& f_change) {
  const Eigen::Matrix3d change = state.left.transpose() * f_change * state.right;
  Eigen::Matrix3d result;
  result.diagonal() = state.normal_tangent * change.diagonal();
  for (std::size_t p = 0; p < 3; ++p) {
    const auto [a, b] = pairs[p];
    const double symmetric = state.symmetric[static_cast<Eigen::Index>(p)];
    const double skew = state.skew[static_cast<Eigen::Index>(p)];
    result(a, b) = symmetric * change(a, b) + skew * change(b, a);
    result(b, a) = symmetric * change(b, a) + skew * change(a, b);
  }
  return state.left * result * state.right.transpose();
}

}  // namespace glisson::closedloop
