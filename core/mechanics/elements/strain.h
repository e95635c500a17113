#pragma once
// Strain and stress of a displaced body, and how far beyond small strain it has gone.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "geometry/tetrahedra.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/materials/deformation.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::mechanics {

// The displacement gradient du_i/dx_j of one cell at a place in it. `u_mm` has 3 values a node.
[[nodiscard]] Eigen::Matrix3d displacement_gradient(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                                    std::size_t cell, const Eigen::Vector4d& barycentric,
                                                    const Eigen::VectorXd& u_mm);

// The same at its four corners, of a cell of that geometry (shape_functions.h). There the quadratic shape functions'
// derivatives by L_k are 3 at the corner itself and -1 at another, 4 at the middle between, and 0 elsewhere.
[[nodiscard]] std::array<Eigen::Matrix3d, 4> corner_gradients(const CellGeometry& shape, const NodeLayout& layout,
                                                              std::size_t cell,
                                                              const Eigen::Ref<const Eigen::VectorXd>& u_mm);

// Small strain, or how much the principal stretches differ from 1, which a turned body does not count as strain.
enum class StrainMeasure { small, stretch };

struct StrainRange {
  double largest_strain = 0;  // largest principal strain in magnitude, over the corners of all cells
  int inverted_cells = 0;     // cells where det(I + grad u) <= 0 at some corner
};
[[nodiscard]] StrainRange strain_range(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                       const Eigen::VectorXd& u_mm, StrainMeasure measure = StrainMeasure::small);

// Von Mises stress (kPa) at each cell's centroid.
[[nodiscard]] std::vector<double> von_mises_of_cells(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                                     const std::vector<Lame>& materials, const Eigen::VectorXd& u_mm);
// The same where one tangent per unit of Young's modulus (anisotropy.h) says the stress.
[[nodiscard]] std::vector<double> von_mises_of_cells(const geometry::TetMesh& mesh, const NodeLayout& layout,
                                                     const std::vector<double>& youngs_kPa,
                                                     const Matrix9d& unit_tangent, const Eigen::VectorXd& u_mm);

}  // namespace glisson::mechanics
