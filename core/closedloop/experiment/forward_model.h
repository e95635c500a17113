#pragma once
// A model that predicts what an experiment measured, with any set of effects switched on. One class for each sort of
// experiment; diagnosis, reports and prediction know this interface alone.

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/sentence.h"
#include "closedloop/experiment/effect.h"
#include "closedloop/experiment/experiment.h"
#include "closedloop/experiment/observations.h"
#include "closedloop/experiment/whitening.h"

namespace glisson::closedloop {

// A prediction and how it changes with each parameter, in the order of the settings: rows x parameter_count(settings).
struct Linearisation {
  Eigen::VectorXd predicted;
  Eigen::MatrixXd derivatives;
};

// A trial that could still be made; nothing is measured yet. The sentence is for a person ("Press at (...) mm with 2
// N."). The conditions are what is done in it, as a trial of an experiment's file says it.
struct FurtherTrial {
  Sentence sentence;
  std::shared_ptr<const Json> conditions;
  Eigen::Index rows = 0;  // that it would measure
};

// Where a search for an effect may begin.
struct Start {
  Eigen::VectorXd values;
  // How much of the residual's sum of squares, in units of the noise, the effect would take to first order. Known where
  // fitting is slow: what promises far less than others is not fitted at all.
  double promise = std::numeric_limits<double>::infinity();
};

class ForwardModel {
 public:
  virtual ~ForwardModel() = default;

  [[nodiscard]] virtual const Observations& observations() const = 0;

  // Effects that this experiment could show at all (no asymmetry where only compression was tested). Several forms of
  // one kind exclude each other and stand in order of increasing freedom.
  [[nodiscard]] virtual const std::vector<Effect>& catalogue() const = 0;

  // One number a row of observations(); no settings: the declared model. Settings are of the catalogue, in bounds.
  // Must be free of data races (called from several threads) and deterministic.
  [[nodiscard]] virtual Result<Eigen::VectorXd> predict(const Settings& settings) const = 0;

  // By central or one-sided differences within the bounds unless a model knows better.
  [[nodiscard]] virtual Result<Linearisation> linearise(const Settings& settings) const;

  // How far the declared model's prediction itself may be off: the discretisation error as a finer solve shows it.
  // Counted as uncertainty, so that it is never named an effect.
  [[nodiscard]] virtual SystematicUncertainty systematic_uncertainty() const { return {}; }

  // What a cause outside of the catalogue may add to a prediction: any combination of functions of what was done. A
  // column each, rows as observations(). None: any smooth function (inference/smooth_rest.h).
  [[nodiscard]] virtual Eigen::MatrixXd unlisted_shapes() const { return {}; }

  // Where to begin the search for `effect` when `active` are on already and leave `residual` (measured - predicted).
  [[nodiscard]] virtual std::vector<Start> starts(const Effect& effect, const Settings& active,
                                                  const Eigen::VectorXd& residual) const;

  // Whether a prediction takes so little that sets of effects may be tried by the score.
  [[nodiscard]] virtual bool predicts_quickly() const { return true; }

  // Further trials that could be measured, the simplest first. What settings predict there is in units of the noise:
  // the rows of all trials, one after the other. Derivatives by differences unless a model knows better.
  [[nodiscard]] virtual std::vector<FurtherTrial> further_trials() const { return {}; }
  [[nodiscard]] virtual Result<Eigen::VectorXd> predict_further(const Settings& settings) const;
  [[nodiscard]] virtual Result<Linearisation> linearise_further(const Settings& settings) const;

  // Which of several things the numbers turned out to be, such as a measurement or a solution on the mesh itself. The
  // word is kept in model.json, so that other trials are predicted as the same. Empty where there is nothing to tell
  // apart.
  [[nodiscard]] virtual std::string reading() const { return ""; }
  [[nodiscard]] virtual Result<Eigen::VectorXd> predict_as(const std::string& reading, const Settings& settings) const;

  // For a person: what was assumed of the experiment before anything was fitted.
  [[nodiscard]] virtual std::vector<Sentence> remarks() const { return {}; }
};

// The effect of the catalogue that a setting switches on; nullptr where the model does not know it.
[[nodiscard]] const Effect* effect_of(const ForwardModel& model, const Setting& setting);

}  // namespace glisson::closedloop
