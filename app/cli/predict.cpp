// glisson-cli predict: the trials of an experiment by the declared model, or by a better one that explain found.

#include <fmt/format.h>
#include <cmath>
#include <vector>

#include "closedloop/explanation_file.h"
#include "closedloop/residual.h"
#include "command.h"

namespace glisson::cli {
namespace {

struct PredictCommand {
  std::string experiment;
  std::string model;
};

Outcome describe(const closedloop::Observations& observations, const Eigen::VectorXd& predicted);

Result<Outcome> run(const PredictCommand& command, const Progress& progress) {
  auto experiment = closedloop::read_experiment(command.experiment, closedloop::Needs::conditions);
  if (!experiment) return failure(std::move(experiment.error()));
  const auto model = closedloop::forward_model(*experiment, progress);
  if (!model) return failure(model.error());
  closedloop::BetterModel better;
  if (!command.model.empty()) {
    auto read = closedloop::read_model(command.model, **model, *experiment);
    if (!read) return failure(std::move(read.error()));
    better = std::move(*read);
  }
  const auto predicted = closedloop::predict_with(**model, better);
  if (!predicted) return failure(predicted.error());
  return describe((*model)->observations(), *predicted);
}

// What belongs to one trial, as an experiment of its own.
closedloop::Observations only_trial(const closedloop::Observations& all, int trial, const Eigen::VectorXd& predicted,
                                    Eigen::VectorXd& predicted_of_trial) {
  closedloop::Observations one;
  one.unit = all.unit;
  one.directions = all.directions;
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < all.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (all.trial[i] != trial) continue;
    rows.push_back(row);
    one.direction.push_back(all.direction[i]);
    one.point.push_back(all.point[i]);
  }
  one.measured = all.measured(rows);
  one.noise = all.noise(rows);
  predicted_of_trial = predicted(rows);
  return one;
}

Outcome describe(const closedloop::Observations& observations, const Eigen::VectorXd& predicted) {
  const std::string suffix = observations.unit == "mm" ? "_mm" : "";
  Outcome outcome{{{"unit", observations.unit}, {"trials", Json::array()}}, {}};
  const auto add_figures = [&](Json& json, const closedloop::ErrorFigures& figures) {
    json["rms" + suffix] = figures.rms;
    json["mean" + suffix] = figures.mean;
    json["p95" + suffix] = figures.p95;
    json["max" + suffix] = figures.max;
    json["reduced_chi2"] = figures.reduced_chi2;
    for (std::size_t d = 0; d < figures.rms_of_direction.size(); ++d)
      if (figures.rms_of_direction[d]) json["rms_" + observations.directions[d]] = *figures.rms_of_direction[d];
  };
  bool measured = false;
  for (int trial = 0; trial < observations.trial_count(); ++trial) {
    Eigen::VectorXd of_trial;
    const auto one = only_trial(observations, trial, predicted, of_trial);
    Json json{{"id", observations.trials[static_cast<std::size_t>(trial)]}, {"values", one.rows()}};
    const bool compared = one.measured.array().isFinite().any();
    if (compared) {
      const auto figures = closedloop::error_figures(one, of_trial);
      add_figures(json, figures);
      outcome.text += fmt::format("{}: rms {:.4g} {}, at most {:.4g}\n", json["id"].get<std::string>(), figures.rms,
                                  observations.unit == "noise" ? "times the noise" : observations.unit, figures.max);
    } else {
      json["not_compared"] = "the trial was not measured";
      json["predicted"] = std::vector<double>(of_trial.begin(), of_trial.end());
      outcome.text += fmt::format("{}: not measured, {} values predicted\n", json["id"].get<std::string>(), one.rows());
    }
    measured = measured || compared;
    outcome.document["trials"].push_back(std::move(json));
  }
  if (measured) {
    const auto figures = closedloop::error_figures(observations, predicted);
    add_figures(outcome.document, figures);
    outcome.document["rms"] = figures.rms;
    outcome.text += fmt::format("all: rms {:.4g}\n", figures.rms);
  }
  return outcome;
}

}  // namespace

void add_predict(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("predict", "Predict the trials of an experiment, and compare where they were measured");
  auto settings = std::make_shared<PredictCommand>();
  command->add_option("experiment", settings->experiment, "Experiment (JSON, glisson-experiment/1)")->required();
  command->add_option("--with", settings->model, "Better model (model.json of explain); without: the declared model");
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli
