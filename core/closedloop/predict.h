#pragma once
// The trials of an experiment as a model predicts them, each by itself, compared where they were measured.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/experiment/observations.h"
#include "closedloop/experiment/residual.h"

namespace glisson::closedloop {

struct PredictedTrial {
  std::string id;
  Eigen::VectorXd predicted;
  std::optional<ErrorFigures> error;  // absent where the trial was not measured
};

struct Prediction {
  std::string unit;
  std::vector<std::string> directions;  // of ErrorFigures::rms_of_direction
  std::vector<PredictedTrial> trials;
  std::optional<ErrorFigures> error;           // of all that was measured
  std::optional<ErrorFigures> hidden_targets;  // of guidance whose frames have them
  Observations observations;                   // what all of it is compared with
  Eigen::VectorXd predicted;                   // a number a row of those
};

// `better` is the model.json of explain; without it, the declared model. Failures: those of read_experiment,
// forward_model and read_model.
Result<Prediction> predict(const std::filesystem::path& experiment, const std::optional<std::filesystem::path>& better,
                           const Progress& progress = {});

// As CSV, a row a number: trial, time_s, load (N; strain; A), for palpations x_mm, y_mm, z_mm of the marker at rest,
// which quantity or component, predicted, measured (empty where nobody did) and its noise.
[[nodiscard]] std::string values_text(const Prediction& prediction);

}  // namespace glisson::closedloop
