#pragma once
// How busy or slow the machine is at this moment, for tests that hold processor time against a limit: other programs
// share its caches and its cores, and make the same work take up to twice as long.

#include <time.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace glisson::test {

// What this thread has computed so far.
inline double computed_ms() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

// Processor time of a fixed piece of work, over what it takes on the quiet machine that limits are written for; at
// least 1. The work sorts a million numbers, in 4 MB.
inline double times_slower_than_usual() {
  constexpr double usual_ms = 62;
  std::vector<double> times_ms;
  for (int repeat = 0; repeat < 3; ++repeat) {
    std::vector<std::uint32_t> numbers(1'000'000);
    std::uint32_t state = 1;
    for (std::uint32_t& number : numbers) number = state = state * 1664525U + 1013904223U;
    const double before_ms = computed_ms();
    std::sort(numbers.begin(), numbers.end());
    times_ms.push_back(computed_ms() - before_ms);
  }
  std::sort(times_ms.begin(), times_ms.end());
  return std::max(1.0, times_ms[1] / usual_ms);
}

}  // namespace glisson::test
