#include "mechanics/solvers/constrained_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mechanics/solvers/internal/principal_part.h"

namespace glisson::mechanics {

Result<ConstrainedSystem> ConstrainedSystem::create(Eigen::SparseMatrix<double> lower, std::vector<std::uint8_t> given,
                                                    std::uint64_t memory_limit_bytes, const Progress& progress,
                                                    std::shared_ptr<const EliminationOrder> known,
                                                    std::vector<int> mutual) {
  ConstrainedSystem system;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i]) system.free_.push_back(static_cast<int>(i));
  }
  system.mutual_ = std::move(mutual);
  if (!system.free_.empty()) {
    std::vector<int> last;
    for (const int unknown : system.mutual_) {
      if (given[unknown]) continue;
      const auto at = std::lower_bound(system.free_.begin(), system.free_.end(), unknown);
      last.push_back(static_cast<int>(at - system.free_.begin()));
    }
    auto factor = CholeskyFactor::create(principal_part(lower, system.free_), memory_limit_bytes, progress,
                                         std::move(known), last);
    if (!factor) return failure(std::move(factor.error()));
    system.factor_ = std::move(*factor);
  }
  system.lower_.swap(lower);  // Eigen's sparse matrices have no move: assigning would copy
  return system;
}

std::vector<ConstrainedSolution> ConstrainedSystem::solve(const Eigen::MatrixXd& f, const Eigen::MatrixXd& given_u,
                                                          const Refinement& refinement) const {
  GLISSON_ASSERT(f.rows() == lower_.rows());
  GLISSON_ASSERT(given_u.size() == 0 || (given_u.rows() == f.rows() && given_u.cols() == f.cols()));
  const auto symmetric = lower_.selfadjointView<Eigen::Lower>();

  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(f.rows(), f.cols());
  if (given_u.size() > 0) {
    u = given_u;
    u(free_, Eigen::all).setZero();
  }
  Eigen::MatrixXd residual = f;
  if (given_u.size() > 0) residual -= symmetric * u;
  Eigen::MatrixXd free_residual = residual(free_, Eigen::all);
  const Eigen::VectorXd scale = free_residual.colwise().norm();
  const auto relative = [&](Eigen::Index column) {
    return scale[column] > 0 ? free_residual.col(column).norm() / scale[column] : 0.0;
  };

  std::vector<ConstrainedSolution> solutions(static_cast<std::size_t>(f.cols()));
  // The first pass is the direct solve; each further one refines the columns together while any of them gains.
  for (int pass = 0; pass <= refinement.max_refinements && factor_; ++pass) {
    bool gains = false;
    const Eigen::MatrixXd before_u = u, before_residual = residual;
    u(free_, Eigen::all) += factor_->solve(free_residual);
    residual = f - symmetric * u;
    free_residual = residual(free_, Eigen::all);
    bool all_reached = true;
    for (Eigen::Index column = 0; column < f.cols(); ++column) {
      ConstrainedSolution& solution = solutions[static_cast<std::size_t>(column)];
      const double now = relative(column);
      if (pass > 0 && !(now < solution.relative_residual)) {  // worse, or not a number: keep what was
        u.col(column) = before_u.col(column);
        residual.col(column) = before_residual.col(column);
        free_residual.col(column) = residual(free_, column);
      } else {
        gains |= pass == 0 || now < 0.5 * solution.relative_residual;
        solution.relative_residual = now;
        solution.iterations = pass;
      }
      all_reached &= solution.relative_residual <= refinement.target;
    }
    if (all_reached || !gains) break;
  }

  for (Eigen::Index column = 0; column < f.cols(); ++column) {
    ConstrainedSolution& solution = solutions[static_cast<std::size_t>(column)];
    solution.u = u.col(column);
    solution.reaction = -residual.col(column);
    for (const int i : free_) solution.reaction[i] = 0.0;
    solution.converged = solution.relative_residual <= refinement.tolerance && solution.u.allFinite();
  }
  return solutions;
}

void ConstrainedSystem::keep_factor_in_single_precision() {
  if (factor_) factor_->keep_in_single_precision();
}

ConstrainedSystem::Response ConstrainedSystem::respond(const Eigen::MatrixXd& f) const {
  GLISSON_ASSERT(f.rows() == lower_.rows());
  Response response{Eigen::MatrixXd::Zero(f.rows(), f.cols())};
  if (!factor_) return response;
  response.u(free_, Eigen::all) = factor_->solve(f(free_, Eigen::all));
  for (int pass = 0; factor_->in_single_precision() && pass < 2; ++pass) {
    const Eigen::MatrixXd residual = f - lower_.selfadjointView<Eigen::Lower>() * response.u;
    response.u(free_, Eigen::all) += factor_->solve(residual(free_, Eigen::all));
  }
  Eigen::VectorXd signs(f.cols());
  std::uint32_t state = 12345;
  for (double& sign : signs) {
    state = 1664525 * state + 1013904223;  // Numerical Recipes' congruences: the same everywhere
    sign = (state >> 31) != 0 ? 1.0 : -1.0;
  }
  const Eigen::VectorXd applied = f * signs;
  const Eigen::VectorXd residual = applied - lower_.selfadjointView<Eigen::Lower>() * (response.u * signs);
  const double scale = applied(free_).norm();
  if (scale > 0) response.relative_residual = residual(free_).norm() / scale;
  return response;
}

Eigen::MatrixXd ConstrainedSystem::mutual_compliance() const {
  const auto size = static_cast<Eigen::Index>(mutual_.size());
  std::vector<Eigen::Index> moving;
  for (Eigen::Index i = 0; i < size; ++i) {
    if (std::binary_search(free_.begin(), free_.end(), mutual_[static_cast<std::size_t>(i)])) moving.push_back(i);
  }
  if (moving.empty()) return Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd of_moving = factor_->inverse_of_last();
  if (of_moving.rows() == size) return of_moving;
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Zero(size, size);
  compliance(moving, moving) = of_moving;
  return compliance;
}

std::uint64_t ConstrainedSystem::matrix_bytes() const {
  return static_cast<std::uint64_t>(lower_.nonZeros()) * (sizeof(double) + sizeof(int));
}

}  // namespace glisson::mechanics
