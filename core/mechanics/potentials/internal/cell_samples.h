#pragma once
// The places of a body's cells where its material is asked: one in a linear cell, which deforms evenly, four in a
// quadratic one.

#include <Eigen/LU>
#include <vector>

#include "base/parallel.h"
#include "mechanics/elements/body.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {

struct Sampling {
  std::vector<double> weights;
  std::vector<TetDerivatives> derivatives;

  explicit Sampling(ElementOrder order) {
    if (order == ElementOrder::linear) {
      weights = {1.0};
      derivatives = {tet_derivatives(order, Eigen::Vector4d::Constant(0.25))};
      return;
    }
    for (const TetPoint& point : tet_points_degree_2()) {
      weights.push_back(point.weight);
      derivatives.push_back(tet_derivatives(order, point.barycentric));
    }
  }
  [[nodiscard]] std::size_t points() const { return weights.size(); }
};

// Calls visit(cell, sample, gradients, F, volume of the sample in mm3) for every sample, cells spread over threads.
template <typename Visit>
void visit_samples(const Body& body, const Sampling& sampling, const Eigen::VectorXd& u_mm, const Visit& visit) {
  const NodeLayout& layout = body.layout;
  parallel_for(layout.cells.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const CellGeometry shape = cell_geometry(body.mesh, c);
      Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 10> moved(3, layout.nodes_per_cell());
      for (int i = 0; i < layout.nodes_per_cell(); ++i) moved.col(i) = u_mm.segment<3>(3 * layout.cells[c][i]);
      for (std::size_t q = 0; q < sampling.points(); ++q) {
        const TetGradients gradients = tet_gradients(sampling.derivatives[q], shape);
        const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + moved * gradients;
        visit(c, q, gradients, f, sampling.weights[q] * shape.volume_mm3);
      }
    }
  });
}

// What first Piola-Kirchhoff stresses stress(cell, sample, F) in kPa resist with: mN, 3 a node. Summed in one order,
// whatever the threads did.
template <typename Stress>
Eigen::VectorXd resisting_force_mN(const Body& body, const Eigen::VectorXd& u_mm, const Stress& stress) {
  using CellForce = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 10>;
  std::vector<CellForce> of_cell(body.layout.cells.size(), CellForce::Zero(3, body.layout.nodes_per_cell()));
  visit_samples(body, Sampling(body.options.order), u_mm,
                [&](std::size_t c, std::size_t q, const TetGradients& gradients, const Eigen::Matrix3d& f,
                    double volume_mm3) { of_cell[c] += volume_mm3 * stress(c, q, f) * gradients.transpose(); });
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(u_mm.size());
  for (std::size_t c = 0; c < of_cell.size(); ++c) {
    for (int i = 0; i < body.layout.nodes_per_cell(); ++i) {
      force_mN.segment<3>(3 * body.layout.cells[c][i]) += of_cell[c].col(i);
    }
  }
  return force_mN;
}

}  // namespace glisson::mechanics
