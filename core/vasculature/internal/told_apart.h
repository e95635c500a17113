#pragma once
// Which system each branch of a graph of one class belongs to.
//
// Several forests are found (forest.h). Portal veins feed every part of a liver and hepatic veins drain every part, so
// that one counts in which every place of the liver has a branch of each near.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "vasculature/systems.h"

namespace glisson::vasculature {

struct ToldApart {
  std::vector<std::array<bool, 2>> belongs;  // each branch to portal, to hepatic veins; what lies between may to both
  std::vector<double> confidence;            // of each branch, 0.5 to 1
  VesselEntries entries;                     // where the thickest trees near the expected place begin
};

// places_mm: spread over the liver; none: what is near is not asked. A click tells the system of the nearest branch,
// which every forest keeps.
[[nodiscard]] ToldApart tell_apart(const VesselGraph& graph, const VesselEntries& expected,
                                   const std::vector<Eigen::Vector3d>& places_mm, const Clicks& clicks);

}  // namespace glisson::vasculature
