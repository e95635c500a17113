#include "mechanics/contact/internal/surface_responses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "base/parallel.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/materials/linear_elasticity.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

SurfaceResponses::SurfaceResponses(StaticModel model, const StaticResult& standing, std::vector<PointInMesh> watched)
    : model_(std::move(model)),
      surface_(geometry::boundary_surface(model_.mesh())),
      watched_(std::move(watched)),
      mutual_compliance_(model_.mutual_compliance()) {
  memory_->relative_residual = standing.relative_residual;
  std::vector<Vector3d> seen_mm;
  seen_of_mesh_point_.assign(model_.mesh().points_mm.size(), -1);
  const auto see = [&](int mesh_point) {
    seen_of_mesh_point_[mesh_point] = static_cast<Eigen::Index>(seen_mm.size());
    seen_mm.push_back(standing.displacement_mm[mesh_point]);
  };
  for (const double p : geometry::find_field(surface_.point_fields, "mesh_point")->values) {
    mesh_point_.push_back(static_cast<int>(p));
    see(mesh_point_.back());
  }
  for (const Vector3d& u_mm : model_.displacement_at(standing, watched_)) seen_mm.push_back(u_mm);
  for (std::size_t p = 0; p < seen_of_mesh_point_.size(); ++p) {
    if (seen_of_mesh_point_[p] >= 0) continue;
    inner_.push_back(static_cast<int>(p));
    see(inner_.back());
  }
  standing_seen_mm_ = Eigen::Map<const VectorXd>(seen_mm.front().data(), 3 * static_cast<Eigen::Index>(seen_mm.size()));

  mutual_of_point_.assign(mesh_point_.size(), -1);
  for (const int p : model_.mutual_points()) {
    const auto point = static_cast<int>(seen_of_mesh_point_[p]);
    GLISSON_ASSERT(static_cast<std::size_t>(point) < mesh_point_.size());
    mutual_of_point_[point] = static_cast<int>(mutual_points_.size());
    mutual_points_.push_back(point);
  }
  memory_->responses.resize(mesh_point_.size());
  make_groups();
}

// Neighbours share a group: who needs one will soon need the others, and several right-hand sides cost little more than
// one. Cells of a grid, cut into runs of at most eight.
void SurfaceResponses::make_groups() {
  constexpr double cell_mm = 15.0;
  constexpr std::size_t maximum = 8;
  std::map<std::array<long, 3>, std::vector<int>> cells;
  for (std::size_t p = 0; p < surface_.points_mm.size(); ++p) {
    if (mutual_of_point_[p] >= 0) continue;
    const Vector3d at = (surface_.points_mm[p] / cell_mm).array().floor();
    cells[{std::lround(at.x()), std::lround(at.y()), std::lround(at.z())}].push_back(static_cast<int>(p));
  }
  group_of_point_.resize(surface_.points_mm.size());
  for (const auto& [cell, points] : cells) {
    for (std::size_t begin = 0; begin < points.size(); begin += maximum) {
      const std::size_t end = std::min(points.size(), begin + maximum);
      for (std::size_t i = begin; i < end; ++i) group_of_point_[points[i]] = static_cast<int>(groups_.size());
      groups_.emplace_back(points.begin() + static_cast<long>(begin), points.begin() + static_cast<long>(end));
    }
  }
}

// Groups side by side: what each answers is its own, whatever the order.
Result<int> SurfaceResponses::remember(const std::vector<int>& points) const {
  const std::lock_guard lock(memory_->mutex);
  auto& responses = memory_->responses;
  std::vector<int> unknown;
  for (const int asked : points) {
    if (!responses[asked] && mutual_of_point_[asked] < 0) unknown.push_back(group_of_point_[asked]);
  }
  std::sort(unknown.begin(), unknown.end());
  unknown.erase(std::unique(unknown.begin(), unknown.end()), unknown.end());
  std::vector<StaticModel::Responses> solved(unknown.size());
  parallel_for(unknown.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t u = begin; u < end; ++u) {
      const std::vector<int>& group = groups_[unknown[u]];
      Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(model_.nodes().nodes()),
                                                   3 * static_cast<Eigen::Index>(group.size()));
      for (std::size_t i = 0; i < group.size(); ++i) {
        unit.block<3, 3>(3 * node(group[i]), 3 * static_cast<Eigen::Index>(i)).setIdentity();
      }
      solved[u] = model_.respond(unit, Digits::seen);
      solved[u].displacement_mm = seen_part(solved[u].displacement_mm);
    }
  });
  int solves = 0;
  for (std::size_t u = 0; u < unknown.size(); ++u) {
    if (auto accepted = accept(solved[u]); !accepted) return failure(std::move(accepted.error()));
    const std::vector<int>& group = groups_[unknown[u]];
    solves += 3 * static_cast<int>(group.size());
    for (std::size_t i = 0; i < group.size(); ++i) {
      responses[group[i]] = solved[u].displacement_mm.middleCols<3>(3 * static_cast<Eigen::Index>(i));
    }
  }
  return solves;
}

Matrix3d SurfaceResponses::compliance(int at, int of) const {
  const int at_mutual = mutual_of_point_[at], of_mutual = mutual_of_point_[of];
  if (of_mutual < 0) return memory_->responses[of]->middleRows<3>(3 * at);
  if (at_mutual < 0) return memory_->responses[at]->middleRows<3>(3 * of).transpose();
  return mutual_compliance_.block<3, 3>(3 * at_mutual, 3 * of_mutual);
}

