#pragma once
// A plan as JSON, `glisson-plan/1` (docs/file-formats.md), and the answer to it.

#include <filesystem>

#include "base/json_forward.h"
#include "base/result.h"
#include "planning/planner.h"

namespace glisson::planning {

// Fails with "plan-invalid", naming what is missing or wrong and where.
Result<Plan> read_plan(const std::filesystem::path& file);
Result<Plan> plan_from(const Json& document, const std::filesystem::path& file = {});

[[nodiscard]] Json plan_json(const Plan& plan);

// Field names as in the contract of the command `plan`; what is not known is left out.
[[nodiscard]] Json answer_json(const PlanAnswer& answer, const vasculature::VesselTrees& trees);

// The same as of a CutBranch, of one of the answer's `branches`.
[[nodiscard]] std::optional<BeyondCut> beyond_cut(const Json& branch);

}  // namespace glisson::planning
