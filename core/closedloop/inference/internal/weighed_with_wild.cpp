#include "closedloop/inference/internal/weighed_with_wild.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "closedloop/inference/internal/wild_values.h"

namespace glisson::closedloop {
namespace {

void weigh(const Weighing& weighing, const std::vector<Weighed>& without, double log_probability,
           std::vector<Weighed>& with, const PosteriorOptions& options, const Progress& progress);

}  // namespace

std::vector<WithWildValues> weighed_with_wild_values(const Weighing& weighing, const std::vector<Weighed>& all,
                                                     const PosteriorOptions& options, const Progress& progress) {
  const Observations& observations = weighing.model.observations();
  if (observations.has_places() || !weighing.model.predicts_quickly() || weighing.systematic.indistinct > 0) return {};
  std::vector<const Weighed*> guesses{&nothing_of(all)};
  if (const Weighed& likeliest = all[likeliest_of(all)]; !likeliest.kinds.empty()) guesses.push_back(&likeliest);
  std::vector<WithWildValues> found;
  for (const Weighed* guess : guesses) {
    const auto predicted = weighing.model.predict(guess->fit.settings);
    if (!predicted) continue;
    const WildValues wild = wild_values(weighing.whitening.whiten(observations.measured - *predicted), options);
    const double log_probability = std::log(options.wild_values) + wild.log_probability / weighing.correlation;
    WithWildValues with{std::make_unique<Whitening>(observations.noise.cwiseQuotient(wild.worth.cwiseSqrt()),
                                                    weighing.systematic, all_rows(observations)),
                        wild.worth,
                        {}};
    weigh(with.weighing(weighing), all, log_probability, with.all, options, progress);
    found.push_back(std::move(with));
  }
  return found;
}

namespace {

void weigh(const Weighing& weighing, const std::vector<Weighed>& without, double log_probability,
           std::vector<Weighed>& with, const PosteriorOptions& options, const Progress& progress) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  double highest = none;
  for (const Weighed& one : without) highest = std::max(highest, one.log.evidence);
  with = without;
  // Wild values make the noise of all others smaller, and differences between sets larger.
  constexpr double wider = 4;
  parallel_for(with.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Weighed& one = with[i];
      one.log = {none, none};
      if (without[i].log.evidence < highest - wider * options.worth_refining && !one.kinds.empty()) continue;
      const auto fit = without_fitting(weighing.model, one.fit.settings, weighing.whitening);
      if (!fit || !fit->derivatives.allFinite()) continue;
      one.fit = local_fit(*fit, weighing.whitening);
      one.log = log_evidence(weighing.model, one.fit, weighing.correlation, options);
    }
  });
  refine(weighing, with, options, progress);
  for (Weighed& one : with) one.log.evidence += log_probability;
}

}  // namespace
}  // namespace glisson::closedloop
