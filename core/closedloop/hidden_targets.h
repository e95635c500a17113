#pragma once
// Places inside a guided organ whose truth is known, as of a phantom or a simulation. Nothing is fitted to them, and
// models are judged by them.

#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/explanation_file.h"

namespace glisson::closedloop {

// How far each model is from the targets of all frames (mm; the vectors are the targets), in the models' order. Empty
// where the experiment has no targets. `noise` and `reduced_chi2` are of no use here. Failures: those of
// guidance_model(), and of a prediction.
Result<std::vector<ErrorFigures>> target_errors(const Guidance& experiment, const std::vector<BetterModel>& models,
                                                const Progress& progress = {});

}  // namespace glisson::closedloop
