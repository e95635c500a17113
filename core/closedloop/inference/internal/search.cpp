#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "closedloop/inference/internal/search_steps.h"

namespace glisson::closedloop {
namespace {

Settings without_kind(Settings settings, const std::string& kind) {
  std::erase_if(settings, [&](const Setting& setting) { return setting.kind == kind; });
  return settings;
}

bool has_kind(const Settings& settings, const std::string& kind) {
  return std::any_of(settings.begin(), settings.end(), [&](const Setting& setting) { return setting.kind == kind; });
}

// The search's rounding decides nothing: of equals the first of the catalogue is taken.
double rounded(double bic) { return std::round(bic); }

double chi2_of(const Candidate& candidate) {
  return candidate.fitted() ? candidate.fit.chi2 : std::numeric_limits<double>::infinity();
}

}  // namespace

Search::Search(const ForwardModel& model, const DiagnosisOptions& options, const Progress& progress)
    : model_(model),
      options_(options),
      progress_(progress),
      systematic_(model.systematic_uncertainty()),
      whitening_(model.observations().noise, systematic_, all_rows(model.observations())),
      folds_(model, options.evidence),
      left_out_by_zeros_(left_out_by_zeros(model, folds_)) {}

double Search::bic_of(const Candidate& candidate) const {
  return bic(candidate.fit.chi2, candidate.fit.white.size(), parameter_count(candidate.fit.settings), correlation_);
}

double Search::cost_of_choice(const Candidate& candidate) const {
  const auto forms = static_cast<double>(model_.catalogue().size());
  const auto chosen = static_cast<double>(candidate.fit.settings.size());
  return 2 * (std::lgamma(forms + 1) - std::lgamma(chosen + 1) - std::lgamma(forms - chosen + 1));
}

Candidate Search::evaluated(Fit fit) const {
  LeftOut left_out = left_out_of(fit);
  return {{}, {}, std::move(fit), std::move(left_out), {}, false};
}

// To first order; with new fits where that is too far, if they are quick, and where it is off by more than zeros would
// be. What has no solution then, or is as far off as before, predicts nothing.
LeftOut Search::left_out_of(const Fit& fit) const {
  LeftOut left_out = leave_out(model_, fit, folds_);
  if (!folds_.any() || parameter_count(fit.settings) == 0) return left_out;
  const auto says_nothing = [&](const LeftOut& one) { return !(one.chi2 <= left_out_by_zeros_); };
  const bool quick = model_.predicts_quickly() && left_out.chi2 > options_.search.beyond_first_order * fit.chi2;
  const bool astray = says_nothing(left_out);
  if (!quick && !astray) return left_out;
  if (auto refitted = leave_out_with_refits(model_, fit, folds_, options_.evidence, progress_)) {
    left_out = std::move(*refitted);
  } else if (!astray) {
    return left_out;
  }
  if (!model_.predicts_quickly() && says_nothing(left_out))
    return {fit.predicted, std::numeric_limits<double>::infinity(), false};
  return left_out;
}

Result<Candidate> Search::declared() const {
  auto fit = without_fitting(model_, {}, whitening_);
  if (!fit) return failure(std::move(fit.error()));
  return evaluated(std::move(*fit));
}

std::vector<const Effect*> Search::additions(const Settings& active) const {
  std::vector<const Effect*> effects;
  for (const Effect& effect : model_.catalogue()) {
    const bool is_active = std::any_of(active.begin(), active.end(), [&](const Setting& setting) {
      return setting.kind == effect.kind && setting.form == effect.form;
    });
    const bool has_room = active.size() < options_.maximum_effects || has_kind(active, effect.kind);
    if (!is_active && has_room) effects.push_back(&effect);
  }
  return effects;
}

Search::Attempt Search::begin(const Settings& active, const Effect& effect, const Eigen::VectorXd& residual) const {
  Attempt attempt{&effect, {}, 0, {}};
  const Settings others = without_kind(active, effect.kind);
  for (const Start& start : model_.starts(effect, others, residual)) {
    attempt.starts.push_back(others);
    attempt.starts.back().push_back({effect.kind, effect.form, start.values});
    attempt.promise = std::max(attempt.promise, start.promise);
  }
  return attempt;
}

Candidate Search::fit_from(const Attempt& attempt) const {
  const SearchOptions& options = options_.search;
  std::vector<std::pair<double, const Settings*>> starts;
  std::string problem;
  for (const Settings& start : attempt.starts) {
    double chi2 = 0;
    if (attempt.starts.size() > 1) {
      const auto predicted = model_.predict(start);
      if (!predicted) {
        problem = predicted.error().message();
        continue;
      }
      chi2 = whitening_.whiten(model_.observations().measured - *predicted).squaredNorm();
    }
    starts.emplace_back(chi2, &start);
  }
  std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  if (starts.size() > options.searches_per_effect) starts.resize(options.searches_per_effect);

  std::optional<Fit> best;
  for (const auto& [chi2, start] : starts) {
    if (best && best->chi2 < options.hopeless_start * chi2) continue;
    const int iterations = model_.predicts_quickly() ? options.first_iterations_where_quick : options.first_iterations;
    auto fitted = fit(model_, *start, whitening_, {.maximum_iterations = iterations}, progress_);
    if (!fitted) {
      problem = fitted.error().message();
    } else if (!best || fitted->chi2 < best->chi2) {
      best = std::move(*fitted);
    }
  }
  Candidate candidate = best ? evaluated(std::move(*best)) : Candidate{};
  if (!best) {
    candidate.removed = problem.empty() ? GLISSON_TEXT("there is nowhere to begin") : problem;
    candidate.failed = true;
  }
  return candidate;
}

// What a few steps did not bring below `chi2_without`, which it has where it does nothing, is left where it stands.
void Search::finish_near_the_best(std::vector<Candidate>& candidates, double chi2_without) const {
  double best = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : candidates) best = std::min(best, chi2_of(candidate));
  parallel_for(candidates.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress_.cancelled(); ++i) {
      const Candidate& candidate = candidates[i];
      if (candidate.fitted() && !candidate.fit.converged && candidate.fit.chi2 < chi2_without &&
          candidate.fit.chi2 <= options_.search.near_the_best * best)
        finish(candidates[i]);
    }
  });
}

