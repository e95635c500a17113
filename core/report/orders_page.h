#pragma once
// Orders of steps side by side: a page with a table and what happens step by step.

#include <string>
#include <vector>

#include "base/json_forward.h"
#include "rehearsal/orders.h"
#include "report/page.h"

namespace glisson::report {

// `origin`: "SIMULATED ...", or empty for a real patient. `remarks`: what a person should know before trusting it.
[[nodiscard]] Page orders_page(const std::vector<rehearsal::OrderOfSteps>& orders, const std::string& origin,
                               const std::vector<std::string>& remarks);

// The same figures: name, steps, landmarks[]: {id, largest_mm, at_step, end_mm}, largest_force_N, largest_strain,
// vessel_strain (null where no vessel is known), open_mm2, bridge_mm2, refused[], unusable[].
[[nodiscard]] Json json_of(const rehearsal::OrderOfSteps& order);

}  // namespace glisson::report
