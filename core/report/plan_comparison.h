#pragma once
// Plans side by side: a page, and the same as CSV. Each plan is an object with its name and the fields of
// planning::answer_json; where a plan no longer holds, "failed" says why and no figure stands.

#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/sentence.h"
#include "report/page.h"
#include "report/words.h"

namespace glisson::report {

// `origin`: "SIMULATED ...", or empty for a real patient.
[[nodiscard]] Page plan_comparison(const std::vector<Json>& plans, const std::string& origin,
                                   const std::vector<Sentence>& remarks, const Words& words = {});

// The tables alone, for a page of more.
void add_plans(Page& page, const std::vector<Json>& plans, const Words& words);

// A line a plan; empty where a figure is not known.
[[nodiscard]] std::string plan_table(const std::vector<Json>& plans);

}  // namespace glisson::report
