#include "closedloop/inference/diagnosis.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "closedloop/inference/internal/search_steps.h"
#include "closedloop/inference/smooth_baseline.h"

namespace glisson::closedloop {
namespace {

struct Rival {
  std::string kind;
  Settings settings;
};

class Tracing {
 public:
  Tracing(const ForwardModel& model, const DiagnosisOptions& options, const Progress& progress)
      : model_(model), options_(options), progress_(progress), search_(model, options, progress) {}

  Result<Explanation> run();

 private:
  Result<Candidate> with_swaps(Candidate chosen, const std::vector<Candidate>& singles);
  Result<std::vector<Candidate>> in_place_of(const Candidate& chosen, std::size_t which,
                                             const std::vector<Candidate>& singles) const;
  Result<void> describe_effects(const Candidate& declared, const Candidate& chosen);
  [[nodiscard]] Eigen::VectorXd with_mesh_error_off(Eigen::VectorXd left_out, const Eigen::VectorXd& fitted) const;
  void describe_parameters(const Candidate& chosen, std::vector<FoundEffect>& effects);
  [[nodiscard]] bool comes_before(const std::string& kind, const std::string& other) const;
  void weigh_against_smooth(const Candidate& declared, const Candidate& chosen);
  void take_off_mesh_error(const Candidate& chosen);
  void rank(const Candidate& declared, const std::vector<Candidate>& singles);
  void decide(const Candidate& declared, Candidate& chosen);
  void find_next_measurement(const Candidate& chosen);
  [[nodiscard]] const Observations& all() const { return model_.observations(); }

