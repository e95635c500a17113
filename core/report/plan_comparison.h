#pragma once
// Plans side by side: a page, and the same as CSV. Each plan is an object with its name and the fields of
// planning::answer_json. Where a plan no longer holds, "failed" says why and no figure stands.

#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/sentence.h"
#include "planning/resectogram.h"
#include "report/page.h"
#include "report/words.h"

namespace glisson::report {

// `origin`: "SIMULATED ...", or empty for a real patient.
[[nodiscard]] Page plan_comparison(const std::vector<Json>& plans, const std::string& origin,
                                   const std::vector<Sentence>& remarks, const Words& words = {});

// The tables alone, for a page of more.
void add_plans(Page& page, const std::vector<Json>& plans, const Words& words);

// The surfaces of a plan's cuts unrolled flat, with bands of 5 and 10 mm around its tumours, and the vessels cut.
void add_resectograms(Page& page, const std::string& plan, const std::vector<planning::Resectogram>& maps,
                      const Words& words);

// A line a plan; empty where a figure is not known.
[[nodiscard]] std::string plan_table(const std::vector<Json>& plans);

}  // namespace glisson::report
