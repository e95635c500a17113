#include "anatomy/internal/artery_trunk.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "anatomy/internal/capsules.h"

namespace glisson::anatomy {

using Eigen::Vector3d;

namespace {

// Every piece cut in shorter ones, so that what runs beside it can turn around it.
VesselTree subdivided(const VesselTree& tree, int pieces) {
  VesselTree fine{tree.system, {}};
  std::vector<int> index(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const VesselNode& node = tree.nodes[i];
    VesselNode step = node;
    if (node.parent >= 0) {
      const Vector3d& from = tree.nodes[static_cast<std::size_t>(node.parent)].position_mm;
      step.parent = index[static_cast<std::size_t>(node.parent)];
      for (int n = 1; n < pieces; ++n) {
        step.position_mm = from + static_cast<double>(n) / pieces * (node.position_mm - from);
        fine.nodes.push_back(step);
        step.parent = static_cast<int>(fine.nodes.size()) - 1;
      }
      step.position_mm = node.position_mm;
    }
    index[i] = static_cast<int>(fine.nodes.size());
    fine.nodes.push_back(step);
  }
  return fine;
}

// Unit directions from each node in which the artery lies: across the plane of a division, on the side that it comes
// along, and turning gradually between two divisions.
std::vector<Vector3d> free_sides(const VesselTree& portal) {
  std::vector<std::vector<std::size_t>> children(portal.nodes.size());
  for (std::size_t i = 0; i < portal.nodes.size(); ++i) {
    if (portal.nodes[i].parent >= 0) children[static_cast<std::size_t>(portal.nodes[i].parent)].push_back(i);
  }
  const auto way = [&](std::size_t n) {
    return (portal.nodes[n].position_mm - portal.nodes[static_cast<std::size_t>(portal.nodes[n].parent)].position_mm)
        .normalized();
  };
  const Vector3d left_and_in_front = Vector3d(0.5, -0.8, 0.2).normalized();
  std::vector<Vector3d> sides(portal.nodes.size(), left_and_in_front);
  for (std::size_t i = 0; i < portal.nodes.size(); ++i) {
    const VesselNode& node = portal.nodes[i];
    if (node.parent < 0) continue;
    // How many steps until the next division, and which side is free there.
    std::size_t ahead = i, steps = 1;
    while (children[ahead].size() == 1) ahead = children[ahead][0], ++steps;
    const Vector3d before = sides[static_cast<std::size_t>(node.parent)];
    Vector3d wanted = before;
    if (children[ahead].size() >= 2) {
      const Vector3d across = way(children[ahead][0]).cross(way(children[ahead][1]));
      if (across.norm() > 0.05) wanted = across.normalized() * (across.dot(before) < 0 ? -1 : 1);
    }
    Vector3d side = before + (wanted - before) / static_cast<double>(steps);
    if (ahead != i) side -= side.dot(way(i)) * way(i);
    sides[i] = side.norm() > 1e-3 ? side.normalized() : before;
  }
  return sides;
}

}  // namespace

VesselTree artery_trunk(const VesselTree& portal, const VesselTree& hepatic, double artery_radius_mm) {
  const VesselTree followed = subdivided(portal, 2);
  const std::vector<Vector3d> sides = free_sides(followed);
  VesselTree artery = followed;
  artery.system = System::artery;
  set_radii(artery, artery_radius_mm);
  // From the wide vein's wall to the branch's own, no faster than the branch comes out of the wide one. Trunks grow
  // wider when they get branches: hence the share of their radius.
  constexpr double approach = 0.4, wider = 1.4;
  std::vector<double> beside_mm(artery.nodes.size());
  for (std::size_t i = 0; i < artery.nodes.size(); ++i) {
    VesselNode& node = artery.nodes[i];
    beside_mm[i] = wider * (followed.nodes[i].radius_mm + node.radius_mm) + 0.9;
    if (node.parent >= 0) {
      const auto parent = static_cast<std::size_t>(node.parent);
      const double step = (followed.nodes[i].position_mm - followed.nodes[parent].position_mm).norm();
      beside_mm[i] = std::max(beside_mm[i], beside_mm[parent] - approach * step);
    }
    node.position_mm += beside_mm[i] * sides[i];
  }
  std::vector<bool> cut(artery.nodes.size(), false);
  for (const VesselTree* vein : {&portal, &hepatic}) {
    for (const Meeting& meeting : meetings(artery, *vein, 1)) cut[meeting.first] = true;
  }
  return pruned(artery, std::move(cut));
}

}  // namespace glisson::anatomy
