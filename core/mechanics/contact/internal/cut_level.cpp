#include "mechanics/contact/internal/cut_level.h"

#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <numbers>

#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Eigen::VectorXf;

// How far behind the front, against its way.
double behind_mm(const CutFront& front, const Vector3d& place_mm);
// H at a place.
double sided(const CutFront& front, const Vector3d& place_mm);

}  // namespace

CutLevel::CutLevel(const Body& body, const SplineLattice& lattice, const std::vector<Shares>& wide_of_node,
                   const OpenCells& open, const std::vector<CutFront>& fronts)
    : lattice_(lattice), entry_of_(static_cast<std::size_t>(body.layout.nodes() + open.jumps()), -1) {
  // The splines that a jump has a share in, once for each front.
  std::vector<int> point_of_jump(static_cast<std::size_t>(open.jumps()), -1);
  for (const OpenCells::Cell& cell : open.all()) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (cell.jump[i] >= 0) point_of_jump[static_cast<std::size_t>(cell.jump[i])] = body.mesh.cells[cell.cell][i];
    }
  }
  int functions = 0;
  for (const CutFront& front : fronts) {
    std::vector<int> number(static_cast<std::size_t>(lattice.wide_points()), -1);
    for (const int jump : front.jumps) {
      const int node = body.layout.node_of_point[point_of_jump[static_cast<std::size_t>(jump)]];
      for (const auto& [point, weight] : wide_of_node[static_cast<std::size_t>(node)]) {
        constexpr float a_share_worth_having = 0.02F;
        int& own = number[static_cast<std::size_t>(point)];
        if (own < 0 && weight > a_share_worth_having) own = functions++;
      }
    }
    for (int node = 0; node < body.layout.nodes(); ++node) {
      for (const auto& [point, weight] : wide_of_node[static_cast<std::size_t>(node)]) {
        const int own = number[static_cast<std::size_t>(point)];
        if (own < 0) continue;
        add(node, own,
            weight * static_cast<float>(sided(front, body.layout.positions_mm[static_cast<std::size_t>(node)])));
      }
    }
    for (const int jump : front.jumps) {
      const int point_in_mesh = point_of_jump[static_cast<std::size_t>(jump)];
      const int node = body.layout.node_of_point[point_in_mesh];
      // H is as far apart there as it is on both sides of the surface.
      const double behind = behind_mm(front, body.mesh.points_mm[static_cast<std::size_t>(point_in_mesh)]);
      if (behind <= 0) continue;
      for (const auto& [point, weight] : wide_of_node[static_cast<std::size_t>(node)]) {
        const int own = number[static_cast<std::size_t>(point)];
        if (own >= 0) add(body.layout.nodes() + jump, own, weight);
      }
    }
  }
  MatrixXd sum = stiffness(body, open, functions);
  if (functions > 0) sum.diagonal().array() += 1e-6 * sum.diagonal().mean();
  inverse_ = sum.llt().solve(MatrixXd::Identity(sum.rows(), sum.cols())).cast<float>();
  for (const Matrix3d& own : open.own_stiffness()) own_inverse_.push_back(own.inverse());
}

void CutLevel::add(int unknown, int function, float weight) {
  int& entry = entry_of_[static_cast<std::size_t>(unknown)];
  if (entry < 0) {
    entry = static_cast<int>(entries_.size());
    entries_.push_back({unknown, {}});
  }
  entries_[static_cast<std::size_t>(entry)].second.emplace_back(function, weight);
}

