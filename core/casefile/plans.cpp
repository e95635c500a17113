#include "casefile/plans.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include "base/json.h"
#include "casefile/internal/vessel_masks.h"
#include "casefile/label_map.h"
#include "casefile/model.h"
#include "casefile/used_entries.h"
#include "elastography/cell_stiffness.h"
#include "imaging/volume_file.h"
#include "planning/plan_file.h"
#include "segmentation/grid_part.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using imaging::Mask;

constexpr const char* plans_folder = "plans/";

fs::path followed_in(const Case& patient) { return patient.folder() / "results" / "resection"; }

bool is_tumour(const std::string& id) { return id.starts_with("labels/tumour"); }

// What a plan's answer rests on, as far as the case has it.
std::vector<std::string> foundations(const Case& patient) {
  std::vector<std::string> ids;
  for (const Entry& entry : patient.entries()) {
    if (entry.id == "labels/liver" || is_tumour(entry.id) || entry.id == trees_id ||
        entry.id == "territories/couinaud" || entry.id == "territories/portal-vein" ||
        entry.id == "territories/hepatic-vein" || entry.id == "volumes/stiffness" || entry.id == "volumes/confidence") {
      ids.push_back(entry.id);
    }
  }
  return ids;
}

Result<Mask> read_label(const Case& patient, const std::string& id) {
  return patient.file_of(id).and_then(imaging::read_mask_file).map([](imaging::SegmentedMask read) {
    return std::move(read.mask);
  });
}

// Liver and tumours on the part of the grid around them.
Result<void> read_outlines(const Case& patient, planning::LiverParts& parts) {
  auto liver = read_label(patient, "labels/liver");
  if (!liver) return failure(std::move(liver.error()));
  Mask all = *liver;
  std::vector<planning::NamedTumour> tumours;
  for (const Entry& entry : patient.entries()) {
    if (!is_tumour(entry.id)) continue;
    auto tumour = read_label(patient, entry.id);
    if (!tumour) return failure(std::move(tumour.error()));
    if (imaging::same_grid(tumour->grid, all.grid)) {
      for (std::size_t v = 0; v < all.values.size(); ++v) all.values[v] |= tumour->values[v];
    }
    tumours.push_back({entry.id.substr(std::string("labels/").size()), std::move(*tumour)});
  }
  const segmentation::Part part = segmentation::part_around(all, 1);
  for (planning::NamedTumour& tumour : tumours) {
    if (imaging::same_grid(tumour.mask.grid, all.grid)) tumour.mask = segmentation::cut_out(tumour.mask, part);
  }
  parts.liver = segmentation::cut_out(*liver, part);
  parts.tumours = std::move(tumours);
  return {};
}

Result<void> read_stiffness(const Case& patient, planning::LiverParts& parts) {
  if (patient.find("volumes/stiffness") == nullptr) return {};
  const auto shear = patient.volume("volumes/stiffness");
  if (!shear) return failure(shear.error());
  auto confident = confident_voxels(patient);
  if (!confident) return failure(std::move(confident.error()));
  parts.youngs_kPa = elastography::reliable_youngs_kPa(*shear, {std::move(*confident), parts.liver});
  return {};
}

planning::Cut cut_with(const PlannedCut& cut, planning::Removed removed) {
  if (!cut.through_mm.empty()) return planning::SheetCut{cut.through_mm, removed};
  return planning::PlaneCut{cut.point_mm, cut.normal, removed};
}

std::string id_of(const Case& patient, const std::string& name) {
  std::string simple = structure_name(name);
  if (simple.empty()) simple = "plan";
  for (int n = 1;; ++n) {
    const std::string id = plans_folder + simple + (n == 1 ? "" : fmt::format("-{}", n));
    const Entry* there = patient.find(id);
    if (there == nullptr) return id;
    const auto plan = planning::read_plan(patient.folder() / there->file);
    if (!plan || plan->name == name) return id;
  }
}

}  // namespace

