#include "closedloop/inference/posterior.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/parallel.h"
#include "closedloop/inference/shaped_rest.h"
#include "closedloop/inference/smooth_rest.h"

namespace glisson::closedloop {
namespace {

using Kinds = std::vector<std::string>;

// A set of effects with its evidence and its share of what was believed; natural logarithms.
struct Weighed {
  LocalFit fit;
  Kinds kinds;
  LogEvidence log;
  double log_prior = 0;
};

bool shows_all(const LocalFit& fit);
std::vector<LocalFit> best_of_each_set(std::vector<LocalFit> considered);
void refine(const Weighing& weighing, std::vector<Weighed>& all, const PosteriorOptions& options,
            const Progress& progress);
void disregard_what_the_mesh_hides(const Weighing& weighing, const Eigen::VectorXd& declared, double of_nothing,
                                   std::vector<Weighed>& all, const PosteriorOptions& options);
// Root mean square by which what is left exceeds the noise, in noises.
double excess(const Observations& observations, const Eigen::VectorXd& predicted);
// Natural logarithms, priors included.
Result<std::vector<double>> weights_of_something_else(const Weighing& weighing, const Eigen::VectorXd& declared,
                                                      const Weighed& leading, double of_nothing,
                                                      const PosteriorOptions& options, const Progress& progress);
Result<std::vector<double>> weights_by_shapes(const Weighing& weighing, const Eigen::MatrixXd& shapes,
                                              const Eigen::VectorXd& declared, const Weighed& leading,
                                              double of_nothing, const PosteriorOptions& options);
LocalFit thinned(LocalFit fit, double share);
double odds_of_look_alike(double evidence_over_nothing, const Kinds& leading, const PosteriorOptions& options);
double root_mean_square(const Eigen::VectorXd& values);

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
  const ForwardModel& model = weighing.model;
  const auto declared = without_fitting(model, {}, weighing.whitening);
  if (!declared) return failure(declared.error());
  considered.push_back(local_fit(*declared, weighing.whitening));
  const Priors priors(model, options);
  std::vector<Weighed> all;
  for (LocalFit& fit : best_of_each_set(std::move(considered))) {
    if (!shows_all(fit)) continue;
    const LogEvidence log = log_evidence(model, fit, weighing.correlation, options);
    if (!std::isfinite(log.evidence)) continue;
    Kinds kinds = kinds_of(fit.settings);
    const double prior = priors.log_of(fit.settings);
    all.push_back({std::move(fit), std::move(kinds), log, prior});
  }
  if (model.predicts_quickly()) refine(weighing, all, options, progress);

  const auto nothing = std::find_if(all.begin(), all.end(), [](const auto& one) { return one.kinds.empty(); });
  const double of_nothing = nothing->log.evidence;
  disregard_what_the_mesh_hides(weighing, declared->predicted, of_nothing, all, options);

  const auto weight = [](const Weighed& one) { return one.log.evidence + one.log_prior; };
  const auto leading =
      std::max_element(all.begin(), all.end(), [&](const auto& a, const auto& b) { return weight(a) < weight(b); });
  auto something_else =
      weights_of_something_else(weighing, declared->predicted, *leading, of_nothing, options, progress);
  if (!something_else) return failure(std::move(something_else.error()));
  if (progress.cancelled()) return cancelled();

  double highest = weight(*leading);
  for (const double log : *something_else) highest = std::max(highest, log);
  std::map<Kinds, double> probabilities;
  double other = 0, beside = 0, sum = 0;
  for (const Weighed& one : all) probabilities[one.kinds] += std::exp(weight(one) - highest);
  for (const auto& [kinds, probability] : probabilities) sum += probability;
  for (const double log : *something_else) other += std::exp(log - highest);
  if (!leading->kinds.empty()) beside = std::exp(something_else->back() - highest);
  other +=
      probabilities[leading->kinds] * odds_of_look_alike(leading->log.evidence - of_nothing, leading->kinds, options);
  sum += other;
  Posterior result;
  for (const auto& [kinds, probability] : probabilities) {
    if (probability / sum < options.worth_telling) continue;
    const Weighed* likeliest = nullptr;  // of its forms
    for (const Weighed& one : all)
      if (one.kinds == kinds && (likeliest == nullptr || weight(one) > weight(*likeliest))) likeliest = &one;
    result.push_back({kinds, false, probability / sum, likeliest->fit});
  }
  if (other / sum >= options.worth_telling) result.push_back({{}, true, other / sum, leading->fit, beside / sum});
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  return result;
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

void refine(const Weighing& weighing, std::vector<Weighed>& all, const PosteriorOptions& options,
            const Progress& progress) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Weighed& one : all) highest = std::max(highest, one.log.evidence);
  parallel_for(all.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (all[i].log.evidence < highest - options.worth_refining) continue;
      all[i].fit = at_maximum(weighing.model, weighing.whitening, std::move(all[i].fit), weighing.correlation, options,
                              progress);
      all[i].log = log_evidence(weighing.model, all[i].fit, weighing.correlation, options);
    }
  });
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

double excess(const Observations& observations, const Eigen::VectorXd& predicted) {
  const double size = root_mean_square((observations.measured - predicted).cwiseQuotient(observations.noise));
  return std::sqrt(std::max(0.0, size * size - 1));
}

