#include "mechanics/contact/internal/surface_responses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "mechanics/statics/displacements.h"

namespace glisson::mechanics {
namespace {

constexpr std::size_t most_surface_bytes = std::size_t{160} << 20, most_rest_bytes = std::size_t{128} << 20;

}  // namespace

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

SurfaceResponses::SurfaceResponses(StaticModel model, const StaticResult& standing, std::vector<PointInMesh> watched,
                                   std::size_t judged)
    : model_(std::move(model)),
      surface_(geometry::boundary_surface(model_.mesh())),
      watched_(std::move(watched)),
      mutual_compliance_(model_.mutual_compliance()) {
  memory_->relative_residual = standing.relative_residual;
  std::vector<int> point_of_mesh_point(model_.mesh().points_mm.size(), -1);
  for (const double p : geometry::find_field(surface_.point_fields, "mesh_point")->values) {
    point_of_mesh_point[static_cast<std::size_t>(p)] = static_cast<int>(mesh_point_.size());
    mesh_point_.push_back(static_cast<int>(p));
  }
  see_nodes(judged);
  standing_seen_mm_ = seen_part(nodal_displacements(model_.nodes(), standing));
  standing_surface_mm_ = standing_seen_mm_.head(surface_values());

  mutual_of_point_.assign(mesh_point_.size(), -1);
  for (const int p : model_.mutual_points()) {
    const int point = point_of_mesh_point[p];
    GLISSON_ASSERT(point >= 0);
    mutual_of_point_[point] = static_cast<int>(mutual_points_.size());
    mutual_points_.push_back(point);
  }
  memory_->responses.resize(mesh_point_.size());
  memory_->lacked_rest.assign(mesh_point_.size(), 0);
  make_groups();
}

// Neighbours share a group: who needs one will soon need the others, and several right-hand sides cost little more than
// one. Cells of a grid, cut into runs of at most four.
void SurfaceResponses::make_groups() {
  constexpr double cell_mm = 15.0;
  constexpr std::size_t maximum = 4;  // a dozen right-hand sides, less than a tenth of a second on a liver
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
  std::vector<int> unknown;
  for (const int asked : points) {
    if (!memory_->responses[asked] && mutual_of_point_[asked] < 0) unknown.push_back(group_of_point_[asked]);
  }
  std::sort(unknown.begin(), unknown.end());
  unknown.erase(std::unique(unknown.begin(), unknown.end()), unknown.end());
  std::vector<StaticModel::Responses> solved(unknown.size());
  parallel_for(unknown.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t u = begin; u < end; ++u) solved[u] = solve_group(unknown[u]);
  });
  int solves = 0;
  for (std::size_t u = 0; u < unknown.size(); ++u) {
    const Part part = memory_->rest_bytes < most_rest_bytes ? Part::all : Part::surface;
    if (auto kept = keep(unknown[u], solved[u], part); !kept) return failure(std::move(kept.error()));
    solves += 3 * static_cast<int>(groups_[unknown[u]].size());
  }
  return solves;
}

Result<bool> SurfaceResponses::remember_ahead(const PointForces& bearing_mN,
                                              const std::vector<Vector3d>& places_mm) const {
  const std::lock_guard lock(memory_->mutex);
  const auto ahead = group_ahead(bearing_mN, places_mm);
  if (!ahead) return false;
  const auto& [group, part] = *ahead;
  return keep(group, solve_group(group), part).map([] { return true; });
}

std::optional<std::pair<int, SurfaceResponses::Part>> SurfaceResponses::group_ahead(
    const PointForces& bearing_mN, const std::vector<Vector3d>& places_mm) const {
  if (memory_->rest_bytes < most_rest_bytes) {
    for (const auto& [point, force] : bearing_mN) {
      if (mutual_of_point_[point] >= 0 || knows_all(point)) continue;
      return std::pair(group_of_point_[point], Part::all);
    }
  }
  if (memory_->surface_bytes >= most_surface_bytes) return {};
  int nearest = -1;
  double nearest_mm = 0;
  for (std::size_t p = 0; p < mesh_point_.size(); ++p) {
    if (mutual_of_point_[p] >= 0 || memory_->responses[p]) continue;
    double away_mm = 0;
    for (std::size_t i = 0; i < places_mm.size(); ++i) {
      const double this_mm = (surface_.points_mm[p] - places_mm[i]).norm();
      away_mm = i == 0 ? this_mm : std::min(away_mm, this_mm);
    }
    if (nearest >= 0 && away_mm >= nearest_mm) continue;
    nearest = group_of_point_[p];
    nearest_mm = away_mm;
  }
  if (nearest < 0) return {};
  return std::pair(nearest, Part::surface);
}

