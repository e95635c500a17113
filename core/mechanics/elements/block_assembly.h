#pragma once
// Symmetric sparse matrices made of 3x3 blocks that cells give for pairs of their nodes: how they are stored and
// summed. For rooms that make a stiffness of cells; it shows how it is stored.

#include <algorithm>
#include <Eigen/SparseCore>
#include <vector>

#include "base/parallel.h"
#include "mechanics/elements/boundary.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/elements/supports.h"

namespace glisson::mechanics {

// Lists of lists in two arrays.
struct Lists {
  std::vector<std::size_t> starts;
  std::vector<int> items;

  [[nodiscard]] const int* begin(int list) const { return items.data() + starts[list]; }
  [[nodiscard]] const int* end(int list) const { return items.data() + starts[list + 1]; }
  [[nodiscard]] int size(int list) const { return static_cast<int>(starts[list + 1] - starts[list]); }
};

// The blocks of the lower triangle: for each node (a column) the nodes not before it that share a cell with it,
// sorted, itself first. Where block k of column node j, its scalar column c and row r, stands among the values:
struct BlockPattern {
  Lists rows;

  [[nodiscard]] std::size_t position(int j, int k, int r, int c) const {
    const auto blocks = static_cast<std::size_t>(rows.size(j));
    const std::size_t column_before = 9 * rows.starts[j] - 3 * static_cast<std::size_t>(j);
    const std::size_t within = c * 3 * blocks - static_cast<std::size_t>(c * (c - 1) / 2);
    return column_before + within + (k == 0 ? r - c : 3 * static_cast<std::size_t>(k) - c + r);
  }
  [[nodiscard]] int block_of(int j, int row_node) const {
    return static_cast<int>(std::lower_bound(rows.begin(j), rows.end(j), row_node) - rows.begin(j));
  }
};

// The cells around each node, ascending.
[[nodiscard]] Lists cells_of_nodes(const NodeLayout& layout);
[[nodiscard]] BlockPattern pattern_of(const NodeLayout& layout, const Lists& cells_of_node);
[[nodiscard]] Eigen::SparseMatrix<double> empty_matrix(const BlockPattern& pattern, int nodes);

// Adds 3x3 blocks of a symmetric matrix one by one, for nodes that share a cell. Both triangles are offered; the lower
// one is kept.
class BlockSink {
 public:
  BlockSink(const BlockPattern& pattern, double* values) : pattern_(pattern), values_(values) {}
  void add(int row, int column, const Eigen::Matrix3d& block) const {
    if (row < column) return;
    const int k = pattern_.block_of(column, row);
    for (int c = 0; c < 3; ++c) {
      for (int r = k == 0 ? c : 0; r < 3; ++r) values_[pattern_.position(column, k, r, c)] += block(r, c);
    }
  }

 private:
  const BlockPattern& pattern_;
  double* values_;
};

void add_foundation(const BoundaryFace& face, const FoundationFace& spring, ElementOrder order, const BlockSink& sink);

// Adds a sum over cells to the values of a matrix with that pattern. `column_of_cell(cell, b)` gives a function of a:
// the 3x3 block of the cell's local nodes a (row) and b (column), integrated over the cell. The result does not depend
// on the number of threads: each column is summed by one thread, in the order of the cells.
template <typename ColumnOfCell>
void add_columns(const NodeLayout& layout, const Lists& cells_of_node, const BlockPattern& pattern,
                 const ColumnOfCell& column_of_cell, double* values) {
  const auto add_column = [&](int j) {
    for (const int* cell = cells_of_node.begin(j); cell != cells_of_node.end(j); ++cell) {
      const auto& nodes = layout.cells[*cell];
      const auto local_j = static_cast<int>(std::find(nodes.begin(), nodes.end(), j) - nodes.begin());
      const auto block_of_row = column_of_cell(static_cast<std::size_t>(*cell), local_j);
      for (int i = 0; i < layout.nodes_per_cell(); ++i) {
        if (nodes[i] < j) continue;
        const Eigen::Matrix3d block = block_of_row(i);
        const int k = pattern.block_of(j, nodes[i]);
        for (int c = 0; c < 3; ++c) {
          for (int r = k == 0 ? c : 0; r < 3; ++r) values[pattern.position(j, k, r, c)] += block(r, c);
        }
      }
    }
  };
  parallel_for(static_cast<std::size_t>(layout.nodes()), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) add_column(static_cast<int>(j));
  });
}

// The lower triangle of the sum over cells, with the springs of foundations.
template <typename ColumnOfCell>
Eigen::SparseMatrix<double> assemble_blocks(const NodeLayout& layout, const std::vector<BoundaryFace>& boundary,
                                            const std::vector<FoundationFace>& foundations,
                                            const ColumnOfCell& column_of_cell) {
  const Lists cells_of_node = cells_of_nodes(layout);
  const BlockPattern pattern = pattern_of(layout, cells_of_node);
  Eigen::SparseMatrix<double> matrix = empty_matrix(pattern, layout.nodes());
  add_columns(layout, cells_of_node, pattern, column_of_cell, matrix.valuePtr());
  const BlockSink sink(pattern, matrix.valuePtr());
  for (const FoundationFace& spring : foundations) add_foundation(boundary[spring.face], spring, layout.order, sink);
  return matrix;
}

}  // namespace glisson::mechanics
