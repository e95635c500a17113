#pragma once
// The value of a result, or the end of the program with the sentence that says why there is none.

#include <fmt/format.h>
#include <cstdlib>
#include <utility>

#include "base/result.h"

template <typename T>
T or_stop(glisson::Result<T> result) {
  if (!result) {
    fmt::print(stderr, "{} {}\n", result.error().message(), result.error().advice());
    std::exit(1);
  }
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}
