#pragma once
// What the tour says at each workspace, in the order of the work.

#include <map>
#include <set>

#include "widgets/help/tour.h"

namespace glisson::widgets {

// Stops at those workspaces that the window has; `acts`: what is done on arrival, by workspace.
[[nodiscard]] std::vector<TourStop> tour_stops(const std::set<QString>& workspaces,
                                               const std::map<QString, std::function<void()>>& acts);

}  // namespace glisson::widgets
