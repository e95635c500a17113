#include "anatomy/landmarks.h"

#include <algorithm>

namespace glisson::anatomy {
namespace {

using Children = std::vector<std::vector<int>>;

const VesselNode& node_of(const VesselTree& tree, int node) { return tree.nodes[static_cast<std::size_t>(node)]; }

Children children_of(const VesselTree& tree) {
  Children children(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].parent >= 0) {
      children[static_cast<std::size_t>(tree.nodes[i].parent)].push_back(static_cast<int>(i));
    }
  }
  return children;
}

// The last node of the trunk beyond which the branches of these segments part; -1 where one of them has none.
int parting_of(const VesselTree& tree, std::initializer_list<int> segments) {
  unsigned wanted = 0;
  for (const int segment : segments) wanted |= 1U << segment;
  std::vector<unsigned> serves(tree.nodes.size(), 0);
  int parting = -1;
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {  // children stand after their parents
    const VesselNode& node = tree.nodes[i];
    if (!node.trunk) continue;
    if (node.segment > 0) serves[i] |= 1U << node.segment;
    if (node.parent >= 0) serves[static_cast<std::size_t>(node.parent)] |= serves[i];
    if (parting < 0 && (serves[i] & wanted) == wanted) parting = static_cast<int>(i);
  }
  return parting;
}

// From a node on, the trunk's nodes; at a division the one that carries more.
std::vector<int> trunk_from(const VesselTree& tree, const Children& children, int node) {
  std::vector<int> chain;
  while (node >= 0) {
    chain.push_back(node);
    int next = -1;
    for (const int child : children[static_cast<std::size_t>(node)]) {
      if (!node_of(tree, child).trunk) continue;
      if (next < 0 || node_of(tree, child).flow > node_of(tree, next).flow) next = child;
    }
    node = next;
  }
  return chain;
}

// Where the largest tributary joins the chain, lower than `below_mm`; -1 if none does.
int largest_joint(const VesselTree& tree, const Children& children, const std::vector<int>& chain, double below_mm) {
  int joint = -1;
  double largest = 0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    if (node_of(tree, chain[i]).position_mm.z() > below_mm) continue;
    for (const int child : children[static_cast<std::size_t>(chain[i])]) {
      if (child == chain[i + 1] || node_of(tree, child).flow <= largest) continue;
      largest = node_of(tree, child).flow;
      joint = chain[i];
    }
  }
  return joint;
}

struct HepaticVein {
  std::string name;
  std::vector<int> chain;
};

// The one that divides on the trunk is the common one of middle and left; of the others the one not of segment I is the
// right. Fills `confluence` with where the first two part.
std::vector<HepaticVein> hepatic_veins(const VesselTree& tree, const Children& children, int& confluence) {
  std::vector<HepaticVein> veins;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].parent >= 0 || !tree.nodes[i].trunk || tree.nodes[i].segment != 0) continue;
    std::vector<int> chain = trunk_from(tree, children, static_cast<int>(i));
    std::vector<HepaticVein> both;
    for (const int node : chain) {
      for (const int child : children[static_cast<std::size_t>(node)]) {
        if (!both.empty() || !node_of(tree, child).trunk || std::find(chain.begin(), chain.end(), child) != chain.end())
          continue;
        confluence = node;
        both = {{"middle", {std::find(chain.begin(), chain.end(), node) + 1, chain.end()}},
                {"left", trunk_from(tree, children, child)}};
      }
    }
    if (both.empty()) {
      veins.push_back({"right", std::move(chain)});
      continue;
    }
    const auto end_x = [&](const HepaticVein& vein) { return node_of(tree, vein.chain.back()).position_mm.x(); };
    if (end_x(both[0]) > end_x(both[1])) std::swap(both[0].chain, both[1].chain);
    for (HepaticVein& vein : both) veins.push_back(std::move(vein));
  }
  return veins;
}

}  // namespace

std::vector<Landmark> landmarks_of(const Patient& patient) {
  constexpr double minimum_depth_mm = 3, lower_mm = 15;
  std::vector<Landmark> landmarks;
  const auto add = [&](const VesselTree& tree, const std::string& id, int node) {
    if (node < 0 || patient.liver->depth_mm(node_of(tree, node).position_mm) < minimum_depth_mm) return;
    landmarks.push_back({id, system_name(tree.system), placed(patient, node_of(tree, node).position_mm)});
  };

  const VesselTree& portal = patient.portal_vein;
  add(portal, "portal-bifurcation", parting_of(portal, {2, 3, 4, 5, 6, 7, 8}));
  add(portal, "portal-right-division", parting_of(portal, {5, 6, 7, 8}));
  add(portal, "portal-right-anterior-division", parting_of(portal, {5, 8}));
  add(portal, "portal-right-posterior-division", parting_of(portal, {6, 7}));
  add(portal, "portal-left-division", parting_of(portal, {2, 3, 4}));
  add(portal, "portal-umbilical-division", parting_of(portal, {3, 4}));

  const Children portal_children = children_of(portal);
  for (int segment = 1; segment <= 8; ++segment) {
    const auto first = std::find_if(portal.nodes.begin(), portal.nodes.end(),
                                    [&](const VesselNode& node) { return node.trunk && node.segment == segment; });
    if (first == portal.nodes.end()) continue;
    const std::vector<int> pedicle =
        trunk_from(portal, portal_children, static_cast<int>(first - portal.nodes.begin()));
    add(portal, "portal-segment-" + std::to_string(segment) + "-division",
        largest_joint(portal, portal_children, pedicle, 1e9));
  }

  const VesselTree& hepatic = patient.hepatic_vein;
  const Children children = children_of(hepatic);
  int confluence = -1;
  const std::vector<HepaticVein> veins = hepatic_veins(hepatic, children, confluence);
  add(hepatic, "hepatic-confluence", confluence);
  for (const HepaticVein& vein : veins) {
    const int joint = largest_joint(hepatic, children, vein.chain, 1e9);
    add(hepatic, "hepatic-" + vein.name + "-division", joint);
    if (vein.name == "left" || joint < 0) continue;
    const double below_mm = node_of(hepatic, joint).position_mm.z() - lower_mm;
    add(hepatic, "hepatic-" + vein.name + "-inferior-division", largest_joint(hepatic, children, vein.chain, below_mm));
  }
  return landmarks;
}

}  // namespace glisson::anatomy
