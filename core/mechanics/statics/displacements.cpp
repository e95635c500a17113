#include "mechanics/statics/displacements.h"

#include <algorithm>

#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {

void set_displacements(const Body& body, const Eigen::VectorXd& u_mm, StaticResult& result) {
  const NodeLayout& layout = body.layout;
  result.displacement_mm.assign(body.mesh.points_mm.size(), Eigen::Vector3d::Zero());
  for (std::size_t p = 0; p < body.mesh.points_mm.size(); ++p) {
    if (layout.node_of_point[p] >= 0) result.displacement_mm[p] = u_mm.segment<3>(3 * layout.node_of_point[p]);
  }
  result.mid_side_displacement_mm.resize(layout.edges.size());
  for (int e = 0; e < static_cast<int>(layout.edges.size()); ++e) {
    result.mid_side_displacement_mm[e] = u_mm.segment<3>(3 * (layout.corner_nodes + e));
  }
  result.max_displacement_mm = 0;
  for (int node = 0; node < layout.nodes(); ++node) {
    result.max_displacement_mm = std::max(result.max_displacement_mm, u_mm.segment<3>(3 * node).norm());
  }
}

Eigen::VectorXd nodal_displacements(const NodeLayout& layout, const StaticResult& result) {
  Eigen::VectorXd u_mm = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(layout.nodes()));
  for (std::size_t p = 0; p < result.displacement_mm.size(); ++p) {
    if (layout.node_of_point[p] >= 0) u_mm.segment<3>(3 * layout.node_of_point[p]) = result.displacement_mm[p];
  }
  for (std::size_t e = 0; e < result.mid_side_displacement_mm.size(); ++e) {
    u_mm.segment<3>(3 * (layout.corner_nodes + static_cast<Eigen::Index>(e))) = result.mid_side_displacement_mm[e];
  }
  return u_mm;
}

std::vector<Eigen::Vector3d> displacement_at(const Body& body, const StaticResult& result,
                                             const std::vector<PointInMesh>& places) {
  GLISSON_ASSERT(result.displacement_mm.size() == body.mesh.points_mm.size());
  const Eigen::MatrixXd rows_mm = displacements_at(body.layout, nodal_displacements(body.layout, result), places);
  std::vector<Eigen::Vector3d> displacements;
  for (Eigen::Index row = 0; row < rows_mm.rows(); row += 3) displacements.emplace_back(rows_mm.col(0).segment<3>(row));
  return displacements;
}

Eigen::MatrixXd displacements_at(const NodeLayout& layout, const Eigen::Ref<const Eigen::MatrixXd>& u_mm,
                                 const std::vector<PointInMesh>& places) {
  Eigen::MatrixXd rows_mm = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(places.size()), u_mm.cols());
  Eigen::Index row = 0;
  for (const PointInMesh& place : places) {
    const TetValues values = tet_values(layout.order, place.barycentric);
    const auto& nodes = layout.cells[static_cast<std::size_t>(place.cell)];
    for (int k = 0; k < layout.nodes_per_cell(); ++k) {
      rows_mm.middleRows<3>(row) +=
          values[k] * u_mm.middleRows<3>(3 * Eigen::Index{nodes[static_cast<std::size_t>(k)]});
    }
    row += 3;
  }
  return rows_mm;
}

}  // namespace glisson::mechanics
