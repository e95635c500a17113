#include "mechanics/contact/internal/open_cells.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "mechanics/cutting/internal/crossed_cells.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/materials/deformation.h"
#include "mechanics/potentials/stiffness_matrix.h"

namespace glisson::mechanics {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

OpenCells::OpenCells(const Body& body, const std::vector<Material>& materials, const Opening& opening,
                     double pressure_kPa)
    : body_(body),
      materials_(materials),
      pressure_kPa_(pressure_kPa),
      springs_(opening.springs()),
      rest_normals_(opening.normals()) {
  GLISSON_ASSERT(body.options.order == ElementOrder::quadratic);
  for (const OpenCell& open : opening.cells()) {
    const auto number = static_cast<std::size_t>(open.cell);
    const CellGeometry shape = cell_geometry(body.mesh, number);
    Cell cell{number, open.jump, shape.barycentric_gradients, {}};
    const std::vector<CellPiece> pieces = pieces_of(open.height_mm);
    for (const int s : {0, 1}) {
      Side& side = cell.sides[static_cast<std::size_t>(s)];
      for (std::size_t i = 0; i < 4; ++i) {
        const int above = open.height_mm[static_cast<Index>(i)] > 0 ? 1 : 0;
        side.of_jump[i] = open.jump[i] >= 0 ? s - above : 0;
      }
      side.first = points_.size();
      Vector4d moment = Vector4d::Zero();
      for (const CellPiece& piece : pieces) {
        if (piece.above != (s == 1)) continue;
        const double volume_mm3 = std::abs(piece.corners.determinant()) * shape.volume_mm3;
        side.volume_mm3 += volume_mm3;
        moment += volume_mm3 * piece.corners.rowwise().mean();
        for (const TetPoint& point : tet_points_degree_2()) {
          const Vector4d at = piece.corners * point.barycentric;
          points_.push_back({tet_gradients(tet_derivatives(body.options.order, at), shape), point.weight * volume_mm3});
        }
      }
      side.last = points_.size();
      side.centroid = moment / side.volume_mm3;
      constexpr double next_to_nothing = 0.05;
      side.counts = side.volume_mm3 > next_to_nothing * shape.volume_mm3;
    }
    cells_.push_back(cell);
  }
  for (const Bridge& bridge : opening.bridges()) {
    const auto* law = std::get_if<VerondaWestmann>(&materials[static_cast<std::size_t>(bridge.cell)]);
    if (law == nullptr) continue;
    const double youngs_kPa = body.youngs_kPa[static_cast<std::size_t>(bridge.cell)];
    stiffening_.push_back({bridge.jump, bridge.share, bridge.area_mm2 * youngs_kPa / bridge.length_mm,
                           3 * law->stiffening / (bridge.length_mm * bridge.length_mm)});
  }
}

int OpenCells::add_force(const VectorXd& x_mm, VectorXd& force_mN) const {
  const auto first_jump = 3 * static_cast<Index>(body_.layout.nodes());
  int inverted_points = 0;
  for (const Cell& cell : cells_) {
    const Nodes u_mm = nodes_of(cell, x_mm);
    Nodes on_nodes = Nodes::Zero();
    Eigen::Matrix<double, 3, 4> on_corners = Eigen::Matrix<double, 3, 4>::Zero();
    for (const Side& side : cell.sides) {
      const Matrix3d jumped = Matrix3d::Identity() + of_jumps(cell, side, x_mm);
      Matrix3d sum = Matrix3d::Zero();
      for (std::size_t p = side.first; p < side.last; ++p) {
        const Point& point = points_[p];
        const Matrix3d of_nodes = u_mm * point.gradients;
        const Matrix3d f = jumped + of_nodes;
        if (side.counts && f.determinant() <= 0) ++inverted_points;
        Matrix3d stress = stress_kPa(cell.cell, f), on_jumps = stress;
        if (pressure_kPa_ != 0) {
          const Matrix3d of_pressure = pressure_kPa_ * determinant_gradient(f);
          stress += of_pressure - pressure_kPa_ * determinant_gradient(Matrix3d::Identity() + of_nodes);
          on_jumps += of_pressure;
        }
        on_nodes.noalias() += point.weight_mm3 * stress * point.gradients.transpose();
        sum += point.weight_mm3 * on_jumps;
      }
      const Eigen::Matrix<double, 3, 4> of_side = sum * cell.barycentric_gradients.transpose();
      for (Index i = 0; i < 4; ++i) on_corners.col(i) += side.of_jump[static_cast<std::size_t>(i)] * of_side.col(i);
    }
    const auto& nodes = body_.layout.cells[cell.cell];
    for (Index a = 0; a < 10; ++a) force_mN.segment<3>(3 * nodes[static_cast<std::size_t>(a)]) -= on_nodes.col(a);
    for (Index i = 0; i < 4; ++i) {
      const int jump = cell.jump[static_cast<std::size_t>(i)];
      if (jump >= 0) force_mN.segment<3>(first_jump + 3 * jump) -= on_corners.col(i);
    }
  }
  using Vectors = Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>>;
  using Forces = Eigen::Map<Eigen::Matrix<double, 3, Eigen::Dynamic>>;
  const Index nodes = body_.layout.nodes(), count = jumps();
  const Vectors u_mm(x_mm.data(), 3, nodes), a_mm(x_mm.data() + first_jump, 3, count);
  Forces on_nodes(force_mN.data(), 3, nodes), on_jumps(force_mN.data() + first_jump, 3, count);
  on_jumps -= a_mm * springs_.between + u_mm * springs_.with_nodes;
  for (Index j = 0; j < springs_.with_nodes.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator spring(springs_.with_nodes, j); spring; ++spring) {
      on_nodes.col(spring.row()) -= spring.value() * a_mm.col(j);
    }
  }
  add_stiffening(x_mm, force_mN);
  return inverted_points;
}

