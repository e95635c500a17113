#pragma once
// The verdict: of the three answers the one that is expected to cost the minimum, by the probabilities of all
// explanations and by what each mistake costs (VerdictCosts).
//
// Berger, Statistical Decision Theory and Bayesian Analysis (1985), 4.4.1 (posterior expected loss).

#include <string>
#include <vector>

#include "closedloop/inference/diagnosis_options.h"
#include "closedloop/inference/explanation.h"

namespace glisson::closedloop {

// A set of causes that an explanation may name, and for each the kinds that the data cannot tell from it.
struct NamedCauses {
  std::vector<std::string> kinds;
  std::vector<std::vector<std::string>> alike;
};

// Whether `kinds` are the named ones, where each may be one that is alike to it.
[[nodiscard]] bool stand_for(const NamedCauses& named, const std::vector<std::string>& kinds);

// That these act, each or what is alike to it, and no others.
[[nodiscard]] double probability_of(const Posterior& posterior, const NamedCauses& named);

// `of_named`: probability that the causes act which would be named; 0 where there are none to name.
[[nodiscard]] Verdict verdict_of(const Posterior& posterior, double of_named, const VerdictCosts& costs);

}  // namespace glisson::closedloop
