#pragma once
// Good files broken in a few places, as the kind of place asks for: bits, counts and cuts in bytes; numbers, words,
// lines and brackets in text. The same number of a mutation gives the same bytes everywhere.

#include <random>
#include <string>
#include <vector>

namespace glisson::fuzz {

// `good` must not be empty; the number picks which of them is broken, and how.
[[nodiscard]] std::string broken(const std::vector<std::string>& good, unsigned number);

}  // namespace glisson::fuzz
