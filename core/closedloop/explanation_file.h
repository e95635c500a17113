#pragma once
// An explanation in files: report.json as the contract has it, and model.json, the better model, which predict and a
// rehearsal take up again.

#include <filesystem>
#include <optional>
#include <string>

#include "base/json_forward.h"
#include "base/result.h"
#include "closedloop/experiment/forward_model.h"
#include "closedloop/inference/explanation.h"
#include "closedloop/posterior_history.h"

namespace glisson::closedloop {

// What was learnt, apart from the experiment that it was learnt from.
struct BetterModel {
  Settings settings;
  std::optional<SmoothCorrection> smooth_correction;
  double mesh_error_share = 0;  // Explanation::mesh_error_share
  std::string reading = {};     // ForwardModel::reading
};

[[nodiscard]] BetterModel better_model(const Explanation& explanation);

[[nodiscard]] std::string name_of(Verdict verdict);  // "nothing-missing", "explained", "unexplained"

// The contract's report; figures carry "_mm" for palpation and stand without it elsewhere.
[[nodiscard]] Json report_json(const Explanation& explanation, const Observations& observations,
                               const PosteriorHistory& history = {});

// Needs the model for the names of parameters.
[[nodiscard]] std::string model_text(const Explanation& explanation, const ForwardModel& model,
                                     const Experiment& experiment);

// For the experiment of `model`. Refused ("model-invalid"): another format, another kind of experiment, effects or
// parameters that no experiment of this kind knows.
Result<BetterModel> read_model(const std::filesystem::path& file, const ForwardModel& model,
                               const Experiment& experiment);

// What the better model predicts for the experiment of `model`, smooth correction included.
Result<Eigen::VectorXd> predict_with(const ForwardModel& model, const BetterModel& better);

[[nodiscard]] std::string kind_of(const Experiment& experiment);  // "palpation", "material", "platform", ...

}  // namespace glisson::closedloop
