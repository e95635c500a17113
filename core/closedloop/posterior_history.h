#pragma once
// How probabilities went while trials were added to an experiment: a step for each answer on record.

#include <filesystem>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "closedloop/experiment/observations.h"
#include "closedloop/inference/explanation.h"

namespace glisson::closedloop {

struct PosteriorStep {
  std::vector<std::string> trials;  // ids
  Posterior posterior;              // without fits
};
using PosteriorHistory = std::vector<PosteriorStep>;  // each with more trials than the one before

// That of an earlier report with this answer after it. What the earlier report did not know, or what knew a trial that
// is gone, is left out. All of it is left out where the file is no report. An answer on the same trials takes the place
// of the last.
[[nodiscard]] PosteriorHistory history_after(const std::filesystem::path& earlier_report,
                                             const Explanation& explanation, const Observations& observations);

// "explanations" as files have them: name, kinds (null: something else) and probability of each.
[[nodiscard]] Json json_of(const Posterior& posterior);
[[nodiscard]] Json json_of(const PosteriorHistory& history);

}  // namespace glisson::closedloop
