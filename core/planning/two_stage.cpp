#include "planning/two_stage.h"

#include <fmt/format.h>

namespace glisson::planning {

Result<TwoStages> two_stages(const Planner& planner, const std::vector<std::string>& embolised,
                             const std::vector<Cut>& cuts, double growth_percent) {
  if (embolised.empty()) {
    return failure("embolised-none", GLISSON_TEXT("No branch is named that is to be embolised."));
  }
  if (!(growth_percent >= 0 && growth_percent <= largest_growth_percent)) {
    return failure("growth-invalid", GLISSON_TEXT("A growth of {0} % is not between 0 and {1} %."),
                   {fmt::format("{}", growth_percent), fmt::format("{}", largest_growth_percent)});
  }
  std::vector<Cut> territories;
  for (const std::string& branch : embolised) {
    if (branch != "portal" && !branch.starts_with("portal/")) {
      return failure("embolised-not-portal", GLISSON_TEXT("{0} is no branch of the portal vein."), {branch});
    }
    territories.emplace_back(TerritoryCut{branch});
  }
  const auto without_embolised = planner.answer(territories);
  if (!without_embolised) return failure(without_embolised.error());
  const auto left = planner.answer(cuts);
  if (!left) return failure(left.error());
  std::vector<Cut> both = cuts;
  both.insert(both.end(), territories.begin(), territories.end());
  const auto fed = planner.answer(both);
  if (!fed) return failure(fed.error());

  TwoStages stages;
  stages.embolised_ml = without_embolised->functional_ml() - without_embolised->functional_remnant_ml;
  stages.grows_ml = fed->functional_remnant_ml;
  stages.grown_ml = stages.grows_ml * (1 + growth_percent / 100);
  stages.embolised_left_ml = left->functional_remnant_ml - fed->functional_remnant_ml;
  stages.remnant_percent = left->remnant_percent();
  stages.grown_percent = 100 * stages.grown_ml / left->functional_ml();
  return stages;
}

}  // namespace glisson::planning
