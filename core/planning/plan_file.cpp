#include "planning/plan_file.h"

#include "base/json.h"
#include "base/json_reading.h"

namespace glisson::planning {
namespace {

Cut cut_from(const Json& json, const std::string& where) {
  const auto side = [](const Json& part, const std::string& place) {
    return part.contains("removed") ? one_of<Removed>(part["removed"], place + ", removed",
                                                      {{"smaller", Removed::smaller},
                                                       {"larger", Removed::larger},
                                                       {"above", Removed::above},
                                                       {"below", Removed::below}})
                                    : Removed::smaller;
  };
  if (json.contains("plane")) {
    const Json& part = json["plane"];
    const std::string place = where + ", plane";
    only_keys(part, {"point_mm", "normal", "removed"}, place);
    return PlaneCut{vector_in(required(part, "point_mm", place), place + ", point_mm"),
                    vector_in(required(part, "normal", place), place + ", normal"), side(part, place)};
  }
  if (json.contains("sheet")) {
    const Json& part = json["sheet"];
    const std::string place = where + ", sheet";
    only_keys(part, {"through_mm", "removed"}, place);
    const Json& points = required(part, "through_mm", place);
    if (!points.is_array()) refuse_at(place + ", through_mm", GLISSON_TEXT("{0} must be a list in brackets."));
    SheetCut cut{{}, side(part, place)};
    for (const Json& point : points) cut.through_mm.push_back(vector_in(point, place + ", through_mm"));
    return cut;
  }
  if (json.contains("segments")) {
    const Json& numbers = json["segments"];
    if (!numbers.is_array()) refuse_at(where + ", segments", GLISSON_TEXT("{0} must be a list in brackets."));
    SegmentsCut cut;
    for (const Json& number : numbers) {
      const double value = number_in(number, where + ", segments");
      if (value != std::floor(value) || value < 1 || value > 8) {
        refuse_at(where + ", segments", GLISSON_TEXT("{0} must be whole numbers from 1 to 8, Couinaud's segments."));
      }
      cut.segments.push_back(static_cast<int>(value));
    }
    return cut;
  }
  if (json.contains("territory")) return TerritoryCut{name_in(json["territory"], where + ", territory")};
  if (json.contains("around")) {
    return MarginCut{name_in(json["around"], where + ", around"),
                     not_negative_in(required(json, "margin_mm", where), where + ", margin_mm")};
  }
  if (json.contains("ablation")) {
    const Json& part = json["ablation"];
    const std::string place = where + ", ablation";
    only_keys(part, {"center_mm", "direction", "radius_along_mm", "radius_across_mm"}, place);
    return AblationCut{vector_in(required(part, "center_mm", place), place + ", center_mm"),
                       vector_in(required(part, "direction", place), place + ", direction"),
                       not_negative_in(required(part, "radius_along_mm", place), place + ", radius_along_mm"),
                       not_negative_in(required(part, "radius_across_mm", place), place + ", radius_across_mm")};
  }
  refuse_at(where, GLISSON_TEXT("{0} needs one of plane, sheet, segments, territory, around, ablation."));
}

void only_keys_of_a_cut(const Json& json, const std::string& where) {
  only_keys(json, {"plane", "sheet", "segments", "territory", "around", "margin_mm", "ablation"}, where);
}

struct CutJson {
  Json operator()(const PlaneCut& cut) const {
    return {{"plane", {{"point_mm", json_of(cut.point_mm)}, {"normal", json_of(cut.normal)}, side(cut.removed)}}};
  }
  Json operator()(const SheetCut& cut) const {
    Json points = Json::array();
    for (const Eigen::Vector3d& point : cut.through_mm) points.push_back(json_of(point));
    return {{"sheet", {{"through_mm", std::move(points)}, side(cut.removed)}}};
  }
  Json operator()(const SegmentsCut& cut) const { return {{"segments", cut.segments}}; }
  Json operator()(const TerritoryCut& cut) const { return {{"territory", cut.branch}}; }
  Json operator()(const MarginCut& cut) const { return {{"around", cut.tumour}, {"margin_mm", cut.margin_mm}}; }
  Json operator()(const AblationCut& cut) const {
    return {{"ablation",
             {{"center_mm", json_of(cut.center_mm)},
              {"direction", json_of(cut.direction)},
              {"radius_along_mm", cut.radius_along_mm},
              {"radius_across_mm", cut.radius_across_mm}}}};
  }

