#pragma once
// A probability for each explanation, by the evidence of each (laplace.h, smooth_rest.h) and what was believed before
// anything was measured (PosteriorOptions). The verdict follows from it (verdict.h).

#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/sentence.h"
#include "closedloop/experiment/forward_model.h"
#include "closedloop/inference/diagnosis_options.h"
#include "closedloop/inference/explanation.h"
#include "closedloop/inference/laplace.h"

namespace glisson::closedloop {

// What everything is weighed on.
struct Weighing {
  const ForwardModel& model;
  const SystematicUncertainty& systematic;
  const Whitening& whitening;  // over all rows
  double correlation = 1;
};

// `considered` are sets of effects near where they fit best. A set may stand there several times and counts once; sets
// that are not there count as impossible. Half of "something else" is a smooth function in place of all known causes.
// The other half acts beside the likeliest of them, which keep their own prior probability. Where "nothing is missing"
// is the likeliest, all of it is the smooth function. Shapes that the model gives stand for that function where there
// are any (shaped_rest.h). And what looks like the likeliest may be something else (PosteriorOptions::look_alike,
// likeness). What lies within the prediction's own error (SystematicUncertainty::indistinct) is no better evidence than
// the declared model. Fails where that cannot be solved, and when cancelled.
Result<Posterior> posterior(const Weighing& weighing, std::vector<LocalFit> considered, const PosteriorOptions& options,
                            const Progress& progress = {});

// In alphabetical order, as a posterior has them.
[[nodiscard]] std::vector<std::string> kinds_of(const Settings& settings);

// "nothing is missing", "stiffness-scale and hysteresis", "something else".
[[nodiscard]] std::string name_of(const WeighedExplanation& weighed);

// For a person, what follows the verdict: how probable the likeliest explanation is, and which comes next. Empty where
// nothing was weighed. `name` is how it calls an explanation, name_of unless another is given.
using NameOfExplanation = std::function<std::string(const WeighedExplanation&)>;
[[nodiscard]] Sentence posterior_sentence(const Explanation& explanation, const NameOfExplanation& name = {});

}  // namespace glisson::closedloop
