#pragma once
// What a diagnosis found: the verdict, the errors before and after, the effects with their evidence, and what to do
// next. Errors are in the experiment's unit.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/sentence.h"
#include "closedloop/experiment/effect.h"
#include "closedloop/experiment/observations.h"
#include "closedloop/experiment/residual.h"
#include "closedloop/inference/laplace.h"
#include "closedloop/inference/smooth_correction.h"

namespace glisson::closedloop {

enum class Verdict {
  nothing_missing,  // what the declared model leaves shows no effect
  explained,        // the effects are probable enough to be named
  unexplained       // something acts, and no set of known effects is
};

// Error on trials left out whole, each predicted by a model fitted to the others.
struct HeldOut {
  double rms = 0;
  double low = 0;  // 95 % interval, bootstrapped over trials
  double high = 0;
  double mean = 0;  // over vectors, as ErrorFigures
  double p95 = 0;
};

struct FoundParameter {
  Parameter parameter;
  double value = 0;
  double std = 0;
  double low = 0;  // 95 % interval, bootstrapped over trials; from the standard deviation where trials are few
  double high = 0;
  bool determined = true;  // false: the data leave it as open as it was
};

struct FoundEffect {
  std::string kind;
  std::string form;
  std::string sentence;
  std::vector<FoundParameter> parameters;
  double delta_bic = 0;                        // of the whole explanation, with it against without it
  std::optional<double> held_out_rms;          // of the whole explanation
  std::optional<double> held_out_rms_without;  // of the explanation without it
  double removed_rms = 0;                      // how much smaller the fitted error is with it than without it
  std::vector<std::string> alike;              // kinds that could stand in its place
};

// How each kind does alone, against the declared model.
struct RankedCandidate {
  std::string kind;
  std::string form;
  Settings settings;
  double rms = 0;
  std::optional<double> held_out_rms;  // absent for a single trial, and where it predicts none from the others
  double delta_bic = 0;
  std::vector<std::string> alike;
  std::string removed;   // why it is out of the running ("its solve failed: ..."); empty where it is not
  bool failed = false;   // its solves failed, rather than that it promised too little
  bool predicts = true;  // a trial left out from the others (LeftOut::given)
};

// A further trial (next_trial.h).
struct NextMeasurement {
  Sentence sentence;
  std::shared_ptr<const Json> conditions;  // what is done, as a trial of an experiment's file says it
  std::vector<std::string> alternatives;   // kinds that it would tell from what is likeliest
  // Of the doubt among the explanations, the share that it and those before it are expected to take away.
  double doubt_removed = 0;
};

// A further trial by itself, whether it is among those to make or not: for who cannot make these.
struct PossibleTrial {
  struct Separation {
    std::vector<std::string> kinds;  // of a standing explanation
    double noises = 0;               // from its prediction to that of the likeliest, all rows together, in deviations
  };
  Sentence sentence;
  std::shared_ptr<const Json> conditions;
  double doubt_removed = 0;             // as of NextMeasurement; 0 where it cannot be solved
  std::vector<Separation> separations;  // of all known explanations that stand, but the likeliest
};

struct NextTrials {
  std::vector<NextMeasurement> to_make;  // one after the other, the most telling first
  std::vector<PossibleTrial> possible;   // all that were considered, in the model's order
};

// How probable an explanation is among all that were weighed.
struct WeighedExplanation {
  std::vector<std::string> kinds;  // what acts together, in alphabetical order; none: nothing is missing
  bool something_else = false;     // nothing of the catalogue, or not that alone
  double probability = 0;
  LocalFit fit = {};  // of its likeliest form; of something else the likeliest known causes
  // Of something else the part of its probability by which it acts beside these and not in their place.
  double beside = 0;
};

// Over nothing, each kind, the sets of kinds that the search fitted, and something else; the likeliest first. The
// improbable are left out (PosteriorOptions::worth_telling), so that the sum is a little less than 1.
using Posterior = std::vector<WeighedExplanation>;

// From where on an effect would have been seen (visible.h).
struct SmallestVisible {
  std::string kind;
  std::string form;
  std::string parameter;
  int component = 0;            // of a parameter that is a vector, from 1; else 0
  double no_effect = 0;         // of the parameter
  std::optional<double> value;  // absent: at no size within the parameter's bounds
};

// Places in the organ that nothing was fitted to (hidden_targets.h): how far the declared and the better model are off.
struct HiddenTargets {
  ErrorFigures before;
  ErrorFigures after;
};

struct Explanation {
  Verdict verdict = Verdict::nothing_missing;
  ErrorFigures before;
  ErrorFigures after;
  std::optional<HeldOut> held_out;         // absent for a single trial, and where the others do not predict one
  std::optional<HeldOut> held_out_before;  // of the declared model: no fit, so it only adds the interval
  ResidualDiagnostics residual_before;
  ResidualDiagnostics residual_after;
  std::vector<FoundEffect> effects;      // by what they remove, the largest first
  Settings settings;                     // the same, for ForwardModel::predict
  std::vector<RankedCandidate> ranking;  // the best first
  std::optional<SmoothCorrection> smooth_correction;
  std::optional<HeldOut> held_out_corrected;    // with it
  std::optional<HiddenTargets> hidden_targets;  // of guidance, where they were given
  NextTrials next;
  Posterior posterior;
  // Probability that the effects act, each or what is alike to it, with nothing beside them that matters; 0 where none
  // is named.
  double of_effects = 0;
  std::vector<SmallestVisible> smallest_visible;  // with "nothing missing"
  // For a person: what is undetermined, what was left out and why. Arguments name kinds and parameters as they are.
  std::vector<Sentence> notes;
  Eigen::VectorXd predicted_before;
  // The share of SystematicUncertainty::expected that the measurements show after all effects; 0 where they do not show
  // it. It is taken off the better model's predictions.
  double mesh_error_share = 0;
  Eigen::VectorXd predicted_after;  // with that, without the smooth correction
  std::string reading;              // ForwardModel::reading
};

}  // namespace glisson::closedloop
