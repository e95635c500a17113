#pragma once
// The four integration points of each quadratic tetrahedron: their small strains, and the nodal forces of stresses
// there.

#include <Eigen/Core>
#include <vector>

#include "geometry/tetrahedra.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {

// Mesh and layout must outlive it. Points are numbered 4 a cell, in the cells' order.
class StrainPoints {
 public:
  StrainPoints(const geometry::TetMesh& mesh, const NodeLayout& layout);

  static constexpr std::size_t per_cell = 4;
  [[nodiscard]] std::size_t count() const { return per_cell * layout_.cells.size(); }
  [[nodiscard]] double volume_mm3(std::size_t point) const {
    return 0.25 * geometry::cell_volume_mm3(mesh_, point / per_cell);
  }

  // Of displacements (mm, 3 a node): (grad u + grad u^T) / 2, one a point.
  [[nodiscard]] std::vector<Eigen::Matrix3d> strains_of(const Eigen::VectorXd& u_mm) const;
  // The integral of B^T sigma (mN, 3 a node) over a field of stresses (kPa, one a point).
  [[nodiscard]] Eigen::VectorXd forces_of(const std::vector<Eigen::Matrix3d>& stresses_kPa) const;

 private:
  const geometry::TetMesh& mesh_;
  const NodeLayout& layout_;
  std::vector<TetDerivatives> derivatives_;
};

}  // namespace glisson::mechanics
