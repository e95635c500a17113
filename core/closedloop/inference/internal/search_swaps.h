#pragma once
// Whether another effect would do as well in the place of each that was chosen.

#include <vector>

#include "closedloop/inference/internal/search_steps.h"

namespace glisson::closedloop {

struct Swapped {
  Candidate chosen;
  std::vector<std::vector<Candidate>> in_place;  // for each of its settings, what was fitted in its place
};

// Each effect of `chosen` against every other kind in its place; a better one takes it. `singles`: each kind alone, as
// the search's first step fitted it. Where `chosen` leaves most of the error of `declared`, nothing is tried.
Result<Swapped> with_swaps(const Search& search, const Candidate& declared, Candidate chosen,
                           const std::vector<Candidate>& singles);

// `chosen` as it stands, with what was fitted in the place of each of its settings.
Result<Swapped> with_alternatives(const Search& search, Candidate chosen, const std::vector<Candidate>& singles);

}  // namespace glisson::closedloop
