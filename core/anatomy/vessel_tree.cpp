#include "anatomy/vessel_tree.h"

#include <algorithm>
#include <cmath>

#include "anatomy/implicit.h"

namespace glisson::anatomy {

using Eigen::Vector3d;

const char* system_name(System system) {
  switch (system) {
    case System::portal_vein: return "portal-vein";
    case System::hepatic_vein: return "hepatic-vein";
    case System::artery: return "artery";
  }
  return "";
}

std::vector<int> VesselTree::children_counts() const {
  std::vector<int> counts(nodes.size(), 0);
  for (const VesselNode& node : nodes) {
    if (node.parent >= 0) ++counts[static_cast<std::size_t>(node.parent)];
  }
  return counts;
}

std::vector<VesselBranch> branches_of(const VesselTree& tree) {
  const std::vector<int> children = tree.children_counts();
  std::vector<VesselBranch> branches;
  std::vector<int> branch_of(tree.nodes.size(), -1);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const VesselNode& node = tree.nodes[i];
    if (node.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(node.parent);
    const bool goes_on = children[parent] == 1 && branch_of[parent] >= 0;
    if (!goes_on) branches.push_back({{}, 0, 0, node.segment, node.generation});
    branch_of[i] = goes_on ? branch_of[parent] : static_cast<int>(branches.size()) - 1;
    VesselBranch& branch = branches[static_cast<std::size_t>(branch_of[i])];
    const double length = (node.position_mm - tree.nodes[parent].position_mm).norm();
    branch.nodes.push_back(static_cast<int>(i));
    branch.length_mm += length;
    branch.radius_mm += length * node.radius_mm;
  }
  for (VesselBranch& branch : branches) {
    if (branch.length_mm > 0) branch.radius_mm /= branch.length_mm;
  }
  return branches;
}

void set_radii(VesselTree& tree, double root_radius_mm) {
  constexpr double goes_on = 0.7;  // of the flow: then it is the same vessel, and the others are its branches
  const std::vector<int> children = tree.children_counts();
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) tree.nodes[i].flow = children[i] == 0 ? 1 : 0;
  double whole = 0;
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const VesselNode& node = tree.nodes[i];
    if (node.parent >= 0) {
      tree.nodes[static_cast<std::size_t>(node.parent)].flow += node.flow;
    } else {
      whole += node.flow;
    }
  }
  for (VesselNode& node : tree.nodes) {
    node.radius_mm = root_radius_mm * std::cbrt(node.flow / whole);
    if (node.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(node.parent);
    const bool same_vessel = children[parent] == 1 || node.flow > goes_on * tree.nodes[parent].flow;
    node.generation = tree.nodes[parent].generation + (same_vessel ? 0 : 1);
  }
}

Field tree_field(const VesselTree& tree, const imaging::Grid& grid, double minimum_radius_mm) {
  const double spacing = grid.spacing_mm.maxCoeff();
  const auto far_mm = static_cast<float>(3 * spacing);
  Field field{grid, std::vector<float>(grid.voxels(), far_mm)};
  for (const VesselNode& node : tree.nodes) {
    if (node.parent < 0 || node.radius_mm < minimum_radius_mm) continue;
    const VesselNode& from = tree.nodes[static_cast<std::size_t>(node.parent)];
    // A child starts at its own width, or where it merely goes on, at its parent's.
    const double start_radius = from.parent >= 0 && from.flow == node.flow ? from.radius_mm : node.radius_mm;
    const double reach = std::max(start_radius, node.radius_mm) + 2 * spacing;
    const Vector3d low = (from.position_mm.cwiseMin(node.position_mm).array() - reach).matrix();
    const Vector3d high = (from.position_mm.cwiseMax(node.position_mm).array() + reach).matrix();
    std::array<int, 3> first{}, last{};
    for (int a = 0; a < 3; ++a) {
      const auto n = static_cast<std::size_t>(a);
      first[n] = std::max(0, static_cast<int>(std::floor((low[a] - grid.origin_mm[a]) / grid.spacing_mm[a])));
      last[n] =
          std::min(grid.size[n] - 1, static_cast<int>(std::ceil((high[a] - grid.origin_mm[a]) / grid.spacing_mm[a])));
    }
    for (int k = first[2]; k <= last[2]; ++k) {
      for (int j = first[1]; j <= last[1]; ++j) {
        for (int i = first[0]; i <= last[0]; ++i) {
          const OnStretch on = on_stretch(from.position_mm, node.position_mm, grid.position_mm(i, j, k));
          const double wall = on.distance_mm - (start_radius + on.along * (node.radius_mm - start_radius));
          float& value = field.at(i, j, k);
          value = std::min(value, static_cast<float>(wall));
        }
      }
    }
  }
  return field;
}

geometry::Surface tree_surface(const VesselTree& tree, double minimum_radius_mm, double spacing_mm) {
  std::vector<Vector3d> points;
  for (const VesselNode& node : tree.nodes) {
    if (node.radius_mm >= minimum_radius_mm) points.push_back(node.position_mm);
  }
  if (points.empty()) return {};
  geometry::Box box = geometry::bounding_box(points);
  double widest = 0;
  for (const VesselNode& node : tree.nodes) widest = std::max(widest, node.radius_mm);
  box.min_mm.array() -= widest + 4 * spacing_mm;
  box.max_mm.array() += widest + 4 * spacing_mm;
  return level_surface(tree_field(tree, grid_over(box, spacing_mm), minimum_radius_mm));
}

}  // namespace glisson::anatomy
