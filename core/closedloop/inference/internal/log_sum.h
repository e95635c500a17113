#pragma once
// Adding up what is known by its natural logarithm, however small or large.

#include <algorithm>
#include <cmath>
#include <vector>

namespace glisson::closedloop {

// ln of the sum of exp of each; of at least one.
[[nodiscard]] inline double log_sum(const std::vector<double>& logs) {
  const double highest = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double log : logs) sum += std::exp(log - highest);
  return highest + std::log(sum);
}

}  // namespace glisson::closedloop
