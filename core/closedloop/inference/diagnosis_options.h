#pragma once
// What a diagnosis is strict about.

#include <cstddef>

namespace glisson::closedloop {

struct DiagnosisOptions {
  double entry_bic = 10;  // "very strong" evidence on Kass and Raftery's scale (1995), over a score of candidates
  double alike_bic = 10;  // what less than that cannot tell apart, causes from a smooth function without cause too
  std::size_t most_effects = 3;
  // With effects, a rest this much above the stated noise is still called explained: noise is seldom known better.
  // Shared among them: the more effects, the closer they must come.
  double near_noise_excess = 0.15;
};

}  // namespace glisson::closedloop
