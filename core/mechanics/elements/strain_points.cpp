#include "mechanics/elements/strain_points.h"

#include "base/parallel.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::mechanics {

using Eigen::Matrix3d;

StrainPoints::StrainPoints(const geometry::TetMesh& mesh, const NodeLayout& layout) : mesh_(mesh), layout_(layout) {
  for (const TetPoint& point : tet_points_degree_2()) {
    derivatives_.push_back(tet_derivatives(ElementOrder::quadratic, point.barycentric));
  }
}

std::vector<Matrix3d> StrainPoints::strains_of(const Eigen::VectorXd& u_mm) const {
  std::vector<Matrix3d> strains(count());
  parallel_for(layout_.cells.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const CellGeometry shape = cell_geometry(mesh_, c);
      Eigen::Matrix<double, 3, 10> moved;
      for (int i = 0; i < 10; ++i) moved.col(i) = u_mm.segment<3>(3 * layout_.cells[c][i]);
      for (std::size_t k = 0; k < per_cell; ++k) {
        strains[per_cell * c + k] = small_strain(moved * tet_gradients(derivatives_[k], shape));
      }
    }
  });
  return strains;
}

Eigen::VectorXd StrainPoints::forces_of(const std::vector<Matrix3d>& stresses_kPa) const {
  std::vector<Eigen::Matrix<double, 3, 10>> of_cell(layout_.cells.size());
  parallel_for(layout_.cells.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const CellGeometry shape = cell_geometry(mesh_, c);
      of_cell[c].setZero();
      for (std::size_t k = 0; k < per_cell; ++k) {
        of_cell[c] += 0.25 * shape.volume_mm3 * stresses_kPa[per_cell * c + k] *
                      tet_gradients(derivatives_[k], shape).transpose();
      }
    }
  });
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(layout_.nodes()));
  for (std::size_t c = 0; c < of_cell.size(); ++c) {
    for (int i = 0; i < 10; ++i) force_mN.segment<3>(3 * layout_.cells[c][i]) += of_cell[c].col(i);
  }
  return force_mN;
}

}  // namespace glisson::mechanics
