#include "mechanics/frame_solver.h"

#include <Eigen/Cholesky>

#include "base/parallel.h"
#include "mechanics/fill_in.h"

namespace glisson::mechanics {
namespace {

constexpr double raise = 1e-9;

// Whether a factor fits the memory and half a minute or so, told from the frames' pattern: each of its entries is a
// block.
bool is_worth_factorising(const FrameMatrix& matrix, std::uint64_t memory_limit_bytes) {
  constexpr double most_operations = 1e12;
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < matrix.rows(); ++row) {
    for (const int* column = matrix.columns().begin(row); column != matrix.columns().end(row); ++column) {
      if (*column <= row) entries.emplace_back(row, *column, 1.0);
    }
  }
  Eigen::SparseMatrix<double> pattern(matrix.rows(), matrix.rows());
  pattern.setFromTriplets(entries.begin(), entries.end());
  const FillIn of_frames = fill_in_of(pattern);
  constexpr double block = frame_size * frame_size;
  return 8.0 * block * of_frames.entries <= static_cast<double>(memory_limit_bytes) &&
         frame_size * block * of_frames.operations <= most_operations;
}

}  // namespace

FramePreconditioner FramePreconditioner::of_diagonal(const FrameMatrix& matrix) {
  FramePreconditioner preconditioner;
  preconditioner.inverses_.resize(static_cast<std::size_t>(matrix.rows()));
  for (int row = 0; row < matrix.rows(); ++row) {
    FrameBlock block = matrix.blocks()[matrix.position(row, row)];
    const double largest = block.diagonal().maxCoeff();
    for (int d = 0; d < frame_size; ++d) block(d, d) += raise * largest + (largest > 0 ? 0.0 : 1.0);
    preconditioner.inverses_[static_cast<std::size_t>(row)] = block.ldlt().solve(FrameBlock::Identity());
  }
  return preconditioner;
}

FramePreconditioner FramePreconditioner::factorised(const FrameMatrix& matrix, std::uint64_t memory_limit_bytes) {
  if (!is_worth_factorising(matrix, memory_limit_bytes)) return of_diagonal(matrix);
  auto factor = CholeskyFactor::create(positive_definite(matrix.lower()), memory_limit_bytes);
  if (!factor) return of_diagonal(matrix);
  FramePreconditioner preconditioner;
  preconditioner.factor_ = std::move(*factor);
  return preconditioner;
}

Eigen::SparseMatrix<double> positive_definite(Eigen::SparseMatrix<double> lower) {
  double largest = 0;
  for (Eigen::Index d = 0; d < lower.cols(); ++d) largest = std::max(largest, lower.coeff(d, d));
  for (Eigen::Index d = 0; d < lower.cols(); ++d) {
    double& value = lower.coeffRef(d, d);
    value += raise * (value > 1e-6 * largest ? value : largest);
  }
  return lower;
}

Eigen::VectorXd FramePreconditioner::apply(const Eigen::VectorXd& r) const {
  if (factor_) return factor_->solve(r);
  Eigen::VectorXd z(r.size());
  for (Eigen::Index row = 0; row < static_cast<Eigen::Index>(inverses_.size()); ++row) {
    z.segment<frame_size>(frame_size * row) =
        inverses_[static_cast<std::size_t>(row)] * r.segment<frame_size>(frame_size * row);
  }
  return z;
}

FrameSolution conjugate_gradients(const FrameMatrix& matrix, const FramePreconditioner& preconditioner,
                                  const Eigen::VectorXd& b, Eigen::VectorXd start, double tolerance,
                                  int max_iterations) {
  FrameSolution solution{std::move(start)};
  const double scale = b.norm();
  if (scale == 0) {
    solution.x.setZero();
    solution.converged = true;
    return solution;
  }
  Eigen::VectorXd r = b - matrix * solution.x;
  if (!(r.norm() < scale)) {
    solution.x.setZero();
    r = b;
  }
  Eigen::VectorXd z = preconditioner.apply(r);
  Eigen::VectorXd p = z;
  double r_dot_z = r.dot(z);
  while (r.norm() > tolerance * scale && solution.iterations < max_iterations && r_dot_z > 0) {
    const Eigen::VectorXd product = matrix * p;
    const double curvature = p.dot(product);
    if (!(curvature > 0)) break;
    const double length = r_dot_z / curvature;
    solution.x += length * p;
    r -= length * product;
    ++solution.iterations;
    z = preconditioner.apply(r);
    const double next = r.dot(z);
    p = z + next / r_dot_z * p;
    r_dot_z = next;
  }
  solution.relative_residual = (b - matrix * solution.x).norm() / scale;
  solution.converged = solution.x.allFinite() && solution.relative_residual <= 1.01 * tolerance;
  return solution;
}

}  // namespace glisson::mechanics
