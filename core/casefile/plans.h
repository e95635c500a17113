#pragma once
// The resection plans of a case, by name.
//
//   plans/NAME           glisson-plan/1 (planning/plan_file.h) with the answer of when it was kept
//   results/resection    the plane or sheet that was kept last, with the liver divided by it (resection_folder.h)
//
// A plan is made from all that its answer rests on. Where outlines, trees, territories or the stiffness map change, it
// is stale, as any entry is.

#include <string>
#include <vector>

#include "base/json_forward.h"
#include "base/progress.h"
#include "base/sentence.h"
#include "casefile/case.h"
#include "casefile/resection_folder.h"
#include "casefile/vascular.h"
#include "planning/planner.h"

namespace glisson::casefile {

// What plans rest on, read from the case and worked out where it is not kept. These are trees and territories where
// there are any, else the segments that are kept. Tumours are the structures named so. Remarks: on what has changed
// since it was made.
struct OpenedPlanner {
  planning::Planner planner;
  std::vector<Sentence> remarks;
};
// Fails where there is no liver, and as territories_in and planning::Planner::open do.
Result<OpenedPlanner> open_planner(const Case& patient, const Progress& progress = {});
// By these territories, just found.
Result<OpenedPlanner> open_planner(const Case& patient, const FoundTerritories& found, const Progress& progress = {});

struct KeptPlan {
  std::string id;  // of the entry, "plans/right-hemihepatectomy"
  planning::Plan plan;
  std::vector<Sentence> remarks;  // that it is stale
};
// The same cut in a plan: by plane or sheet, with the part that goes, or with the side of it that was found to.
[[nodiscard]] planning::Cut cut_of(const PlannedCut& cut);
[[nodiscard]] planning::Cut cut_of(const PlannedCut& cut, bool specimen_is_above);

// In the order in which they came.
Result<std::vector<KeptPlan>> kept_plans(const Case& patient);

// By its name or its id without the folder. Fails with "plan-unknown".
Result<KeptPlan> kept_plan(const Case& patient, const std::string& name);

// As it was answered when it was kept. Fails where the file is gone or damaged.
Result<Json> kept_answer(const Case& patient, const std::string& id);

// Replaces a plan of that name. Its entry's id.
Result<std::string> keep_plan(Case& patient, const planning::Plan& plan, const planning::PlanAnswer& answer,
                              const vasculature::VesselTrees& trees);

// Whether results/resection holds this plan: a single plane or sheet on the liver at rest. Rehearsal, guidance and the
// patient's page follow it.
[[nodiscard]] bool is_followed(const Case& patient, const planning::Plan& plan);

// With what is in results/resection, where that is followed. Fails with "plan-unknown".
Result<void> drop_plan(Case& patient, const std::string& name);

}  // namespace glisson::casefile
