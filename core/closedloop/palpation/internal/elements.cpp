#include "closedloop/palpation/internal/elements.h"

#include <cmath>

#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::closedloop {

Elements elements_of(const mechanics::Body& body) {
  GLISSON_ASSERT(body.options.order == mechanics::ElementOrder::quadratic);
  const auto quadrature = mechanics::tet_points_degree_2();
  static_assert(quadrature.size() == Elements::points_per_cell);
  Elements elements;
  elements.cells = body.layout.cells;
  elements.unknowns = 3 * static_cast<Eigen::Index>(body.layout.nodes());
  elements.points.reserve(quadrature.size() * elements.cells.size());
  elements.edge_mm.reserve(elements.cells.size());
  for (std::size_t c = 0; c < elements.cells.size(); ++c) {
    const mechanics::CellGeometry shape = mechanics::cell_geometry(body.mesh, c);
    elements.edge_mm.push_back(mechanics::regular_edge_mm(shape.volume_mm3));
    for (const mechanics::TetPoint& at : quadrature) {
      Elements::Point point;
      point.gradients =
          mechanics::tet_gradients(mechanics::tet_derivatives(body.layout.order, at.barycentric), shape).transpose();
      point.position_mm.setZero();
      for (int i = 0; i < 4; ++i) point.position_mm += at.barycentric[i] * body.mesh.points_mm[body.mesh.cells[c][i]];
      point.volume_mm3 = at.weight * shape.volume_mm3;
      elements.points.push_back(point);
    }
  }
  return elements;
}

Interpolation::Interpolation(const mechanics::NodeLayout& layout, const std::vector<mechanics::PointInMesh>& places) {
  for (const mechanics::PointInMesh& place : places) {
    nodes_.push_back(layout.cells[static_cast<std::size_t>(place.cell)]);
    values_.emplace_back(mechanics::tet_values(layout.order, place.barycentric));
  }
}

Eigen::MatrixXd Interpolation::at_places(const Eigen::MatrixXd& nodal) const {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(rows(), nodal.cols());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (int k = 0; k < 10; ++k) {
      values.middleRows<3>(3 * static_cast<Eigen::Index>(i)) += values_[i][k] * nodal.middleRows<3>(3 * nodes_[i][k]);
    }
  }
  return values;
}

void Interpolation::add_transposed(Eigen::Index row, double value, Eigen::Ref<Eigen::VectorXd> nodal) const {
  const auto i = static_cast<std::size_t>(row / 3);
  for (int k = 0; k < 10; ++k) nodal[3 * nodes_[i][k] + row % 3] += value * values_[i][k];
}

}  // namespace glisson::closedloop
