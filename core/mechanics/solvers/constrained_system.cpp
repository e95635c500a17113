#include "mechanics/solvers/constrained_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mechanics/solvers/internal/principal_part.h"

namespace glisson::mechanics {
namespace {

Eigen::VectorXd signs_that_look_random(Eigen::Index count) {
  Eigen::VectorXd signs(count);
  std::uint32_t state = 12345;
  for (double& sign : signs) {
    state = 1664525 * state + 1013904223;  // Numerical Recipes' congruences: the same everywhere
    sign = (state >> 31) != 0 ? 1.0 : -1.0;
  }
  return signs;
}

}  // namespace

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

// Asked once how far its answers are off: that depends on the equations' condition, and hardly on the load.
void ConstrainedSystem::keep_factor_in_single_precision() {
  if (!factor_) return;
  factor_->keep_in_single_precision();
  constexpr double seen = 1e-5;
  const Eigen::VectorXd load = signs_that_look_random(lower_.rows());
  const Eigen::MatrixXd u = factor_->solve(load(free_));
  Eigen::VectorXd all = Eigen::VectorXd::Zero(lower_.rows());
  all(free_) = u;
  const Eigen::VectorXd residual = load - lower_.selfadjointView<Eigen::Lower>() * all;
  answers_as_seen_ = factor_->solve(residual(free_)).norm() <= seen * u.norm();
}

ConstrainedSystem::Response ConstrainedSystem::respond(const Eigen::MatrixXd& f, Digits digits) const {
  GLISSON_ASSERT(f.rows() == lower_.rows());
  Response response{Eigen::MatrixXd::Zero(f.rows(), f.cols())};
  if (!factor_) return response;
  const Eigen::VectorXd signs = signs_that_look_random(f.cols());
  const Eigen::VectorXd applied = f * signs;
  const double scale = applied(free_).norm();
  const auto look_at_the_sum = [&] {
    const Eigen::VectorXd residual = applied - lower_.selfadjointView<Eigen::Lower>() * (response.u * signs);
    if (scale > 0) response.relative_residual = residual(free_).norm() / scale;
  };
  response.u(free_, Eigen::all) = factor_->solve(f(free_, Eigen::all));
  look_at_the_sum();
  if (!factor_->in_single_precision()) return response;
  constexpr double enough = 1e-3;  // far above what a sound factor leaves
  response.is_seen_right = digits == Digits::seen && answers_as_seen_ && response.relative_residual <= enough;
  if (response.is_seen_right) return response;
  constexpr int most_refinements = 2;
  constexpr double fine = 1e-4;  // of the load: what the next pass leaves of it is its square or so
  for (int pass = 0; pass < most_refinements; ++pass) {
    const Eigen::MatrixXd residual = f - lower_.selfadjointView<Eigen::Lower>() * response.u;
    const Eigen::MatrixXd left = residual(free_, Eigen::all);
    response.u(free_, Eigen::all) += factor_->solve(left);
    if ((left.colwise().norm().array() <= fine * f(free_, Eigen::all).colwise().norm().array()).all()) break;
  }
  look_at_the_sum();
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
