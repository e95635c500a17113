#include "mechanics/compliance_distance.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "base/parallel.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

// Calls visit(offset) for every voxel whose centre lies in the tetrahedron.
template <typename Visit>
void visit_voxels_in(const geometry::TetMesh& mesh, std::size_t cell, const imaging::Grid& grid, const Visit& visit);

// The voxel that holds a place; a place on the grid's empty layer belongs to the nearest voxel within.
std::size_t voxel_of(const imaging::Grid& grid, const Vector3d& place_mm);

}  // namespace

VoxelBody voxelise(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa, double spacing_mm) {
  GLISSON_ASSERT(youngs_kPa.size() == mesh.cells.size() && spacing_mm > 0);
  const geometry::Box box = geometry::bounding_box(mesh.points_mm);
  VoxelBody voxels;
  imaging::Grid& grid = voxels.body.grid;
  grid.spacing_mm.setConstant(spacing_mm);
  for (int axis = 0; axis < 3; ++axis) {
    const double length_mm = box.max_mm[axis] - box.min_mm[axis];
    const int inner = std::max(1, static_cast<int>(std::ceil(length_mm / spacing_mm - 1e-6)));
    grid.size[axis] = inner + 2;
    grid.origin_mm[axis] = 0.5 * (box.min_mm[axis] + box.max_mm[axis]) - 0.5 * spacing_mm * (inner + 1);
  }
  voxels.body.values.assign(grid.voxels(), 0);
  voxels.youngs_kPa.assign(grid.voxels(), 0.0F);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    visit_voxels_in(mesh, c, grid, [&](std::size_t voxel) {
      voxels.body.values[voxel] = 1;
      voxels.youngs_kPa[voxel] = static_cast<float>(youngs_kPa[c]);
    });
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const int point : mesh.cells[c]) {
      const std::size_t voxel = voxel_of(grid, mesh.points_mm[point]);
      if (voxels.body.values[voxel]) continue;
      voxels.body.values[voxel] = 1;
      voxels.youngs_kPa[voxel] = static_cast<float>(youngs_kPa[c]);
    }
  }
  return voxels;
}

ComplianceDistance::ComplianceDistance(const VoxelBody& body, const std::vector<Cut>& cuts)
    : body_(&body), stride_{1, grid().size[0], std::ptrdiff_t{grid().size[0]} * grid().size[1]} {
  if (cuts.empty()) return;
  blocked_.assign(grid().voxels(), 0);
  std::vector<double> height_mm(blocked_.size());
  for (const Cut& cut : cuts) {
    const CutInSpace& in_space = cuts_.emplace_back(CutInSpace::of(cut).value());
    parallel_for(blocked_.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t voxel = begin; voxel < end; ++voxel) {
        height_mm[voxel] = in_space.surface.height_mm(center_mm(voxel));
      }
    });
    for (std::size_t voxel = 0; voxel < blocked_.size(); ++voxel) {
      if (!inside(voxel)) continue;  // the empty layer around the body leaves every voxel of it a next one
      const Vector3d here_mm = center_mm(voxel);
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3d next_mm = here_mm + grid().spacing_mm[axis] * Vector3d::Unit(axis);
        const std::size_t next = voxel + static_cast<std::size_t>(stride_[axis]);
        if (in_space.separates(here_mm, height_mm[voxel], next_mm, height_mm[next])) {
          blocked_[voxel] |= static_cast<std::uint8_t>(1 << axis);
        }
      }
    }
  }
}

ComplianceDistance::Voronoi ComplianceDistance::voronoi(const std::vector<Vector3d>& seeds_mm) const {
  Workspace workspace(grid().voxels());
  for (std::size_t s = 0; s < seeds_mm.size(); ++s) start(seeds_mm[s], static_cast<int>(s), workspace);
  march(unreached, workspace, [](std::size_t, float) {});
  return {std::move(workspace.owner_), std::move(workspace.distance_)};
}

