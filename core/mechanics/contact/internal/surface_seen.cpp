// What of a linear body is seen (surface_responses.h): which nodes, and what follows from their displacements.

#include <algorithm>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <mutex>

#include "base/parallel.h"
#include "mechanics/contact/internal/surface_responses.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/materials/linear_elasticity.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

void SurfaceResponses::see_nodes(std::size_t judged) {
  const NodeLayout& layout = model_.nodes();
  seen_of_node_.assign(static_cast<std::size_t>(layout.nodes()), -1);
  const auto see = [&](int node) {
    int& seen = seen_of_node_[static_cast<std::size_t>(node)];
    if (seen >= 0) return seen;
    seen = static_cast<int>(seen_nodes_.size());
    seen_nodes_.push_back(node);
    return seen;
  };
  for (std::size_t p = 0; p < mesh_point_.size(); ++p) see(node(static_cast<int>(p)));
  std::vector<Eigen::Triplet<double>> values;
  judged_values_ = 3 * static_cast<Eigen::Index>(seen_nodes_.size());
  for (std::size_t w = 0; w < watched_.size(); ++w) {
    const auto& nodes = layout.cells[static_cast<std::size_t>(watched_[w].cell)];
    const TetValues of_nodes = tet_values(layout.order, watched_[w].barycentric);
    for (int k = 0; k < layout.nodes_per_cell(); ++k) {
      values.emplace_back(static_cast<int>(w), see(nodes[static_cast<std::size_t>(k)]), of_nodes[k]);
    }
    if (w < judged) judged_values_ = 3 * static_cast<Eigen::Index>(seen_nodes_.size());
  }
  std::vector<std::uint8_t> is_inner(layout.node_of_point.size(), 1);
  for (const int p : mesh_point_) is_inner[static_cast<std::size_t>(p)] = 0;
  for (std::size_t p = 0; p < is_inner.size(); ++p) {
    if (is_inner[p] == 0 || layout.node_of_point[p] < 0) continue;
    see(layout.node_of_point[p]);
    inner_.push_back(static_cast<int>(p));
  }
  watched_of_seen_.resize(static_cast<Eigen::Index>(watched_.size()), static_cast<Eigen::Index>(seen_nodes_.size()));
  watched_of_seen_.setFromTriplets(values.begin(), values.end());
}

// The surface's points, the inner corners, and the watched places, which no nodes' values give where a cell is open.
SeenPart SurfaceResponses::seen_of_cut() const {
  std::vector<int> points = mesh_point_;
  points.insert(points.end(), inner_.begin(), inner_.end());
  std::vector<int> nodes;
  for (const int p : points) nodes.push_back(model_.nodes().node_of_point[static_cast<std::size_t>(p)]);
  SeenPart seen{[nodes, places = watched_, layout = model_.nodes()](const Eigen::MatrixXd& displacement_mm) {
                  const auto corners = 3 * static_cast<Eigen::Index>(nodes.size());
                  Eigen::MatrixXd part(corners + 3 * static_cast<Eigen::Index>(places.size()), displacement_mm.cols());
                  for (std::size_t i = 0; i < nodes.size(); ++i) {
                    part.middleRows<3>(3 * static_cast<Eigen::Index>(i)) =
                        displacement_mm.middleRows<3>(3 * Eigen::Index{nodes[i]});
                  }
                  part.bottomRows(part.rows() - corners) = displacements_at(layout, displacement_mm, places);
                  return part;
                },
                {},
                points};
  for (const PointInMesh& place : watched_) {
    seen.places.push_back({3 * static_cast<Eigen::Index>(seen.points.size()), place});
    seen.points.push_back(-1);
  }
  return seen;
}

std::vector<Vector3d> SurfaceResponses::surface_mm(const Seen& seen) const {
  std::vector<Vector3d> displacement_mm;
  for (Eigen::Index row = 0; row < surface_values(); row += 3) {
    displacement_mm.emplace_back(seen.nodes_mm.segment<3>(row));
    if (seen.by_cut_mm.size() > 0) displacement_mm.back() += seen.by_cut_mm.segment<3>(row);
  }
  return displacement_mm;
}