Result<OpenedPlanner> open_planner(const Case& patient, const Progress& progress) {
  const SegmentsBy by = patient.find(trees_id) != nullptr ? SegmentsBy::trees : SegmentsBy::shape;
  if (by == SegmentsBy::shape && kept_territories(patient, by) != Kept::current) {
    return open_planner(patient, FoundTerritories{}, progress);
  }
  const auto found = territories_in(patient, by, progress.part(0, 0.6));
  if (!found) return failure(found.error());
  return open_planner(patient, *found, progress.part(0.6, 1));
}

Result<OpenedPlanner> open_planner(const Case& patient, const FoundTerritories& found, const Progress& progress) {
  planning::LiverParts parts;
  if (auto read = read_outlines(patient, parts); !read) return failure(std::move(read.error()));
  if (auto read = read_stiffness(patient, parts); !read) return failure(std::move(read.error()));
  parts.trees = found.trees;
  if (!found.couinaud.segment.values.empty()) parts.segments = found.couinaud.segment;
  parts.portal = found.territory[0];
  parts.hepatic = found.territory[1];
  auto planner = planning::Planner::open(parts, progress);
  if (!planner) return failure(std::move(planner.error()));
  std::vector<Sentence> remarks = remarks_on(patient, {trees_id});
  if (const auto missing = missing_from_trees(patient); !missing.empty()) {
    remarks.push_back({GLISSON_TEXT("The vessel trees were made before there was {0}: find the vessels again."),
                       {fmt::format("{}", fmt::join(missing, ", "))}});
  }
  return OpenedPlanner{std::move(*planner), std::move(remarks)};
}

planning::Cut cut_of(const PlannedCut& cut) {
  const bool larger = cut.removed == PlannedCut::Removed::larger;
  return cut_with(cut, larger ? planning::Removed::larger : planning::Removed::smaller);
}

planning::Cut cut_of(const PlannedCut& cut, bool specimen_is_above) {
  return cut_with(cut, specimen_is_above ? planning::Removed::above : planning::Removed::below);
}

Result<std::vector<KeptPlan>> kept_plans(const Case& patient) {
  std::vector<KeptPlan> plans;
  for (const Entry& entry : patient.entries()) {
    if (!entry.id.starts_with(plans_folder)) continue;
    auto plan = planning::read_plan(patient.folder() / entry.file);
    if (!plan) return failure(std::move(plan.error()));
    plans.push_back({entry.id, std::move(*plan), remarks_on(patient, {entry.id})});
  }
  return plans;
}

Result<KeptPlan> kept_plan(const Case& patient, const std::string& name) {
  auto plans = kept_plans(patient);
  if (!plans) return failure(std::move(plans.error()));
  for (KeptPlan& kept : *plans) {
    if (kept.plan.name == name || kept.id == plans_folder + name) return std::move(kept);
  }
  return failure("plan-unknown", GLISSON_TEXT("The case has no plan {0}."), {name});
}

Result<Json> kept_answer(const Case& patient, const std::string& id) {
  const auto document = patient.file_of(id).and_then([](const fs::path& file) { return read_json_file(file); });
  if (!document) return failure(document.error());
  return document->value("answer", Json::object());
}

Result<std::string> keep_plan(Case& patient, const planning::Plan& plan, const planning::PlanAnswer& answer,
                              const vasculature::VesselTrees& trees) {
  std::string id = id_of(patient, plan.name);
  Json document = planning::plan_json(plan);
  document["answer"] = planning::answer_json(answer, trees);
  auto added = patient.add(id, ".json", Provenance{"plan", {}, foundations(patient), {}, {}},
                           [&](const fs::path& file) { return write_json_file(file, document); });
  if (!added) return failure(std::move(added.error()));
  return id;
}

bool is_followed(const Case& patient, const planning::Plan& plan) {
  const auto cut = read_planned_cut(followed_in(patient));
  if (!cut || cut->liver != PlannedCut::Liver::at_rest) return false;
  return plan.cuts.size() == 1 && plan.cuts.front() == cut_of(*cut);
}

Result<void> drop_plan(Case& patient, const std::string& name) {
  return kept_plan(patient, name).and_then([&](const KeptPlan& kept) {
    const bool followed = is_followed(patient, kept.plan);
    return patient.remove(kept.id).and_then(
        [&] { return followed ? remove_resection(followed_in(patient)) : Result<void>(); });
  });
}

}  // namespace glisson::casefile
