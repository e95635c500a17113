#include "mechanics/elements/block_assembly.h"

namespace glisson::mechanics {

Lists cells_of_nodes(const NodeLayout& layout) {
  const int nodes_per_cell = layout.nodes_per_cell();
  Lists lists;
  lists.starts.assign(static_cast<std::size_t>(layout.nodes()) + 1, 0);
  for (const auto& nodes : layout.cells) {
    for (int i = 0; i < nodes_per_cell; ++i) ++lists.starts[nodes[i] + 1];
  }
  for (std::size_t n = 1; n < lists.starts.size(); ++n) lists.starts[n] += lists.starts[n - 1];
  lists.items.resize(lists.starts.back());
  std::vector<std::size_t> next(lists.starts.begin(), lists.starts.end() - 1);
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    for (int i = 0; i < nodes_per_cell; ++i) lists.items[next[layout.cells[c][i]]++] = static_cast<int>(c);
  }
  return lists;
}

BlockPattern pattern_of(const NodeLayout& layout, const Lists& cells_of_node) {
  const int nodes_per_cell = layout.nodes_per_cell();
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(layout.nodes()));
  parallel_for(rows.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      auto& row_nodes = rows[j];
      for (const int* cell = cells_of_node.begin(static_cast<int>(j)); cell != cells_of_node.end(static_cast<int>(j));
           ++cell) {
        for (int i = 0; i < nodes_per_cell; ++i) {
          if (layout.cells[*cell][i] >= static_cast<int>(j)) row_nodes.push_back(layout.cells[*cell][i]);
        }
      }
      std::sort(row_nodes.begin(), row_nodes.end());
      row_nodes.erase(std::unique(row_nodes.begin(), row_nodes.end()), row_nodes.end());
    }
  });
  BlockPattern pattern;
  pattern.rows.starts.assign(1, 0);
  for (const auto& row_nodes : rows) {
    pattern.rows.items.insert(pattern.rows.items.end(), row_nodes.begin(), row_nodes.end());
    pattern.rows.starts.push_back(pattern.rows.items.size());
  }
  return pattern;
}

Eigen::SparseMatrix<double> empty_matrix(const BlockPattern& pattern, int nodes) {
  const std::size_t stored = 9 * pattern.rows.items.size() - 3 * static_cast<std::size_t>(nodes);
  Eigen::SparseMatrix<double> matrix(3 * nodes, 3 * nodes);
  matrix.resizeNonZeros(static_cast<Eigen::Index>(stored));
  std::fill_n(matrix.valuePtr(), stored, 0.0);
  int* column_starts = matrix.outerIndexPtr();
  int* row_indices = matrix.innerIndexPtr();
  std::fill_n(matrix.valuePtr(), matrix.nonZeros(), 0.0);
  for (int j = 0; j < nodes; ++j) {
    for (int c = 0; c < 3; ++c) {
      column_starts[3 * j + c] = static_cast<int>(pattern.position(j, 0, c, c));
      for (int k = 0; k < pattern.rows.size(j); ++k) {
        for (int r = k == 0 ? c : 0; r < 3; ++r) {
          row_indices[pattern.position(j, k, r, c)] = 3 * pattern.rows.begin(j)[k] + r;
        }
      }
    }
  }
  column_starts[3 * nodes] = static_cast<int>(stored);
  return matrix;
}

void add_foundation(const BoundaryFace& face, const FoundationFace& spring, ElementOrder order, const BlockSink& sink) {
  const FaceMass mass = face_mass_mm2(face, order);
  for (int a = 0; a < mass.rows(); ++a) {
    for (int b = 0; b < mass.cols(); ++b) {
      sink.add(face.nodes[a], face.nodes[b], spring.stiffness_kPa_per_mm * mass(a, b) * Eigen::Matrix3d::Identity());
    }
  }
}

}  // namespace glisson::mechanics
