#pragma once
// Plans put in order by what a surgeon chooses, and which of them another one beats.

#include <optional>
#include <string_view>
#include <vector>

#include "planning/planner.h"

namespace glisson::planning {

// margin: the widest first. living: the most perfused and drained tissue first. branches: the least tissue beyond the
// branches that are cut first. Plans that leave a tumour, or cut through one, come after those that do not.
enum class RankBy { margin, living, branches };
[[nodiscard]] std::optional<RankBy> rank_by(std::string_view name);  // "margin", "living", "branches"

// Places in `answers`, the best first; equals stay in their order.
[[nodiscard]] std::vector<std::size_t> ranked(const std::vector<PlanAnswer>& answers, RankBy by);

// Of each answer the places of those that beat it (Pareto dominance). These are no worse in tumours cleared, smallest
// margin and living tissue, and better in one. Margins within half a millimetre and volumes within a millilitre are the
// same.
[[nodiscard]] std::vector<std::vector<std::size_t>> beaten_by(const std::vector<PlanAnswer>& answers);

}  // namespace glisson::planning
