#include "closedloop/inference/diagnosis.h"

#include <fmt/format.h>
#include <cmath>
#include <iterator>
#include <utility>

#include "closedloop/inference/internal/found_effects.h"
#include "closedloop/inference/internal/search_steps.h"
#include "closedloop/inference/internal/search_swaps.h"
#include "closedloop/inference/next_trial.h"
#include "closedloop/inference/posterior.h"
#include "closedloop/inference/smooth_baseline.h"
#include "closedloop/inference/verdict.h"
#include "closedloop/inference/visible.h"

namespace glisson::closedloop {
namespace {

// What the search chose, and everything that it was compared with.
struct Choice {
  Candidate declared;
  std::vector<Candidate> singles;  // each kind alone; none where nothing is missing
  Swapped found;
};

class Diagnosis {
 public:
  Diagnosis(const ForwardModel& model, const DiagnosisOptions& options, const Progress& progress)
      : options_(options), progress_(progress), all_(model.observations()), search_(model, options, progress) {}

  Result<Explanation> run();

 private:
  Result<Choice> choose();
  [[nodiscard]] Remainder remainder(const Choice& choice) const;
  [[nodiscard]] const Candidate& worth_naming(const Choice& choice, Verdict verdict) const;
  [[nodiscard]] double mesh_error_share(const Candidate& named) const;
  [[nodiscard]] Result<std::optional<HeldOut>> held_out(const Candidate& named, double mesh_error_share) const;
  [[nodiscard]] Result<Posterior> weighed(const Choice& choice);
  [[nodiscard]] Weighing weighing() const {
    return {search_.model(), search_.systematic(), search_.whitening(), search_.correlation()};
  }
  [[nodiscard]] std::vector<Sentence> notes_on_verdict(const Choice& choice, const Remainder& left) const;