void Search::finish(Candidate& candidate) const {
  auto finished = fit(model_, candidate.fit.settings, whitening_, {}, progress_);
  if (!finished) return;
  Candidate better = evaluated(std::move(*finished));
  better.kind = candidate.kind;
  better.form = candidate.form;
  candidate = std::move(better);
}

// In three rounds: what is quick, or promises about as much as the best; then the slow forms of kinds that did well;
// then those near the best are fitted to the end.
Result<std::vector<Candidate>> Search::fit_each(const Settings& active, const std::vector<const Effect*>& effects,
                                                const Progress& progress) const {
  const auto predicted = model_.predict(active);
  if (!predicted) return failure(predicted.error());
  const Eigen::VectorXd residual = model_.observations().measured - *predicted;
  const double square = plain_square(*predicted);
  std::vector<Candidate> candidates(effects.size());
  std::vector<Attempt> attempts(effects.size());
  std::atomic<std::size_t> done = 0;
  const auto each = [&](const auto& wanted, const auto& act) {
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < effects.size(); ++i) {
      if (wanted(i)) which.push_back(i);
    }
    parallel_for(which.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress_.cancelled(); ++i) act(which[i]);
    });
  };
  const auto try_one = [&](std::size_t i) {
    candidates[i] = fit_from(attempts[i]);
    candidates[i].kind = effects[i]->kind;
    candidates[i].form = effects[i]->form;
    progress.report(static_cast<double>(++done) / static_cast<double>(effects.size()), GLISSON_TEXT("trying effects"));
  };
  const auto is_fitted = [&](std::size_t i) { return candidates[i].fit.predicted.size() > 0; };
  const auto maximum_taken = [&] {
    double maximum = 0;
    for (std::size_t i = 0; i < effects.size(); ++i) {
      if (is_fitted(i)) maximum = std::max(maximum, square - plain_square(candidates[i].fit.predicted));
    }
    return maximum;
  };

  for (std::size_t i = 0; i < effects.size(); ++i) {
    candidates[i].kind = effects[i]->kind;
    candidates[i].form = effects[i]->form;
    candidates[i].removed = GLISSON_TEXT("it promised to take much less of the error than others");
  }
  each([&](std::size_t i) { return !effects[i]->late; },
       [&](std::size_t i) { attempts[i] = begin(active, *effects[i], residual); });
  each([&](std::size_t i) { return !effects[i]->late && std::isinf(attempts[i].promise); }, try_one);
  double worth_trying = maximum_taken();
  for (const Attempt& attempt : attempts) {
    if (std::isfinite(attempt.promise)) worth_trying = std::max(worth_trying, attempt.promise);
  }
  worth_trying *= options_.search.minimum_promise;
  if (!active.empty()) {
    worth_trying = std::max(worth_trying, options_.search.promise_over_mesh_error * indistinct() * indistinct() *
                                              static_cast<double>(residual.size()));
  }
  if (active.size() >= 2)
    worth_trying = std::max(
        worth_trying, options_.search.promise_of_third_effect() * (square - static_cast<double>(residual.size())));
  each(
      [&](std::size_t i) {
        return !effects[i]->late && std::isfinite(attempts[i].promise) && attempts[i].promise >= worth_trying;
      },
      try_one);
  if (progress_.cancelled()) return cancelled();

  const double did_well = options_.search.promise_for_slow_form * maximum_taken();
  const auto kind_did_well = [&](const Effect& effect) {
    for (std::size_t i = 0; i < effects.size(); ++i) {
      if (effects[i]->kind == effect.kind && is_fitted(i) &&
          square - plain_square(candidates[i].fit.predicted) >= did_well)
        return true;
    }
    return has_kind(active, effect.kind);
  };
  std::vector<bool> of_good_kind;
  for (const Effect* effect : effects) of_good_kind.push_back(effect->late && kind_did_well(*effect));
  each([&](std::size_t i) { return of_good_kind[i]; },
       [&](std::size_t i) {
         attempts[i] = begin(active, *effects[i], residual);
         try_one(i);
       });
  finish_near_the_best(candidates, model_.predicts_quickly() ? std::numeric_limits<double>::infinity()
                                                             : whitening_.whiten(residual).squaredNorm());
  if (progress_.cancelled()) return cancelled();
  return candidates;
}

