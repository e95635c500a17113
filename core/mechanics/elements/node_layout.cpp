#include "mechanics/elements/node_layout.h"

#include <algorithm>

#include "mechanics/elements/shape_functions.h"

#include <Eigen/LU>

namespace glisson::mechanics {
namespace {

std::vector<std::array<int, 2>> edges_of_mesh(const geometry::TetMesh& mesh) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(6 * mesh.cells.size());
  for (const auto& cell : mesh.cells) {
    for (const auto& [i, j] : edges_of_cell) edges.push_back({std::min(cell[i], cell[j]), std::max(cell[i], cell[j])});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  edges.shrink_to_fit();
  return edges;
}

}  // namespace

int NodeLayout::node_of_edge(int point_a, int point_b) const {
  const std::array<int, 2> edge{std::min(point_a, point_b), std::max(point_a, point_b)};
  const auto found = std::lower_bound(edges.begin(), edges.end(), edge);
  GLISSON_ASSERT(found != edges.end() && *found == edge);
  return corner_nodes + static_cast<int>(found - edges.begin());
}

NodeLayout lay_out_nodes(const geometry::TetMesh& mesh, ElementOrder order) {
  NodeLayout layout;
  layout.order = order;
  layout.node_of_point.assign(mesh.points_mm.size(), -1);
  for (const auto& cell : mesh.cells) {
    for (const int point : cell) layout.node_of_point[point] = 0;
  }
  for (std::size_t point = 0; point < mesh.points_mm.size(); ++point) {
    if (layout.node_of_point[point] < 0) continue;
    layout.node_of_point[point] = layout.nodes();
    layout.positions_mm.push_back(mesh.points_mm[point]);
  }
  layout.corner_nodes = layout.nodes();

  if (order == ElementOrder::quadratic) {
    layout.edges = edges_of_mesh(mesh);
    for (const auto& [a, b] : layout.edges) {
      layout.positions_mm.emplace_back(0.5 * (mesh.points_mm[a] + mesh.points_mm[b]));
    }
  }

  layout.cells.resize(mesh.cells.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& points = mesh.cells[c];
    auto& nodes = layout.cells[c];
    nodes.fill(-1);
    for (int i = 0; i < 4; ++i) nodes[i] = layout.node_of_point[points[i]];
    if (order == ElementOrder::linear) continue;
    for (int k = 0; k < 6; ++k) {
      nodes[4 + k] = layout.node_of_edge(points[edges_of_cell[k][0]], points[edges_of_cell[k][1]]);
    }
  }
  return layout;
}

CellGeometry cell_geometry(const geometry::TetMesh& mesh, std::size_t cell) {
  const auto& [p0, p1, p2, p3] = mesh.cells[cell];
  Eigen::Matrix3d edges;
  edges << mesh.points_mm[p1] - mesh.points_mm[p0], mesh.points_mm[p2] - mesh.points_mm[p0],
      mesh.points_mm[p3] - mesh.points_mm[p0];
  CellGeometry geometry;
  geometry.barycentric_gradients.bottomRows<3>() = edges.inverse();
  geometry.barycentric_gradients.row(0) = -geometry.barycentric_gradients.bottomRows<3>().colwise().sum();
  geometry.volume_mm3 = edges.determinant() / 6.0;
  return geometry;
}

}  // namespace glisson::mechanics