std::vector<ComplianceDistance::Reached> ComplianceDistance::within(const Vector3d& seed_mm, float limit,
                                                                    Workspace& workspace) const {
  std::vector<Reached> reached;
  start(seed_mm, 0, workspace);
  march(limit, workspace, [&](std::size_t voxel, float distance) { reached.push_back({voxel, distance}); });
  for (const std::size_t voxel : workspace.touched_) {
    workspace.distance_[voxel] = unreached;
    workspace.owner_[voxel] = -1;
    workspace.fixed_[voxel] = 0;
  }
  workspace.touched_.clear();
  workspace.front_.clear();
  return reached;
}

float ComplianceDistance::step(const Vector3d& place_mm, const Vector3d& seen_from_mm, std::size_t voxel) const {
  const Vector3d there_mm = center_mm(voxel);
  for (const CutInSpace& cut : cuts_) {
    if (cut.separates(seen_from_mm, there_mm)) return unreached;
  }
  const std::size_t here = voxel_at(place_mm);
  const auto compliance = [&](std::size_t v) { return 1.0 / body_->youngs_kPa[v]; };
  const double mean = inside(here) ? 0.5 * (compliance(here) + compliance(voxel)) : compliance(voxel);
  return static_cast<float>(mean * (place_mm - there_mm).norm());
}

std::size_t ComplianceDistance::voxel_at(const Vector3d& place_mm) const { return voxel_of(grid(), place_mm); }

Vector3d ComplianceDistance::center_mm(std::size_t voxel) const {
  const auto offset = static_cast<std::ptrdiff_t>(voxel);
  const std::ptrdiff_t row = offset % stride_[2] / stride_[1], slice = offset / stride_[2];
  return grid().origin_mm +
         grid().spacing_mm.cwiseProduct(Vector3d(double(offset % stride_[1]), double(row), double(slice)));
}

std::vector<std::size_t> ComplianceDistance::around(std::size_t voxel) const {
  std::vector<std::size_t> voxels;
  for (int k = -1; k <= 1; ++k) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        const auto other =
            static_cast<std::size_t>(static_cast<std::ptrdiff_t>(voxel) + i + j * stride_[1] + k * stride_[2]);
        if (inside(other)) voxels.push_back(other);
      }
    }
  }
  return voxels;
}

std::vector<std::size_t> ComplianceDistance::beside(std::size_t voxel) const {
  std::vector<std::size_t> voxels;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {-1, 1}) {
      const auto other = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(voxel) + sign * stride_[axis]);
      if (inside(other) && open(voxel, axis, sign)) voxels.push_back(other);
    }
  }
  return voxels;
}

void ComplianceDistance::start(const Vector3d& seed_mm, int owner, Workspace& workspace) const {
  const std::size_t home = voxel_at(seed_mm);
  GLISSON_ASSERT(inside(home));
  // A seed that a cut passes close by is seen from its own voxel's centre: that voxel belongs to one side.
  const Vector3d seen_from_mm = center_mm(home);
  for (const std::size_t voxel : around(home)) {
    const float distance = step(seed_mm, seen_from_mm, voxel);
    if (distance < unreached) offer(voxel, distance, owner, workspace);
  }
}

void ComplianceDistance::offer(std::size_t voxel, float distance, int owner, Workspace& workspace) const {
  if (workspace.fixed_[voxel] || !(distance < workspace.distance_[voxel])) return;
  if (workspace.distance_[voxel] == unreached) workspace.touched_.push_back(voxel);
  workspace.distance_[voxel] = distance;
  workspace.owner_[voxel] = owner;
  workspace.front_.emplace_back(distance, voxel);
  std::push_heap(workspace.front_.begin(), workspace.front_.end(), std::greater<>());
}

template <typename Visit>
void ComplianceDistance::march(float limit, Workspace& workspace, const Visit& visit) const {
  while (!workspace.front_.empty()) {
    std::pop_heap(workspace.front_.begin(), workspace.front_.end(), std::greater<>());
    const auto [distance, voxel] = workspace.front_.back();
    workspace.front_.pop_back();
    if (workspace.fixed_[voxel] || distance > workspace.distance_[voxel]) continue;
    if (distance > limit) return;
    workspace.fixed_[voxel] = 1;
    visit(voxel, distance);
    for (int axis = 0; axis < 3; ++axis) {
      for (const int sign : {-1, 1}) {
        const auto next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(voxel) + sign * stride_[axis]);
        if (!inside(next) || workspace.fixed_[next] || !open(voxel, axis, sign)) continue;
        const auto [reached, owner] = upwind(next, workspace);
        offer(next, reached, owner, workspace);
      }
    }
  }
}

