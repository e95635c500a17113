#include "mechanics/stiffness_matrix.h"

#include <algorithm>

#include "base/parallel.h"
#include "mechanics/quadrature.h"
#include "mechanics/shape_functions.h"

namespace glisson::mechanics {
namespace {

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

Lists cells_of_nodes(const NodeLayout& layout);
BlockPattern pattern_of(const NodeLayout& layout, const Lists& cells_of_node);
Eigen::SparseMatrix<double> empty_matrix(const BlockPattern& pattern, int nodes);
void add_foundation(const BoundaryFace& face, double stiffness_kPa_per_mm, ElementOrder order,
                    const BlockPattern& pattern, double* values);

}  // namespace

Eigen::SparseMatrix<double> assemble_stiffness(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                               const std::vector<Lame>& materials,
                                               const std::vector<BoundaryFace>& boundary,
                                               const std::vector<FoundationFace>& foundations) {
  const Lists cells_of_node = cells_of_nodes(layout);
  const BlockPattern pattern = pattern_of(layout, cells_of_node);
  Eigen::SparseMatrix<double> matrix = empty_matrix(pattern, layout.nodes());
  double* values = matrix.valuePtr();

  const auto points = tet_points_degree_2();
  std::array<TetDerivatives, points.size()> derivatives;
  for (std::size_t q = 0; q < points.size(); ++q) derivatives[q] = tet_derivatives(layout.order, points[q].barycentric);

  const int nodes_per_cell = layout.nodes_per_cell();
  const auto add_column = [&](int j) {
    for (const int* cell = cells_of_node.begin(j); cell != cells_of_node.end(j); ++cell) {
      const auto& nodes = layout.cells[*cell];
      const CellGeometry shape = cell_geometry(mesh, static_cast<std::size_t>(*cell));
      const auto local_j = static_cast<int>(std::find(nodes.begin(), nodes.end(), j) - nodes.begin());
      std::array<TetGradients, points.size()> gradients;
      for (std::size_t q = 0; q < points.size(); ++q) gradients[q] = tet_gradients(derivatives[q], shape);
      for (int i = 0; i < nodes_per_cell; ++i) {
        if (nodes[i] < j) continue;
        Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
        for (std::size_t q = 0; q < points.size(); ++q) {
          block +=
              points[q].weight * stiffness_of_pair(materials[*cell], gradients[q].row(i), gradients[q].row(local_j));
        }
        block *= shape.volume_mm3;
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
  for (const FoundationFace& spring : foundations) {
    add_foundation(boundary[spring.face], spring.stiffness_kPa_per_mm, layout.order, pattern, values);
  }
  return matrix;
}

namespace {

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

void add_foundation(const BoundaryFace& face, double stiffness_kPa_per_mm, ElementOrder order,
                    const BlockPattern& pattern, double* values) {
  const FaceMass mass = face_mass_mm2(face, order);
  for (int a = 0; a < mass.rows(); ++a) {
    for (int b = 0; b < mass.cols(); ++b) {
      if (face.nodes[a] < face.nodes[b]) continue;
      const int k = pattern.block_of(face.nodes[b], face.nodes[a]);
      for (int d = 0; d < 3; ++d) values[pattern.position(face.nodes[b], k, d, d)] += stiffness_kPa_per_mm * mass(a, b);
    }
  }
}

}  // namespace
}  // namespace glisson::mechanics
