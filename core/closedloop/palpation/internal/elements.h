#pragma once
// Quadratic tetrahedra seen from their quadrature points: what is needed to multiply with a stiffness, or with its
// derivative by some parameter, without assembling it.

#include <Eigen/Core>
#include <vector>

#include "mechanics/elements/body.h"
#include "mechanics/elements/point_location.h"
#include "mechanics/materials/deformation.h"

namespace glisson::closedloop {

struct Elements {
  static constexpr std::size_t points_per_cell = 4;  // exact for the stiffness of straight-edged quadratic cells
  using Gradients = Eigen::Matrix<double, 3, 10>;    // of the shape functions, 1/mm

  struct Point {
    Gradients gradients;
    Eigen::Vector3d position_mm;
    double volume_mm3;  // the share of the cell
  };
  std::vector<Point> points;               // points_per_cell a cell
  std::vector<std::array<int, 10>> cells;  // nodes
  std::vector<double> edge_mm;             // of the regular tetrahedron as large as the cell
  Eigen::Index unknowns = 0;               // 3 a node
};
[[nodiscard]] Elements elements_of(const mechanics::Body& body);

// The forces on the nodes (mN) of a stress (kPa) that `stress_at(cell, point, gradient)` gives from the displacement
// gradient. `point` counts all quadrature points.
template <typename StressAt>
Eigen::VectorXd internal_force_mN(const Elements& elements, const Eigen::Ref<const Eigen::VectorXd>& u_mm,
                                  const StressAt& stress_at) {
  Eigen::VectorXd force_mN = Eigen::VectorXd::Zero(elements.unknowns);
  Elements::Gradients moved, force;
  for (std::size_t c = 0; c < elements.cells.size(); ++c) {
    for (int i = 0; i < 10; ++i) moved.col(i) = u_mm.segment<3>(3 * elements.cells[c][i]);
    force.setZero();
    for (std::size_t p = c * Elements::points_per_cell; p < (c + 1) * Elements::points_per_cell; ++p) {
      const Elements::Point& point = elements.points[p];
      const Eigen::Matrix3d gradient = moved * point.gradients.transpose();
      const Eigen::Matrix3d stress = stress_at(c, p, gradient);
      force.noalias() += (point.volume_mm3 * stress) * point.gradients;
    }
    for (int i = 0; i < 10; ++i) force_mN.segment<3>(3 * elements.cells[c][i]) += force.col(i);
  }
  return force_mN;
}

// Displacements at places of a body: sparse rows, 3 a place.
class Interpolation {
 public:
  Interpolation() = default;
  Interpolation(const mechanics::NodeLayout& layout, const std::vector<mechanics::PointInMesh>& places);

  [[nodiscard]] Eigen::Index rows() const { return 3 * static_cast<Eigen::Index>(nodes_.size()); }
  // (3 * places) x columns from (3 * nodes) x columns, and its transpose for one row.
  [[nodiscard]] Eigen::MatrixXd at_places(const Eigen::MatrixXd& nodal) const;
  void add_transposed(Eigen::Index row, double value, Eigen::Ref<Eigen::VectorXd> nodal) const;

 private:
  std::vector<std::array<int, 10>> nodes_;
  std::vector<Eigen::Matrix<double, 10, 1>> values_;
};

}  // namespace glisson::closedloop
