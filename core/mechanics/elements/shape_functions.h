#pragma once
// Shape functions of straight-edged tetrahedra and triangles in barycentric coordinates L. The linear ones are L
// itself. The quadratic ones are L_i (2 L_i - 1) at corners and 4 L_i L_j at the middle of the edge i-j. Source: any
// text, e.g. Zienkiewicz and Taylor, The Finite Element Method, 8.10. Node order: node_layout.h.

#include <cmath>
#include <Eigen/Core>

#include "geometry/tetrahedra.h"
#include "mechanics/elements/node_layout.h"

namespace glisson::mechanics {

// One value a node, 4 or 10 of them.
using TetValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 10, 1>;
// One row a node: the gradient in 1/mm.
using TetGradients = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 10, 3>;
// One row a node: the derivatives by the four barycentric coordinates.
using TetDerivatives = Eigen::Matrix<double, Eigen::Dynamic, 4, 0, 10, 4>;

inline TetValues tet_values(ElementOrder order, const Eigen::Vector4d& l) {
  if (order == ElementOrder::linear) return l;
  TetValues values(10);
  for (int i = 0; i < 4; ++i) values[i] = l[i] * (2.0 * l[i] - 1.0);
  for (int k = 0; k < 6; ++k) values[4 + k] = 4.0 * l[edges_of_cell[k][0]] * l[edges_of_cell[k][1]];
  return values;
}

inline TetDerivatives tet_derivatives(ElementOrder order, const Eigen::Vector4d& l) {
  if (order == ElementOrder::linear) return Eigen::Matrix4d::Identity();
  TetDerivatives derivatives = TetDerivatives::Zero(10, 4);
  for (int i = 0; i < 4; ++i) derivatives(i, i) = 4.0 * l[i] - 1.0;
  for (int k = 0; k < 6; ++k) {
    derivatives(4 + k, edges_of_cell[k][0]) = 4.0 * l[edges_of_cell[k][1]];
    derivatives(4 + k, edges_of_cell[k][1]) = 4.0 * l[edges_of_cell[k][0]];
  }
  return derivatives;
}

// The gradients (1/mm, one row a corner) of a cell's barycentric coordinates, and its volume.
struct CellGeometry {
  Eigen::Matrix<double, 4, 3> barycentric_gradients;
  double volume_mm3;
};

// The edge of the regular tetrahedron of that volume: how large a cell is.
inline double regular_edge_mm(double volume_mm3) { return std::cbrt(6.0 * std::sqrt(2.0) * volume_mm3); }

CellGeometry cell_geometry(const geometry::TetMesh& mesh, std::size_t cell);

inline TetGradients tet_gradients(const TetDerivatives& derivatives, const CellGeometry& cell) {
  return derivatives * cell.barycentric_gradients;
}

// Values on a quadratic triangle: corners, then the middles of 0-1, 1-2, 2-0.
inline Eigen::Matrix<double, 6, 1> quadratic_triangle_values(const Eigen::Vector3d& l) {
  Eigen::Matrix<double, 6, 1> values;
  for (int i = 0; i < 3; ++i) {
    values[i] = l[i] * (2.0 * l[i] - 1.0);
    values[3 + i] = 4.0 * l[i] * l[(i + 1) % 3];
  }
  return values;
}

}  // namespace glisson::mechanics
