#include "closedloop/predict.h"

#include <fmt/format.h>
#include <cmath>

#include "closedloop/explain.h"
#include "closedloop/explanation_file.h"
#include "closedloop/hidden_targets.h"

namespace glisson::closedloop {
namespace {

// What belongs to one trial, as far as errors need it.
Observations only_trial(const Observations& all, int trial, const std::vector<Eigen::Index>& rows) {
  Observations one;
  one.unit = all.unit;
  one.directions = all.directions;
  one.trials = {all.trials[static_cast<std::size_t>(trial)]};
  for (const Eigen::Index row : rows) {
    one.direction.push_back(all.direction[static_cast<std::size_t>(row)]);
    one.point.push_back(all.point[static_cast<std::size_t>(row)]);
  }
  one.measured = all.measured(rows);
  one.noise = all.noise(rows);
  return one;
}

std::vector<Eigen::Index> rows_of(const Observations& all, int trial) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < all.rows(); ++row) {
    if (all.trial[static_cast<std::size_t>(row)] == trial) rows.push_back(row);
  }
  return rows;
}

}  // namespace

Result<Prediction> predict(const std::filesystem::path& file, const std::optional<std::filesystem::path>& better_file,
                           const Progress& progress) {
  auto experiment = read_experiment(file, Needs::conditions);
  if (!experiment) return failure(std::move(experiment.error()));
  const auto model = forward_model(*experiment, progress);
  if (!model) return failure(model.error());
  BetterModel better;
  if (better_file) {
    auto read = read_model(*better_file, **model, *experiment);
    if (!read) return failure(std::move(read.error()));
    better = *std::move(read);
  }
  const auto predicted = predict_with(**model, better);
  if (!predicted) return failure(predicted.error());

  const Observations& observations = (*model)->observations();
  Prediction prediction{observations.unit, observations.directions, {}, {}, {}, observations, *predicted};
  for (int trial = 0; trial < observations.trial_count(); ++trial) {
    const auto rows = rows_of(observations, trial);
    const Observations one = only_trial(observations, trial, rows);
    PredictedTrial made{one.trials.front(), (*predicted)(rows), {}};
    if (one.measured.array().isFinite().any()) made.error = error_figures(one, made.predicted);
    prediction.trials.push_back(std::move(made));
  }
  if (observations.measured.array().isFinite().any()) prediction.error = error_figures(observations, *predicted);
  if (const auto* guidance = std::get_if<Guidance>(&experiment->setup)) {
    const auto errors = target_errors(*guidance, {better});
    if (!errors) return failure(errors.error());
    if (!errors->empty()) prediction.hidden_targets = errors->front();
  }
  return prediction;
}

std::string values_text(const Prediction& prediction) {
  const Observations& all = prediction.observations;
  std::string text = all.has_places() ? "trial,time_s,load,x_mm,y_mm,z_mm,quantity,predicted,measured,noise\n"
                                      : "trial,time_s,load,quantity,predicted,measured,noise\n";
  for (Eigen::Index row = 0; row < all.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    const auto add = [&](const std::string& cell) { (text += cell) += ','; };
    const auto add_number = [&](double value) { add(std::isfinite(value) ? fmt::format("{:.9g}", value) : ""); };
    // An id may hold a comma.
    add(fmt::format("\"{}\"", all.trials[static_cast<std::size_t>(all.trial[i])]));
    add_number(all.time_s[row]);
    add_number(all.load[row]);
    if (all.has_places())
      for (const double x : all.place_mm.row(row)) add_number(x);
    add(all.directions[static_cast<std::size_t>(all.direction[i])]);
    add_number(prediction.predicted[row]);
    add_number(all.measured[row]);
    text += fmt::format("{:.9g}\n", all.noise[row]);
  }
  return text;
}

}  // namespace glisson::closedloop
