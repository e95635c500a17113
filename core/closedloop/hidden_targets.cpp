#include "closedloop/hidden_targets.h"

#include <utility>

#include "closedloop/guidance/model.h"

namespace glisson::closedloop {
namespace {

Guidance with_targets_as_landmarks(const Guidance& experiment);

}  // namespace

Result<std::vector<ErrorFigures>> target_errors(const Guidance& experiment, const std::vector<BetterModel>& models,
                                                const Progress& progress) {
  Guidance judged = with_targets_as_landmarks(experiment);
  std::vector<ErrorFigures> errors;
  if (judged.organ.trials.empty()) return errors;
  const auto model = guidance_model(std::move(judged), progress);
  if (!model) return failure(model.error());
  for (const BetterModel& better : models) {
    const auto predicted = predict_with(**model, better);
    if (!predicted) return failure(predicted.error());
    errors.push_back(error_figures((*model)->observations(), *predicted));
  }
  return errors;
}

namespace {

// The frames that have targets, with nothing else to be seen, each a trial by itself.
Guidance with_targets_as_landmarks(const Guidance& experiment) {
  Guidance judged = experiment;
  judged.organ.trials.clear();
  judged.points_mm.clear();
  judged.time_s.clear();
  judged.trials.clear();
  for (std::size_t f = 0; f < experiment.organ.trials.size(); ++f) {
    if (experiment.targets[f].empty()) continue;
    PalpationTrial frame = experiment.organ.trials[f];
    frame.samples.back().markers = experiment.targets[f];
    judged.trials.push_back({frame.id, {judged.organ.trials.size()}});
    judged.organ.trials.push_back(std::move(frame));
    judged.points_mm.emplace_back();
    judged.time_s.push_back(experiment.time_s[f]);
  }
  return judged;
}

}  // namespace
}  // namespace glisson::closedloop
