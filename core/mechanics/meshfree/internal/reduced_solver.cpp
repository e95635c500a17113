#include "mechanics/meshfree/internal/reduced_solver.h"

#include <algorithm>
#include <array>
#include <Eigen/Cholesky>
#include <map>

#include "base/parallel.h"
#include "geometry/tetrahedra.h"

namespace glisson::mechanics {
namespace {

// The least that makes a factor of a semi-definite matrix, and what is tried where rounding wants more.
constexpr std::array<double, 3> raises{1e-13, 1e-11, 1e-9};

// Leaders at the points of a lattice, trilinear between them; and one for each node of fixed points, alone.
HandleLead lead_on_lattice(const AffineBasis& basis, int maximum_leaders);
// Leaders for a given spacing, nodes of fixed points left out.
HandleLead lead_by_spacing(const AffineBasis& basis, double spacing_mm);

// Nothing where the factor does not fit the memory.
std::optional<CholeskyFactor> factor_of(const Eigen::SparseMatrix<double>& lower, std::uint64_t memory_limit_bytes);

// Each block's inverse, the block raised by a billionth.
std::vector<Eigen::Matrix<float, handle_size, handle_size>> inverted(const std::vector<HandleBlock>& diagonal);

}  // namespace

ReducedPreconditioner ReducedPreconditioner::of(const ReducedOperator& matrix, std::uint64_t memory_limit_bytes) {
  constexpr int maximum_leaders = 300;
  ReducedPreconditioner preconditioner;
  if (matrix.assembled() != nullptr) {
    preconditioner.factor_ = factor_of(matrix.assembled()->lower(), memory_limit_bytes);
    if (preconditioner.factor_) return preconditioner;
  }
  preconditioner.inverses_ = inverted(matrix.diagonal());
  if (matrix.of_places() == nullptr) return preconditioner;
  preconditioner.basis_ = matrix.basis();
  HandleLead lead = lead_on_lattice(*matrix.basis(), maximum_leaders);
  const ReducedMatrix of_leaders = reduced(*matrix.of_places(), matrix.basis()->led_by(lead));
  preconditioner.factor_ = factor_of(of_leaders.lower(), memory_limit_bytes);
  if (preconditioner.factor_) preconditioner.lead_ = std::move(lead);
  return preconditioner;
}

std::uint64_t ReducedPreconditioner::bytes() const {
  return (factor_ ? factor_->bytes() : 0) + inverses_.size() * sizeof(float) * handle_size * handle_size;
}

Eigen::SparseMatrix<double> positive_definite(Eigen::SparseMatrix<double> lower, double raise) {
  double largest = 0;
  for (Eigen::Index d = 0; d < lower.cols(); ++d) largest = std::max(largest, lower.coeff(d, d));
  for (Eigen::Index d = 0; d < lower.cols(); ++d) {
    double& value = lower.coeffRef(d, d);
    value += raise * (value > 1e-6 * largest ? value : largest);
  }
  return lower;
}

Eigen::VectorXd ReducedPreconditioner::apply(const Eigen::VectorXd& r) const {
  if (inverses_.empty()) return factor_->solve(r);
  Eigen::VectorXd z(r.size());
  parallel_for(inverses_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const auto at = handle_size * static_cast<Eigen::Index>(row);
      z.segment<handle_size>(at) = (inverses_[row] * r.segment<handle_size>(at).cast<float>()).cast<double>();
    }
  });
  if (lead_) z += basis_->follow(*lead_, factor_->solve(basis_->gather(*lead_, r)));
  return z;
}

