// Stable names of branches, by the segments that each and what grows from it run through.

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <numeric>

#include "vasculature/couinaud.h"
#include "vasculature/internal/nearest_line.h"
#include "vasculature/internal/nearest_voxel.h"

namespace glisson::vasculature {

using imaging::Grid;

namespace {

using InSegments = std::array<double, 9>;  // of a branch with what grows from it: millimetres in each

// Outside of the liver's outline, as at its hilum, an artery or a duct counts as the portal branch beside it.
std::vector<InSegments> where_they_run(const VesselTrees& trees, const CouinaudSegments& segments) {
  constexpr double beside_mm = 10;  // from its wall
  const Grid& grid = segments.segment.grid;
  std::vector<InSegments> in(trees.branches.size());
  const auto portal_branch = [&](std::size_t b) {
    return trees.branches[b].system == System::portal_vein ? &trees.branches[b].points : nullptr;
  };
  const auto add_beside = [&](const Eigen::Vector3d& place_mm, InSegments& sum) {
    const auto nearest = nearest_line(trees.branches.size(), place_mm, portal_branch);
    if (nearest.number < 0 || nearest.from_wall_mm > beside_mm) return;
    const InSegments& portal = in[static_cast<std::size_t>(nearest.number)];
    const double all = std::accumulate(portal.begin() + 1, portal.end(), 0.0);
    for (std::size_t s = 1; s <= 8 && all > 0; ++s) sum[s] += portal[s] / all;
  };
  for (const bool veins : {true, false}) {
    for (std::size_t b = trees.branches.size(); b-- > 0;) {
      const TreeBranch& branch = trees.branches[b];
      if (is_vein(branch.system) != veins) continue;
      for (const CenterPoint& point : branch.points) {
        const auto voxel = nearest_voxel(grid, point.position_mm);
        const std::size_t segment = voxel ? segments.segment.values[*voxel] : 0U;
        if (segment != 0 || veins) ++in[b][segment];
        if (segment == 0 && !veins) add_beside(point.position_mm, in[b]);
      }
      if (branch.parent < 0) continue;
      for (std::size_t s = 0; s <= 8; ++s) in[static_cast<std::size_t>(branch.parent)][s] += in[b][s];
    }
  }
  return in;
}

}  // namespace

void name_branches(VesselTrees& trees, const CouinaudSegments& segments) {
  // Of portal branches, and of the arteries and bile ducts that run with them.
  static constexpr std::array<const char*, 9> portal_place = {"",
                                                              "left/caudate/I",
                                                              "left/lateral/II",
                                                              "left/lateral/III",
                                                              "left/medial/IV",
                                                              "right/anterior/V",
                                                              "right/posterior/VI",
                                                              "right/posterior/VII",
                                                              "right/anterior/VIII"};
  const std::vector<InSegments> in = where_they_run(trees, segments);
  std::map<std::string, std::vector<std::size_t>> of_name;
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    const auto share = [&](std::initializer_list<std::size_t> some) {
      double sum = 0, all = 0;
      for (std::size_t s = 1; s <= 8; ++s) all += in[b][s];
      for (const std::size_t s : some) sum += in[b][s];
      return all > 0 ? sum / all : 0;
    };
    constexpr double nearly_all = 0.8;
    std::string name;
    const System system = trees.branches[b].system;
    if (system != System::hepatic_vein) {
      static constexpr std::array<const char*, all_systems.size()> beginnings = {"portal", "hepatic", "hepatic-artery",
                                                                                 "bile-duct"};
      name = beginnings.at(static_cast<std::size_t>(system));
      const auto largest = std::max_element(in[b].begin() + 1, in[b].end()) - in[b].begin();
      if (!is_vein(system) && std::all_of(in[b].begin() + 1, in[b].end(), [](double mm) { return mm == 0; })) {
        name += "/outside";  // of the liver, with all that grows from it
      } else if (share({static_cast<std::size_t>(largest)}) >= nearly_all) {
        name += std::string("/") + portal_place.at(static_cast<std::size_t>(largest));
      } else if (share({5, 8}) >= nearly_all) {
        name += "/right/anterior";
      } else if (share({6, 7}) >= nearly_all) {
        name += "/right/posterior";
      } else if (share({5, 6, 7, 8}) >= nearly_all) {
        name += "/right";
      } else if (share({2, 3}) >= nearly_all) {
        name += "/left/lateral";
      } else if (share({1, 2, 3, 4}) >= nearly_all) {
        name += "/left";
      } else {
        name += "/stem";
      }
    } else {
      // By what it drains: the right vein V to VIII, the middle one IV with V and VIII, the left one II and III.
      const double left = share({2, 3}), posterior = share({6, 7});
      name = share({1}) > 0.6                  ? "hepatic/caudate"
             : left > 0.4                      ? "hepatic/left"
             : posterior > 0.25                ? "hepatic/right"
             : share({4}) > 0.1 || left > 0.05 ? "hepatic/middle"
                                               : "hepatic/right";
    }
    of_name[name].push_back(b);
  }
  for (auto& [name, branches] : of_name) {
    std::stable_sort(branches.begin(), branches.end(), [&](std::size_t a, std::size_t b) {
      return trees.branches[a].radius_mm > trees.branches[b].radius_mm;
    });
    for (std::size_t n = 0; n < branches.size(); ++n) {
      trees.branches[branches[n]].name = n == 0 ? name : fmt::format("{}/{}", name, n + 1);
    }
  }
}

}  // namespace glisson::vasculature
