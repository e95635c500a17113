#pragma once
// From an experiment on disk to what its model lacks, in one call.

#include <filesystem>
#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/explanation.h"
#include "closedloop/forward_model.h"

namespace glisson::closedloop {

struct Explained {
  Experiment experiment;
  std::shared_ptr<const ForwardModel> model;
  Explanation explanation;
};

// Failures: those of read_experiment, forward_model and trace.
Result<Explained> explain(const std::filesystem::path& experiment, const Progress& progress = {});

}  // namespace glisson::closedloop
