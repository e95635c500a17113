#pragma once
// What closing the loop found, as a report for a person. It shows the residual before, the suspects with their
// evidence, the residual after, the parameters with their uncertainty, and what to measure next.

#include <string>

#include "closedloop/inference/explanation.h"
#include "closedloop/posterior_history.h"
#include "report/page.h"
#include "report/words.h"

namespace glisson::report {

// `history`: drawn from two steps on.
[[nodiscard]] Page explanation_page(const closedloop::Explanation& explanation,
                                    const closedloop::Observations& observations, const std::string& title,
                                    const Words& words = {}, const closedloop::PosteriorHistory& history = {});

}  // namespace glisson::report
