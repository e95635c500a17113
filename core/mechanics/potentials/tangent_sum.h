#pragma once
// The sparse matrix that terms of a potential energy add their tangents to: 3x3 blocks for pairs of nodes.

#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/elements/block_assembly.h"

namespace glisson::mechanics {

class TangentSum {
 public:
  // Zero, over the nodes of a body. The layout must outlive it.
  explicit TangentSum(const NodeLayout& layout)
      : layout_(layout),
        cells_of_node_(cells_of_nodes(layout)),
        pattern_(pattern_of(layout, cells_of_node_)),
        matrix_(empty_matrix(pattern_, layout.nodes())) {}

  // Integrals over cells, as assemble_blocks wants them; each column is summed by one thread.
  template <typename ColumnOfCell>
  void add_cells(const ColumnOfCell& column_of_cell) {
    add_columns(layout_, cells_of_node_, pattern_, column_of_cell, matrix_.valuePtr());
  }
  // For pairs of nodes that share a cell; both triangles are offered.
  [[nodiscard]] BlockSink within_cells() { return {pattern_, matrix_.valuePtr()}; }
  // For any pair of nodes; both triangles are offered.
  void add(int row, int column, const Eigen::Matrix3d& block) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        if (3 * row + r >= 3 * column + c) anywhere_.emplace_back(3 * row + r, 3 * column + c, block(r, c));
      }
    }
  }
  // A symmetric matrix over the nodes, by its lower triangle. It must outlive the sum.
  void add(double factor, const Eigen::SparseMatrix<double>& lower) { whole_.emplace_back(factor, &lower); }

  // Lower triangle of the sum (mN/mm); nothing is left here.
  [[nodiscard]] Eigen::SparseMatrix<double> take() {
    for (const auto& [factor, lower] : whole_) matrix_ += factor * *lower;
    if (!anywhere_.empty()) {
      Eigen::SparseMatrix<double> more(matrix_.rows(), matrix_.cols());
      more.setFromTriplets(anywhere_.begin(), anywhere_.end());
      matrix_ += more;
    }
    Eigen::SparseMatrix<double> sum;  // Eigen's sparse matrices are not moved, but swapped
    sum.swap(matrix_);
    return sum;
  }

 private:
  const NodeLayout& layout_;
  Lists cells_of_node_;
  BlockPattern pattern_;
  Eigen::SparseMatrix<double> matrix_;
  std::vector<Eigen::Triplet<double>> anywhere_;
  std::vector<std::pair<double, const Eigen::SparseMatrix<double>*>> whole_;
};

}  // namespace glisson::mechanics
