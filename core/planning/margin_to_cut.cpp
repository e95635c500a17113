#include "planning/internal/margin_to_cut.h"

#include <algorithm>

namespace glisson::planning {
namespace {

// Where each voxel of the organ stands, by its number.
Eigen::Vector3d position_mm(const Organ& organ, std::uint32_t voxel);

}  // namespace

MarginAnswer margin_to_cut(std::size_t number, const Removal& removal, const Organ& organ,
                           const std::vector<TumourSurroundings>& tumours) {
  const TumourSurroundings& tumour = tumours[number];
  const auto removed = static_cast<std::size_t>(std::count_if(
      tumour.voxels.begin(), tumour.voxels.end(), [&](std::uint32_t v) { return removal.removed[v] != 0; }));
  MarginAnswer margin{tumour.name, removed == 0 ? Side::left : Side::removed, 0, false};
  if (removed != 0 && removed != tumour.voxels.size()) {
    margin.side = Side::cut_through;
    return margin;
  }
  // A voxel on the other side of the cut lies some way beyond it: by its height over a surface, else by half a voxel.
  const bool goes = margin.side == Side::removed;
  const double half_mm = 0.5 * organ.voxel_mm(), deepest_mm = organ.grid.spacing_mm.norm();
  const auto beyond_cut_mm = [&](const TumourSurroundings::Near& near) {
    double beyond_mm = goes ? deepest_mm : 0;
    for (const PreparedCut& cut : removal.cuts) {
      double here_mm = goes ? half_mm : 0;
      if (cut.surface) {
        here_mm = (goes ? -cut.sign : cut.sign) * cut.surface->height_mm(position_mm(organ, near.voxel));
      } else if (cut.ablation) {
        here_mm = (goes ? 1 : -1) * outside_mm(*cut.ablation, position_mm(organ, near.voxel));
      } else if (cut.tumour == number && goes) {
        here_mm = static_cast<double>(near.distance_mm) - cut.margin_mm;
      } else if (!goes) {
        here_mm = half_mm;
      }
      beyond_mm = goes ? std::min(beyond_mm, here_mm) : std::max(beyond_mm, here_mm);
    }
    return std::clamp(beyond_mm, 0.0, deepest_mm);
  };
  margin.margin_mm = largest_margin_mm;
  margin.is_at_least = true;
  for (const auto& near : tumour.around) {
    const auto distance_mm = static_cast<double>(near.distance_mm);
    if (!margin.is_at_least && distance_mm > margin.margin_mm + deepest_mm + 0.05) break;
    if ((removal.removed[near.voxel] != 0) == goes) continue;
    const double to_cut_mm = std::max(0.0, distance_mm - beyond_cut_mm(near));
    if (!margin.is_at_least && to_cut_mm >= margin.margin_mm) continue;
    margin.margin_mm = to_cut_mm;
    margin.is_at_least = false;
  }
  return margin;
}

namespace {

Eigen::Vector3d position_mm(const Organ& organ, std::uint32_t voxel) {
  const auto after = std::upper_bound(organ.runs.begin(), organ.runs.end(), static_cast<std::size_t>(voxel),
                                      [](std::size_t number, const Run& run) { return number < run.first; });
  const Run& run = *std::prev(after);
  return organ.grid.position_mm(run.i + static_cast<int>(voxel - run.first), run.j, run.k);
}

}  // namespace
}  // namespace glisson::planning