bool ComplianceDistance::open(std::size_t from, int axis, int sign) const {
  if (blocked_.empty()) return true;
  const auto lower = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from) + (sign < 0 ? -stride_[axis] : 0));
  return !(blocked_[lower] >> axis & 1U);
}

// The root of sum over axes of (d - d_axis)^2 = (h/E)^2 over the axes from which the front comes, the nearest first.
std::pair<float, int> ComplianceDistance::upwind(std::size_t voxel, const Workspace& workspace) const {
  std::array<double, 3> nearest{unreached, unreached, unreached};
  int owner = -1;
  double smallest = unreached;
  for (int axis = 0; axis < 3; ++axis) {
    double& best = nearest[static_cast<std::size_t>(axis)];
    for (const int sign : {-1, 1}) {
      const auto other = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(voxel) + sign * stride_[axis]);
      if (!workspace.fixed_[other] || !open(voxel, axis, sign)) continue;
      best = std::min(best, double(workspace.distance_[other]));
      if (workspace.distance_[other] < smallest) {
        smallest = workspace.distance_[other];
        owner = workspace.owner_[other];
      }
    }
  }
  if (nearest[1] < nearest[0]) std::swap(nearest[0], nearest[1]);
  if (nearest[2] < nearest[1]) std::swap(nearest[1], nearest[2]);
  if (nearest[1] < nearest[0]) std::swap(nearest[0], nearest[1]);
  const double cost = grid().spacing_mm.x() / body_->youngs_kPa[voxel];
  double distance = nearest[0] + cost;
  double sum = nearest[0], squares = nearest[0] * nearest[0];
  for (int n = 2; n <= 3 && distance > nearest[static_cast<std::size_t>(n - 1)]; ++n) {
    const double added = nearest[static_cast<std::size_t>(n - 1)];
    sum += added;
    squares += added * added;
    const double discriminant = sum * sum - n * (squares - cost * cost);
    if (discriminant < 0) break;
    distance = (sum + std::sqrt(discriminant)) / n;
  }
  return {static_cast<float>(distance), owner};
}

namespace {

std::size_t voxel_of(const imaging::Grid& grid, const Vector3d& place_mm) {
  const Vector3d index = (place_mm - grid.origin_mm).cwiseQuotient(grid.spacing_mm);
  const auto within = [&](int axis) {
    return static_cast<int>(std::clamp(std::round(index[axis]), 1.0, double(grid.size[axis] - 2)));
  };
  return grid.offset(within(0), within(1), within(2));
}

template <typename Visit>
void visit_voxels_in(const geometry::TetMesh& mesh, std::size_t cell, const imaging::Grid& grid, const Visit& visit) {
  const auto& corners = mesh.cells[cell];
  const Vector3d origin_mm = mesh.points_mm[corners[0]];
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = mesh.points_mm[corners[i + 1]] - origin_mm;
  const Eigen::Matrix3d to_barycentric = edges.inverse();
  Eigen::Vector3d lowest = grid.index_of(origin_mm), highest = lowest;
  for (const int corner : corners) {
    const Vector3d index = grid.index_of(mesh.points_mm[corner]);
    lowest = lowest.cwiseMin(index);
    highest = highest.cwiseMax(index);
  }
  const Eigen::Vector3i first = lowest.array().ceil().matrix().cast<int>();
  const Eigen::Vector3i last = highest.array().floor().matrix().cast<int>();
  for (int k = first.z(); k <= last.z(); ++k) {
    for (int j = first.y(); j <= last.y(); ++j) {
      for (int i = first.x(); i <= last.x(); ++i) {
        const Vector3d l = to_barycentric * (grid.position_mm(i, j, k) - origin_mm);
        if (l.minCoeff() >= -1e-9 && l.sum() <= 1.0 + 1e-9) visit(grid.offset(i, j, k));
      }
    }
  }
}

}  // namespace
}  // namespace glisson::mechanics