void OpenCells::add_stiffening(const VectorXd& x_mm, VectorXd& force_mN) const {
  const auto first_jump = 3 * static_cast<Index>(body_.layout.nodes());
  for (const Stiffening& bridge : stiffening_) {
    const Vector3d a_mm = jump_at(bridge, x_mm);
    // A step too far is taken back by whoever asks; its force must only be a number.
    const double more = std::expm1(std::min(bridge.by_length2 * a_mm.squaredNorm(), 60.0));
    for (std::size_t i = 0; i < 4; ++i) {
      if (bridge.jump[i] < 0) continue;
      force_mN.segment<3>(first_jump + 3 * bridge.jump[i]) -=
          bridge.share[static_cast<Index>(i)] * more * bridge.k_mN_mm * a_mm;
    }
  }
}

Vector3d OpenCells::jump_at(const Stiffening& bridge, const VectorXd& x_mm) const {
  const auto first_jump = 3 * static_cast<Index>(body_.layout.nodes());
  Vector3d a_mm = Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    if (bridge.jump[i] >= 0)
      a_mm += bridge.share[static_cast<Index>(i)] * x_mm.segment<3>(first_jump + 3 * bridge.jump[i]);
  }
  return a_mm;
}

double OpenCells::largest_strain(const VectorXd& x_mm) const {
  double largest = 0;
  for_points(x_mm, [&](const Cell&, const Side& side, const Point&, const Matrix3d& f) {
    if (!side.counts) return;
    const Vector3d stretches = Eigen::JacobiSVD<Matrix3d>(f).singularValues();
    largest = std::max(largest, (stretches.array() - 1).abs().maxCoeff());
  });
  return largest;
}

double OpenCells::energy_uJ(const VectorXd& x_mm) const {
  double sum_uJ = 0;
  for_points(x_mm, [&](const Cell& cell, const Side&, const Point& point, const Matrix3d& f) {
    sum_uJ += point.weight_mm3 * energy_density_kPa(materials_[cell.cell], f);
  });
  const Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>> a_mm(
      x_mm.data() + 3 * static_cast<Index>(body_.layout.nodes()), 3, jumps());
  for (const Stiffening& bridge : stiffening_) {
    const double exponent = bridge.by_length2 * jump_at(bridge, x_mm).squaredNorm();
    sum_uJ += 0.5 * bridge.k_mN_mm / bridge.by_length2 * (std::expm1(exponent) - exponent);
  }
  return sum_uJ + 0.5 * a_mm.cwiseProduct(a_mm * springs_.between).sum();
}

