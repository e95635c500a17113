#pragma once
// Orders of steps side by side: a page with a table and what happens step by step.

#include <string>
#include <vector>

#include "rehearsal/orders.h"
#include "report/page.h"
#include "report/words.h"

namespace glisson::report {

// `origin`: "SIMULATED ...", or empty for a real patient. `remarks`: what a person should know before trusting it.
[[nodiscard]] Page orders_page(const std::vector<rehearsal::OrderOfSteps>& orders, const std::string& origin,
                               const std::vector<std::string>& remarks);

// The table alone, in a page's language: a row a quantity, a column an order.
[[nodiscard]] Table orders_table(const std::vector<rehearsal::OrderOfSteps>& orders, const Words& words);

}  // namespace glisson::report
