#pragma once
// The residual as pictures: vectors and heat on the specimen where there are places, curves elsewhere.

#include <string>
#include <vector>

#include "closedloop/inference/explanation.h"
#include "closedloop/posterior_history.h"
#include "report/page.h"
#include "report/words.h"

namespace glisson::report {

// Measured against predicted before and after, or residuals on the specimen before and after with the error by load.
[[nodiscard]] std::vector<Drawing> explanation_pictures(const closedloop::Explanation& explanation,
                                                        const closedloop::Observations& observations,
                                                        const Words& words);

// How probable each explanation is: a bar each, the likeliest first, as long as its probability.
[[nodiscard]] Drawing probability_bars(const closedloop::Posterior& posterior, const Words& words);

// How they went while trials were added: a curve each of those that were ever among the four likeliest.
[[nodiscard]] Drawing probabilities_by_trials(const closedloop::PosteriorHistory& history, const Words& words);

// "nothing is missing", "stiffness-scale and hysteresis", "something else"; `quoted` within a sentence.
[[nodiscard]] std::string explanation_name(const closedloop::WeighedExplanation& weighed, const Words& words,
                                           bool quoted = false);

}  // namespace glisson::report