  const DiagnosisOptions& options_;
  const Progress& progress_;
  const Observations& all_;
  Search search_;
};

std::vector<Sentence> notes_on_ranking(const std::vector<RankedCandidate>& ranking);

void append(std::vector<Sentence>& notes, std::vector<Sentence> more) {
  notes.insert(notes.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
}

}  // namespace

Result<Explanation> diagnose(const ForwardModel& model, const DiagnosisOptions& options, const Progress& progress) {
  if (!model.observations().measured.allFinite())
    return failure("experiment-invalid",
                   GLISSON_TEXT("Only an experiment whose trials are measured can be explained."));
  return Diagnosis(model, options, progress).run();
}

namespace {

Result<Explanation> Diagnosis::run() {
  progress_.report(0, GLISSON_TEXT("predicting with the declared model"));
  const auto choice = choose();
  if (!choice) return failure(choice.error());
  progress_.report(0.95, GLISSON_TEXT("weighing the evidence"));
  const Candidate& declared = choice->declared;
  const Remainder left = remainder(*choice);
  const Verdict verdict = verdict_of(left, options_);
  const Candidate& named = worth_naming(*choice, verdict);

  const auto smooth = verdict == Verdict::unexplained
                          ? fit_smooth_correction(all_, all_.measured - named.fit.predicted, progress_)
                          : std::nullopt;
  const double share = smooth ? 0 : mesh_error_share(named);
  Eigen::VectorXd predicted = named.fit.predicted;
  if (share != 0) predicted += share * search_.systematic().expected;
  const ErrorFigures after = error_figures(all_, predicted);
  const auto left_out = held_out(named, share);
  if (!left_out) return failure(left_out.error());
  auto found = found_effects(search_, declared, named, choice->found.in_place,
                             *left_out ? std::optional((*left_out)->rms) : std::nullopt, after.rms);
  if (!found) return failure(std::move(found.error()));
  std::vector<RankedCandidate> alone = ranking(search_, declared, choice->singles);

  std::vector<Sentence> notes = search_.model().remarks();
  if (const auto times = impossible_noise(all_, all_.measured - named.fit.predicted))
    notes.push_back({GLISSON_TEXT("From one measurement to the next the values scatter {0} times as much as the stated "
                                  "noise, which cannot be right: state it anew and ask again."),
                     {fmt::format("{:.2g}", *times)}});
  append(notes, notes_on_ranking(alone));
  append(notes, notes_on_verdict(*choice, left));
  if (share != 0)
    notes.push_back(
        {GLISSON_TEXT("A finer mesh would change the prediction; {0} % of what it would change shows in the "
                      "measurements and is taken off what the better model predicts."),
         {fmt::format("{:.0f}", 100 * share)}});
  append(notes, std::move(found->notes));
  if (!search_.folds().any())
    notes.push_back({GLISSON_TEXT("There is only one trial, so nothing could be predicted that was not fitted."), {}});
  auto probabilities = options_.probabilities ? weighed(*choice) : Posterior{};
  if (!probabilities) return failure(std::move(probabilities.error()));
  std::vector<SmallestVisible> visible;
  if (verdict == Verdict::nothing_missing) {
    auto found_visible =
        smallest_visible(search_.model(), search_.systematic(), search_.whitening(), options_, progress_);
    if (!found_visible) return failure(std::move(found_visible.error()));
    visible = *std::move(found_visible);
  }
  auto next = next_trials(weighing(), *probabilities, options_, progress_);
  if (!next) return failure(std::move(next.error()));
  progress_.report(1, GLISSON_TEXT("done"));

  const auto if_left_out = [&](const Eigen::VectorXd& trials) {
    return search_.folds().any() ? std::optional(held_out_error(all_, trials, options_.evidence)) : std::nullopt;
  };
  return Explanation{
      .verdict = verdict,
      .before = error_figures(all_, declared.fit.predicted),
      .after = after,
      .held_out = *left_out,
      .held_out_before = if_left_out(declared.fit.predicted),
      .residual_before = residual_diagnostics(all_, declared.fit.white, declared.fit.predicted),
      .residual_after = residual_diagnostics(all_, named.fit.white, named.fit.predicted),
      .effects = std::move(found->effects),
      .settings = named.fit.settings,
      .ranking = std::move(alone),
      .evidence_over_smooth = left.evidence_over_smooth,
      .smooth_correction = smooth ? std::optional(smooth->smooth) : std::nullopt,
      .held_out_corrected =
          smooth ? std::optional(held_out_error(all_, named.left_out.predicted + smooth->held_out, options_.evidence))
                 : std::nullopt,
      .hidden_targets = {},  // whoever knows them judges by them (explain.cpp)
      .next = *std::move(next),
      .posterior = *std::move(probabilities),
      .smallest_visible = std::move(visible),
      .notes = std::move(notes),
      .predicted_before = declared.fit.predicted,
      .mesh_error_share = share,
      .predicted_after = std::move(predicted),
      .reading = search_.model().reading(),
  };
}

Result<Choice> Diagnosis::choose() {
  auto declared = search_.declared();
  if (!declared) return failure(std::move(declared.error()));
  if (search_.leaves_nothing(*declared)) return Choice{*declared, {}, {*declared, {}}};
  std::vector<Candidate> singles;
  auto selected = search_.select(*declared, singles);
  if (!selected) return failure(std::move(selected.error()));
  auto swapped = with_swaps(search_, *declared, std::move(*selected), singles);
  if (!swapped) return failure(std::move(swapped.error()));
  return Choice{std::move(*declared), std::move(singles), std::move(*swapped)};
}

Remainder Diagnosis::remainder(const Choice& choice) const {
  const Candidate& chosen = choice.found.chosen;
  const auto rows = static_cast<double>(chosen.fit.white.size());
  const double rms = std::max(std::sqrt(chosen.fit.chi2 / rows), rms_of_worst_quantity(all_, chosen.fit.white));
  Remainder left{chosen.fit.settings.size(), search_.leaves_nothing(chosen), rms, {}};
  // Several causes together, or one with much freedom, can be bent to what none of them did.
  if (left.effects > 0 && reaches_noise(left, options_)) {
    left.evidence_over_smooth =
        evidence_over_smooth(all_, all_.measured - choice.declared.fit.predicted, all_.measured - chosen.fit.predicted,
                             parameter_count(chosen.fit.settings), search_.correlation(), progress_) -
        search_.cost_of_choice(chosen);
  }
  return left;
}

// An explanation that does not reach the noise is named only where it predicts trials left out much better.
const Candidate& Diagnosis::worth_naming(const Choice& choice, Verdict verdict) const {
  const Candidate& chosen = choice.found.chosen;
  const bool too_little =
      verdict == Verdict::unexplained && search_.folds().any() &&
      std::sqrt(chosen.left_out.chi2) > options_.worth_naming * std::sqrt(choice.declared.left_out.chi2);
  return too_little ? choice.declared : chosen;
}

// The mesh's own error is no effect and is never named; but what of it the measurements show need not spoil what the
// better model predicts. The error before stays that of the declared model as it was solved.
double Diagnosis::mesh_error_share(const Candidate& named) const {
  const Eigen::VectorXd& expected = search_.systematic().expected;
  if (expected.size() == 0) return 0;
  return share_of(expected, all_.measured - named.fit.predicted, all_.noise, all_rows(all_), options_.evidence);
}

// Nothing for a single trial. Trials left out know no more of the mesh's error than the others show.
Result<std::optional<HeldOut>> Diagnosis::held_out(const Candidate& named, double mesh_error_share) const {
  if (!search_.folds().any()) return std::nullopt;
  const auto refitted =
      leave_out_with_refits(search_.model(), named.fit, search_.folds(), options_.evidence, progress_);
  if (!refitted && progress_.cancelled()) return failure(refitted.error());
  if (!refitted && !named.left_out.given) return std::nullopt;
  Eigen::VectorXd predicted = refitted ? refitted->predicted : named.left_out.predicted;
  if (mesh_error_share != 0) {
    const Eigen::VectorXd& expected = search_.systematic().expected;
    for (const CrossValidationFolds::Fold& fold : search_.folds().trials()) {
      const double share =
          share_of(expected, all_.measured - named.fit.predicted, all_.noise, fold.kept.rows(), options_.evidence);
      for (const Eigen::Index row : fold.left_out.rows()) predicted[row] += share * expected[row];
    }
  }
  return held_out_error(all_, predicted, options_.evidence);
}

// Everything that was fitted. Where the declared model left nothing no effect was: each is looked at by itself.
Result<Posterior> Diagnosis::weighed(const Choice& choice) {
  if (search_.model().predicts_quickly() && !choice.singles.empty()) search_.consider_pairs(choice.singles);
  std::vector<LocalFit> considered = search_.considered();
  const auto consider = [&](const Candidate& candidate) {
    if (candidate.fitted()) considered.push_back(local_fit(candidate.fit, search_.whitening()));
  };
  consider(choice.found.chosen);
  for (const std::vector<Candidate>& others : choice.found.in_place)
    for (const Candidate& other : others) consider(other);
  if (choice.singles.empty()) {
    auto alone = search_.each_alone();
    if (!alone) return failure(std::move(alone.error()));
    considered.insert(considered.end(), std::move_iterator(alone->begin()), std::move_iterator(alone->end()));
  }
  return posterior(weighing(), std::move(considered), options_.posterior, progress_);
}

std::vector<Sentence> Diagnosis::notes_on_verdict(const Choice& choice, const Remainder& left) const {
  const Candidate& chosen = choice.found.chosen;
  if (left.effects == 0 && reaches_noise(left, options_) &&
      !residual_diagnostics(all_, chosen.fit.white, chosen.fit.predicted).is_noise) {
    // Rows that are not quite random may still be as small as the noise.
    const bool small = reaches_noise({0, false, left.rms_in_noise, {}}, options_);
    return {{small
                 ? GLISSON_TEXT("The residual is not quite random, but no larger than the noise can be trusted to be.")
                 : GLISSON_TEXT("The residual is not quite random, but no larger than what a finer mesh would change "
                                "of the prediction."),
             {}}};
  }
  if (!left.evidence_over_smooth || verdict_of(left, options_) == Verdict::explained) return {};
  return {{GLISSON_TEXT("What was found brings the residual to the noise, but is no clearly better evidence (BIC {0}) "
                        "than a smooth function of what was done, which names no cause."),
           {fmt::format("{:+.0f}", *left.evidence_over_smooth)}}};
}

std::vector<Sentence> notes_on_ranking(const std::vector<RankedCandidate>& ranking) {
  std::vector<Sentence> notes;
  for (const RankedCandidate& candidate : ranking) {
    if (candidate.failed) notes.push_back({GLISSON_TEXT("{0} was left out: {1}"), {candidate.kind, candidate.removed}});
    if (!candidate.predicts)
      notes.push_back(
          {GLISSON_TEXT("Fitted without one of the trials, {0} has no solution there, or is farther off than "
                        "a prediction of zero: it predicts nothing beyond what it was fitted to."),
           {candidate.kind}});
  }
  return notes;
}

}  // namespace
}  // namespace glisson::closedloop