double Search::plain_square(const Eigen::VectorXd& predicted) const {
  const Observations& all = model_.observations();
  return (all.measured - predicted).cwiseQuotient(all.noise).squaredNorm();
}

double Search::excess(const Candidate& candidate) const {
  const double mean_square =
      plain_square(candidate.fit.predicted) / static_cast<double>(candidate.fit.predicted.size());
  return std::sqrt(std::max(0.0, mean_square - 1));
}

bool Search::leaves_nothing(const Candidate& candidate) const {
  return residual_diagnostics(model_.observations(), candidate.fit.white, candidate.fit.predicted).is_noise ||
         excess(candidate) <= indistinct();
}

// It lowers the plain error, on what was fitted and on what was left out, and by more than the prediction's own error
// might.
bool Search::shows(const Candidate& candidate, const Candidate& current) const {
  const auto rows = static_cast<double>(candidate.fit.predicted.size());
  const double change =
      (candidate.fit.predicted - current.fit.predicted).cwiseQuotient(model_.observations().noise).norm();
  return change > indistinct() * std::sqrt(rows) &&
         plain_square(candidate.fit.predicted) < plain_square(current.fit.predicted) && candidate.left_out.given &&
         plain_square(candidate.left_out.predicted) < plain_square(current.left_out.predicted);
}

