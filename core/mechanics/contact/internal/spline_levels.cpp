#include "mechanics/contact/internal/spline_levels.h"

#include <algorithm>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "mechanics/contact/internal/dense_product.h"
#include "mechanics/solvers/cholesky_factor.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;

// A's rows of nodes, without what is held.
using Blocks = std::vector<std::vector<std::pair<int, Matrix3d>>>;
Blocks free_blocks(const Eigen::SparseMatrix<double>& lower, const SplineLattice& lattice);

}  // namespace

bool SplineLevels::refresh(const Eigen::SparseMatrix<double>& lower) {
  const Blocks blocks = free_blocks(lower, lattice_);
  const Eigen::Index unknowns = 3 * lattice_.wide_points();
  MatrixXd coarse = MatrixXd::Zero(unknowns, unknowns);
  std::vector<Matrix3d> diagonal(static_cast<std::size_t>(lattice_.points()), Matrix3d::Zero());
  // A node's row times the splines first, then by the splines around the node.
  std::vector<SplineLattice::Shares<float>> narrow;
  for (int node = 0; node < static_cast<int>(blocks.size()); ++node) narrow.push_back(lattice_.around(node));
  const auto rows_times = [&](const std::vector<SplineLattice::Shares<float>>& around, int points, const auto& take) {
    std::vector<Matrix3d> product(static_cast<std::size_t>(points), Matrix3d::Zero());
    std::vector<std::uint8_t> is_touched(product.size(), 0);
    std::vector<int> touched;
    for (std::size_t row = 0; row < blocks.size(); ++row) {
      for (const auto& [column, block] : blocks[row]) {
        for (const auto& [point, weight] : around[static_cast<std::size_t>(column)]) {
          const auto p = static_cast<std::size_t>(point);
          if (!is_touched[p]) touched.push_back(point);
          is_touched[p] = 1;
          product[p] += double{weight} * block;
        }
      }
      take(around[row], touched, product);
      for (const int point : touched) {
        product[static_cast<std::size_t>(point)].setZero();
        is_touched[static_cast<std::size_t>(point)] = 0;
      }
      touched.clear();
    }
  };
  using Shares = SplineLattice::Shares<float>;
  rows_times(wide_of_node_, lattice_.wide_points(),
             [&](const Shares& own, const std::vector<int>& touched, const std::vector<Matrix3d>& product) {
               for (const int column : touched) {
                 for (const auto& [point, weight] : own) {
                   if (point < column) continue;
                   coarse.block<3, 3>(3 * point, 3 * column) +=
                       double{weight} * product[static_cast<std::size_t>(column)];
                 }
               }
             });
  // A point that hardly touches the body, or only what is held, has little to say.
  coarse.diagonal().array() += 1e-6 * coarse.diagonal().mean();
  const MatrixXd lower_part = coarse.triangularView<Eigen::Lower>();
  const auto factor = CholeskyFactor::create(lower_part.sparseView(), std::uint64_t{2} << 30);
  if (!factor) return false;
  wide_inverse_ = padded_rows(factor->solve(MatrixXd::Identity(unknowns, unknowns)).cast<float>());

  rows_times(narrow, lattice_.points(),
             [&](const Shares& own, const std::vector<int>&, const std::vector<Matrix3d>& product) {
               for (const auto& [point, weight] : own) {
                 diagonal[static_cast<std::size_t>(point)] += double{weight} * product[static_cast<std::size_t>(point)];
               }
             });
  // Neighbouring points move largely the same nodes, so that together they answer a residual several times over: w.
  constexpr double damping = 0.3;
  double largest = 0;
  for (const Matrix3d& block : diagonal) largest = std::max(largest, block.trace() / 3);
  narrow_inverse_.clear();
  for (const Matrix3d& block : diagonal) {
    const Matrix3d safe = block + 1e-4 * largest * Matrix3d::Identity();
    narrow_inverse_.emplace_back((damping * safe.inverse()).cast<float>());
  }
  inverse_diagonal_.clear();
  for (int node = 0; node < static_cast<int>(blocks.size()); ++node) {
    Matrix3d own = Matrix3d::Zero();
    for (const auto& [column, block] : blocks[static_cast<std::size_t>(node)]) {
      if (column == node) own = block;
    }
    for (int d = 0; d < 3; ++d) own(d, d) += lattice_.is_fixed(node, d) ? 1.0 : 0.0;
    own = own.inverse().eval();
    for (int d = 0; d < 3; ++d) {
      if (lattice_.is_fixed(node, d)) own(d, d) = 0;
    }
    inverse_diagonal_.push_back(own);
  }
  return true;
}

namespace {

Blocks free_blocks(const Eigen::SparseMatrix<double>& lower, const SplineLattice& lattice) {
  Blocks blocks(static_cast<std::size_t>(lower.cols() / 3));
  for (int column = 0; column < static_cast<int>(blocks.size()); ++column) {
    auto& own = blocks[static_cast<std::size_t>(column)];
    const std::size_t before = own.size();
    for (int c = 0; c < 3; ++c) {
      std::size_t at = before;
      for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, 3 * column + c); entry; ++entry) {
        const int row = static_cast<int>(entry.row() / 3), r = static_cast<int>(entry.row() % 3);
        while (at < own.size() && own[at].first != row) ++at;
        if (at == own.size()) own.emplace_back(row, Matrix3d::Zero());
        if (lattice.is_fixed(row, r) || lattice.is_fixed(column, c)) continue;
        own[at].second(c, r) = entry.value();
        if (row == column) own[at].second(r, c) = entry.value();
      }
    }
    for (std::size_t at = before; at < own.size(); ++at) {
      if (own[at].first != column) {
        blocks[static_cast<std::size_t>(own[at].first)].emplace_back(column, own[at].second.transpose());
      }
    }
  }
  return blocks;
}

}  // namespace
}  // namespace glisson::mechanics