  static Json side(Removed removed) {
    static constexpr std::array<const char*, 4> words = {"smaller", "larger", "above", "below"};
    return {"removed", words.at(static_cast<std::size_t>(removed))};
  }
};

void add_stiffness(Json& json, const Tissue& tissue) {
  if (!tissue.mean_kPa) return;
  json["mean_kPa"] = *tissue.mean_kPa;
  json["confident_share"] = tissue.confident_share;
}

}  // namespace

Result<Plan> read_plan(const std::filesystem::path& file) {
  const auto document = read_json_file(file);
  return document ? plan_from(*document, file) : failure(document.error());
}

Result<Plan> plan_from(const Json& json, const std::filesystem::path& file) {
  return reading("plan-invalid", file, [&] {
    if (!json.is_object()) refuse_at("The plan", GLISSON_TEXT("{0} must be an object in braces."));
    if (json.contains("format") && json["format"] != "glisson-plan/1") {
      refuse_at("The plan", GLISSON_TEXT("{0} is not of the format glisson-plan/1."));
    }
    Plan plan{name_in(required(json, "name", "The plan"), "The plan's name"), {}};
    if (json.contains("cuts")) {
      only_keys(json, {"format", "name", "cuts", "answer"}, "The plan");
      if (!json["cuts"].is_array() || json["cuts"].empty()) {
        refuse_at("The plan", GLISSON_TEXT("{0} needs at least one cut in its list of cuts."));
      }
      for (std::size_t n = 0; n < json["cuts"].size(); ++n) {
        only_keys_of_a_cut(json["cuts"][n], item("cut", n));
        plan.cuts.push_back(cut_from(json["cuts"][n], item("cut", n)));
      }
    } else {
      only_keys(
          json,
          {"format", "name", "plane", "sheet", "segments", "territory", "around", "margin_mm", "ablation", "answer"},
          "The plan");
      plan.cuts.push_back(cut_from(json, "The plan"));
    }
    return plan;
  });
}

Json plan_json(const Plan& plan) {
  Json cuts = Json::array();
  for (const Cut& cut : plan.cuts) cuts.push_back(std::visit(CutJson{}, cut));
  return {{"format", "glisson-plan/1"}, {"name", plan.name}, {"cuts", std::move(cuts)}};
}

Json answer_json(const PlanAnswer& answer, const vasculature::VesselTrees& trees) {
  Json json{{"liver_ml", answer.liver_ml},
            {"tumours_ml", answer.tumours_ml},
            {"removed_ml", answer.removed_ml},
            {"remnant_ml", answer.remnant_ml},
            {"functional_remnant_ml", answer.functional_remnant_ml},
            {"remnant_percent", answer.remnant_percent()}};
  const auto known = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
  };
  if (answer.ablated_ml > 0) json["ablated_ml"] = answer.ablated_ml;
  known("perfused_ml", answer.perfused_ml);
  known("drained_ml", answer.drained_ml);
  known("living_ml", answer.living_ml);
  known("ischaemic_ml", answer.ischaemic_ml);
  known("congested_ml", answer.congested_ml);
  if (answer.living_ml) json["living_percent"] = answer.living_percent();
  known("margin_mm", answer.margin_mm);
  if (answer.margin_is_at_least) json["margin_is_at_least"] = true;
  add_stiffness(json, answer.left);
  json["tumours"] = Json::array();
  for (const MarginAnswer& tumour : answer.tumours) {
    json["tumours"].push_back(
        {{"name", tumour.tumour}, {"side", side_name(tumour.side)}, {"margin_mm", tumour.margin_mm}});
    if (tumour.is_at_least) json["tumours"].back()["margin_is_at_least"] = true;
  }
  json["segments"] = Json::array();
  for (const SegmentAnswer& segment : answer.segments) {
    Json& one = json["segments"].emplace_back(Json{{"number", segment.number},
                                                   {"removed_ml", segment.removed_ml},
                                                   {"left_ml", segment.left.ml},
                                                   {"living_ml", segment.living_ml}});
    add_stiffness(one, segment.left);
  }
  json["branches"] = Json::array();
  for (const CutBranch& cut : answer.branches) {
    const vasculature::TreeBranch& branch = trees.branches[cut.branch];
    json["branches"].push_back({{"id", cut.branch},
                                {"name", branch.name},
                                {"system", vasculature::system_name(branch.system)},
                                {"at_mm", json_of(cut.at_mm)},
                                {"radius_mm", cut.radius_mm},
                                {"beyond_ml", cut.beyond_ml},
                                {"affected_ml", cut.affected_ml},
                                {"beyond_mm", cut.beyond_mm},
                                {"left_mm", cut.left_mm},
                                {"confidence", branch.confidence}});
  }
  return json;
}

std::optional<BeyondCut> beyond_cut(const Json& branch) {
  CutBranch cut;
  cut.beyond_ml = branch.at("beyond_ml").get<double>();
  cut.affected_ml = branch.at("affected_ml").get<double>();
  cut.beyond_mm = branch.value("beyond_mm", 0.0);  // absent from answers of earlier versions
  cut.left_mm = branch.value("left_mm", 0.0);
  const auto system = vasculature::system_named(branch.at("system").get<std::string>());
  return beyond_cut(cut, system.value_or(vasculature::System::portal_vein));
}

}  // namespace glisson::planning
