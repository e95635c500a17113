#pragma once
// What a planner knows of a ball of tissue: vessel trees, octants as segments, one tumour, stiffness.

#include <gtest/gtest.h>

#include "planning/planner.h"
#include "vasculature/territories.h"
#include "vasculature/vessels_in_a_ball.h"

namespace glisson::planning {

inline vasculature::VesselTrees some_trees() {
  vasculature::VesselTrees trees;
  const auto add = [&](vasculature::System system, int parent, Eigen::Vector3d from, Eigen::Vector3d to,
                       double radius_mm, const char* name) {
    trees.branches.push_back(vasculature::straight(system, parent, from, to, radius_mm));
    trees.branches.back().name = name;
  };
  add(vasculature::System::portal_vein, -1, {0, 0, -30}, {0, 0, 0}, 3, "portal");
  add(vasculature::System::portal_vein, 0, {0, 0, 0}, {25, 5, 15}, 3, "portal/left");
  add(vasculature::System::portal_vein, 0, {0, 0, 0}, {-25, -5, 10}, 2, "portal/right");
  add(vasculature::System::portal_vein, 1, {15, 3, 9}, {0, 25, 20}, 2, "portal/left/II");  // back across x = 10
  add(vasculature::System::hepatic_vein, -1, {0, 30, 20}, {0, 0, 10}, 3, "hepatic");
  add(vasculature::System::hepatic_vein, 4, {0, 0, 10}, {20, -20, 0}, 2, "hepatic/left");
  add(vasculature::System::hepatic_vein, 4, {0, 0, 10}, {-20, -20, 0}, 2, "hepatic/right");
  return trees;
}

// Calls visit(i, j, k, position) for the voxels of the mask.
template <typename Visit>
void for_each_voxel(const imaging::Mask& liver, const Visit& visit) {
  const auto& size = liver.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (liver.at(i, j, k) != 0) visit(i, j, k, liver.grid.position_mm(i, j, k));
      }
    }
  }
}

inline int octant(const Eigen::Vector3d& at) {
  return 1 + (at.x() > 0 ? 1 : 0) + (at.y() > 0 ? 2 : 0) + (at.z() > 0 ? 4 : 0);
}
inline double stiffness_at(const Eigen::Vector3d& at) {
  return at.y() < -20 ? -1 : 6 + 0.1 * at.x();
}  // not trusted in front

inline imaging::LabelMap territory(const vasculature::VesselTrees& trees, vasculature::System system,
                                   const imaging::Mask& liver) {
  const auto found = vasculature::territories_of(trees, system, liver);
  EXPECT_TRUE(found);
  imaging::LabelMap map{liver.grid, {}};
  for (const std::int32_t branch : found->branch) map.values.push_back(static_cast<std::uint16_t>(branch + 1));
  return map;
}

inline imaging::Mask ball_at(const imaging::Mask& liver, const Eigen::Vector3d& center, double radius_mm) {
  imaging::Mask mask{liver.grid, std::vector<std::uint8_t>(liver.values.size(), 0)};
  for_each_voxel(liver, [&](int i, int j, int k, const Eigen::Vector3d& at) {
    mask.at(i, j, k) = (at - center).norm() < radius_mm ? 1 : 0;
  });
  return mask;
}

inline const Eigen::Vector3d tumour_mm(-12, 4, -3);
inline constexpr double tumour_radius_mm = 7;

inline LiverParts parts_of_ball() {
  LiverParts parts;
  parts.liver = vasculature::ball();
  parts.trees = some_trees();
  parts.portal = territory(parts.trees, vasculature::System::portal_vein, parts.liver);
  parts.hepatic = territory(parts.trees, vasculature::System::hepatic_vein, parts.liver);
  parts.tumours.push_back({"tumour-1", ball_at(parts.liver, tumour_mm, tumour_radius_mm)});
  parts.segments = imaging::LabelMap{parts.liver.grid, std::vector<std::uint16_t>(parts.liver.values.size(), 0)};
  for_each_voxel(parts.liver, [&](int i, int j, int k, const Eigen::Vector3d& at) {
    parts.segments->at(i, j, k) = static_cast<std::uint16_t>(octant(at));
  });
  // A coarse map of its own.
  imaging::Volume map;
  map.grid.size = {30, 30, 30};
  map.grid.spacing_mm = {3, 3, 3};
  map.grid.origin_mm = {-43.5, -43.5, -43.5};
  for (int k = 0; k < 30; ++k) {
    for (int j = 0; j < 30; ++j) {
      for (int i = 0; i < 30; ++i) {
        map.values.push_back(static_cast<float>(stiffness_at(map.grid.position_mm(i, j, k))));
      }
    }
  }
  parts.youngs_kPa = std::move(map);
  return parts;
}

}  // namespace glisson::planning
