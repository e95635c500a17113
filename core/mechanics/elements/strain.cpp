#include "mechanics/elements/strain.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <mutex>

#include "base/parallel.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {
namespace {

using CellDisplacement = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 10>;

CellDisplacement displacement_of_cell(const NodeLayout& layout, std::size_t cell, const Eigen::VectorXd& u_mm) {
  CellDisplacement displacement(3, layout.nodes_per_cell());
  for (int i = 0; i < layout.nodes_per_cell(); ++i) displacement.col(i) = u_mm.segment<3>(3 * layout.cells[cell][i]);
  return displacement;
}

template <typename StressOf>
std::vector<double> von_mises_at_centroids(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                           const Eigen::VectorXd& u_mm, const StressOf& stress_of) {
  std::vector<double> stresses(layout.cells.size());
  parallel_for(stresses.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      stresses[c] =
          von_mises(stress_of(c, displacement_gradient(mesh, layout, c, Eigen::Vector4d::Constant(0.25), u_mm)));
    }
  });
  return stresses;
}

Eigen::Vector3d principal_strains(const Eigen::Matrix3d& f, StrainMeasure measure) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal;
  if (measure == StrainMeasure::small) {
    principal.computeDirect(small_strain(f - Eigen::Matrix3d::Identity()), Eigen::EigenvaluesOnly);
    return principal.eigenvalues();
  }
  principal.computeDirect(f.transpose() * f, Eigen::EigenvaluesOnly);
  return principal.eigenvalues().cwiseMax(0.0).cwiseSqrt().array() - 1.0;
}

}  // namespace

Eigen::Matrix3d displacement_gradient(const geometry::TetMesh& mesh, const NodeLayout& layout, std::size_t cell,
                                      const Eigen::Vector4d& barycentric, const Eigen::VectorXd& u_mm) {
  return displacement_of_cell(layout, cell, u_mm) *
         tet_gradients(tet_derivatives(layout.order, barycentric), cell_geometry(mesh, cell));
}

StrainRange strain_range(const geometry::TetMesh& mesh, const NodeLayout& layout, const Eigen::VectorXd& u_mm,
                         StrainMeasure measure) {
  std::array<TetDerivatives, 4> derivatives;
  for (int i = 0; i < 4; ++i) derivatives[i] = tet_derivatives(layout.order, Eigen::Vector4d::Unit(i));
  StrainRange range;
  std::mutex joining;
  parallel_for(layout.cells.size(), 1024, [&](std::size_t begin, std::size_t end) {
    StrainRange part;
    for (std::size_t c = begin; c < end; ++c) {
      const CellDisplacement displacement = displacement_of_cell(layout, c, u_mm);
      const CellGeometry shape = cell_geometry(mesh, c);
      bool inverted = false;
      for (const TetDerivatives& at_corner : derivatives) {
        const Eigen::Matrix3d gradient = displacement * tet_gradients(at_corner, shape);
        const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + gradient;
        part.largest_strain = std::max(part.largest_strain, principal_strains(f, measure).cwiseAbs().maxCoeff());
        inverted |= f.determinant() <= 0;
      }
      part.inverted_cells += inverted ? 1 : 0;
    }
    const std::lock_guard lock(joining);
    range.largest_strain = std::max(range.largest_strain, part.largest_strain);
    range.inverted_cells += part.inverted_cells;
  });
  return range;
}

std::vector<double> von_mises_of_cells(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                       const std::vector<Lame>& materials, const Eigen::VectorXd& u_mm) {
  return von_mises_at_centroids(mesh, layout, u_mm, [&](std::size_t c, const Eigen::Matrix3d& gradient) {
    return stress_kPa(materials[c], small_strain(gradient));
  });
}

std::vector<double> von_mises_of_cells(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                       const std::vector<double>& youngs_kPa, const Matrix9d& unit_tangent,
                                       const Eigen::VectorXd& u_mm) {
  return von_mises_at_centroids(mesh, layout, u_mm, [&](std::size_t c, const Eigen::Matrix3d& gradient) {
    return (youngs_kPa[c] * as_matrix(unit_tangent * as_vector(gradient))).eval();
  });
}

}  // namespace glisson::mechanics