// Over the rows that a smooth function rests on, with the leading explanation on the same rows: in place of all causes,
// or at work beside the leading ones, which then have to be there too.
Result<std::vector<double>> weights_of_something_else(const Weighing& weighing, const Eigen::VectorXd& declared,
                                                      const Weighed& leading, double of_nothing,
                                                      const PosteriorOptions& options, const Progress& progress) {
  const ForwardModel& model = weighing.model;
  if (const Eigen::MatrixXd shapes = model.unlisted_shapes(); shapes.size() > 0)
    return weights_by_shapes(weighing, shapes, declared, leading, of_nothing, options);
  const auto smooth = [&](const Eigen::VectorXd& predicted) {
    return smooth_evidence(model.observations(), weighing.systematic, model.observations().measured - predicted,
                           options, progress);
  };
  // What is no larger than the prediction's own error is no sign of anything.
  const auto beside = [&](const SmoothEvidence& rest, const Eigen::VectorXd& predicted) {
    const double better = rest.smooth - rest.noise;
    return excess(model.observations(), predicted) <= weighing.systematic.indistinct ? std::min(0.0, better) : better;
  };
  const double log_prior = std::log(options.something_else), half = std::log(0.5);
  const double log_odds = log_prior - std::log(1 - options.something_else);
  const SmoothEvidence in_place = smooth(declared);
  if (leading.kinds.empty()) return std::vector<double>{log_prior + of_nothing + beside(in_place, declared)};
  const auto predicted = model.predict(leading.fit.settings);
  if (!predicted) return failure(predicted.error());
  const SmoothEvidence rest = smooth(*predicted);
  // What the freedom of its parameters costs on these rows, as that of the smooth function is counted.
  const LogEvidence seen = log_evidence(model, thinned(leading.fit, rest.share_of_rows), weighing.correlation, options);
  return std::vector<double>{
      half + log_prior + leading.log.evidence + (seen.best - seen.evidence) + in_place.smooth - rest.noise,
      half + log_odds + leading.log_prior + leading.log.evidence + beside(rest, *predicted)};
}

// The same over all rows, where the model says what shapes something else may have; and, as likely, that the leading
// explanation is the catalogue's nearest to something that is not in it. What such a likeness leaves is a share of what
// it changes, and a larger one than the mesh's own error.
Result<std::vector<double>> weights_by_shapes(const Weighing& weighing, const Eigen::MatrixXd& shapes,
                                              const Eigen::VectorXd& declared, const Weighed& leading,
                                              double of_nothing, const PosteriorOptions& options) {
  const Observations& observations = weighing.model.observations();
  const ShapedRest rest(observations, weighing.whitening.whiten(shapes), options);
  const auto left = [&](const Eigen::VectorXd& predicted) -> Eigen::VectorXd {
    return weighing.whitening.whiten(observations.measured - predicted);
  };
  const auto shown = [&](double log_odds, const Eigen::VectorXd& predicted) {
    return excess(observations, predicted) <= weighing.systematic.indistinct ? std::min(0.0, log_odds) : log_odds;
  };
  const auto in_noises = [&](const Eigen::VectorXd& values) {
    return root_mean_square(values.cwiseQuotient(observations.noise));
  };
  const Amplitude any{options.smooth_amplitude, options.smooth_amplitude_spread};
  const double log_prior = std::log(options.something_else), half = std::log(0.5);
  const double in_place = rest.log_odds(left(declared), any);
  if (leading.kinds.empty()) return std::vector<double>{log_prior + of_nothing + shown(in_place, declared)};
  const auto predicted = weighing.model.predict(leading.fit.settings);
  if (!predicted) return failure(predicted.error());
  const double change = in_noises(*predicted - declared);
  const double mesh = weighing.systematic.indistinct / std::max(1e-12, in_noises(declared)) * change;
  const double left_over =
      shown(rest.log_odds(left(*predicted), {options.likeness_leaves * change, options.likeness_leaves_spread},
                          {mesh, options.mesh_error_scale}),
            *predicted);
  const double of_leading = leading.log_prior + leading.log.evidence;
  const double log_odds = log_prior - std::log(1 - options.something_else);
  return std::vector<double>{half + log_prior + of_nothing + in_place,
                             std::log(options.likeness) + of_leading + left_over,
                             half + log_odds + of_leading + left_over};
}

// To a share of its rows, evenly from all.
LocalFit thinned(LocalFit fit, double share) {
  fit.chi2 *= share;
  fit.rows = static_cast<Eigen::Index>(std::lround(share * double(fit.rows)));
  fit.downhill *= share;
  fit.information *= share;
  return fit;
}

double odds_of_look_alike(double evidence_over_nothing, const Kinds& leading, const PosteriorOptions& options) {
  if (leading.empty()) return options.too_weak_to_show;
  return options.look_alike * std::min(1.0, options.look_alike_nats / std::max(1e-9, evidence_over_nothing));
}

double root_mean_square(const Eigen::VectorXd& values) {
  return values.norm() / std::sqrt(static_cast<double>(values.size()));
}

}  // namespace
}  // namespace glisson::closedloop
