#include "mechanics/stiffness_matrix.h"

#include "mechanics/block_assembly.h"
#include "mechanics/quadrature.h"
#include "mechanics/shape_functions.h"
#include "mechanics/surroundings.h"

namespace glisson::mechanics {

Eigen::SparseMatrix<double> assemble_stiffness(const Body& body) {
  const NodeLayout& layout = body.layout;
  const auto points = tet_points_degree_2();
  std::array<TetDerivatives, points.size()> derivatives;
  for (std::size_t q = 0; q < points.size(); ++q) derivatives[q] = tet_derivatives(layout.order, points[q].barycentric);

  const auto column_of_cell = [&](std::size_t cell, int b) {
    const CellGeometry shape = cell_geometry(body.mesh, cell);
    std::array<TetGradients, points.size()> gradients;
    for (std::size_t q = 0; q < points.size(); ++q) gradients[q] = tet_gradients(derivatives[q], shape);
    return [&points, gradients, b, material = body.materials[cell], volume_mm3 = shape.volume_mm3](int a) {
      Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
      for (std::size_t q = 0; q < points.size(); ++q) {
        block += points[q].weight * stiffness_of_pair(material, gradients[q].row(a), gradients[q].row(b));
      }
      return (volume_mm3 * block).eval();
    };
  };
  return assemble_blocks(layout, column_of_cell, [&](const BlockSink& sink) {
    const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(layout.nodes()));
    add_surroundings_tangent(body, 0.0, at_rest, Tangent::exact, sink);
  });
}

}  // namespace glisson::mechanics