StaticModel::Responses SurfaceResponses::solve_group(int group) const {
  const std::vector<int>& points = groups_[group];
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(model_.nodes().nodes()),
                                               3 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    unit.block<3, 3>(3 * node(points[i]), 3 * static_cast<Eigen::Index>(i)).setIdentity();
  }
  StaticModel::Responses solved = model_.respond(unit, Digits::seen);
  solved.displacement_mm = seen_part(solved.displacement_mm);
  return solved;
}

Result<void> SurfaceResponses::keep(int group, const StaticModel::Responses& solved, Part part) const {
  if (auto accepted = accept(solved); !accepted) return accepted;
  const Eigen::Index rows = part == Part::surface ? judged_values_ : solved.displacement_mm.rows();
  for (std::size_t i = 0; i < groups_[group].size(); ++i) {
    auto& known = memory_->responses[groups_[group][i]];
    const std::size_t bytes_a_row = 3 * sizeof(float);
    const Eigen::Index rest_known = known ? known->rows() - judged_values_ : 0;
    if (!known) memory_->surface_bytes += bytes_a_row * static_cast<std::size_t>(judged_values_);
    memory_->rest_bytes += bytes_a_row * static_cast<std::size_t>(rows - judged_values_ - rest_known);
    known = solved.displacement_mm.block(0, 3 * static_cast<Eigen::Index>(i), rows, 3).cast<float>();
  }
  return {};
}

bool SurfaceResponses::knows_all(int point) const {
  return memory_->responses[point] && memory_->responses[point]->rows() == standing_seen_mm_.size();
}

Matrix3d SurfaceResponses::compliance(int at, int of) const {
  const int at_mutual = mutual_of_point_[at], of_mutual = mutual_of_point_[of];
  if (of_mutual < 0) return memory_->responses[of]->middleRows<3>(3 * at).cast<double>();
  if (at_mutual < 0) return memory_->responses[at]->middleRows<3>(3 * of).transpose().cast<double>();
  return mutual_compliance_.block<3, 3>(3 * at_mutual, 3 * of_mutual);
}

Result<SurfaceResponses> SurfaceResponses::opened(const CutStrip& strip, const Loads& standing_loads) const {
  if (!mutual_points_.empty()) {
    return failure("not-available", GLISSON_TEXT("A cut cannot advance through a body that was meshed with a cut."));
  }
  SurfaceResponses next = *this;
  if (!next.opening_) {
    auto closed = Opening::of(model_, standing_loads, seen_of_cut());
    if (!closed) return failure(std::move(closed.error()));
    next.opening_ = std::move(*closed);
  }
  auto advanced = next.opening_->advanced(strip);
  if (!advanced) return failure(std::move(advanced.error()));
  next.opening_ = std::move(*advanced);
  next.open_cells_ = next.opening_->cells();
  return next;
}

