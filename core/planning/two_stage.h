#pragma once
// Two stages: portal branches are embolised first, what they feed shrinks, the rest grows; weeks later the cut is made.
//
// What keeps its portal inflow grows by one share everywhere. How much is the surgeon's to set. On average the future
// remnant grew by 37.9 % after embolisation of portal branches, less in a cirrhotic liver. Those were 1791 patients in
// 44 studies (van Lienden et al. 2013, Cardiovasc Intervent Radiol 36:25). What was embolised and stays is told by
// itself, as it is now, and counts as nothing afterwards. Where and when tissue grows is not foreseen, nor how well it
// works.

#include <string>
#include <vector>

#include "planning/planner.h"

namespace glisson::planning {

inline constexpr double mean_growth_percent = 37.9;
inline constexpr double largest_growth_percent = 200;

// Tissue without tumours.
struct TwoStages {
  double embolised_ml = 0;       // what the embolised branches feed, before any cut
  double grows_ml = 0;           // what the cut leaves with portal inflow, as it is now
  double grown_ml = 0;           // the same after it grew
  double embolised_left_ml = 0;  // what the cut leaves of the embolised tissue, as it is now
  double remnant_percent = 0;    // what the cut leaves now, of the liver without tumours
  double grown_percent = 0;      // grown_ml of the same
};

// `embolised`: names of portal branches, "portal/right" with all that grows from it. Failures: those of
// Planner::answer(), "embolised-none", "embolised-not-portal" and "growth-invalid".
[[nodiscard]] Result<TwoStages> two_stages(const Planner& planner, const std::vector<std::string>& embolised,
                                           const std::vector<Cut>& cuts, double growth_percent = mean_growth_percent);

}  // namespace glisson::planning
