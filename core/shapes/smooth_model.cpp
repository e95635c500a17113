#include "shapes/smooth_model.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "base/noise.h"
#include "shapes/correspondence.h"

namespace glisson::shapes {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct Leading {
  VectorXd values;  // the largest first
  MatrixXd vectors;
};

// The largest eigenvalues of a symmetric matrix whose others fall off fast, by subspace iteration (Halko, Martinsson
// and Tropp, SIAM Review 53:217, 2011). All of them would take a hundred times as long.
Leading leading_of(const MatrixXd& matrix, Index count) {
  constexpr int iterations = 8;
  const Index columns = std::min(matrix.cols(), 2 * count + 10);
  MatrixXd basis(matrix.rows(), columns);
  for (Index c = 0; c < columns; ++c) {
    for (Index r = 0; r < basis.rows(); ++r) {
      basis(r, c) = normal_pair(static_cast<std::uint64_t>(c), static_cast<std::uint64_t>(r)).x();
    }
  }
  for (int n = 0; n < iterations; ++n) {
    const Eigen::HouseholderQR<MatrixXd> factor(matrix * basis);
    basis = factor.householderQ() * MatrixXd::Identity(basis.rows(), columns);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(basis.transpose() * matrix * basis);
  return {solver.eigenvalues().reverse().head(count),
          basis * solver.eigenvectors().rightCols(count).rowwise().reverse()};
}

}  // namespace

Result<ShapeModel> smooth_model(const SmoothModelOptions& options) {
  auto reference = reference_liver(options.reference_spacing_mm);
  if (!reference) return failure(reference.error());
  const auto points = static_cast<Index>(reference->points_mm.size());
  MatrixXd kernel(points, points);
  for (Index a = 0; a < points; ++a) {
    for (Index b = 0; b < points; ++b) {
      const double mm =
          (reference->points_mm[static_cast<std::size_t>(a)] - reference->points_mm[static_cast<std::size_t>(b)])
              .norm() /
          options.length_mm;
      kernel(a, b) = std::exp(-0.5 * mm * mm);
    }
  }
  const Index waves = std::min<Index>(options.modes / 3, points);
  const Leading leading = leading_of(kernel, waves);
  ShapeModel model;
  model.mean = std::move(*reference);
  model.modes_mm = MatrixXd::Zero(3 * points, 3 * waves);
  VectorXd explained = VectorXd::Zero(points);
  for (Index w = 0; w < waves; ++w) {
    const VectorXd wave = options.deviation_mm * std::sqrt(std::max(0.0, leading.values[w])) * leading.vectors.col(w);
    explained += wave.cwiseAbs2();
    for (Index p = 0; p < points; ++p) {
      for (Index axis = 0; axis < 3; ++axis) model.modes_mm(3 * p + axis, 3 * w + axis) = wave[p];
    }
  }
  const double all = options.deviation_mm * options.deviation_mm;
  model.residual_sd_mm = (all - explained.array()).max(1.0).sqrt();
  return model;
}

}  // namespace glisson::shapes
