#pragma once
// The way of tools from station to station, and what stands at its end: what finite elements and the meshfree engine
// share (large_contact.h).

#include <vector>

#include "mechanics/contact/internal/augmented_lagrangian.h"
#include "mechanics/contact/large_contact.h"

namespace glisson::mechanics {

// Of Newton's method in each round of the augmented Lagrangian.
inline constexpr double residual_of_a_round = 1e-5;
inline constexpr int newton_steps_of_a_round = 40;

// Through the stations, up to one where `rest_under` finds no rest; gives back how many were gone to.
template <typename RestUnder>
Result<std::size_t> go_through(const std::vector<std::vector<ContactTool>>& stations, const RestUnder& equilibrate,
                               bool& rested, const Progress& progress) {
  std::size_t station = 0;
  for (rested = true; station < stations.size() && rested; ++station) {
    progress.report(double(station) / double(stations.size()), GLISSON_TEXT("Moving the tools"));
    const Result<bool> came_to_rest = equilibrate(stations[station]);
    if (!came_to_rest) return failure(came_to_rest.error());
    rested = *came_to_rest;
  }
  return station;
}

LargeContact outcome(const AugmentedLagrangian& lagrangian, StaticResult state, const std::vector<ContactTool>& tools,
                     bool rested, std::size_t station, std::size_t stations, const ContactOptions& options);

}  // namespace glisson::mechanics
