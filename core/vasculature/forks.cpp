#include "vasculature/forks.h"

namespace glisson::vasculature {

std::vector<Fork> forks_of(const VesselTrees& trees, double minimum_calibre_mm) {
  std::vector<int> leaving(trees.branches.size(), 0);
  for (const TreeBranch& branch : trees.branches) {
    if (branch.parent >= 0 && branch.joint == Joint::vessel) ++leaving[static_cast<std::size_t>(branch.parent)];
  }
  std::vector<Fork> forks;
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    const TreeBranch& branch = trees.branches[b];
    if (leaving[b] < 2 || branch.joint != Joint::vessel || 2 * branch.radius_mm < minimum_calibre_mm) continue;
    forks.push_back({branch.points.back().position_mm, branch.system, 2 * branch.radius_mm, leaving[b]});
  }
  return forks;
}

}  // namespace glisson::vasculature
