#pragma once
// From an experiment on disk to what its model lacks, in one call.

#include <filesystem>
#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/experiment/forward_model.h"
#include "closedloop/inference/explanation.h"

namespace glisson::closedloop {

// The declared model of an experiment and its catalogue. Fails where the declared model cannot be solved.
Result<std::unique_ptr<ForwardModel>> forward_model(Experiment experiment, const Progress& progress = {});

struct Explained {
  Experiment experiment;
  std::shared_ptr<const ForwardModel> model;
  Explanation explanation;
};

// Failures: those of read_experiment, forward_model and diagnose.
Result<Explained> explain(const std::filesystem::path& experiment, const Progress& progress = {});

}  // namespace glisson::closedloop
