// glisson-cli predict: the trials of an experiment by the declared model, or by a better one that explain found.

#include <fmt/format.h>
#include <vector>

#include "base/files.h"
#include "closedloop/predict.h"
#include "command.h"

namespace glisson::cli {
namespace {

struct PredictCommand {
  std::string experiment;
  std::string model;
  std::string values;
};

Outcome describe(const closedloop::Prediction& prediction) {
  const std::string suffix = prediction.unit == "mm" ? "_mm" : "";
  const std::string unit = prediction.unit == "noise" ? "times the noise" : prediction.unit;
  Outcome outcome{{{"unit", prediction.unit}, {"trials", Json::array()}}, {}};
  const auto add_figures = [&](Json& json, const closedloop::ErrorFigures& figures) {
    json["rms" + suffix] = figures.rms;
    json["mean" + suffix] = figures.mean;
    json["p95" + suffix] = figures.p95;
    json["max" + suffix] = figures.max;
    json["reduced_chi2"] = figures.reduced_chi2;
    for (std::size_t d = 0; d < figures.rms_of_direction.size(); ++d)
      if (figures.rms_of_direction[d]) json["rms_" + prediction.directions[d]] = *figures.rms_of_direction[d];
  };
  for (const closedloop::PredictedTrial& trial : prediction.trials) {
    Json json{{"id", trial.id}, {"values", trial.predicted.size()}};
    if (trial.error) {
      add_figures(json, *trial.error);
      outcome.text +=
          fmt::format("{}: rms {:.4g} {}, at most {:.4g}\n", trial.id, trial.error->rms, unit, trial.error->max);
    } else {
      json["not_compared"] = "the trial was not measured";
      json["predicted"] = std::vector<double>(trial.predicted.begin(), trial.predicted.end());
      outcome.text += fmt::format("{}: not measured, {} values predicted\n", trial.id, trial.predicted.size());
    }
    outcome.document["trials"].push_back(std::move(json));
  }
  if (prediction.error) {
    add_figures(outcome.document, *prediction.error);
    outcome.document["rms"] = prediction.error->rms;
    outcome.text += fmt::format("all: rms {:.4g}\n", prediction.error->rms);
  }
  if (prediction.hidden_targets) {
    const closedloop::ErrorFigures& targets = *prediction.hidden_targets;
    outcome.document["hidden_targets"] = {{"mean_mm", targets.mean}, {"p95_mm", targets.p95}, {"max_mm", targets.max}};
    outcome.text += fmt::format("hidden targets: {:.3g} mm on average, at most {:.3g}\n", targets.mean, targets.max);
  }
  return outcome;
}

Result<Outcome> run(const PredictCommand& command, const Progress& progress) {
  const auto better = command.model.empty() ? std::nullopt : std::optional<std::filesystem::path>(command.model);
  const auto prediction = closedloop::predict(command.experiment, better, progress);
  if (!prediction) return failure(prediction.error());
  if (!command.values.empty()) {
    if (auto written = write_text_file(command.values, closedloop::values_text(*prediction)); !written)
      return failure(std::move(written.error()));
  }
  return describe(*prediction);
}

}  // namespace

void add_predict(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("predict", "Predict the trials of an experiment, and compare where they were measured");
  auto settings = std::make_shared<PredictCommand>();
  command->add_option("experiment", settings->experiment, "Experiment (JSON, glisson-experiment/1)")->required();
  command->add_option("--with", settings->model, "Better model (model.json of explain); without: the declared model");
  command->add_option("--values", settings->values,
                      "Every number predicted, beside what was measured (CSV: trial, time, load, place, quantity, "
                      "predicted, measured, noise)");
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli
