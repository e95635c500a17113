#pragma once
// From an experiment and its forward model to what the model lacks.
//
// The declared model is judged first. If what it leaves is noise, that is the answer. Otherwise effects enter one by
// one, and all parameters are fitted again each time. The one with the best BIC enters, if it pays by BIC and by the
// error on trials left out whole. Left out are each trial by itself, and those under the largest load. After each step
// effects that no longer pay leave. When nothing more pays or the rest is noise, every effect is put against each other
// kind in its place. Those that do as well are named with it.

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/experiment/forward_model.h"
#include "closedloop/inference/diagnosis_options.h"
#include "closedloop/inference/explanation.h"

namespace glisson::closedloop {

// Fails where the declared model cannot be solved, and when cancelled. A candidate whose solve fails is left out, with
// the reason in the ranking.
Result<Explanation> diagnose(const ForwardModel& model, const DiagnosisOptions& options = {},
                             const Progress& progress = {});

}  // namespace glisson::closedloop
