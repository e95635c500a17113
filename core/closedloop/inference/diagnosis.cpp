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
  [[nodiscard]] Result<Posterior> weighed(const Choice& choice);
  [[nodiscard]] Result<Swapped> likeliest_causes(const Choice& choice, const Posterior& posterior) const;
  [[nodiscard]] bool is_near_noise(const Candidate& candidate, double excess) const;
  [[nodiscard]] NamedCauses named_causes(const Swapped& causes) const;
  [[nodiscard]] double probability_of_causes(const Swapped& causes, const Choice& choice,
                                             const Posterior& posterior) const;
  [[nodiscard]] const Candidate& worth_naming(const Candidate& causes, const Candidate& declared,
                                              Verdict verdict) const;
  [[nodiscard]] double mesh_error_share(const Candidate& named) const;
  [[nodiscard]] Result<std::optional<HeldOut>> held_out(const Candidate& named, double mesh_error_share) const;
  [[nodiscard]] Weighing weighing() const {
    return {search_.model(), search_.systematic(), search_.whitening(), search_.correlation()};
  }
  [[nodiscard]] std::vector<Sentence> notes_on_nothing(const Candidate& declared) const;

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
  auto probabilities = weighed(*choice);
  if (!probabilities) return failure(std::move(probabilities.error()));
  const auto causes = likeliest_causes(*choice, *probabilities);
  if (!causes) return failure(causes.error());
  const double of_causes = probability_of_causes(*causes, *choice, *probabilities);
  const Verdict verdict = verdict_of(*probabilities, of_causes, options_.costs);
  const Candidate& named = worth_naming(causes->chosen, declared, verdict);

  const auto smooth = verdict == Verdict::unexplained
                          ? fit_smooth_correction(all_, all_.measured - named.fit.predicted, progress_)
                          : std::nullopt;
  const double share = smooth ? 0 : mesh_error_share(named);
  Eigen::VectorXd predicted = named.fit.predicted;
  if (share != 0) predicted += share * search_.systematic().expected;
  const ErrorFigures after = error_figures(all_, predicted);
  const auto left_out = held_out(named, share);
  if (!left_out) return failure(left_out.error());
  auto found = found_effects(search_, declared, named, causes->in_place,
                             *left_out ? std::optional((*left_out)->rms) : std::nullopt, after.rms);
  if (!found) return failure(std::move(found.error()));
  std::vector<RankedCandidate> alone = ranking(search_, declared, choice->singles);

  std::vector<Sentence> notes = search_.model().remarks();
  if (const auto times = impossible_noise(all_, all_.measured - named.fit.predicted))
    notes.push_back({GLISSON_TEXT("From one measurement to the next the values scatter {0} times as much as the stated "
                                  "noise, which cannot be right: state it anew and ask again."),
                     {fmt::format("{:.2g}", *times)}});
  append(notes, notes_on_ranking(alone));
  if (verdict == Verdict::nothing_missing) append(notes, notes_on_nothing(declared));
  if (share != 0)
    notes.push_back(
        {GLISSON_TEXT("A finer mesh would change the prediction; {0} % of what it would change shows in the "
                      "measurements and is taken off what the better model predicts."),
         {fmt::format("{:.0f}", 100 * share)}});
  append(notes, std::move(found->notes));
  if (!search_.folds().any())
    notes.push_back({GLISSON_TEXT("There is only one trial, so nothing could be predicted that was not fitted."), {}});
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
      .smooth_correction = smooth ? std::optional(smooth->smooth) : std::nullopt,
      .held_out_corrected =
          smooth ? std::optional(held_out_error(all_, named.left_out.predicted + smooth->held_out, options_.evidence))
                 : std::nullopt,
      .hidden_targets = {},  // whoever knows them judges by them (explain.cpp)
      .next = *std::move(next),
      .posterior = *std::move(probabilities),
      .of_effects = named.fit.settings.empty() ? 0 : of_causes,
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

