#include "mechanics/meshfree/compliance_distance.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "base/parallel.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

constexpr float buckets_across = 8;  // of the stiffest voxel

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

void Front::start(float width) {
  for (; bucket_ < buckets_.size(); ++bucket_) buckets_[bucket_].clear();
  beyond_.clear();
  width_ = width;
  first_ = 0;
  bucket_ = 0;
}

void Front::put(float distance, std::size_t voxel) {
  const float place = (distance - first_) / width_;
  if (!(place < static_cast<float>(maximum_buckets))) {
    beyond_.push_back({distance, static_cast<std::uint32_t>(voxel)});
    return;
  }
  const std::size_t bucket = std::max(bucket_, static_cast<std::size_t>(std::max(place, 0.0F)));
  if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
  buckets_[bucket].push_back({distance, static_cast<std::uint32_t>(voxel)});
}

bool Front::take(Waiting& next) {
  for (;;) {
    while (bucket_ < buckets_.size() && buckets_[bucket_].empty()) ++bucket_;
    if (bucket_ < buckets_.size()) {
      next = buckets_[bucket_].back();
      buckets_[bucket_].pop_back();
      return true;
    }
    if (beyond_.empty()) return false;
    // Begin anew at the nearest of those beyond.
    first_ = std::min_element(beyond_.begin(), beyond_.end(), [](const Waiting& a, const Waiting& b) {
               return a.distance < b.distance;
             })->distance;
    bucket_ = 0;
    std::vector<Waiting> waiting;
    waiting.swap(beyond_);
    for (const Waiting& one : waiting) put(one.distance, one.voxel);
  }
}

ComplianceDistance::ComplianceDistance(const VoxelBody& body, const std::vector<Cut>& cuts)
    : body_(&body), stride_{1, grid().size[0], std::ptrdiff_t{grid().size[0]} * grid().size[1]} {
  across_.assign(grid().voxels(), unreached);
  for (std::size_t voxel = 0; voxel < across_.size(); ++voxel) {
    if (inside(voxel)) across_[voxel] = static_cast<float>(grid().spacing_mm.x() / body.youngs_kPa[voxel]);
    minimum_across_ = std::min(minimum_across_, across_[voxel]);
  }
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
  workspace.front_.start(minimum_across_ / buckets_across);
  for (std::size_t s = 0; s < seeds_mm.size(); ++s) offer_around(seeds_mm[s], static_cast<int>(s), workspace);
  march(unreached, workspace, [](std::size_t, float) {});
  return {std::move(workspace.owner_), std::move(workspace.fixed_)};
}

std::vector<ComplianceDistance::Reached> ComplianceDistance::within(const Vector3d& seed_mm, float limit,
                                                                    Workspace& workspace) const {
  std::vector<Reached> reached;
  workspace.front_.start(minimum_across_ / buckets_across);
  offer_around(seed_mm, 0, workspace);
  march(limit, workspace, [&](std::size_t voxel, float distance) { reached.push_back({voxel, distance}); });
  for (const std::size_t voxel : workspace.touched_) {
    workspace.offered_[voxel] = unreached;
    workspace.fixed_[voxel] = unreached;
    workspace.owner_[voxel] = -1;
  }
  workspace.touched_.clear();
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

void ComplianceDistance::offer_around(const Vector3d& seed_mm, int owner, Workspace& workspace) const {
  const std::size_t home = voxel_at(seed_mm);
  GLISSON_ASSERT(inside(home));
  // A seed that a cut passes close by is seen from its own voxel's centre: that voxel belongs to one side.
  const Vector3d seen_from_mm = center_mm(home);
  for (const std::size_t voxel : around(home)) {
    const float distance = step(seed_mm, seen_from_mm, voxel);
    if (distance < unreached) offer(voxel, distance, owner, workspace);
  }
}

// The root of sum over axes of (d - d_axis)^2 = (h/E)^2 over the axes from which the front comes, the nearest first.
template <bool has_cuts>
float ComplianceDistance::upwind(std::size_t voxel, int& owner, const Workspace& workspace) const {
  std::array<float, 3> nearest;
  float smallest = unreached;
  std::size_t from = voxel;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto stride = static_cast<std::size_t>(stride_[axis]);
    float before = workspace.fixed_[voxel - stride], after = workspace.fixed_[voxel + stride];
    if (has_cuts && !open(voxel, static_cast<int>(axis), -1)) before = unreached;
    if (has_cuts && !open(voxel, static_cast<int>(axis), 1)) after = unreached;
    nearest[axis] = std::min(before, after);
    if (nearest[axis] < smallest) {
      smallest = nearest[axis];
      from = before < after ? voxel - stride : voxel + stride;
    }
  }
  owner = workspace.owner_[from];
  if (nearest[1] < nearest[0]) std::swap(nearest[0], nearest[1]);
  if (nearest[2] < nearest[1]) std::swap(nearest[1], nearest[2]);
  if (nearest[1] < nearest[0]) std::swap(nearest[0], nearest[1]);
  // Beyond the nearest, so that little is lost where all are far.
  const float cost = across_[voxel], second = nearest[1] - nearest[0], third = nearest[2] - nearest[0];
  float beyond = cost;
  if (beyond > second) {
    beyond = 0.5F * (second + std::sqrt(2 * cost * cost - second * second));
    if (beyond > third) {
      const float sum = second + third;
      const float discriminant = sum * sum - 3 * (second * second + third * third - cost * cost);
      if (discriminant >= 0) beyond = (sum + std::sqrt(discriminant)) / 3;
    }
  }
  return nearest[0] + beyond;
}

void ComplianceDistance::offer(std::size_t voxel, float distance, int owner, Workspace& workspace) {
  if (!(distance < workspace.offered_[voxel]) || workspace.fixed_[voxel] < unreached) return;
  if (workspace.offered_[voxel] == unreached) workspace.touched_.push_back(voxel);
  workspace.offered_[voxel] = distance;
  workspace.owner_[voxel] = owner;
  workspace.front_.put(distance, voxel);
}

template <typename Visit>
void ComplianceDistance::march(float limit, Workspace& workspace, const Visit& visit) const {
  if (blocked_.empty()) {
    march_past<false>(limit, workspace, visit);
  } else {
    march_past<true>(limit, workspace, visit);
  }
}

template <bool has_cuts, typename Visit>
void ComplianceDistance::march_past(float limit, Workspace& workspace, const Visit& visit) const {
  Front::Waiting next_one{};
  while (workspace.front_.take(next_one)) {
    const auto [distance, voxel] = next_one;
    if (workspace.fixed_[voxel] < unreached || distance > workspace.offered_[voxel] || distance > limit) continue;
    workspace.fixed_[voxel] = distance;
    visit(voxel, distance);
    for (int axis = 0; axis < 3; ++axis) {
      for (const int sign : {-1, 1}) {
        const auto next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(voxel) + sign * stride_[axis]);
        if (across_[next] == unreached || workspace.fixed_[next] < unreached) continue;
        if (has_cuts && !open(voxel, axis, sign)) continue;
        int owner = -1;
        const float reached = upwind<has_cuts>(next, owner, workspace);
        if (reached <= limit) offer(next, reached, owner, workspace);
      }
    }
  }
}

bool ComplianceDistance::open(std::size_t from, int axis, int sign) const {
  if (blocked_.empty()) return true;
  const auto lower = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from) + (sign < 0 ? -stride_[axis] : 0));
  return !(blocked_[lower] >> axis & 1U);
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