ReducedSolution conjugate_gradients(const ReducedOperator& matrix, const ReducedPreconditioner& preconditioner,
                                    const Eigen::VectorXd& b, Eigen::VectorXd start, double tolerance,
                                    int max_iterations) {
  ReducedSolution solution{std::move(start)};
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
  // Products are rough and what they leave is formed anew: a round ends where its own residual is small enough, or as
  // small as rough products can tell.
  constexpr double minimum_of_a_round = 1e-4;
  double norm = r.norm();
  for (bool gains = true; gains && norm > tolerance * scale && solution.iterations < max_iterations;) {
    const double target = std::max(0.9 * tolerance * scale, minimum_of_a_round * norm);
    Eigen::VectorXd z = preconditioner.apply(r);
    Eigen::VectorXd p = z;
    double r_dot_z = r.dot(z);
    while (r.norm() > target && solution.iterations < max_iterations && r_dot_z > 0) {
      const Eigen::VectorXd product = matrix.rough(p);
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
    r = b - matrix * solution.x;
    const double before = norm;
    norm = r.norm();
    gains = norm < 0.5 * before;
  }
  solution.relative_residual = norm / scale;
  solution.converged = solution.x.allFinite() && solution.relative_residual <= 1.01 * tolerance;
  return solution;
}

ReducedSolutions solve_together(const ReducedOperator& matrix, const ReducedPreconditioner& preconditioner,
                                const Eigen::MatrixXd& b, double tolerance, int max_iterations) {
  GLISSON_ASSERT(matrix.assembled() != nullptr && preconditioner.whole_factor() != nullptr);
  constexpr int most_refinements = 6;
  const Eigen::ArrayXd scale = b.colwise().norm().transpose().array().max(1e-300);
  ReducedSolutions solutions{Eigen::MatrixXd::Zero(b.rows(), b.cols())};
  Eigen::MatrixXd r = b;
  Eigen::ArrayXd left = Eigen::ArrayXd::Ones(b.cols());
  for (int pass = 0; pass < most_refinements && left.maxCoeff() > tolerance; ++pass) {
    solutions.x += preconditioner.whole_factor()->solve(r);
    r = b - matrix.assembled()->times_columns(solutions.x);
    left = r.colwise().norm().transpose().array() / scale;
  }
  for (Eigen::Index column = 0; column < b.cols(); ++column) {
    if (left[column] <= tolerance) continue;
    auto alone =
        conjugate_gradients(matrix, preconditioner, b.col(column), solutions.x.col(column), tolerance, max_iterations);
    solutions.x.col(column) = alone.x;
    left[column] = alone.relative_residual;
  }
  solutions.relative_residual = left.size() > 0 ? left.maxCoeff() : 0.0;
  return solutions;
}

namespace {

std::optional<CholeskyFactor> factor_of(const Eigen::SparseMatrix<double>& lower, std::uint64_t memory_limit_bytes) {
  for (const double raise : raises) {
    auto factor = CholeskyFactor::create(positive_definite(lower, raise), memory_limit_bytes);
    if (factor) return std::move(*factor);
    if (factor.error().code == "too-large") break;
  }
  return std::nullopt;
}

HandleLead lead_on_lattice(const AffineBasis& basis, int maximum_leaders) {
  geometry::Box box = geometry::Box{basis.position_mm(0), basis.position_mm(0)};
  for (int i = 0; i < basis.handles(); ++i) {
    box.min_mm = box.min_mm.cwiseMin(basis.position_mm(i));
    box.max_mm = box.max_mm.cwiseMax(basis.position_mm(i));
  }
  double spacing_mm = std::max((box.max_mm - box.min_mm).maxCoeff(), 1e-9);
  HandleLead lead = lead_by_spacing(basis, spacing_mm);
  for (int refinements = 0; refinements < 60; ++refinements) {
    spacing_mm *= 0.92;
    HandleLead finer = lead_by_spacing(basis, spacing_mm);
    if (static_cast<int>(finer.leaders_mm.size()) > maximum_leaders) break;
    lead = std::move(finer);
  }
  const int led = basis.handles() - basis.fixed_nodes();
  for (int i = led; i < basis.handles(); ++i) {
    lead.leaders.push_back(static_cast<int>(lead.leaders_mm.size()));
    lead.weights.push_back(1.0);
    lead.starts.push_back(lead.leaders.size());
    lead.leaders_mm.push_back(basis.position_mm(i));
    lead.lengths_mm.push_back(basis.length_mm(i));
  }
  return lead;
}

HandleLead lead_by_spacing(const AffineBasis& basis, double spacing_mm) {
  const int led = basis.handles() - basis.fixed_nodes();
  Eigen::Vector3d origin_mm = basis.position_mm(0);
  for (int i = 0; i < led; ++i) origin_mm = origin_mm.cwiseMin(basis.position_mm(i));
  HandleLead lead;
  lead.starts.push_back(0);
  std::map<std::array<int, 3>, int> numbers;
  for (int i = 0; i < led; ++i) {
    const Eigen::Vector3d place = (basis.position_mm(i) - origin_mm) / spacing_mm;
    const Eigen::Vector3d floor = place.array().floor(), within = place - floor;
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector3d offset(k & 1, k >> 1 & 1, k >> 2);
      const double weight = (offset.array() > 0).select(within.array(), 1.0 - within.array()).prod();
      if (weight <= 0) continue;
      const Eigen::Vector3d at = floor + offset;
      const auto [found, is_new] =
          numbers.try_emplace({int(at.x()), int(at.y()), int(at.z())}, static_cast<int>(lead.leaders_mm.size()));
      if (is_new) {
        lead.leaders_mm.emplace_back(origin_mm + spacing_mm * at);
        lead.lengths_mm.push_back(spacing_mm);
      }
      lead.leaders.push_back(found->second);
      lead.weights.push_back(weight);
    }
    lead.starts.push_back(lead.leaders.size());
  }
  return lead;
}

std::vector<Eigen::Matrix<float, handle_size, handle_size>> inverted(const std::vector<HandleBlock>& diagonal) {
  std::vector<Eigen::Matrix<float, handle_size, handle_size>> inverses(diagonal.size());
  parallel_for(diagonal.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      HandleBlock block = diagonal[row];
      const double largest = block.diagonal().maxCoeff();
      block.diagonal().array() += raises.back() * largest + (largest > 0 ? 0.0 : 1.0);
      inverses[row] = block.ldlt().solve(HandleBlock::Identity()).cast<float>();
    }
  });
  return inverses;
}

}  // namespace
}  // namespace glisson::mechanics