// The integral of strains' products, each function seen by its gradient at one point of a cell, or of a cell's side.
MatrixXd CutLevel::stiffness(const Body& body, const OpenCells& open, int functions) const {
  MatrixXd sum = MatrixXd::Zero(3 * Index{functions}, 3 * Index{functions});
  std::vector<int> place(static_cast<std::size_t>(functions), -1);
  std::vector<int> here;  // functions
  std::vector<Vector3d> gradient;
  const auto take = [&](int unknown, const Vector3d& of_unknown) {
    for (const auto& [function, weight] : around(unknown)) {
      int& at = place[static_cast<std::size_t>(function)];
      if (at < 0) {
        at = static_cast<int>(here.size());
        here.push_back(function);
        gradient.emplace_back(Vector3d::Zero());
      }
      gradient[static_cast<std::size_t>(at)] += double{weight} * of_unknown;
    }
  };
  const auto integrate = [&](const Lame& lame, double volume_mm3) {
    const double lambda = volume_mm3 * lame.lambda_kPa, mu = volume_mm3 * lame.mu_kPa;
    for (std::size_t k = 0; k < here.size(); ++k) {
      for (std::size_t l = 0; l < here.size(); ++l) {
        if (here[l] > here[k]) continue;
        Matrix3d block = lambda * gradient[k] * gradient[l].transpose() + mu * gradient[l] * gradient[k].transpose();
        block.diagonal().array() += mu * gradient[k].dot(gradient[l]);
        sum.block<3, 3>(3 * here[k], 3 * here[l]) += block;
      }
      place[static_cast<std::size_t>(here[k])] = -1;
    }
    here.clear();
    gradient.clear();
  };
  std::vector<std::uint8_t> is_open(body.mesh.cells.size(), 0);
  for (const OpenCells::Cell& cell : open.all()) {
    is_open[cell.cell] = 1;
    const CellGeometry shape{cell.barycentric_gradients, 0};
    for (const OpenCells::Side& side : cell.sides) {
      const TetGradients gradients = tet_gradients(tet_derivatives(body.options.order, side.centroid), shape);
      for (Index a = 0; a < gradients.rows(); ++a) {
        take(body.layout.cells[cell.cell][static_cast<std::size_t>(a)], gradients.row(a));
      }
      for (std::size_t i = 0; i < 4; ++i) {
        if (side.of_jump[i] == 0) continue;
        take(body.layout.nodes() + cell.jump[i],
             side.of_jump[i] * cell.barycentric_gradients.row(static_cast<Index>(i)));
      }
      integrate(body.materials[cell.cell], side.volume_mm3);
    }
  }
  const TetDerivatives in_the_middle = tet_derivatives(body.options.order, Eigen::Vector4d::Constant(0.25));
  for (std::size_t c = 0; c < body.mesh.cells.size(); ++c) {
    const auto& nodes = body.layout.cells[c];
    bool reached = false;
    for (int a = 4; a < 10; ++a) reached = reached || !around(nodes[static_cast<std::size_t>(a)]).empty();
    if (is_open[c] || !reached) continue;
    const CellGeometry shape = cell_geometry(body.mesh, c);
    const TetGradients gradients = tet_gradients(in_the_middle, shape);
    for (Index a = 4; a < 10; ++a) take(nodes[static_cast<std::size_t>(a)], gradients.row(a));
    integrate(body.materials[c], shape.volume_mm3);
  }
  const auto& bridges = open.springs().between;
  for (Index j = 0; j < bridges.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator bridge(bridges, j); bridge; ++bridge) {
      for (const auto& [k, of_k] : around(body.layout.nodes() + static_cast<int>(bridge.row()))) {
        for (const auto& [l, of_l] : around(body.layout.nodes() + static_cast<int>(j))) {
          if (l > k) continue;
          sum.block<3, 3>(3 * k, 3 * l).diagonal().array() += bridge.value() * double{of_k} * double{of_l};
        }
      }
    }
  }
  return sum.selfadjointView<Eigen::Lower>();
}

VectorXf CutLevel::answer(const VectorXd& r) const {
  VectorXf seen = VectorXf::Zero(values());
  for (const auto& [unknown, shares] : entries_) {
    const Eigen::Vector3f force = r.segment<3>(3 * unknown).cast<float>();
    for (const auto& [function, weight] : shares) seen.segment<3>(3 * function) += weight * force;
  }
  return inverse_ * seen;
}

void CutLevel::spread(const VectorXf& values, VectorXd& z) const {
  const auto nodes = static_cast<int>(entry_of_.size()) - jumps();
  for (const auto& [unknown, shares] : entries_) {
    Eigen::Vector3f moved = Eigen::Vector3f::Zero();
    for (const auto& [function, weight] : shares) moved += weight * values.segment<3>(3 * function);
    for (int d = 0; d < 3; ++d) {
      if (unknown >= nodes || !lattice_.is_fixed(unknown, d)) z[3 * unknown + d] += double{moved[d]};
    }
  }
}

namespace {

double behind_mm(const CutFront& front, const Vector3d& place_mm) {
  return (front.last.to_mm - place_mm).dot((front.last.to_mm - front.last.from_mm).normalized());
}

double sided(const CutFront& front, const Vector3d& place_mm) {
  const double angle = std::atan2(front.last.surface.height_mm(place_mm), -behind_mm(front, place_mm));
  return 0.5 + angle / (2 * std::numbers::pi);
}

}  // namespace
}  // namespace glisson::mechanics
