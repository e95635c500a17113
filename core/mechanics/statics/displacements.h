#pragma once
// Displacements of nodes, of a result, and at places in the body.

#include <Eigen/Core>
#include <vector>

#include "mechanics/elements/body.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/statics/static_result.h"

namespace glisson::mechanics {

// Nodal displacements (3 a node) into a result's, and back.
void set_displacements(const Body& body, const Eigen::VectorXd& u_mm, StaticResult& result);
[[nodiscard]] Eigen::VectorXd nodal_displacements(const NodeLayout& layout, const StaticResult& result);

// The displacement at places in the body, by the cells' own shape functions.
[[nodiscard]] std::vector<Eigen::Vector3d> displacement_at(const Body& body, const StaticResult& result,
                                                           const std::vector<PointInMesh>& places);
// The same of several displacements of all nodes (3 a node, one a column): 3 rows a place.
[[nodiscard]] Eigen::MatrixXd displacements_at(const NodeLayout& layout, const Eigen::Ref<const Eigen::MatrixXd>& u_mm,
                                               const std::vector<PointInMesh>& places);

}  // namespace glisson::mechanics