std::vector<Vector3d> SurfaceResponses::watched_mm(const Seen& seen) const {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  const Rows rows_mm = watched_of_seen_ * Eigen::Map<const Rows>(seen.nodes_mm.data(), seen.nodes_mm.size() / 3, 3);
  const Eigen::Index first = surface_values() + 3 * static_cast<Eigen::Index>(inner_.size());
  std::vector<Vector3d> displacement_mm(watched_.size());
  for (std::size_t w = 0; w < watched_.size(); ++w) {
    displacement_mm[w] = rows_mm.row(static_cast<Eigen::Index>(w));
    if (seen.by_cut_mm.size() > 0) {
      displacement_mm[w] += seen.by_cut_mm.segment<3>(first + 3 * static_cast<Eigen::Index>(w));
    }
  }
  return displacement_mm;
}

Eigen::MatrixXd SurfaceResponses::seen_part(const Eigen::MatrixXd& displacement_mm) const {
  Eigen::MatrixXd part(3 * static_cast<Eigen::Index>(seen_nodes_.size()), displacement_mm.cols());
  Eigen::Index row = 0;
  for (const int node : seen_nodes_) {
    part.middleRows<3>(row) = displacement_mm.middleRows<3>(3 * Eigen::Index{node});
    row += 3;
  }
  return part;
}

std::vector<Vector3d> SurfaceResponses::mesh_points_mm(const Seen& seen) const {
  std::vector<Vector3d> displacement_mm(model_.mesh().points_mm.size(), Vector3d(0, 0, 0));
  Eigen::Index row = 0;
  for (const auto* points : {&mesh_point_, &inner_}) {
    for (const int p : *points) {
      const int node = model_.nodes().node_of_point[static_cast<std::size_t>(p)];
      Vector3d& there_mm = displacement_mm[static_cast<std::size_t>(p)];
      there_mm = seen.nodes_mm.segment<3>(3 * Eigen::Index{seen_of_node_[static_cast<std::size_t>(node)]});
      if (seen.by_cut_mm.size() > 0) there_mm += seen.by_cut_mm.segment<3>(row);
      row += 3;
    }
  }
  return displacement_mm;
}

StrainRange SurfaceResponses::strain_range(const std::vector<Vector3d>& points_mm, const VectorXd& jumps_mm) const {
  const geometry::TetMesh& mesh = model_.mesh();
  using Corners = Eigen::Matrix<double, 3, 4>;
  const auto corners_of = [&](std::size_t c) {
    Corners u_mm;
    for (int i = 0; i < 4; ++i) u_mm.col(i) = points_mm[static_cast<std::size_t>(mesh.cells[c][i])];
    return u_mm;
  };
  const auto count = [&](std::size_t c, const Corners& u_mm, StrainRange& range) {
    const Matrix3d gradient = u_mm * cell_geometry(mesh, c).barycentric_gradients;
    range.inverted_cells += (Matrix3d::Identity() + gradient).determinant() <= 0 ? 1 : 0;
    const Matrix3d strain = small_strain(gradient);
    if (strain.norm() <= range.largest_strain) return;  // of which the largest principal strain is no more
    Eigen::SelfAdjointEigenSolver<Matrix3d> principal;
    principal.computeDirect(strain, Eigen::EigenvaluesOnly);
    range.largest_strain = std::max(range.largest_strain, principal.eigenvalues().cwiseAbs().maxCoeff());
  };

  StrainRange range;
  std::vector<std::uint8_t> open(open_cells_.empty() ? 0 : mesh.cells.size(), 0);
  for (const OpenCell& cell : open_cells_) {
    open[cell.cell] = 1;
    for (const int side : {0, 1}) {
      Corners u_mm = corners_of(static_cast<std::size_t>(cell.cell));
      for (int i = 0; i < 4; ++i) {
        if (cell.jump[i] >= 0)
          u_mm.col(i) += (side - (cell.height_mm[i] > 0 ? 1 : 0)) * jumps_mm.segment<3>(3 * cell.jump[i]);
      }
      count(static_cast<std::size_t>(cell.cell), u_mm, range);
    }
  }
  std::mutex joining;
  parallel_for(mesh.cells.size(), 1024, [&](std::size_t begin, std::size_t end) {
    StrainRange part;
    for (std::size_t c = begin; c < end; ++c) {
      if (open.empty() || open[c] == 0) count(c, corners_of(c), part);
    }
    const std::lock_guard lock(joining);
    range.largest_strain = std::max(range.largest_strain, part.largest_strain);
    range.inverted_cells += part.inverted_cells;
  });
  return range;
}

}  // namespace glisson::mechanics
