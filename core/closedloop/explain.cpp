#include "closedloop/explain.h"

#include "closedloop/guidance/model.h"
#include "closedloop/hardware/model.h"
#include "closedloop/hidden_targets.h"
#include "closedloop/inference/diagnosis.h"
#include "closedloop/material/model.h"
#include "closedloop/palpation/model.h"

namespace glisson::closedloop {

Result<Explained> explain(const std::filesystem::path& file, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("Reading the experiment"));
  auto experiment = read_experiment(file);
  if (!experiment) return failure(std::move(experiment.error()));
  auto model = forward_model(*experiment, progress.part(0, 0.1));
  if (!model) return failure(std::move(model.error()));
  auto explanation = diagnose(**model, {}, progress.part(0.1, 1));
  if (!explanation) return failure(std::move(explanation.error()));
  if (const auto* guidance = std::get_if<Guidance>(&experiment->setup)) {
    const auto errors = target_errors(*guidance, {BetterModel{}, better_model(*explanation)});
    if (!errors) return failure(errors.error());
    if (!errors->empty()) explanation->hidden_targets = HiddenTargets{errors->front(), errors->back()};
  }
  return Explained{*std::move(experiment), *std::move(model), *std::move(explanation)};
}

Result<std::unique_ptr<ForwardModel>> forward_model(Experiment experiment, const Progress& progress) {
  if (auto* palpation = std::get_if<Palpation>(&experiment.setup)) {
    return palpation_model(std::move(*palpation), progress).map_error([&](Error error) {
      return error.file.empty() ? std::move(error).in_file(experiment.file) : error;
    });
  }
  if (auto* guidance = std::get_if<Guidance>(&experiment.setup)) {
    return guidance_model(std::move(*guidance), progress).map_error([&](Error error) {
      return error.file.empty() ? std::move(error).in_file(experiment.file) : error;
    });
  }
  if (auto* material = std::get_if<Material>(&experiment.setup)) return material_model(std::move(*material));
  return platform_model(std::move(std::get<Platform>(experiment.setup))).map_error([&](Error error) {
    return std::move(error).in_file(experiment.file);
  });
}

}  // namespace glisson::closedloop