// On trials left out one by one.
bool Search::predicts_better(const Candidate& candidate, const Candidate& current) const {
  if (!folds_.any()) return true;
  const double variance = std::max(1.0, candidate.fit.chi2 / static_cast<double>(candidate.fit.white.size()));
  return candidate.left_out.chi2 < current.left_out.chi2 - options_.search.gain_beyond_luck * variance * correlation_;
}

// On them and on those under the largest load, together: while other effects are still missing, one alone may reach
// less far than none, and yet be right.
bool Search::pays_beyond(const Candidate& candidate, const Candidate& current) const {
  const auto with = largest_load_chi2(model_, candidate.fit, folds_, options_.evidence, progress_);
  const auto without = largest_load_chi2(model_, current.fit, folds_, options_.evidence, progress_);
  return !with || !without || candidate.left_out.chi2 + *with < current.left_out.chi2 + *without;
}

// The size of an effect, its first parameter, at the end of its range: the search wanted something that the effect
// cannot be. (An end that means no effect does not pay by BIC.)
bool Search::ran_out_of_range(const Setting& setting) const {
  if (setting.parameters.size() == 0) return false;
  const Effect& effect = *effect_of(model_, setting);
  const Parameter& parameter = effect.parameters.front();
  const double size = setting.parameters[0];
  const double close = options_.search.end_of_range;
  const double margin = close * (parameter.upper - parameter.lower);
  const bool at_lower_end = size < parameter.lower * (1 + close) + margin * (parameter.scale == Scale::linear);
  return (at_lower_end && !effect.lower_end_may_be) || size > parameter.upper - margin;
}

bool Search::ran_out_of_range(const Candidate& candidate) const {
  return std::any_of(candidate.fit.settings.begin(), candidate.fit.settings.end(), [&](const Setting& setting) {
    return setting.kind == candidate.kind && ran_out_of_range(setting);
  });
}

// While effects are still missing, what is left is no noise and says nothing of how noise repeats itself; so the steps
// forward take the stated noise at its word. What they leave shows it, and then each effect must still pay.
Result<Candidate> Search::select(const Candidate& declared, std::vector<Candidate>& singles) {
  auto chosen = forward(declared, &singles);
  if (!chosen) return chosen;
  if (model_.predicts_quickly() && (!leaves_nothing(*chosen) || chosen->fit.settings.size() > 2)) {
    chosen = with_best_pair(std::move(*chosen), declared, singles);
    if (!chosen) return chosen;
  }
  correlation_ = correlation_length(model_.observations(), chosen->fit.white);
  return backward(std::move(*chosen));
}

Result<Candidate> Search::forward(Candidate current, std::vector<Candidate>* singles) {
  const double at_first = excess(current);
  for (std::size_t step = 0; step < 2 * options_.maximum_effects; ++step) {
    const bool in_vain =
        current.fit.settings.size() >= 2 && excess(current) > options_.search.excess_worth_a_third_effect * at_first;
    if (in_vain && !model_.predicts_quickly()) return current;
    const double begin = std::min(0.9, 0.3 * static_cast<double>(step));
    auto candidates = fit_each(current.fit.settings, additions(current.fit.settings),
                               progress_.part(begin, std::min(0.95, begin + 0.3)));
    if (!candidates) return failure(std::move(candidates.error()));
    if (step == 0 && singles != nullptr) *singles = *candidates;
    consider(*candidates);
    std::erase_if(*candidates, [](const Candidate& candidate) { return !candidate.fitted(); });
    if (candidates->empty()) return current;
    std::erase_if(*candidates, [&](const Candidate& candidate) {
      return bic_of(candidate) >= bic_of(current) - options_.entry_bic || ran_out_of_range(candidate) ||
             !shows(candidate, current) || !predicts_better(candidate, current);
    });
    std::stable_sort(candidates->begin(), candidates->end(),
                     [this](const auto& a, const auto& b) { return rounded(bic_of(a)) < rounded(bic_of(b)); });
    const auto next = std::find_if(candidates->begin(), candidates->end(),
                                   [&](const Candidate& candidate) { return pays_beyond(candidate, current); });
    if (next == candidates->end()) return current;
    auto checked = backward(std::move(*next));
    if (!checked) return checked;
    if (current.fit.settings.size() >= 2 &&
        excess(*checked) > options_.search.excess_after_third_effect * excess(current) && !leaves_nothing(*checked))
      return current;
    current = std::move(*checked);
    if (leaves_nothing(current)) return current;
  }
  return current;
}

