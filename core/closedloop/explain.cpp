#include "closedloop/explain.h"

#include <fmt/format.h>

#include "closedloop/fullfield/model.h"
#include "closedloop/guidance/model.h"
#include "closedloop/hardware/model.h"
#include "closedloop/hidden_targets.h"
#include "closedloop/inference/diagnosis.h"
#include "closedloop/material/model.h"
#include "closedloop/palpation/model.h"
#include "closedloop/waves/model.h"

namespace glisson::closedloop {
namespace {

void tell_of_targets(const HiddenTargets& targets, Explanation& explanation);

}  // namespace

Result<Explained> explain(const std::filesystem::path& file, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("Reading the experiment"));
  auto experiment = read_experiment(file);
  if (!experiment) return failure(std::move(experiment.error()));
  auto model = forward_model(*experiment, progress.part(0, 0.1));
  if (!model) return failure(std::move(model.error()));
  DiagnosisOptions options;
  if (std::holds_alternative<FullField>(experiment->setup)) options.maximum_effects = 1;  // a law in place of another
  auto explanation = diagnose(**model, options, progress.part(0.1, 1));
  if (!explanation) return failure(std::move(explanation.error()));
  if (const auto* guidance = std::get_if<Guidance>(&experiment->setup)) {
    const auto errors = target_errors(*guidance, {BetterModel{}, better_model(*explanation)});
    if (!errors) return failure(errors.error());
    if (!errors->empty()) tell_of_targets(HiddenTargets{errors->front(), errors->back()}, *explanation);
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
  if (auto* field = std::get_if<FullField>(&experiment.setup)) {
    return full_field_model(std::move(*field), progress).map_error([&](Error error) {
      return error.file.empty() ? std::move(error).in_file(experiment.file) : error;
    });
  }
  if (auto* waves = std::get_if<Elastography>(&experiment.setup)) {
    return wave_model(std::move(*waves)).map_error([&](Error error) {
      return error.file.empty() ? std::move(error).in_file(experiment.file) : error;
    });
  }
  if (auto* material = std::get_if<Material>(&experiment.setup)) return material_model(std::move(*material));
  return hardware_model(std::move(std::get<Hardware>(experiment.setup))).map_error([&](Error error) {
    return std::move(error).in_file(experiment.file);
  });
}

namespace {

// What fits better and predicts worse what nothing was fitted to is no explanation, whatever the verdict.
void tell_of_targets(const HiddenTargets& targets, Explanation& explanation) {
  explanation.hidden_targets = targets;
  if (targets.after.mean <= targets.before.mean) return;
  explanation.notes.push_back(
      {GLISSON_TEXT("The hidden targets, which nothing was fitted to, are farther off with what was found ({0} mm on "
                    "average) than without it ({1} mm): do not take it for the cause."),
       {fmt::format("{:.2f}", targets.after.mean), fmt::format("{:.2f}", targets.before.mean)}});
}

}  // namespace
}  // namespace glisson::closedloop