Result<SurfaceResponses> SurfaceResponses::opened(const CutStrip& strip, const Loads& standing_loads) const {
  if (!mutual_points_.empty()) {
    return failure("not-available", GLISSON_TEXT("A cut cannot advance through a body that was meshed with a cut."));
  }
  SurfaceResponses next = *this;
  if (!next.opening_) {
    SeenPart seen{[body = *this](const Eigen::MatrixXd& displacement_mm) { return body.seen_part(displacement_mm); },
                  {}};
    seen.points = mesh_point_;
    for (std::size_t w = 0; w < watched_.size(); ++w) {
      seen.places.push_back({surface_values() + 3 * static_cast<Eigen::Index>(w), watched_[w]});
      seen.points.push_back(-1);
    }
    seen.points.insert(seen.points.end(), inner_.begin(), inner_.end());
    auto closed = Opening::of(model_, standing_loads, std::move(seen));
    if (!closed) return failure(std::move(closed.error()));
    next.opening_ = std::move(*closed);
  }
  auto advanced = next.opening_->advanced(strip);
  if (!advanced) return failure(std::move(advanced.error()));
  next.opening_ = std::move(*advanced);
  next.open_cells_ = next.opening_->cells();
  return next;
}

VectorXd SurfaceResponses::amplitudes_under(const PointForces& force_mN, const WallForces& wall_mN) const {
  if (!opening_) return {};
  VectorXd load_mN = opening_->standing_load();
  for (const auto& [point, force] : force_mN) load_mN += opening_->load_of_force(3 * point, force);
  for (const auto& [wall, force] : wall_mN) {
    load_mN += opening_->load_of_push(static_cast<std::size_t>(wall), force * opening_->normals()[wall]);
  }
  return opening_->amplitudes_mm(load_mN);
}

VectorXd SurfaceResponses::jumps_under(const PointForces& force_mN, const WallForces& wall_mN) const {
  return opening_ ? opening_->jumps_mm(amplitudes_under(force_mN, wall_mN)) : VectorXd();
}

Result<VectorXd> SurfaceResponses::seen_under(const PointForces& force_mN, const WallForces& wall_mN, Part part) const {
  VectorXd seen_mm = standing_seen_mm_;
  const Eigen::Index rows = part == Part::surface ? surface_values() : seen_values();
  if (opening_) seen_mm.head(rows) += opening_->seen_mm(amplitudes_under(force_mN, wall_mN), rows);
  VectorXd of_mutual_mN;
  for (const auto& [point, force] : force_mN) {
    if (mutual_of_point_[point] < 0) {
      seen_mm.head(rows) += memory_->responses[point]->topRows(rows) * force;
      continue;
    }
    if (of_mutual_mN.size() == 0) of_mutual_mN = VectorXd::Zero(3 * static_cast<Eigen::Index>(model_.nodes().nodes()));
    of_mutual_mN.segment<3>(3 * node(point)) += force;
  }
  if (of_mutual_mN.size() == 0) return seen_mm;
  const std::lock_guard lock(memory_->mutex);
  const StaticModel::Responses solved = model_.respond(of_mutual_mN);
  if (auto accepted = accept(solved); !accepted) return failure(std::move(accepted.error()));
  return seen_mm + seen_part(solved.displacement_mm);
}

Result<void> SurfaceResponses::accept(const StaticModel::Responses& solved) const {
  if (auto usable = solved.usable(); !usable) return usable;
  memory_->relative_residual = std::max(memory_->relative_residual, solved.relative_residual);
  return {};
}

double SurfaceResponses::relative_residual() const {
  return std::max(memory_->relative_residual, opening_ ? opening_->relative_residual() : 0.0);
}

Eigen::MatrixXd SurfaceResponses::seen_part(const Eigen::MatrixXd& displacement_mm) const {
  const NodeLayout& layout = model_.nodes();
  Eigen::MatrixXd part = Eigen::MatrixXd::Zero(seen_values(), displacement_mm.cols());
  Eigen::Index row = 0;
  for (const int p : mesh_point_) {
    part.middleRows<3>(row) = displacement_mm.middleRows<3>(3 * layout.node_of_point[p]);
    row += 3;
  }
  part.middleRows(row, watched_values()) = displacements_at(layout, displacement_mm, watched_);
  row += watched_values();
  for (const int p : inner_) {
    if (layout.node_of_point[p] >= 0) {
      part.middleRows<3>(row) = displacement_mm.middleRows<3>(3 * layout.node_of_point[p]);
    }
    row += 3;
  }
  return part;
}

std::vector<Vector3d> SurfaceResponses::mesh_points_mm(const VectorXd& seen_mm) const {
  std::vector<Vector3d> displacement_mm;
  for (const Eigen::Index place : seen_of_mesh_point_) displacement_mm.emplace_back(seen_mm.segment<3>(3 * place));
  return displacement_mm;
}

StrainRange SurfaceResponses::strain_range(const VectorXd& seen_mm, const VectorXd& jumps_mm) const {
  const geometry::TetMesh& mesh = model_.mesh();
  using Corners = Eigen::Matrix<double, 3, 4>;
  const auto corners_of = [&](std::size_t c) {
    Corners u_mm;
    for (int i = 0; i < 4; ++i) u_mm.col(i) = seen_mm.segment<3>(3 * seen_of_mesh_point_[mesh.cells[c][i]]);
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
