#include "mechanics/potentials/stiffness_matrix.h"

#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/potentials/total_potential.h"

namespace glisson::mechanics {

namespace {

// The force on a node by a displacement of another, per volume, of any tangent: node b moved by e changes the gradient
// by e g_b^T, and a stress P pushes on node a with P g_a.
Eigen::Matrix3d pair_by_tangent(const Matrix9d& tangent, const Eigen::Vector3d& g_a, const Eigen::Vector3d& g_b) {
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
  for (int d = 0; d < 3; ++d) {
    for (int e = 0; e < 3; ++e) block += g_a[d] * g_b[e] * tangent.block<3, 3>(3 * d, 3 * e);
  }
  return block;
}

}  // namespace

PairStiffness::PairStiffness(const Body& body) : body_(body) {
  if (!body.options.anisotropy) return;
  const double nu = body.options.poisson_ratio;
  anisotropy_ = unit_tangent(*body.options.anisotropy, nu) - unit_tangent(TransverseIsotropy{}, nu);
}

Eigen::Matrix3d PairStiffness::operator()(std::size_t cell, const Eigen::Vector3d& gradient_a,
                                          const Eigen::Vector3d& gradient_b) const {
  Eigen::Matrix3d block = stiffness_of_pair(body_.materials[cell], gradient_a, gradient_b);
  if (anisotropy_) block += body_.youngs_kPa[cell] * pair_by_tangent(*anisotropy_, gradient_a, gradient_b);
  return block;
}

Eigen::SparseMatrix<double> assemble_stiffness(const Body& body) {
  const NodeLayout& layout = body.layout;
  const auto points = tet_points_degree_2();
  std::array<TetDerivatives, points.size()> derivatives;
  for (std::size_t q = 0; q < points.size(); ++q) derivatives[q] = tet_derivatives(layout.order, points[q].barycentric);
  const PairStiffness pair(body);
  const auto column_of_cell = [&](std::size_t cell, int b) {
    const CellGeometry shape = cell_geometry(body.mesh, cell);
    std::array<TetGradients, points.size()> gradients;
    for (std::size_t q = 0; q < points.size(); ++q) gradients[q] = tet_gradients(derivatives[q], shape);
    return [&, gradients, b, cell, volume_mm3 = shape.volume_mm3](int a) {
      Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
      for (std::size_t q = 0; q < points.size(); ++q) {
        block += points[q].weight * pair(cell, gradients[q].row(a), gradients[q].row(b));
      }
      return (volume_mm3 * block).eval();
    };
  };
  TangentSum sum(layout);
  sum.add_cells(column_of_cell);
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(layout.nodes()));
  for (const auto& term : boundary_potentials(body, 0.0)) term->add_tangent(at_rest, Tangent::exact, sum);
  return sum.take();
}

}  // namespace glisson::mechanics
