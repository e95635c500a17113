// Two effects fitted afresh together, where steps taken one after the other do not reach the noise.

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "closedloop/inference/internal/search_steps.h"

namespace glisson::closedloop {
namespace {

// Where the fits of a form begin, and where the fit of it alone ended.
std::vector<Setting> beginnings_of(const ForwardModel& model, const Candidate& alone) {
  const Setting& ended = alone.fit.settings.front();
  std::vector<Setting> settings{ended};
  for (const Eigen::VectorXd& start : effect_of(model, ended)->starts)
    settings.push_back({ended.kind, ended.form, start});
  return settings;
}

// Of each kind the forms that did best alone and the first of the catalogue, for what does nothing alone may do so in
// company (friction in a specimen that is softer than declared).
std::vector<const Candidate*> forms_to_pair(const std::vector<Candidate>& singles, std::size_t of_a_kind) {
  std::vector<const Candidate*> by_chi2;
  for (const Candidate& single : singles) {
    if (single.fitted() && single.fit.settings.size() == 1) by_chi2.push_back(&single);
  }
  std::vector<const Candidate*> forms;
  std::map<std::string, std::size_t> taken;
  const auto take = [&] {
    taken.clear();
    for (const Candidate* form : by_chi2) {
      if (++taken[form->kind] <= of_a_kind && std::count(forms.begin(), forms.end(), form) == 0) forms.push_back(form);
    }
  };
  take();
  std::stable_sort(by_chi2.begin(), by_chi2.end(),
                   [](const auto* a, const auto* b) { return a->fit.chi2 < b->fit.chi2; });
  take();
  return forms;
}

std::string name_of_form(const Setting& setting) { return setting.kind + "/" + setting.form; }

}  // namespace

// What fits best alone need not be there at all, and a step that took it does not come back. So where the steps leave
// something, or took three, two effects are fitted afresh together; the best two lead if they are better evidence, and
// the steps go on from them.
Result<Candidate> Search::with_best_pair(Candidate chosen, const Candidate& declared,
                                         const std::vector<Candidate>& singles) {
  std::vector<Candidate> pairs = pairs_of(singles);
  if (progress_.cancelled()) return cancelled();
  consider(pairs);
  pairs_considered_ = true;
  const auto weight = [this](const Candidate& candidate) { return bic_of(candidate) + cost_of_choice(candidate); };
  std::erase_if(pairs, [&](const Candidate& pair) {
    return !pair.fitted() || !shows(pair, declared) || !predicts_better(pair, declared) ||
           std::any_of(pair.fit.settings.begin(), pair.fit.settings.end(),
                       [&](const Setting& setting) { return ran_out_of_range(setting); });
  });
  std::stable_sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) { return weight(a) < weight(b); });
  const auto best = std::find_if(pairs.begin(), pairs.end(),
                                 [&](const Candidate& candidate) { return pays_beyond(candidate, declared); });
  if (best == pairs.end()) return chosen;
  const bool fewer = best->fit.settings.size() < chosen.fit.settings.size();
  if (weight(*best) > weight(chosen) - (fewer ? 0 : options_.entry_bic) ||
      leaves_nothing(chosen) > leaves_nothing(*best))
    return chosen;
  auto checked = backward(std::move(*best));
  if (!checked || leaves_nothing(*checked)) return checked;
  return forward(std::move(*checked), nullptr);
}

// What two kinds do together the data may show where one of them seems to be enough, so that a posterior weighs all
// pairs: those of the steps' forms, and every form of the best kinds.
void Search::consider_pairs(const std::vector<Candidate>& singles) {
  if (!pairs_considered_) consider(pairs_of(singles));
  constexpr std::size_t other_forms_of = 3;
  std::vector<const LocalFit*> pairs;
  for (const LocalFit& fit : considered_)
    if (fit.settings.size() == 2) pairs.push_back(&fit);
  const auto weight = [this](const LocalFit* fit) {
    return bic(fit->chi2, fit->rows, parameter_count(fit->settings), correlation_);
  };
  std::stable_sort(pairs.begin(), pairs.end(), [&](auto* a, auto* b) { return weight(a) < weight(b); });
  std::set<std::set<std::string>> best;
  for (const LocalFit* pair : pairs)
    if (best.size() < other_forms_of) best.insert({pair->settings[0].kind, pair->settings[1].kind});
  std::set<std::set<std::string>> known;
  for (const LocalFit* pair : pairs) known.insert({name_of_form(pair->settings[0]), name_of_form(pair->settings[1])});
  std::vector<std::pair<const Candidate*, const Candidate*>> missing;
  for (std::size_t b = 1; b < singles.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!singles[a].fitted() || !singles[b].fitted() || singles[a].kind == singles[b].kind) continue;
      if (best.count({singles[a].kind, singles[b].kind}) == 0) continue;
      if (known.count({name_of_form(singles[a].fit.settings.front()), name_of_form(singles[b].fit.settings.front())}) ==
          0)
        missing.emplace_back(&singles[a], &singles[b]);
    }
  }
  consider(fit_together(missing));
}

// Each two of different kinds.
std::vector<Candidate> Search::pairs_of(const std::vector<Candidate>& singles) const {
  const std::vector<const Candidate*> forms = forms_to_pair(singles, options_.search.forms_per_kind_in_pairs);
  std::vector<std::pair<const Candidate*, const Candidate*>> pairs;
  for (std::size_t b = 1; b < forms.size(); ++b)
    for (std::size_t a = 0; a < b; ++a)
      if (forms[a]->kind != forms[b]->kind) pairs.emplace_back(forms[a], forms[b]);
  return fit_together(pairs);
}

// From where each began or ended alone.
std::vector<Candidate> Search::fit_together(
    const std::vector<std::pair<const Candidate*, const Candidate*>>& together) const {
  std::vector<Attempt> attempts;
  for (const auto& [first, second] : together) {
    Attempt attempt{effect_of(model_, second->fit.settings.front()), {}, 0, {}};
    for (const Setting& one : beginnings_of(model_, *first)) {
      for (const Setting& other : beginnings_of(model_, *second)) attempt.starts.push_back({one, other});
    }
    attempts.push_back(std::move(attempt));
  }
  std::vector<Candidate> pairs(attempts.size());
  parallel_for(attempts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress_.cancelled(); ++i) {
      pairs[i] = fit_from(attempts[i]);
      pairs[i].kind = attempts[i].effect->kind;
      pairs[i].form = attempts[i].effect->form;
    }
  });
  finish_near_the_best(pairs, std::numeric_limits<double>::infinity());
  return pairs;
}

}  // namespace glisson::closedloop
