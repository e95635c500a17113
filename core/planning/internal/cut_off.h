#pragma once
// Points of vessel trees by number, and which of them hang on a branch that is cut.

#include <cstdint>
#include <functional>
#include <vector>

#include "imaging/image.h"
#include "planning/internal/organ.h"
#include "vasculature/systems.h"

namespace glisson::planning {

struct TreePoints {
  std::vector<std::size_t> first;   // of each branch the number of its first point; then how many there are
  std::vector<std::int32_t> voxel;  // of the organ at each point; -1 where it lies outside
  std::vector<std::size_t> joint;   // of each branch: which point of its parent it grows from
  std::vector<double> radius_mm;    // of the vessel at each point
  [[nodiscard]] std::size_t count() const { return voxel.size(); }
};

// A point in a hollow of the organ (vessels left out of the outline) takes the nearest voxel beside it: it has tissue
// within 15 mm along at least five of the six ways of the axes. Of an artery or a bile duct two do, as at the hilum,
// where they divide. What runs outside of the organ has no voxel.
[[nodiscard]] TreePoints points_of(const vasculature::VesselTrees& trees, const Organ& organ,
                                   const std::vector<std::int32_t>& numbers);

// For each voxel of the organ in a territory (branch + 1) the number of the nearest point of that branch; elsewhere
// points.count().
[[nodiscard]] std::vector<std::uint32_t> nearest_points(const vasculature::VesselTrees& trees, const TreePoints& points,
                                                        const Organ& organ, const imaging::LabelMap& territory);

struct CutOff {
  std::vector<std::int32_t> cause;  // of each point the place in `cut` it hangs on, or -1; one more, for "no point"
  struct Place {
    std::size_t branch, point;  // of the branch
  };
  std::vector<Place> cut;
};
// What hangs on a point and on all beyond it.
[[nodiscard]] std::vector<std::size_t> sum_beyond(const vasculature::VesselTrees& trees, const TreePoints& points,
                                                  const std::vector<std::size_t>& at_points);

// A branch is cut at its first point, counted from the stem, for which is_cut(number of the point).
[[nodiscard]] CutOff cut_off(const vasculature::VesselTrees& trees, const TreePoints& points,
                             const std::function<bool(std::size_t)>& is_cut);

}  // namespace glisson::planning
