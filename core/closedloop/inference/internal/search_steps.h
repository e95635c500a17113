#pragma once
// The search for effects: candidates fitted, weighed by evidence, and let in or sent away. diagnosis.cpp tells its
// outcome.

#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "closedloop/inference/diagnosis_options.h"
#include "closedloop/inference/evidence.h"
#include "closedloop/inference/laplace.h"

namespace glisson::closedloop {

// A set of effects, fitted.
struct Candidate {
  std::string kind;  // the effect that it tries, on top of what is active
  std::string form;
  Fit fit;
  LeftOut left_out;
  std::string removed;  // why it is out; empty where it is fitted
  bool failed = false;  // out because its solves failed, not because it promised too little
  [[nodiscard]] bool fitted() const { return removed.empty(); }
};

class Search {
 public:
  Search(const ForwardModel& model, const DiagnosisOptions& options, const Progress& progress);

  Result<Candidate> declared() const;

  // Forward steps with backward checks from the declared model; leaves the first step's candidates in `singles`.
  Result<Candidate> select(const Candidate& declared, std::vector<Candidate>& singles);

  // Each effect of the catalogue alone. Of models whose fits are slow, to first order from where a fit would begin.
  Result<std::vector<LocalFit>> each_alone() const;

  // Fits each two kinds together where the steps did not, and all forms of the best: of models that predict quickly.
  void consider_pairs(const std::vector<Candidate>& singles);

  // All that was fitted, for what it is worth together.
  [[nodiscard]] const std::vector<LocalFit>& considered() const { return considered_; }

  // The best candidate of each other kind in place of setting `which` of `chosen`, and the other forms of its own.
  Result<std::vector<Candidate>> in_place_of(const Candidate& chosen, std::size_t which) const;

  // Fitted to the end from these settings.
  Result<Candidate> fitted(const Settings& settings) const;

  // `chosen` without setting `which`, fitted again.
  Result<Candidate> without(const Candidate& chosen, std::size_t which) const;

  // What is left is noise, or no larger than the prediction's own error.
  [[nodiscard]] bool leaves_nothing(const Candidate& candidate) const;
  // How far what is left exceeds the noise: root mean square, in units of the noise; compared with `indistinct`.
  [[nodiscard]] double excess(const Candidate& candidate) const;
  [[nodiscard]] double indistinct() const { return systematic_.indistinct; }
  [[nodiscard]] const SystematicUncertainty& systematic() const { return systematic_; }

  // The effect that it tries is at the end of its range.
  [[nodiscard]] bool ran_out_of_range(const Candidate& candidate) const;

  [[nodiscard]] double bic_of(const Candidate& candidate) const;
  // 2 ln (P over k): what choosing k among the P forms of effects costs besides their parameters (extended BIC: Chen
  // and Chen 2008, Biometrika 95:759).
  [[nodiscard]] double cost_of_choice(const Candidate& candidate) const;
  [[nodiscard]] const CrossValidationFolds& folds() const { return folds_; }
  [[nodiscard]] const Whitening& whitening() const { return whitening_; }
  [[nodiscard]] double correlation() const { return correlation_; }
  [[nodiscard]] const ForwardModel& model() const { return model_; }
  [[nodiscard]] const DiagnosisOptions& options() const { return options_; }

 private:
  Result<Candidate> forward(Candidate current, std::vector<Candidate>* singles);
  Result<Candidate> with_best_pair(Candidate chosen, const Candidate& declared, const std::vector<Candidate>& singles);
  [[nodiscard]] std::vector<Candidate> pairs_of(const std::vector<Candidate>& singles) const;
  [[nodiscard]] std::vector<Candidate> fit_together(
      const std::vector<std::pair<const Candidate*, const Candidate*>>& together) const;
  [[nodiscard]] std::vector<const Effect*> additions(const Settings& active) const;
  [[nodiscard]] Result<std::vector<Candidate>> fit_each(const Settings& active,
                                                        const std::vector<const Effect*>& effects,
                                                        const Progress& progress) const;
  // Where the fits of an effect begin, the best first, and what it promises.
  struct Attempt {
    const Effect* effect = nullptr;
    std::vector<Settings> starts;
    double promise = 0;
    std::string problem;
  };
  [[nodiscard]] Attempt begin(const Settings& active, const Effect& effect, const Eigen::VectorXd& residual) const;
  [[nodiscard]] Candidate fit_from(const Attempt& attempt) const;
  void finish(Candidate& candidate) const;
  void consider(const std::vector<Candidate>& candidates);
  void finish_near_the_best(std::vector<Candidate>& candidates, double chi2_without) const;
  [[nodiscard]] Candidate evaluated(Fit fit) const;
  [[nodiscard]] LeftOut left_out_of(const Fit& fit) const;
  [[nodiscard]] double plain_square(const Eigen::VectorXd& predicted) const;
  [[nodiscard]] bool shows(const Candidate& candidate, const Candidate& current) const;
  [[nodiscard]] bool predicts_better(const Candidate& candidate, const Candidate& current) const;
  [[nodiscard]] bool pays_beyond(const Candidate& candidate, const Candidate& current) const;
  [[nodiscard]] bool ran_out_of_range(const Setting& setting) const;
  Result<Candidate> backward(Candidate chosen) const;

  const ForwardModel& model_;
  const DiagnosisOptions& options_;
  const Progress& progress_;
  SystematicUncertainty systematic_;
  Whitening whitening_;
  CrossValidationFolds folds_;
  double left_out_by_zeros_ = 0;
  std::vector<LocalFit> considered_;
  bool pairs_considered_ = false;
  double correlation_ = 1;  // of what the best candidate so far leaves
};

}  // namespace glisson::closedloop
