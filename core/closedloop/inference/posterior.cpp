#include "closedloop/inference/posterior.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "closedloop/inference/internal/log_sum.h"
#include "closedloop/inference/internal/something_else.h"
#include "closedloop/inference/internal/weighed.h"
#include "closedloop/inference/internal/weighed_with_wild.h"

namespace glisson::closedloop {
namespace {

std::vector<Weighed> weighed_sets(const Weighing& weighing, std::vector<LocalFit> considered,
                                  const PosteriorOptions& options, const Progress& progress);
// Each with its evidence whatever the noise is like.
std::vector<Weighed> either_noise(std::vector<Weighed> as_stated, const std::vector<WithWildValues>& wild);
// For that set; nullptr where there is none.
const WithWildValues* better_guess(const std::vector<WithWildValues>& wild, std::size_t set);
Posterior probabilities(const std::vector<Weighed>& all, std::size_t leading, const std::vector<double>& something_else,
                        const PosteriorOptions& options);
bool shows_all(const LocalFit& fit);
std::vector<LocalFit> best_of_each_set(std::vector<LocalFit> considered);
void disregard_what_the_mesh_hides(const Weighing& weighing, const Eigen::VectorXd& declared, double of_nothing,
                                   std::vector<Weighed>& all, const PosteriorOptions& options);
double odds_of_look_alike(double evidence_over_nothing, const Kinds& leading, const PosteriorOptions& options);

// How many kinds there are and how many forms each has say what each set of them may expect.
class Priors {
 public:
  Priors(const ForwardModel& model, const PosteriorOptions& options) : options_(options) {
    for (const Effect& effect : model.catalogue()) forms_[effect.kind] += 1;
  }

  [[nodiscard]] double log_of(const Settings& settings) const {
    if (settings.empty()) return std::log(options_.nothing_missing);
    const double known = 1 - options_.nothing_missing - options_.something_else;
    const double of_number = settings.size() == 1   ? 1 - options_.two_causes - options_.three_causes
                             : settings.size() == 2 ? options_.two_causes
                                                    : options_.three_causes;
    double sets = 1;  // of as many kinds
    for (std::size_t i = 0; i < settings.size(); ++i)
      sets *= std::max(1.0, static_cast<double>(forms_.size()) - double(i)) / double(i + 1);
    double log = std::log(known * of_number / sets);
    for (const Setting& setting : settings) log -= std::log(forms_.at(setting.kind));
    return log;
  }