SurfaceResponses SurfaceResponses::within_step(const VectorXd& rest_mm, const VectorXd& taken_mm) const {
  SurfaceResponses step = *this;
  step.standing_seen_mm_ = seen_part(taken_mm);
  step.standing_surface_mm_ = seen_part(rest_mm).topRows(surface_values());
  return step;
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

Result<VectorXd> SurfaceResponses::surface_under(const PointForces& force_mN, const WallForces& wall_mN) const {
  auto nodes_mm = nodes_under(force_mN, Part::surface);
  if (!nodes_mm) return nodes_mm;
  VectorXd surface_mm = nodes_mm->head(surface_values());
  if (opening_) surface_mm += opening_->seen_mm(amplitudes_under(force_mN, wall_mN), surface_values());
  return surface_mm;
}

Result<SurfaceResponses::Seen> SurfaceResponses::all_under(const PointForces& force_mN,
                                                           const WallForces& wall_mN) const {
  auto nodes_mm = nodes_under(force_mN, Part::all);
  if (!nodes_mm) return failure(std::move(nodes_mm.error()));
  Seen seen{std::move(*nodes_mm), {}, {}};
  if (!opening_) return seen;
  const VectorXd amplitudes_mm = amplitudes_under(force_mN, wall_mN);
  seen.by_cut_mm = opening_->seen_mm(amplitudes_mm);
  seen.jumps_mm = opening_->jumps_mm(amplitudes_mm);
  return seen;
}

// The rows of surface and judged places are sums of what is remembered, so that their bits do not depend on whether the
// others are, or are solved for.
Result<VectorXd> SurfaceResponses::nodes_under(const PointForces& force_mN, Part part) const {
  const Eigen::Index rows = part == Part::surface ? judged_values_ : standing_seen_mm_.size();
  Eigen::VectorXf moved_mm = Eigen::VectorXf::Zero(rows);
  PointForces of_mutual_mN, unknown_mN;
  for (const auto& [point, force] : force_mN) {
    if (mutual_of_point_[point] >= 0) {
      of_mutual_mN.emplace(point, force);
      continue;
    }
    const Response& response = *memory_->responses[point];
    moved_mm.head(judged_values_) += response.topRows(judged_values_) * force.cast<float>();
    if (part == Part::surface) continue;
    if (knows_all(point)) {
      moved_mm.tail(rows - judged_values_) += response.bottomRows(rows - judged_values_) * force.cast<float>();
    } else {
      unknown_mN.emplace(point, force);
    }
  }
  VectorXd nodes_mm = standing_seen_mm_.head(rows) + moved_mm.cast<double>();
  if (!unknown_mN.empty()) {
    const auto rest_mm = rest_under(unknown_mN);
    if (!rest_mm) return rest_mm;
    nodes_mm.tail(rows - judged_values_) += *rest_mm;
  }
  if (of_mutual_mN.empty()) return nodes_mm;
  const std::lock_guard lock(memory_->mutex);
  const StaticModel::Responses solved = model_.respond(force_on_nodes_mN(of_mutual_mN));
  if (auto accepted = accept(solved); !accepted) return failure(std::move(accepted.error()));
  return nodes_mm + seen_part(solved.displacement_mm).col(0).head(rows);
}

Result<VectorXd> SurfaceResponses::rest_under(const PointForces& force_mN) const {
  const std::lock_guard lock(memory_->mutex);
  int again = -1;  // that lacks it again, and bears most
  for (const auto& [point, force] : force_mN) {
    auto& lacked = memory_->lacked_rest[point];
    if (lacked != 0 && (again < 0 || force.norm() > force_mN.at(again).norm())) again = point;
    lacked = 1;
  }
  if (memory_->rest_bytes >= most_rest_bytes) again = -1;
  Eigen::MatrixXd loads_mN = force_on_nodes_mN(force_mN);
  if (again >= 0) {
    loads_mN.conservativeResize(Eigen::NoChange, 4);
    loads_mN.rightCols<3>().setZero();
    loads_mN.block<3, 3>(3 * node(again), 1).setIdentity();
  }
  StaticModel::Responses solved = model_.respond(loads_mN, Digits::seen);
  if (auto accepted = accept(solved); !accepted) return failure(std::move(accepted.error()));
  const Eigen::Index rest = standing_seen_mm_.size() - judged_values_;
  const Eigen::MatrixXd rest_mm = seen_part(solved.displacement_mm).bottomRows(rest);
  if (again >= 0) {
    Response& known = *memory_->responses[again];
    known.conservativeResize(judged_values_ + rest, 3);
    known.bottomRows(rest) = rest_mm.rightCols<3>().cast<float>();
    memory_->rest_bytes += 3 * sizeof(float) * static_cast<std::size_t>(rest);
  }
  return VectorXd(rest_mm.col(0));
}

VectorXd SurfaceResponses::force_on_nodes_mN(const PointForces& force_mN) const {
  VectorXd on_nodes_mN = VectorXd::Zero(3 * static_cast<Eigen::Index>(model_.nodes().nodes()));
  for (const auto& [point, force] : force_mN) on_nodes_mN.segment<3>(3 * node(point)) += force;
  return on_nodes_mN;
}

Result<void> SurfaceResponses::accept(const StaticModel::Responses& solved) const {
  if (auto usable = solved.usable(); !usable) return usable;
  memory_->relative_residual = std::max(memory_->relative_residual, solved.relative_residual);
  return {};
}

double SurfaceResponses::relative_residual() const {
  return std::max(memory_->relative_residual, opening_ ? opening_->relative_residual() : 0.0);
}

}  // namespace glisson::mechanics