std::vector<Vector3d> OpenCells::normals(const VectorXd& x_mm) const {
  std::vector<Matrix3d> around(rest_normals_.size(), Matrix3d::Zero());
  for_points(x_mm, [&](const Cell& cell, const Side& side, const Point& point, const Matrix3d& f) {
    if (!side.counts) return;
    for (const int jump : cell.jump) {
      if (jump >= 0) around[static_cast<std::size_t>(jump)] += point.weight_mm3 * determinant_gradient(f);
    }
  });
  std::vector<Vector3d> normals = rest_normals_;
  for (std::size_t j = 0; j < normals.size(); ++j) {
    const Vector3d turned = around[j] * rest_normals_[j];
    if (turned.norm() > 0) normals[j] = turned.normalized();
  }
  return normals;
}

std::vector<Matrix3d> OpenCells::own_stiffness() const {
  const PairStiffness pair(body_);
  std::vector<Matrix3d> own(rest_normals_.size(), Matrix3d::Zero());
  for (const Cell& cell : cells_) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (cell.jump[i] < 0) continue;
      const Vector3d gradient = cell.barycentric_gradients.row(static_cast<Index>(i));
      for (const Side& side : cell.sides) {
        own[static_cast<std::size_t>(cell.jump[i])] +=
            side.volume_mm3 * side.of_jump[i] * side.of_jump[i] * pair(cell.cell, gradient, gradient);
      }
    }
  }
  for (std::size_t j = 0; j < own.size(); ++j) {
    own[j].diagonal().array() += springs_.between.coeff(static_cast<Index>(j), static_cast<Index>(j));
  }
  return own;
}

std::vector<int> OpenCells::cells() const {
  std::vector<int> cells;
  for (const Cell& cell : cells_) cells.push_back(static_cast<int>(cell.cell));
  return cells;
}

OpenCells::Nodes OpenCells::nodes_of(const Cell& cell, const VectorXd& x_mm) const {
  Nodes u_mm;
  for (Index a = 0; a < 10; ++a) {
    u_mm.col(a) = x_mm.segment<3>(3 * body_.layout.cells[cell.cell][static_cast<std::size_t>(a)]);
  }
  return u_mm;
}

Matrix3d OpenCells::of_jumps(const Cell& cell, const Side& side, const VectorXd& x_mm) const {
  const auto first_jump = 3 * static_cast<Index>(body_.layout.nodes());
  Matrix3d sum = Matrix3d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    if (side.of_jump[i] == 0) continue;
    sum += side.of_jump[i] * x_mm.segment<3>(first_jump + 3 * cell.jump[i]) *
           cell.barycentric_gradients.row(static_cast<Index>(i));
  }
  return sum;
}

// Laws that know no body turned inside out need a number there too: a step so far is taken back by whoever asks.
Matrix3d OpenCells::stress_kPa(std::size_t cell, const Matrix3d& f) const {
  constexpr double flat = 1e-3;
  const bool known = std::holds_alternative<StableNeoHookean>(materials_[cell]) || f.determinant() > flat;
  return known ? first_piola_kPa(materials_[cell], f) : StableNeoHookean(body_.materials[cell]).first_piola_kPa(f);
}

template <typename At>
void OpenCells::for_points(const VectorXd& x_mm, const At& at) const {
  for (const Cell& cell : cells_) {
    const Nodes u_mm = nodes_of(cell, x_mm);
    for (const Side& side : cell.sides) {
      const Matrix3d jumped = Matrix3d::Identity() + of_jumps(cell, side, x_mm);
      for (std::size_t p = side.first; p < side.last; ++p) {
        at(cell, side, points_[p], jumped + u_mm * points_[p].gradients);
      }
    }
  }
}

}  // namespace glisson::mechanics