 private:
  const PosteriorOptions& options_;
  std::map<std::string, double> forms_;
};

}  // namespace

Result<Posterior> posterior(const Weighing& weighing, std::vector<LocalFit> considered, const PosteriorOptions& options,
                            const Progress& progress) {
  const auto declared = without_fitting(weighing.model, {}, weighing.whitening);
  if (!declared) return failure(declared.error());
  considered.push_back(local_fit(*declared, weighing.whitening));
  std::vector<Weighed> as_stated = weighed_sets(weighing, std::move(considered), options, progress);
  disregard_what_the_mesh_hides(weighing, declared->predicted, nothing_of(as_stated).log.evidence, as_stated, options);

  const std::vector<WithWildValues> wild = weighed_with_wild_values(weighing, as_stated, options, progress);
  if (!wild.empty())
    for (Weighed& one : as_stated) one.log.evidence += std::log(1 - options.wild_values);
  const std::vector<Weighed> all = either_noise(as_stated, wild);
  const std::size_t leading = likeliest_of(all);
  auto something_else = weights_of_something_else(weighing, declared->predicted, as_stated[leading],
                                                  nothing_of(as_stated).log.evidence, options, progress);
  if (!something_else) return failure(std::move(something_else.error()));
  if (const WithWildValues* better = better_guess(wild, leading); better != nullptr) {
    const auto with = weights_of_something_else(better->weighing(weighing), declared->predicted, better->all[leading],
                                                nothing_of(better->all).log.evidence, options, progress);
    if (!with) return failure(with.error());
    for (std::size_t i = 0; i < with->size(); ++i) (*something_else)[i] = log_sum({(*something_else)[i], (*with)[i]});
  }
  if (progress.cancelled()) return cancelled();
  return probabilities(all, leading, *something_else, options);
}

std::string name_of(const WeighedExplanation& weighed) {
  if (weighed.something_else) return "something else";
  if (weighed.kinds.empty()) return "nothing is missing";
  std::string name;
  for (const std::string& kind : weighed.kinds) name += (name.empty() ? "" : " and ") + kind;
  return name;
}

namespace {

std::string in_percent(double probability) {
  return fmt::format("{}{:.0f} %",
                     probability > 0.995  ? "> "
                     : probability < 0.01 ? "< "
                                          : "",
                     std::clamp(100 * probability, 1.0, 99.0));
}

}  // namespace

Sentence posterior_sentence(const Explanation& explanation, const NameOfExplanation& name) {
  if (explanation.posterior.empty()) return {};
  const Posterior& all = explanation.posterior;
  const auto called = [&](const WeighedExplanation& weighed) { return name ? name(weighed) : name_of(weighed); };
  const WeighedExplanation& leading = all.front();
  const WeighedExplanation named{kinds_of(explanation.settings)};
  if (explanation.verdict == Verdict::explained && named.kinds != leading.kinds)
    return {GLISSON_TEXT("Probability of {0}, or of what these data cannot tell from it: {1}."),
            {called(named), in_percent(explanation.of_effects)}};
  const bool more = all.size() > 1 && all[1].probability >= 0.01;
  std::vector<std::string> figures{called(leading), in_percent(leading.probability)};
  if (more) figures.insert(figures.end(), {called(all[1]), in_percent(all[1].probability)});
  if (leading.something_else)
    return {more ? GLISSON_TEXT("Probability that something acts which is not in the catalogue: {1}; next comes: "
                                "{2}, {3}.")
                 : GLISSON_TEXT("Probability that something acts which is not in the catalogue: {1}."),
            figures};
  if (leading.kinds.empty())
    return {more ? GLISSON_TEXT("Probability that nothing is missing: {1}; next comes: {2}, {3}.")
                 : GLISSON_TEXT("Probability that nothing is missing: {1}."),
            figures};
  if (explanation.verdict == Verdict::unexplained && more)
    return {GLISSON_TEXT("Nothing is probable enough to be named. Probability of {0}: {1}; next comes: {2}, {3}."),
            figures};
  return {
      more ? GLISSON_TEXT("Probability of {0}: {1}; next comes: {2}, {3}.") : GLISSON_TEXT("Probability of {0}: {1}."),
      figures};
}

std::vector<std::string> kinds_of(const Settings& settings) {
  Kinds kinds;
  for (const Setting& setting : settings) kinds.push_back(setting.kind);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

namespace {

std::vector<Weighed> weighed_sets(const Weighing& weighing, std::vector<LocalFit> considered,
                                  const PosteriorOptions& options, const Progress& progress) {
  const Priors priors(weighing.model, options);
  std::vector<Weighed> all;
  for (LocalFit& fit : best_of_each_set(std::move(considered))) {
    if (!shows_all(fit)) continue;
    const LogEvidence log = log_evidence(weighing.model, fit, weighing.correlation, options);
    if (!std::isfinite(log.evidence)) continue;
    Kinds kinds = kinds_of(fit.settings);
    const double prior = priors.log_of(fit.settings);
    all.push_back({std::move(fit), std::move(kinds), log, prior});
  }
  if (weighing.model.predicts_quickly()) refine(weighing, all, options, progress);
  return all;
}

std::vector<Weighed> either_noise(std::vector<Weighed> as_stated, const std::vector<WithWildValues>& wild) {
  for (std::size_t i = 0; i < as_stated.size(); ++i) {
    const WithWildValues* better = better_guess(wild, i);
    if (better == nullptr) continue;
    Weighed& one = as_stated[i];
    const Weighed& with = better->all[i];
    if (with.log.evidence > one.log.evidence) one.fit = with.fit;
    one.log.evidence = log_sum({one.log.evidence, with.log.evidence});
  }
  return as_stated;
}

const WithWildValues* better_guess(const std::vector<WithWildValues>& wild, std::size_t set) {
  const WithWildValues* better = nullptr;
  for (const WithWildValues& guess : wild) {
    const double evidence = guess.all[set].log.evidence;
    if (std::isfinite(evidence) && (better == nullptr || evidence > better->all[set].log.evidence)) better = &guess;
  }
  return better;
}

Posterior probabilities(const std::vector<Weighed>& all, std::size_t leading, const std::vector<double>& something_else,
                        const PosteriorOptions& options) {
  const Weighed& leader = all[leading];
  double highest = leader.weight();
  for (const double log : something_else) highest = std::max(highest, log);
  std::map<Kinds, double> of_kinds;
  double other = 0, beside = 0, sum = 0;
  for (const Weighed& one : all) of_kinds[one.kinds] += std::exp(one.weight() - highest);
  for (const auto& [kinds, probability] : of_kinds) sum += probability;
  for (const double log : something_else) other += std::exp(log - highest);
  if (!leader.kinds.empty()) beside = std::exp(something_else.back() - highest);
  other += of_kinds[leader.kinds] *
           odds_of_look_alike(leader.log.evidence - nothing_of(all).log.evidence, leader.kinds, options);
  sum += other;
  Posterior result;
  for (const auto& [kinds, probability] : of_kinds) {
    if (probability / sum < options.worth_telling) continue;
    const Weighed* likeliest = nullptr;  // of its forms
    for (const Weighed& one : all)
      if (one.kinds == kinds && (likeliest == nullptr || one.weight() > likeliest->weight())) likeliest = &one;
    result.push_back({kinds, false, probability / sum, likeliest->fit});
  }
  if (other / sum >= options.worth_telling) result.push_back({{}, true, other / sum, leader.fit, beside / sum});
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  return result;
}

// Each of its effects changes something that was measured; of one that does not the data say nothing, and it is not
// weighed.
bool shows_all(const LocalFit& fit) {
  Eigen::Index at = 0;
  for (const Setting& setting : fit.settings) {
    const Eigen::Index count = setting.parameters.size();
    if (count > 0 && fit.information.diagonal().segment(at, count).maxCoeff() <= 0) return false;
    at += count;
  }
  return true;
}

// Of several fits of the same forms the closest.
std::vector<LocalFit> best_of_each_set(std::vector<LocalFit> considered) {
  std::map<std::set<std::pair<std::string, std::string>>, LocalFit> best;
  for (LocalFit& fit : considered) {
    std::set<std::pair<std::string, std::string>> forms;
    for (const Setting& setting : fit.settings) forms.emplace(setting.kind, setting.form);
    const auto [known, is_new] = best.try_emplace(std::move(forms), fit);
    if (!is_new && fit.chi2 < known->second.chi2) known->second = std::move(fit);
  }
  std::vector<LocalFit> fits;
  for (auto& [forms, fit] : best) fits.push_back(std::move(fit));
  return fits;
}

// What lies within the prediction's own error shows nothing: it is no better evidence than the declared model. From the
// best down, to where the rest weighs nothing beside what does show something.
void disregard_what_the_mesh_hides(const Weighing& weighing, const Eigen::VectorXd& declared, double of_nothing,
                                   std::vector<Weighed>& all, const PosteriorOptions& options) {
  const double indistinct = weighing.systematic.indistinct;
  if (!(indistinct > 0)) return;
  const Observations& observations = weighing.model.observations();
  const bool as_the_mesh = excess(observations, declared) <= indistinct;
  const auto changes_more = [&](const Weighed& one) {
    const auto predicted = weighing.model.predict(one.fit.settings);
    return predicted && root_mean_square((*predicted - declared).cwiseQuotient(observations.noise)) > indistinct;
  };
  std::vector<Weighed*> best_first;
  for (Weighed& one : all) best_first.push_back(&one);
  std::stable_sort(best_first.begin(), best_first.end(),
                   [](const Weighed* a, const Weighed* b) { return a->log.evidence > b->log.evidence; });
  double shown = -std::numeric_limits<double>::infinity();
  for (Weighed* one : best_first) {
    if (one->log.evidence <= of_nothing || one->log.evidence < shown - options.worth_refining) break;
    if (!as_the_mesh && changes_more(*one))
      shown = std::max(shown, one->log.evidence);
    else
      one->log.evidence = of_nothing;
  }
}

double odds_of_look_alike(double evidence_over_nothing, const Kinds& leading, const PosteriorOptions& options) {
  if (leading.empty()) return options.too_weak_to_show;
  return options.look_alike * std::min(1.0, options.look_alike_nats / std::max(1e-9, evidence_over_nothing));
}

}  // namespace
}  // namespace glisson::closedloop
