#include "closedloop/inference/internal/weighed.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace glisson::closedloop {

const Weighed& nothing_of(const std::vector<Weighed>& all) {
  return *std::find_if(all.begin(), all.end(), [](const Weighed& one) { return one.kinds.empty(); });
}

std::size_t likeliest_of(const std::vector<Weighed>& all) {
  return static_cast<std::size_t>(
      std::max_element(all.begin(), all.end(),
                       [](const Weighed& a, const Weighed& b) { return a.weight() < b.weight(); }) -
      all.begin());
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

}  // namespace glisson::closedloop
