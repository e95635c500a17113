#include "closedloop/inference/internal/found_effects.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace glisson::closedloop {
namespace {

struct FoundParameters {
  std::vector<std::vector<FoundParameter>> of_setting;
  std::vector<Sentence> notes;
};
FoundParameters found_parameters(const Search& search, const Candidate& chosen);

}  // namespace

Result<FoundEffects> found_effects(const Search& search, const Candidate& declared, const Candidate& chosen,
                                   const std::vector<std::vector<Candidate>>& in_place,
                                   const std::optional<double>& held_out_rms, double rms) {
  const Observations& all = search.model().observations();
  FoundParameters parameters = found_parameters(search, chosen);
  std::vector<std::vector<std::string>> alike = alike_kinds(search, chosen, in_place);
  FoundEffects found{{}, std::move(parameters.notes)};
  for (std::size_t which = 0; which < chosen.fit.settings.size(); ++which) {
    const Setting& setting = chosen.fit.settings[which];
    const auto smaller = chosen.fit.settings.size() == 1 ? Result<Candidate>(declared) : search.without(chosen, which);
    if (!smaller) return failure(smaller.error());
    FoundEffect effect;
    effect.kind = setting.kind;
    effect.form = setting.form;
    effect.sentence = effect_of(search.model(), setting)->sentence;
    effect.parameters = std::move(parameters.of_setting[which]);
    effect.delta_bic = search.bic_of(chosen) - search.bic_of(*smaller);
    effect.held_out_rms = held_out_rms;
    if (search.folds().any() && smaller->left_out.given)
      effect.held_out_rms_without = error_figures(all, smaller->left_out.predicted).rms;
    effect.removed_rms = error_figures(all, smaller->fit.predicted).rms - rms;
    effect.alike = std::move(alike[which]);
    found.effects.push_back(std::move(effect));
  }
  std::stable_sort(found.effects.begin(), found.effects.end(),
                   [](const auto& a, const auto& b) { return a.removed_rms > b.removed_rms; });
  return found;
}

std::vector<std::vector<std::string>> alike_kinds(const Search& search, const Candidate& chosen,
                                                  const std::vector<std::vector<Candidate>>& in_place) {
  std::vector<std::vector<std::string>> alike(chosen.fit.settings.size());
  const double limit = search.bic_of(chosen) + search.options().alike_bic;
  for (std::size_t which = 0; which < alike.size(); ++which) {
    for (const Candidate& other : in_place[which]) {
      const bool known = other.kind == chosen.fit.settings[which].kind ||
                         std::count(alike[which].begin(), alike[which].end(), other.kind) > 0;
      if (!known && other.left_out.given && search.bic_of(other) < limit) alike[which].push_back(other.kind);
    }
  }
  return alike;
}

std::vector<RankedCandidate> ranking(const Search& search, const Candidate& declared,
                                     const std::vector<Candidate>& singles) {
  const Observations& all = search.model().observations();
  std::vector<RankedCandidate> ranking;
  for (const Candidate& single : singles) {
    RankedCandidate candidate{single.kind, single.form,    single.fit.settings, 0, {}, 0,
                              {},          single.removed, single.failed};
    if (single.fitted()) {
      candidate.rms = error_figures(all, single.fit.predicted).rms;
      candidate.delta_bic = search.bic_of(single) - search.bic_of(declared);
      candidate.predicts = single.left_out.given;
      if (search.folds().any() && single.left_out.given)
        candidate.held_out_rms = error_figures(all, single.left_out.predicted).rms;
    }
    const auto same =
        std::find_if(ranking.begin(), ranking.end(), [&](const auto& s) { return s.kind == single.kind; });
    if (same == ranking.end()) {
      ranking.push_back(std::move(candidate));
    } else if (candidate.removed.empty() && (!same->removed.empty() || candidate.delta_bic < same->delta_bic)) {
      *same = std::move(candidate);
    }
  }
  std::stable_sort(ranking.begin(), ranking.end(), [](const RankedCandidate& a, const RankedCandidate& b) {
    return std::pair(!a.removed.empty(), a.delta_bic) < std::pair(!b.removed.empty(), b.delta_bic);
  });
  const auto stands = [](const RankedCandidate& one) { return one.removed.empty() && one.predicts; };
  for (RankedCandidate& candidate : ranking) {
    for (const RankedCandidate& other : ranking) {
      if (&other != &candidate && stands(candidate) && stands(other) &&
          std::abs(other.delta_bic - candidate.delta_bic) < search.options().alike_bic)
        candidate.alike.push_back(other.kind);
    }
  }
  return ranking;
}

