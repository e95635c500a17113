#pragma once
// One problem solved in every way, timed, with energy where the machine counts it (table 3.2).

#include "base/progress.h"
#include "registration/mrf.h"
#include "studies/dissertation/matching_study.h"

namespace glisson::studies {

struct MatchingTimes {
  std::vector<MatchingTiming> timings;
  std::vector<std::string> remarks;
  double memory_GB_per_s = 0;
  double costs_G_per_s = 0;  // of all threads, in vectors
};

Result<MatchingTimes> time_matching(const registration::MatchingProblem& problem, const MatchingOptions& options,
                                    const Progress& progress);

// So many passes and nothing beyond what the dissertation's solver does.
[[nodiscard]] registration::TrwlsOptions as_in_table_3_1(int passes, registration::WordWidth width);

}  // namespace glisson::studies