// Those that the search chose, where these are they or cannot be told from them: of what the data cannot tell apart it
// chose the plainest. Or where none is probable enough to be named. Else they are fitted to the end.
Result<Swapped> Diagnosis::likeliest_causes(const Choice& choice, const Posterior& posterior) const {
  const auto known =
      std::find_if(posterior.begin(), posterior.end(), [](const auto& one) { return !one.fit.settings.empty(); });
  double of_all = 0;
  for (const WeighedExplanation& one : posterior) of_all += one.kinds.empty() ? one.beside : one.probability;
  if (known == posterior.end() || verdict_of(posterior, of_all, options_.costs) != Verdict::explained)
    return choice.found;
  if (stand_for(named_causes(choice.found), kinds_of(known->fit.settings))) return choice.found;
  auto fitted = search_.fitted(known->fit.settings);
  if (!fitted) return failure(std::move(fitted.error()));
  return with_alternatives(search_, *std::move(fitted), choice.singles);
}

// What predicts trials that were left out no better than the declared model does explains nothing, and what leaves more
// than roughly stated noise explains not all.
double Diagnosis::probability_of_causes(const Swapped& causes, const Choice& choice, const Posterior& posterior) const {
  const Candidate& candidate = causes.chosen;
  if (candidate.fit.settings.empty()) return 0;
  if (search_.folds().any() && (!candidate.left_out.given || candidate.left_out.chi2 >= choice.declared.left_out.chi2))
    return 0;
  if (!is_near_noise(candidate, options_.maximum_noise_excess)) return 0;
  const NamedCauses named = named_causes(causes);
  double probability = probability_of(posterior, named);
  if (!is_near_noise(candidate, options_.near_noise_excess / double(named.kinds.size()))) return probability;
  for (const WeighedExplanation& one : posterior)
    if (one.beside > 0 && stand_for(named, kinds_of(one.fit.settings))) probability += one.beside;
  return probability;
}

// All of it, and each quantity by itself.
bool Diagnosis::is_near_noise(const Candidate& candidate, double excess) const {
  const double rms = std::sqrt(candidate.fit.chi2 / static_cast<double>(candidate.fit.white.size()));
  return search_.leaves_nothing(candidate) ||
         std::max(rms, rms_of_worst_quantity(all_, candidate.fit.white)) <= 1 + excess;
}

NamedCauses Diagnosis::named_causes(const Swapped& causes) const {
  NamedCauses named{{}, alike_kinds(search_, causes.chosen, causes.in_place)};
  for (const Setting& setting : causes.chosen.fit.settings) named.kinds.push_back(setting.kind);
  return named;
}

// An explanation that is not probable enough is named only where it predicts trials left out much better.
const Candidate& Diagnosis::worth_naming(const Candidate& causes, const Candidate& declared, Verdict verdict) const {
  if (verdict == Verdict::nothing_missing) return declared;
  const bool too_little = verdict == Verdict::unexplained && search_.folds().any() &&
                          std::sqrt(causes.left_out.chi2) > options_.worth_naming * std::sqrt(declared.left_out.chi2);
  return too_little ? declared : causes;
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
    if (candidate.fitted() && candidate.left_out.given)
      considered.push_back(local_fit(candidate.fit, search_.whitening()));
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

// Rows that are not quite random may still be as small as the noise, or be no sign of an effect.
std::vector<Sentence> Diagnosis::notes_on_nothing(const Candidate& declared) const {
  if (residual_diagnostics(all_, declared.fit.white, declared.fit.predicted).is_noise) return {};
  if (declared.fit.white.squaredNorm() <= noise_is_known_to * noise_is_known_to * double(all_.rows()))
    return {{GLISSON_TEXT("The residual is not quite random, but no larger than the noise can be trusted to be."), {}}};
  if (search_.leaves_nothing(declared))
    return {{GLISSON_TEXT("The residual is not quite random, but no larger than what a finer mesh would change "
                          "of the prediction."),
             {}}};
  return {{GLISSON_TEXT("The residual is larger than the stated noise, but has no shape that speaks of an effect: the "
                        "noise may be stated too small, or some rows are outliers."),
           {}}};
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
