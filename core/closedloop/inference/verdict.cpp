#include "closedloop/inference/verdict.h"

#include <algorithm>
#include <cstddef>

namespace glisson::closedloop {

bool stand_for(const NamedCauses& named, const std::vector<std::string>& kinds) {
  if (kinds.size() != named.kinds.size()) return false;
  std::vector<std::string> left = named.kinds;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    auto same = std::find(left.begin(), left.end(), kinds[i]);
    if (same == left.end())
      same = std::find_if(left.begin(), left.end(), [&](const std::string& kind) {
        const auto at = std::find(named.kinds.begin(), named.kinds.end(), kind) - named.kinds.begin();
        const auto& alike = named.alike[static_cast<std::size_t>(at)];
        return std::find(alike.begin(), alike.end(), kinds[i]) != alike.end();
      });
    if (same == left.end()) return false;
    left.erase(same);
  }
  return true;
}

double probability_of(const Posterior& posterior, const NamedCauses& named) {
  double sum = 0;
  for (const WeighedExplanation& one : posterior)
    if (!one.something_else && stand_for(named, one.kinds)) sum += one.probability;
  return sum;
}

Verdict verdict_of(const Posterior& posterior, double of_named, const VerdictCosts& costs) {
  double nothing = 0, known = 0;
  for (const WeighedExplanation& one : posterior) {
    if (!one.something_else) (one.kinds.empty() ? nothing : known) += one.probability;
  }
  const double of_nothing_missing = costs.overlooked * (1 - nothing);
  const double of_unexplained = costs.false_alarm * nothing + costs.unnamed * known;
  const double of_explained = costs.wrong_name * (1 - of_named);
  if (of_nothing_missing <= std::min(of_unexplained, of_explained)) return Verdict::nothing_missing;
  return of_named > 0 && of_explained < of_unexplained ? Verdict::explained : Verdict::unexplained;
}

}  // namespace glisson::closedloop
