#include "vasculature/remnant.h"

#include <algorithm>
#include <limits>

#include "vasculature/internal/nearest_voxel.h"

namespace glisson::vasculature {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

// From which of its points on each branch is cut off, and by which branch's cut.
struct CutOff {
  std::vector<std::size_t> from, cause;
  std::vector<CutBranch> cut;
};

CutOff cut_off(const VesselTrees& trees, const Mask& removed);
std::size_t nearest_point(const TreeBranch& branch, const Vector3d& position_mm);

// Whether the tissue of a voxel hangs on something that is cut: by which branch, or nowhere.
std::size_t cause_at(const VesselTrees& trees, const CutOff& off, const Territories& territories, std::size_t voxel,
                     const Vector3d& position_mm) {
  const std::int32_t owner = territories.branch[voxel];
  if (owner < 0) return nowhere;
  const auto branch = static_cast<std::size_t>(owner);
  if (off.from[branch] == nowhere) return nowhere;
  const bool is_beyond =
      off.from[branch] == 0 || nearest_point(trees.branches[branch], position_mm) >= off.from[branch];
  return is_beyond ? off.cause[branch] : nowhere;
}

}  // namespace

Result<Remnant> remnant_of(const VesselTrees& trees, const Territories& portal, const Territories& hepatic,
                           const Mask& removed) {
  if (!imaging::same_grid(portal.grid, removed.grid) || !imaging::same_grid(hepatic.grid, removed.grid)) {
    return failure("remnant-grids", GLISSON_TEXT("What is removed and the territories lie on different grids."));
  }
  CutOff off = cut_off(trees, removed);
  std::vector<double> affected(trees.branches.size(), 0);
  Remnant remnant;
  const double voxel_ml = removed.grid.voxel_volume_mm3() / 1000;
  const auto& size = removed.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const std::size_t voxel = removed.grid.offset(i, j, k);
        const bool is_liver = portal.branch[voxel] >= 0 || hepatic.branch[voxel] >= 0;
        if (!is_liver) continue;
        if (removed.values[voxel] != 0) {
          remnant.removed_ml += voxel_ml;
          continue;
        }
        const Vector3d at = removed.grid.position_mm(i, j, k);
        const std::size_t starved = cause_at(trees, off, portal, voxel, at);
        const std::size_t held_up = cause_at(trees, off, hepatic, voxel, at);
        remnant.remnant_ml += voxel_ml;
        (starved == nowhere ? remnant.perfused_ml : remnant.ischaemic_ml) += voxel_ml;
        (held_up == nowhere ? remnant.drained_ml : remnant.congested_ml) += voxel_ml;
        if (starved == nowhere && held_up == nowhere) remnant.living_ml += voxel_ml;
        for (const std::size_t cause : {starved, held_up}) {
          if (cause != nowhere) affected[cause] += voxel_ml;
        }
      }
    }
  }
  remnant.cut = std::move(off.cut);
  for (CutBranch& cut : remnant.cut) cut.affected_ml = affected[cut.branch];
  std::stable_sort(remnant.cut.begin(), remnant.cut.end(),
                   [](const CutBranch& a, const CutBranch& b) { return a.affected_ml > b.affected_ml; });
  return remnant;
}

namespace {

bool is_removed(const Mask& removed, const Vector3d& position_mm) {
  const auto voxel = nearest_voxel(removed.grid, position_mm);
  return voxel && removed.values[*voxel] != 0;
}

// Parents stand before their branches.
CutOff cut_off(const VesselTrees& trees, const Mask& removed) {
  CutOff off{std::vector(trees.branches.size(), nowhere), std::vector(trees.branches.size(), nowhere), {}};
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    const TreeBranch& branch = trees.branches[b];
    if (branch.points.empty()) continue;
    if (branch.parent >= 0) {
      const auto parent = static_cast<std::size_t>(branch.parent);
      const std::size_t joint = nearest_point(trees.branches[parent], branch.points.front().position_mm);
      if (joint >= off.from[parent]) {
        off.from[b] = 0;
        off.cause[b] = off.cause[parent];
        continue;
      }
    }
    const auto first = std::find_if(branch.points.begin(), branch.points.end(),
                                    [&](const CenterPoint& point) { return is_removed(removed, point.position_mm); });
    if (first == branch.points.end()) continue;
    off.from[b] = static_cast<std::size_t>(first - branch.points.begin());
    off.cause[b] = b;
    off.cut.push_back({b, first->position_mm, first->radius_mm, 0});
  }
  return off;
}

std::size_t nearest_point(const TreeBranch& branch, const Vector3d& position_mm) {
  const auto nearest =
      std::min_element(branch.points.begin(), branch.points.end(), [&](const CenterPoint& a, const CenterPoint& b) {
        return (a.position_mm - position_mm).squaredNorm() < (b.position_mm - position_mm).squaredNorm();
      });
  return static_cast<std::size_t>(nearest - branch.points.begin());
}

}  // namespace
}  // namespace glisson::vasculature
