#include "casefile/structure_landmarks.h"

#include <fmt/format.h>
#include <algorithm>

#include "geometry/spread_points.h"

namespace glisson::casefile {
namespace {

using segmentation::Structure;

std::vector<Eigen::Vector3d> spread_points(const imaging::Mask& mask, const imaging::Mask* inside, int count);

}  // namespace

std::vector<mechanics::Landmark> landmarks_of(const std::vector<Structure>& structures, int points_per_vessel) {
  const imaging::Mask* liver = nullptr;
  for (const Structure& structure : structures) {
    if (structure.name == "liver") liver = &structure.mask;
  }
  std::vector<mechanics::Landmark> landmarks;
  for (const Structure& structure : structures) {
    if (segmentation::known_structure(structure.name).place != segmentation::Place::inside) continue;
    const imaging::Mask* inside = liver && imaging::same_grid(liver->grid, structure.mask.grid) ? liver : nullptr;
    if (is_vessel(structure.name)) {
      int number = 0;
      for (const Eigen::Vector3d& point : spread_points(structure.mask, inside, points_per_vessel)) {
        landmarks.push_back({fmt::format("{}-{}", structure.name, ++number), point});
      }
      continue;
    }
    const auto found = segmentation::pieces(structure.mask);
    if (found.empty()) continue;
    landmarks.push_back({structure.name, found.front().centroid_mm});
  }
  return landmarks;
}

bool is_vessel(const std::string& name) {
  return name.find("vein") != std::string::npos || name.find("arter") != std::string::npos;
}

namespace {

// Points of a mask, spread by always taking the one farthest from those taken; the first is the farthest from the
// centroid. Every voxel is looked at once for each point taken.
std::vector<Eigen::Vector3d> spread_points(const imaging::Mask& mask, const imaging::Mask* inside, int count) {
  std::vector<Eigen::Vector3d> voxels;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        if (!mask.at(i, j, k) || (inside && !inside->at(i, j, k))) continue;
        voxels.push_back(mask.grid.position_mm(i, j, k));
        centroid += voxels.back();
      }
    }
  }
  if (voxels.empty()) return {};
  centroid /= static_cast<double>(voxels.size());

  const auto farthest_from_centroid =
      std::max_element(voxels.begin(), voxels.end(), [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return (a - centroid).squaredNorm() < (b - centroid).squaredNorm();
      });
  std::vector<Eigen::Vector3d> taken;
  for (const std::size_t v :
       geometry::spread_points(voxels, static_cast<std::size_t>(std::max(count, 1)),
                               static_cast<std::size_t>(farthest_from_centroid - voxels.begin()))) {
    taken.push_back(voxels[v]);
  }
  return taken;
}

}  // namespace
}  // namespace glisson::casefile
