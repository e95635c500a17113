#include "shapes/smooth_model.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>

#include "shapes/correspondence.h"

namespace glisson::shapes {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(kernel);
  const Index waves = std::min<Index>(options.modes / 3, points);
  ShapeModel model;
  model.mean = std::move(*reference);
  model.modes_mm = MatrixXd::Zero(3 * points, 3 * waves);
  VectorXd explained = VectorXd::Zero(points);
  for (Index w = 0; w < waves; ++w) {
    const Index from_largest = points - 1 - w;
    const VectorXd wave = options.deviation_mm * std::sqrt(std::max(0.0, solver.eigenvalues()[from_largest])) *
                          solver.eigenvectors().col(from_largest);
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
