#pragma once
// The slow, obvious finite element method that judges the fast one: strain-displacement matrices as textbooks print
// them, a dense stiffness matrix, a dense solve. No code is shared with core/mechanics but the numbering of nodes.

#include <Eigen/Dense>

#include "mechanics/elements/node_layout.h"

namespace glisson::mechanics::test {

struct SlowShape {
  Eigen::VectorXd values;     // one a node of the cell
  Eigen::MatrixXd gradients;  // one row a node, 1/mm
};

// Shape functions from their definition as polynomials: on the cell's own nodes, N_a = sum of coefficients times the
// monomials 1 x y z (x2 y2 z2 xy yz zx), found by inverting the matrix of the monomials at the nodes.
class SlowCell {
 public:
  SlowCell(const NodeLayout& layout, std::size_t cell) : count_(layout.nodes_per_cell()) {
    for (int i = 0; i < count_; ++i) nodes_.push_back(layout.positions_mm[layout.cells[cell][i]]);
    Eigen::MatrixXd at_nodes(count_, count_);
    for (int i = 0; i < count_; ++i) at_nodes.row(i) = monomials(nodes_[i]).transpose();
    coefficients_ = at_nodes.inverse();
  }

  [[nodiscard]] SlowShape at(const Eigen::Vector3d& x) const {
    SlowShape shape;
    shape.values = coefficients_.transpose() * monomials(x);
    shape.gradients = coefficients_.transpose() * monomial_gradients(x);
    return shape;
  }
  [[nodiscard]] Eigen::Vector3d place(const Eigen::Vector4d& l) const {
    return l[0] * nodes_[0] + l[1] * nodes_[1] + l[2] * nodes_[2] + l[3] * nodes_[3];
  }
  [[nodiscard]] double volume() const {
    Eigen::Matrix4d m;
    for (int i = 0; i < 4; ++i) m.row(i) << 1.0, nodes_[i].transpose();
    return m.determinant() / 6.0;
  }

 private:
  [[nodiscard]] Eigen::VectorXd monomials(const Eigen::Vector3d& p) const {
    Eigen::VectorXd m(10);
    m << 1, p.x(), p.y(), p.z(), p.x() * p.x(), p.y() * p.y(), p.z() * p.z(), p.x() * p.y(), p.y() * p.z(),
        p.z() * p.x();
    return m.head(count_);
  }
  [[nodiscard]] Eigen::MatrixXd monomial_gradients(const Eigen::Vector3d& p) const {
    Eigen::MatrixXd g(10, 3);
    g << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2 * p.x(), 0, 0, 0, 2 * p.y(), 0, 0, 0, 2 * p.z(), p.y(), p.x(), 0, 0,
        p.z(), p.y(), p.z(), 0, p.x();
    return g.topRows(count_);
  }

  int count_;
  std::vector<Eigen::Vector3d> nodes_;
  Eigen::MatrixXd coefficients_;
};

// Visits a 4 x 4 x 4 Gauss rule on the cell (the cube collapsed onto the tetrahedron), exact to degree 5 and more:
// visit(place, weight in mm3).
template <typename Visit>
void integrate(const SlowCell& cell, Visit visit) {
  constexpr double x[4] = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629};
  constexpr double w[4] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) {
        const double a = x[i], b = x[j] * (1 - a), c = x[k] * (1 - a - b);
        visit(cell.place({1 - a - b - c, a, b, c}), 6 * cell.volume() * w[i] * w[j] * w[k] * (1 - a) * (1 - a - b));
      }
    }
  }
}

inline Eigen::MatrixXd slow_stiffness(const NodeLayout& layout, const std::vector<double>& youngs_kPa, double nu) {
  const int unknowns = 3 * layout.nodes();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
    d.topLeftCorner<3, 3>().setConstant(nu);
    d.diagonal() << 1 - nu, 1 - nu, 1 - nu, 0.5 - nu, 0.5 - nu, 0.5 - nu;
    d *= youngs_kPa[c] / ((1 + nu) * (1 - 2 * nu));
    const SlowCell cell(layout, c);
    const int count = layout.nodes_per_cell();
    integrate(cell, [&](const Eigen::Vector3d& place, double weight) {
      const Eigen::MatrixXd g = cell.at(place).gradients;
      Eigen::MatrixXd b = Eigen::MatrixXd::Zero(6, 3 * count);
      for (int a = 0; a < count; ++a) {
        b.block<6, 3>(0, 3 * a) << g(a, 0), 0, 0, 0, g(a, 1), 0, 0, 0, g(a, 2), g(a, 1), g(a, 0), 0, 0, g(a, 2),
            g(a, 1), g(a, 2), 0, g(a, 0);
      }
      const Eigen::MatrixXd k = weight * b.transpose() * d * b;
      for (int p = 0; p < count; ++p) {
        for (int q = 0; q < count; ++q) {
          stiffness.block<3, 3>(3 * layout.cells[c][p], 3 * layout.cells[c][q]) += k.block<3, 3>(3 * p, 3 * q);
        }
      }
    });
  }
  return stiffness;
}

// The forces (3 a node) of a body force per volume given as a function of place.
template <typename BodyForce>
Eigen::VectorXd slow_body_force(const NodeLayout& layout, BodyForce force_per_mm3) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * layout.nodes());
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    const SlowCell cell(layout, c);
    integrate(cell, [&](const Eigen::Vector3d& place, double weight) {
      const Eigen::VectorXd values = cell.at(place).values;
      for (int a = 0; a < layout.nodes_per_cell(); ++a) {
        force.segment<3>(3 * layout.cells[c][a]) += weight * values[a] * force_per_mm3(place);
      }
    });
  }
  return force;
}

}  // namespace glisson::mechanics::test