  const ForwardModel& model_;
  const DiagnosisOptions& options_;
  const Progress& progress_;
  Search search_;
  Explanation explanation_;
  std::optional<Candidate> declared_;
  std::vector<std::vector<Candidate>> in_place_;  // for each effect that was chosen
  std::vector<Rival> rivals_;
};

}  // namespace

Result<Explanation> diagnose(const ForwardModel& model, const DiagnosisOptions& options, const Progress& progress) {
  if (!model.observations().measured.allFinite())
    return failure("experiment-invalid",
                   GLISSON_TEXT("Only an experiment whose trials are measured can be explained."));
  return Tracing(model, options, progress).run();
}

namespace {

Result<Explanation> Tracing::run() {
  progress_.report(0, GLISSON_TEXT("predicting with the declared model"));
  const auto declared = search_.declared();
  if (!declared) return failure(declared.error());
  Explanation& e = explanation_;
  e.predicted_before = declared->fit.predicted;
  e.before = error_figures(all(), e.predicted_before);
  e.judgement_before = judge(all(), declared->fit.white, e.predicted_before);
  if (search_.folds().any()) e.held_out_before = held_out_error(all(), e.predicted_before);
  declared_ = *declared;
  Candidate chosen = *declared;
  std::vector<Candidate> singles;
  if (!search_.leaves_nothing(*declared)) {
    auto selected = search_.select(*declared, singles);
    if (!selected) return failure(std::move(selected.error()));
    selected = with_swaps(std::move(*selected), singles);
    if (!selected) return failure(std::move(selected.error()));
    chosen = std::move(*selected);
  }
  progress_.report(0.95, GLISSON_TEXT("weighing the evidence"));
  rank(*declared, singles);
  decide(*declared, chosen);
  take_off_mesh_error(chosen);
  if (auto described = describe_effects(*declared, chosen); !described) return failure(std::move(described.error()));
  find_next_measurement(chosen);
  if (!search_.folds().any())
    e.notes.emplace_back("There is only one trial, so nothing could be predicted that was not fitted.");
  progress_.report(1, GLISSON_TEXT("done"));
  return std::move(e);
}

// What could stand in the place of a single effect was fitted in the search's first step.
Result<std::vector<Candidate>> Tracing::in_place_of(const Candidate& chosen, std::size_t which,
                                                    const std::vector<Candidate>& singles) const {
  if (chosen.fit.settings.size() != 1) return search_.in_place_of(chosen, which);
  std::vector<Candidate> others = singles;
  const Setting& own = chosen.fit.settings.front();
  std::erase_if(others, [&](const Candidate& other) {
    return !other.fitted() || search_.ran_out_of_range(other) || (other.kind == own.kind && other.form == own.form);
  });
  return others;
}

// Each effect against every other kind in its place; a better one takes it.
Result<Candidate> Tracing::with_swaps(Candidate chosen, const std::vector<Candidate>& singles) {
  constexpr int most_rounds = 3;
  constexpr double clearly = 2;
  constexpr double about_as_well = 1.1;  // on trials left out
  // An explanation that leaves most of the error is none, and which of its effects could be another does not matter.
  if (search_.excess(chosen) > 0.5 * search_.excess(*declared_)) {
    in_place_.resize(chosen.fit.settings.size());
    return chosen;
  }
  for (int round = 0; round < most_rounds; ++round) {
    in_place_.clear();
    bool swapped = false;
    for (std::size_t which = 0; which < chosen.fit.settings.size() && !swapped; ++which) {
      auto others = in_place_of(chosen, which, singles);
      if (!others) return failure(std::move(others.error()));
      std::stable_sort(others->begin(), others->end(),
                       [&](const auto& a, const auto& b) { return search_.bic_of(a) < search_.bic_of(b); });
      const auto better = std::find_if(others->begin(), others->end(), [&](const Candidate& other) {
        const double gain = search_.bic_of(chosen) - search_.bic_of(other);
        const auto more = parameter_count(other.fit.settings) - parameter_count(chosen.fit.settings);
        // Of two that the data cannot tell apart, the one of fewer numbers leads.
        if (more < 0 && gain > -options_.alike_bic)
          return (search_.leaves_nothing(other) || !search_.leaves_nothing(chosen)) &&
                 other.left_out.chi2 <= about_as_well * chosen.left_out.chi2;
        // Of as many numbers, the one that the catalogue names first: it begins with the plainest causes.
        if (more == 0 && gain > -clearly && comes_before(other.kind, chosen.fit.settings[which].kind) &&
            search_.leaves_nothing(other) == search_.leaves_nothing(chosen))
          return other.left_out.chi2 <= chosen.left_out.chi2;
        return gain > (more > 0 ? options_.alike_bic : clearly) && other.left_out.chi2 <= chosen.left_out.chi2;
      });
      if (better != others->end()) {
        chosen = *better;
        swapped = true;
      }
      in_place_.push_back(std::move(*others));
    }
    if (!swapped) return chosen;
  }
  // Still swapping: the last choice stands, and its rivals are found once more.
  in_place_.clear();
  for (std::size_t which = 0; which < chosen.fit.settings.size(); ++which) {
    auto others = in_place_of(chosen, which, singles);
    if (!others) return failure(std::move(others.error()));
    in_place_.push_back(std::move(*others));
  }
  return chosen;
}

bool Tracing::comes_before(const std::string& kind, const std::string& other) const {
  const auto place = [&](const std::string& wanted) {
    return std::find_if(model_.catalogue().begin(), model_.catalogue().end(),
                        [&](const Effect& effect) { return effect.kind == wanted; });
  };
  return place(kind) < place(other);
}

void Tracing::rank(const Candidate& declared, const std::vector<Candidate>& singles) {
  auto& ranking = explanation_.ranking;
  for (const Candidate& single : singles) {
    Suspect suspect{single.kind, single.form, single.fit.settings, 0, {}, 0, {}, single.removed, single.failed};
    if (single.fitted()) {
      suspect.rms = error_figures(all(), single.fit.predicted).rms;
      suspect.delta_bic = search_.bic_of(single) - search_.bic_of(declared);
      if (search_.folds().any()) suspect.held_out_rms = error_figures(all(), single.left_out.predicted).rms;
    }
    const auto same =
        std::find_if(ranking.begin(), ranking.end(), [&](const auto& s) { return s.kind == single.kind; });
    if (same == ranking.end()) {
      ranking.push_back(std::move(suspect));
    } else if (suspect.removed.empty() && (!same->removed.empty() || suspect.delta_bic < same->delta_bic)) {
      *same = std::move(suspect);
    }
  }
  std::stable_sort(ranking.begin(), ranking.end(), [](const Suspect& a, const Suspect& b) {
    return std::pair(!a.removed.empty(), a.delta_bic) < std::pair(!b.removed.empty(), b.delta_bic);
  });
  for (Suspect& suspect : ranking) {
    for (const Suspect& other : ranking) {
      if (&other != &suspect && suspect.removed.empty() && other.removed.empty() &&
          std::abs(other.delta_bic - suspect.delta_bic) < options_.alike_bic)
        suspect.alike.push_back(other.kind);
    }
    if (suspect.failed) explanation_.notes.push_back(fmt::format("{} was left out: {}", suspect.kind, suspect.removed));
  }
}

void Tracing::decide(const Candidate& declared, Candidate& chosen) {
  Explanation& e = explanation_;
  constexpr double worth_naming = 0.8;  // a partial explanation is kept where it predicts this much better
  constexpr double noise_uncertainty = 1.05;
  const auto rows = static_cast<double>(chosen.fit.white.size());
  const auto rms_in_noise = [&](const Candidate& candidate) { return std::sqrt(candidate.fit.chi2 / rows); };
  e.judgement_after = judge(all(), chosen.fit.white, chosen.fit.predicted);
  if (chosen.fit.settings.empty()) {
    const bool small = rms_in_noise(chosen) <= noise_uncertainty;
    e.verdict = search_.leaves_nothing(chosen) || small ? Verdict::nothing_missing : Verdict::unexplained;
    if (!e.judgement_after.is_noise && small) {
      e.notes.emplace_back("The residual is not quite random, but no larger than the noise can be trusted to be.");
    } else if (!e.judgement_after.is_noise && e.verdict == Verdict::nothing_missing) {
      e.notes.emplace_back(
          "The residual is not quite random, but no larger than what a finer mesh would change of the prediction.");
    }
  } else {
    const double near = 1 + options_.near_noise_excess / static_cast<double>(chosen.fit.settings.size());
    e.verdict =
        search_.leaves_nothing(chosen) || rms_in_noise(chosen) <= near ? Verdict::explained : Verdict::unexplained;
  }
  if (e.verdict == Verdict::explained) weigh_against_smooth(declared, chosen);
  if (e.verdict == Verdict::unexplained && !chosen.fit.settings.empty() &&
      std::sqrt(chosen.left_out.chi2) > worth_naming * std::sqrt(declared.left_out.chi2) && search_.folds().any()) {
    chosen = declared;
    in_place_.clear();
    e.judgement_after = e.judgement_before;
  }
  if (e.verdict == Verdict::unexplained) {
    const auto smooth = fit_smooth_correction(all(), all().measured - chosen.fit.predicted, progress_);
    if (smooth) {
      e.smooth_correction = smooth->smooth;
      e.held_out_corrected = held_out_error(all(), chosen.left_out.predicted + smooth->held_out);
    }
  }
  e.settings = chosen.fit.settings;
  e.predicted_after = chosen.fit.predicted;
  e.after = error_figures(all(), e.predicted_after);
}

// Several causes together, or one with much freedom, can be bent to what none of them did.
void Tracing::weigh_against_smooth(const Candidate& declared, const Candidate& chosen) {
  Explanation& e = explanation_;
  e.evidence_over_smooth =
      evidence_over_smooth(all(), all().measured - declared.fit.predicted, all().measured - chosen.fit.predicted,
                           parameter_count(chosen.fit.settings), search_.correlation(), progress_) -
      search_.cost_of_choice(chosen);
  if (*e.evidence_over_smooth >= options_.alike_bic) return;
  e.verdict = Verdict::unexplained;
  e.notes.push_back(fmt::format(
      "What was found brings the residual to the noise, but is no clearly better evidence (BIC {:+.0f}) than a smooth "
      "function of what was done, which names no cause.",
      *e.evidence_over_smooth));
}

// The mesh's own error is no effect and is never named; but what of it the measurements show need not spoil what the
// better model predicts. The error before stays that of the declared model as it was solved.
void Tracing::take_off_mesh_error(const Candidate& chosen) {
  Explanation& e = explanation_;
  const Eigen::VectorXd& expected = search_.systematic().expected;
  if (expected.size() == 0 || e.smooth_correction) return;
  e.mesh_error_share = share_of(expected, all().measured - chosen.fit.predicted, all().noise, all_rows(all()));
  if (e.mesh_error_share == 0) return;
  e.predicted_after += e.mesh_error_share * expected;
  e.after = error_figures(all(), e.predicted_after);
  e.notes.push_back(fmt::format(
      "A finer mesh would change the prediction; {:.0f} % of what it would change shows in the measurements "
      "and is taken off what the better model predicts.",
      100 * e.mesh_error_share));
}

// Trials left out know no more of it than the others show.
Eigen::VectorXd Tracing::with_mesh_error_off(Eigen::VectorXd left_out, const Eigen::VectorXd& fitted) const {
  if (explanation_.mesh_error_share == 0) return left_out;
  const Eigen::VectorXd& expected = search_.systematic().expected;
  for (const CrossValidationFolds::Fold& fold : search_.folds().trials()) {
    const double share = share_of(expected, all().measured - fitted, all().noise, fold.kept.rows());
    for (const Eigen::Index row : fold.left_out.rows()) left_out[row] += share * expected[row];
  }
  return left_out;
}

Result<void> Tracing::describe_effects(const Candidate& declared, const Candidate& chosen) {
  Explanation& e = explanation_;
  if (!search_.folds().any() && chosen.fit.settings.empty()) return {};
  std::optional<double> held_out_rms;
  if (search_.folds().any()) {
    auto refitted = leave_out_with_refits(model_, chosen.fit, search_.folds(), progress_);
    if (!refitted && progress_.cancelled()) return failure(std::move(refitted.error()));
    e.held_out = held_out_error(
        all(), with_mesh_error_off(refitted ? refitted->predicted : chosen.left_out.predicted, chosen.fit.predicted));
    held_out_rms = e.held_out->rms;
  }
  std::vector<FoundEffect> effects;
  for (std::size_t which = 0; which < chosen.fit.settings.size(); ++which) {
    const Setting& setting = chosen.fit.settings[which];
    const auto smaller = chosen.fit.settings.size() == 1 ? Result<Candidate>(declared) : search_.without(chosen, which);
    if (!smaller) return failure(smaller.error());
    FoundEffect effect;
    effect.kind = setting.kind;
    effect.form = setting.form;
    effect.sentence = effect_of(model_, setting)->sentence;
    effect.delta_bic = search_.bic_of(chosen) - search_.bic_of(*smaller);
    effect.held_out_rms = held_out_rms;
    if (search_.folds().any()) effect.held_out_rms_without = error_figures(all(), smaller->left_out.predicted).rms;
    effect.removed_rms = error_figures(all(), smaller->fit.predicted).rms - e.after.rms;
    for (const Candidate& other : in_place_[which]) {
      const bool known =
          other.kind == setting.kind || std::count(effect.alike.begin(), effect.alike.end(), other.kind) > 0;
      if (!known && search_.bic_of(other) < search_.bic_of(chosen) + options_.alike_bic) {
        effect.alike.push_back(other.kind);
        rivals_.push_back({other.kind, other.fit.settings});
      }
    }
    effects.push_back(std::move(effect));
  }
  describe_parameters(chosen, effects);
  std::stable_sort(effects.begin(), effects.end(),
                   [](const auto& a, const auto& b) { return a.removed_rms > b.removed_rms; });
  e.effects = std::move(effects);
  return {};
}

void Tracing::describe_parameters(const Candidate& chosen, std::vector<FoundEffect>& effects) {
  if (parameter_count(chosen.fit.settings) == 0) return;
  constexpr int enough_trials = 4;  // for resampling to say something
  constexpr double strongly = 0.95;
  const ParameterRanges ranges = ranges_of(model_, chosen.fit.settings);
  const double excess = std::max(1.0, chosen.fit.chi2 / double(chosen.fit.white.size())) * search_.correlation();
  const Eigen::MatrixXd covariance_of_noise =
      covariance(search_.whitening().whiten(chosen.fit.derivatives) / std::sqrt(excess), ranges.prior_width);
  const Eigen::MatrixXd samples = bootstrapped_parameters(model_, chosen.fit, search_.whitening());
  const Eigen::VectorXd values = values_of(chosen.fit.settings);
  std::vector<std::size_t> effect_of_parameter;
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const Effect& effect = *effect_of(model_, chosen.fit.settings[i]);
    for (const Parameter& parameter : effect.parameters) {
      FoundParameter found{parameter, values[at], std::sqrt(covariance_of_noise(at, at)), 0, 0, true};
      const double mean = samples.row(at).mean();
      const double resampled = std::sqrt((samples.row(at).array() - mean).square().mean());
      found.low = found.value - 1.96 * found.std;
      found.high = found.value + 1.96 * found.std;
      if (all().trial_count() >= enough_trials && resampled > found.std) {
        found.std = resampled;
        std::vector<double> sorted(samples.row(at).begin(), samples.row(at).end());
        std::sort(sorted.begin(), sorted.end());
        found.low = sorted[sorted.size() / 40];
        found.high = sorted[sorted.size() - 1 - sorted.size() / 40];
      }
      found.low = std::max(found.low, parameter.lower);
      found.high = std::min(found.high, parameter.upper);
      found.determined = found.std < 0.5 * ranges.prior_width[at];
      if (!found.determined)
        explanation_.notes.push_back(
            fmt::format("These data do not determine {} of {}.", parameter.name, effects[i].kind));
      constexpr double close = 1e-3;
      const double margin = close * (parameter.upper - parameter.lower);
      const bool at_end = found.value > parameter.upper - margin ||
                          (parameter.scale == Scale::logarithmic ? found.value < (1 + close) * parameter.lower
                                                                 : found.value < parameter.lower + margin);
      if (at_end)
        explanation_.notes.push_back(fmt::format("{} of {} ended at the limit of its range ({:.3g}).", parameter.name,
                                                 effects[i].kind, found.value));
      effects[i].parameters.push_back(std::move(found));
      effect_of_parameter.push_back(i);
      ++at;
    }
  }
  std::set<std::pair<std::size_t, std::size_t>> told;
  for (Eigen::Index a = 0; a < at; ++a) {
    for (Eigen::Index b = 0; b < a; ++b) {
      const std::size_t one = effect_of_parameter[static_cast<std::size_t>(b)];
      const std::size_t other = effect_of_parameter[static_cast<std::size_t>(a)];
      const double correlation =
          covariance_of_noise(a, b) / std::sqrt(covariance_of_noise(a, a) * covariance_of_noise(b, b));
      if (one != other && std::abs(correlation) > strongly && told.insert({one, other}).second)
        explanation_.notes.push_back(fmt::format("{} and {} can hardly be told apart in size (correlation {:.2f}).",
                                                 effects[one].kind, effects[other].kind, correlation));
    }
  }
}

// The trial for which the leading rival is expected to differ most from what was chosen: for two models with normal
// noise the expected log Bayes factor is half the square of their distance.
void Tracing::find_next_measurement(const Candidate& chosen) {
  const std::vector<std::string> sentences = model_.further_trials();
  if (rivals_.empty() || sentences.empty()) return;
  NextMeasurement next;
  for (std::size_t trial = 0; trial < sentences.size(); ++trial) {
    const auto expected = model_.predict_further(trial, chosen.fit.settings);
    if (!expected || !expected->allFinite()) continue;
    std::vector<std::string> separated;
    double least = std::numeric_limits<double>::infinity();
    for (const Rival& rival : rivals_) {
      const auto otherwise = model_.predict_further(trial, rival.settings);
      if (!otherwise || !otherwise->allFinite()) continue;
      const double separation = (*expected - *otherwise).norm();
      constexpr double clear = 4;
      if (separation < clear) continue;
      least = std::min(least, separation);
      if (std::count(separated.begin(), separated.end(), rival.kind) == 0) separated.push_back(rival.kind);
    }
    if (separated.empty()) continue;
    if (std::pair(separated.size(), least) > std::pair(next.rivals.size(), next.expected_separation))
      next = {sentences[trial], separated, least};
  }
  if (!next.rivals.empty()) explanation_.next = std::move(next);
}

}  // namespace
}  // namespace glisson::closedloop
