#pragma once
// What the search found, for people: effects with their parameters and evidence, and how each kind does
// alone.

#include <optional>
#include <string>
#include <vector>

#include "closedloop/inference/explanation.h"
#include "closedloop/inference/internal/search_steps.h"

namespace glisson::closedloop {

struct FoundEffects {
  std::vector<FoundEffect> effects;  // by what they remove, the largest first
  std::vector<Sentence> notes;       // which parameters the data leave open
};

// The settings of `chosen`. `in_place`: for each of them, what was fitted in its place. `held_out_rms` and `rms` are
// errors of the whole explanation. Fails where an explanation without one of them cannot be solved.
Result<FoundEffects> found_effects(const Search& search, const Candidate& declared, const Candidate& chosen,
                                   const std::vector<std::vector<Candidate>>& in_place,
                                   const std::optional<double>& held_out_rms, double rms);

// Of each setting of `chosen` the other kinds that the data cannot tell from it.
[[nodiscard]] std::vector<std::vector<std::string>> alike_kinds(const Search& search, const Candidate& chosen,
                                                                const std::vector<std::vector<Candidate>>& in_place);

// Of each kind its best form alone, against the declared model; the best first, what was left out last.
[[nodiscard]] std::vector<RankedCandidate> ranking(const Search& search, const Candidate& declared,
                                                   const std::vector<Candidate>& singles);

}  // namespace glisson::closedloop
