#include "closedloop/explain.h"

#include "closedloop/trace.h"

namespace glisson::closedloop {

Result<Explained> explain(const std::filesystem::path& file, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("Reading the experiment"));
  auto experiment = read_experiment(file);
  if (!experiment) return failure(std::move(experiment.error()));
  auto model = forward_model(*experiment, progress.part(0, 0.1));
  if (!model) return failure(std::move(model.error()));
  auto explanation = trace(**model, {}, progress.part(0.1, 1));
  if (!explanation) return failure(std::move(explanation.error()));
  return Explained{*std::move(experiment), *std::move(model), *std::move(explanation)};
}

}  // namespace glisson::closedloop
