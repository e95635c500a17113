#pragma once
// The value in the middle; of an even count the larger of both there, so that it is one of the values. 0 of none.

#include <algorithm>
#include <vector>

namespace glisson {

template <typename Number>
[[nodiscard]] double upper_median(std::vector<Number> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle);
}

}  // namespace glisson
