#include "mechanics/elements/strain.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <mutex>

#include "base/parallel.h"

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

// The largest in magnitude; 0 where none is above `known`, by the norm of the tensor that it comes of.
double principal_strain_above(double known, const Eigen::Matrix3d& gradient, StrainMeasure measure) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal;
  if (measure == StrainMeasure::small) {
    const Eigen::Matrix3d strain = small_strain(gradient);
    if (strain.norm() <= known) return 0;
    principal.computeDirect(strain, Eigen::EigenvaluesOnly);
    return principal.eigenvalues().cwiseAbs().maxCoeff();
  }
  const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + gradient, c = f.transpose() * f;
  const double from_1 = (c - Eigen::Matrix3d::Identity()).norm();
  if (std::max(std::sqrt(1 + from_1) - 1, from_1 < 1 ? 1 - std::sqrt(1 - from_1) : 1.0) <= known) return 0;
  principal.computeDirect(c, Eigen::EigenvaluesOnly);
  return (principal.eigenvalues().cwiseMax(0.0).cwiseSqrt().array() - 1.0).abs().maxCoeff();
}

}  // namespace

Eigen::Matrix3d displacement_gradient(const geometry::TetMesh& mesh, const NodeLayout& layout, std::size_t cell,
                                      const Eigen::Vector4d& barycentric, const Eigen::VectorXd& u_mm) {
  return displacement_of_cell(layout, cell, u_mm) *
         tet_gradients(tet_derivatives(layout.order, barycentric), cell_geometry(mesh, cell));
}

std::array<Eigen::Matrix3d, 4> corner_gradients(const CellGeometry& shape, const NodeLayout& layout, std::size_t cell,
                                                const Eigen::Ref<const Eigen::VectorXd>& u_mm) {
  const auto& nodes = layout.cells[cell];
  const auto of_node = [&](int node) {
    return u_mm.segment<3>(3 * Eigen::Index{nodes[static_cast<std::size_t>(node)]});
  };
  Eigen::Matrix<double, 3, 4> of_corners;
  for (int k = 0; k < 4; ++k) of_corners.col(k) = of_node(k);
  std::array<Eigen::Matrix3d, 4> gradients;
  if (layout.order == ElementOrder::linear) {
    gradients.fill(of_corners * shape.barycentric_gradients);
    return gradients;
  }
  for (int i = 0; i < 4; ++i) {
    Eigen::Matrix<double, 3, 4> by_l;
    for (int k = 0; k < 4; ++k) {
      if (k == i) {
        by_l.col(k) = 3 * of_corners.col(k);
      } else {
        by_l.col(k) =
            4 * of_node(node_between[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]) - of_corners.col(k);
      }
    }
    gradients[static_cast<std::size_t>(i)] = by_l * shape.barycentric_gradients;
  }
  return gradients;
}

StrainRange strain_range(const geometry::TetMesh& mesh, const NodeLayout& layout, const Eigen::VectorXd& u_mm,
                         StrainMeasure measure) {
  StrainRange range;
  std::mutex joining;
  parallel_for(layout.cells.size(), 1024, [&](std::size_t begin, std::size_t end) {
    StrainRange part;
    for (std::size_t c = begin; c < end; ++c) {
      bool inverted = false;
      for (const Eigen::Matrix3d& gradient : corner_gradients(cell_geometry(mesh, c), layout, c, u_mm)) {
        part.largest_strain =
            std::max(part.largest_strain, principal_strain_above(part.largest_strain, gradient, measure));
        inverted |= (Eigen::Matrix3d::Identity() + gradient).determinant() <= 0;
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