namespace {

std::vector<Sentence> hardly_told_apart(const Settings& settings, const Eigen::MatrixXd& covariance,
                                        double inseparable);

// Value, standard deviation and interval: from the noise, or, where trials are many and scatter more, from them.
FoundParameter found_parameter(const Parameter& parameter, double value, double std,
                               const Eigen::MatrixXd::ConstRowXpr& samples, bool enough_trials) {
  FoundParameter found{parameter, value, std, value - 1.96 * std, value + 1.96 * std, true};
  const double mean = samples.mean();
  const double resampled = std::sqrt((samples.array() - mean).square().mean());
  if (enough_trials && resampled > std) {
    found.std = resampled;
    std::vector<double> sorted(samples.begin(), samples.end());
    std::sort(sorted.begin(), sorted.end());
    found.low = sorted[sorted.size() / 40];
    found.high = sorted[sorted.size() - 1 - sorted.size() / 40];
  }
  found.low = std::max(found.low, parameter.lower);
  found.high = std::min(found.high, parameter.upper);
  return found;
}

bool at_end_of_range(const Parameter& parameter, double value, double close) {
  const double margin = close * (parameter.upper - parameter.lower);
  return value > parameter.upper - margin ||
         (parameter.scale == Scale::logarithmic ? value < (1 + close) * parameter.lower
                                                : value < parameter.lower + margin);
}

FoundParameters found_parameters(const Search& search, const Candidate& chosen) {
  const Settings& settings = chosen.fit.settings;
  FoundParameters found;
  found.of_setting.resize(settings.size());
  if (parameter_count(settings) == 0) return found;
  const ForwardModel& model = search.model();
  const DiagnosisOptions& options = search.options();
  const ParameterRanges ranges = ranges_of(model, settings);
  const double excess = std::max(1.0, chosen.fit.chi2 / double(chosen.fit.white.size())) * search.correlation();
  const Eigen::MatrixXd covariance_of_noise =
      covariance(search.whitening().whiten(chosen.fit.derivatives) / std::sqrt(excess), ranges.prior_width);
  const Eigen::MatrixXd samples = bootstrapped_parameters(model, chosen.fit, search.whitening(), options.evidence);
  const Eigen::VectorXd values = values_of(settings);
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Effect& effect = *effect_of(model, settings[i]);
    for (const Parameter& parameter : effect.parameters) {
      FoundParameter one =
          found_parameter(parameter, values[at], std::sqrt(covariance_of_noise(at, at)), samples.row(at),
                          model.observations().trial_count() >= options.trials_to_resample);
      one.determined = one.std < options.undetermined * ranges.prior_width[at];
      if (!one.determined)
        found.notes.push_back(
            {GLISSON_TEXT("These data do not determine {0} of {1}."), {parameter.name, settings[i].kind}});
      const bool may_be = effect.lower_end_may_be && one.value < std::sqrt(parameter.lower * parameter.upper);
      if (!may_be && at_end_of_range(parameter, one.value, options.told_at_end_of_range))
        found.notes.push_back({GLISSON_TEXT("{0} of {1} ended at the limit of its range ({2})."),
                               {parameter.name, settings[i].kind, fmt::format("{:.3g}", one.value)}});
      found.of_setting[i].push_back(std::move(one));
      ++at;
    }
  }
  for (Sentence& note : hardly_told_apart(settings, covariance_of_noise, options.inseparable))
    found.notes.push_back(std::move(note));
  return found;
}

// A sentence for each two effects of which one's size stands for the other's.
std::vector<Sentence> hardly_told_apart(const Settings& settings, const Eigen::MatrixXd& covariance,
                                        double inseparable) {
  std::vector<std::size_t> setting_of_parameter;
  for (std::size_t i = 0; i < settings.size(); ++i)
    setting_of_parameter.insert(setting_of_parameter.end(), static_cast<std::size_t>(settings[i].parameters.size()), i);
  std::vector<Sentence> notes;
  std::set<std::pair<std::size_t, std::size_t>> said;
  for (Eigen::Index a = 0; a < covariance.rows(); ++a) {
    for (Eigen::Index b = 0; b < a; ++b) {
      const std::size_t one = setting_of_parameter[static_cast<std::size_t>(b)];
      const std::size_t other = setting_of_parameter[static_cast<std::size_t>(a)];
      const double correlation = covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
      if (one != other && std::abs(correlation) > inseparable && said.insert({one, other}).second)
        notes.push_back({GLISSON_TEXT("{0} and {1} can hardly be told apart in size (correlation {2})."),
                         {settings[one].kind, settings[other].kind, fmt::format("{:.2f}", correlation)}});
    }
  }
  return notes;
}

}  // namespace
}  // namespace glisson::closedloop