void Search::consider(const std::vector<Candidate>& candidates) {
  for (const Candidate& candidate : candidates)
    if (candidate.fitted() && candidate.left_out.given) considered_.push_back(local_fit(candidate.fit, whitening_));
}

Result<std::vector<LocalFit>> Search::each_alone() const {
  std::vector<LocalFit> alone;
  if (model_.predicts_quickly()) {
    auto fitted = fit_each({}, additions({}), progress_);
    if (!fitted) return failure(std::move(fitted.error()));
    for (const Candidate& candidate : *fitted)
      if (candidate.fitted()) alone.push_back(local_fit(candidate.fit, whitening_));
    return alone;
  }
  const auto predicted = model_.predict({});
  if (!predicted) return failure(predicted.error());
  const Eigen::VectorXd residual = model_.observations().measured - *predicted;
  for (const Effect* effect : additions({})) {
    if (progress_.cancelled()) return cancelled();
    if (effect->late) continue;
    const Attempt attempt = begin({}, *effect, residual);
    if (attempt.starts.empty()) continue;
    if (const auto there = without_fitting(model_, attempt.starts.front(), whitening_))
      alone.push_back(local_fit(*there, whitening_));
  }
  return alone;
}

Result<Candidate> Search::without(const Candidate& chosen, std::size_t which) const {
  Settings settings = chosen.fit.settings;
  settings.erase(settings.begin() + static_cast<std::ptrdiff_t>(which));
  return fitted(settings);
}

Result<Candidate> Search::fitted(const Settings& settings) const {
  auto found = fit(model_, settings, whitening_, {}, progress_);
  if (!found) return failure(std::move(found.error()));
  return evaluated(std::move(*found));
}

// Effects that do not pay any more, now that others are there, leave. Where what is left repeats itself from row to
// row, few rows count and hardly anything pays; trials are still independent of each other, and what they need stays.
Result<Candidate> Search::backward(Candidate chosen) const {
  for (std::size_t which = 0; which < chosen.fit.settings.size();) {
    auto smaller = without(chosen, which);
    if (!smaller) {
      if (progress_.cancelled()) return cancelled();
      ++which;
    } else if (bic_of(*smaller) < bic_of(chosen) + options_.search.exit_bic_share * options_.entry_bic &&
               smaller->left_out.chi2 < options_.search.clearly_worse_left_out * chosen.left_out.chi2) {
      chosen = std::move(*smaller);
      which = 0;
    } else {
      ++which;
    }
  }
  return chosen;
}

Result<std::vector<Candidate>> Search::in_place_of(const Candidate& chosen, std::size_t which) const {
  Settings others = chosen.fit.settings;
  const Setting replaced = others[which];
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(which));
  std::vector<const Effect*> effects;
  for (const Effect& effect : model_.catalogue()) {
    const bool same = effect.kind == replaced.kind && effect.form == replaced.form;
    if (!same && !has_kind(others, effect.kind)) effects.push_back(&effect);
  }
  auto candidates = fit_each(others, effects, {});
  if (candidates) {
    std::erase_if(*candidates,
                  [&](const Candidate& candidate) { return !candidate.fitted() || ran_out_of_range(candidate); });
  }
  return candidates;
}

}  // namespace glisson::closedloop
