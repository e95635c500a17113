#pragma once
// next_trials.json: what a lab may measure next.

#include "base/json_forward.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/inference/explanation.h"

namespace glisson::closedloop {

// "glisson-next-trials/1": the trials to make, one after the other, and all that are possible. Each has a sentence, and
// what is done in it as an experiment's file says it. So it can be measured, completed and added there.
[[nodiscard]] Json next_trials_json(const NextTrials& next, const Experiment& experiment);

}  // namespace glisson::closedloop
