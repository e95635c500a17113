#pragma once
// The nodes that carry a body's displacement: the points of the mesh that cells use, then (for quadratic cells)
// the middle of every edge. Cells keep their straight edges.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "geometry/tetrahedra.h"

namespace glisson::mechanics {

enum class ElementOrder { linear = 1, quadratic = 2 };

// Mid-side node 4 + k of a ten-node tetrahedron lies between the corners edges_of_cell[k]; the order of VTK's
// quadratic tetrahedron and of C3D10 in CalculiX.
inline constexpr std::array<std::array<int, 2>, 6> edges_of_cell{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

// By corners: the node in the middle of the edge between two; on the diagonal the corner's own.
inline constexpr std::array<std::array<int, 4>, 4> node_between{
    {{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}}};

struct NodeLayout {
  ElementOrder order = ElementOrder::quadratic;
  std::vector<Eigen::Vector3d> positions_mm;  // rest position of every node
  std::vector<int> node_of_point;             // for each mesh point, its node; -1 where no cell uses the point
  std::vector<std::array<int, 2>> edges;      // mesh points at the ends, sorted; edge k has node corner_nodes + k
  std::vector<std::array<int, 10>> cells;     // nodes of each cell; the last six are -1 for linear cells
  int corner_nodes = 0;

  [[nodiscard]] int nodes() const { return static_cast<int>(positions_mm.size()); }
  [[nodiscard]] int nodes_per_cell() const { return order == ElementOrder::linear ? 4 : 10; }
  // The node in the middle of an edge of a quadratic layout, given the mesh points at its ends.
  [[nodiscard]] int node_of_edge(int point_a, int point_b) const;
};

// The mesh must have passed check_tetrahedra.
[[nodiscard]] NodeLayout lay_out_nodes(const geometry::TetMesh& mesh, ElementOrder order);

}  // namespace glisson::mechanics
