// Regions, cuts and tools of a scenario, from JSON and back.

#include <cmath>

#include "mechanics/scenario/internal/scenario_reading.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

ToolShape shape_from(const Json& json, const std::string& where);
Rod rod_from(const Json& json, const std::string& where);
Vector3d direction_from(const Json& json, const std::string& where);

}  // namespace

Region region_from(const Json& json, const std::string& where) {
  const auto kinds = json.count("point_array") + json.count("sphere") + json.count("box");
  if (kinds != 1) refuse_at(where, GLISSON_TEXT("{0} needs exactly one of \"point_array\", \"sphere\" and \"box\"."));

  if (json.contains("point_array")) return NamedPoints{name_in(json["point_array"], where + ", point_array")};
  if (json.contains("sphere")) {
    const Json& sphere = json["sphere"];
    only_keys(sphere, {"center_mm", "radius_mm"}, where + ", sphere");
    return Ball{vector_in(required(sphere, "center_mm", where + ", sphere"), where + ", center_mm"),
                positive_in(required(sphere, "radius_mm", where + ", sphere"), where + ", radius_mm")};
  }
  const Json& box = json["box"];
  only_keys(box, {"min_mm", "max_mm"}, where + ", box");
  const geometry::Box region{vector_in(required(box, "min_mm", where + ", box"), where + ", min_mm"),
                             vector_in(required(box, "max_mm", where + ", box"), where + ", max_mm")};
  if ((region.min_mm.array() > region.max_mm.array()).any()) {
    refuse_at(where, GLISSON_TEXT("In {0} the box's min_mm must not exceed its max_mm."));
  }
  return region;
}

Cut cut_from(const Json& json, const std::string& where) {
  only_keys(json, {"center_mm", "normal", "radius_mm", "points_mm"}, where);
  if (json.count("normal") + json.count("points_mm") != 1)
    refuse_at(where,
              GLISSON_TEXT("{0} needs exactly one of \"normal\" (a plane) and \"points_mm\" (a sheet through them)."));
  Cut cut;
  if (json.contains("radius_mm")) cut.radius_mm = positive_in(json["radius_mm"], where + ", radius_mm");
  const bool is_plane = json.contains("normal");
  if (is_plane || json.contains("radius_mm"))
    cut.center_mm = vector_in(required(json, "center_mm", where), where + ", center_mm");
  if (is_plane) {
    cut.normal = direction_from(json["normal"], where + ", normal").normalized();
    return cut;
  }
  if (json.contains("center_mm") && !json.contains("radius_mm"))
    refuse_at(where, GLISSON_TEXT("{0} is a sheet: its \"center_mm\" needs the \"radius_mm\" that it is open within."));
  if (!json["points_mm"].is_array() || json["points_mm"].size() < 3)
    refuse_at(where + ", points_mm", GLISSON_TEXT("{0} must be a list of three points or more."));
  for (const Json& point : json["points_mm"]) cut.points_mm.push_back(vector_in(point, where + ", points_mm"));
  return cut;
}

ScenarioTool tool_from(const Json& json, const std::string& where) {
  only_keys(json,
            {"id", "shape", "position_mm", "direction", "advance_mm", "push_N", "friction", "grasp", "displacement_mm",
             "pull_N"},
            where);
  ScenarioTool tool{name_in(required(json, "id", where), where + ", id"), {}};
  const auto one_of_two = [&](const char* a, const char* b) {
    if (json.count(a) + json.count(b) != 1)
      refuse_at(where, GLISSON_TEXT("{0} needs exactly one of \"{1}\" and \"{2}\"."), {a, b});
  };
  one_of_two("shape", "grasp");
  if (json.contains("grasp")) {
    only_keys(json, {"id", "grasp", "displacement_mm", "pull_N"}, where);
    one_of_two("displacement_mm", "pull_N");
    const Json& grasp = json["grasp"];
    only_keys(grasp, {"center_mm", "radius_mm"}, where + ", grasp");
    ScenarioGrasp jaws;
    jaws.center_mm = vector_in(required(grasp, "center_mm", where + ", grasp"), where + ", center_mm");
    jaws.radius_mm = positive_in(required(grasp, "radius_mm", where + ", grasp"), where + ", radius_mm");
    if (json.contains("displacement_mm")) jaws.displacement_mm = vector_in(json["displacement_mm"], where);
    if (json.contains("pull_N")) jaws.pull_mN = vector_in(json["pull_N"], where).unaryExpr(&units::mN_from_N);
    tool.what = jaws;
    return tool;
  }
  only_keys(json, {"id", "shape", "position_mm", "direction", "advance_mm", "push_N", "friction"}, where);
  one_of_two("advance_mm", "push_N");
  ScenarioRigidTool rigid;
  rigid.shape = shape_from(json["shape"], where + ", shape");
  rigid.position_mm = vector_in(required(json, "position_mm", where), where + ", position_mm");
  rigid.direction = direction_from(required(json, "direction", where), where + ", direction");
  if (json.contains("advance_mm")) {
    rigid.advance_mm = not_negative_in(json["advance_mm"], where + ", advance_mm");
  } else {
    rigid.push_mN = units::mN_from_N(positive_in(json["push_N"], where + ", push_N"));
  }
  if (json.contains("friction")) rigid.friction = not_negative_in(json["friction"], where + ", friction");
  tool.what = std::move(rigid);
  return tool;
}

Json json_of(const Region& region) {
  if (const auto* named = std::get_if<NamedPoints>(&region)) return {{"point_array", named->point_array}};
  if (const auto* ball = std::get_if<Ball>(&region)) {
    return {{"sphere", {{"center_mm", json_of(ball->center_mm)}, {"radius_mm", ball->radius_mm}}}};
  }
  const auto& box = std::get<geometry::Box>(region);
  return {{"box", {{"min_mm", json_of(box.min_mm)}, {"max_mm", json_of(box.max_mm)}}}};
}

Json json_of(const Cut& cut) {
  Json json;
  if (cut.points_mm.empty()) {
    json["normal"] = json_of(cut.normal);
  } else {
    json["points_mm"] = Json::array();
    for (const Vector3d& point : cut.points_mm) json["points_mm"].push_back(json_of(point));
  }
  if (cut.points_mm.empty() || std::isfinite(cut.radius_mm)) json["center_mm"] = json_of(cut.center_mm);
  if (std::isfinite(cut.radius_mm)) json["radius_mm"] = cut.radius_mm;
  return json;
}

Json json_of(const ScenarioTool& tool) {
  Json json{{"id", tool.id}};
  if (const auto* jaws = std::get_if<ScenarioGrasp>(&tool.what)) {
    json["grasp"] = {{"center_mm", json_of(jaws->center_mm)}, {"radius_mm", jaws->radius_mm}};
    if (jaws->pull_mN) {
      json["pull_N"] = json_of(Vector3d(jaws->pull_mN->unaryExpr(&units::N_from_mN)));
    } else {
      json["displacement_mm"] = json_of(jaws->displacement_mm);
    }
    return json;
  }
  const auto& rigid = std::get<ScenarioRigidTool>(tool.what);
  Json rods = Json::array();
  for (const Rod& rod : rigid.shape) {
    rods.push_back({{"from_mm", json_of(rod.from_mm)}, {"to_mm", json_of(rod.to_mm)}, {"radius_mm", rod.radius_mm}});
  }
  json["shape"] = {{"rods", std::move(rods)}};
  json["position_mm"] = json_of(rigid.position_mm);
  json["direction"] = json_of(rigid.direction);
  if (rigid.push_mN) {
    json["push_N"] = units::N_from_mN(*rigid.push_mN);
  } else {
    json["advance_mm"] = rigid.advance_mm;
  }
  if (rigid.friction > 0) json["friction"] = rigid.friction;
  return json;
}

namespace {

ToolShape shape_from(const Json& json, const std::string& where) {
  if (json == "nathanson-retractor") return nathanson_retractor();
  if (json == "palpation-probe") return palpation_probe();
  if (!json.is_object()) {
    refuse_at(where, GLISSON_TEXT("{0} must be \"nathanson-retractor\", \"palpation-probe\" or {\"rods\": [...]}."));
  }
  only_keys(json, {"rods"}, where);
  const Json& rods = required(json, "rods", where);
  if (!rods.is_array() || rods.empty()) refuse_at(where + ", rods", GLISSON_TEXT("{0} must be a list in brackets."));
  ToolShape shape;
  for (std::size_t i = 0; i < rods.size(); ++i) shape.push_back(rod_from(rods[i], where + ", " + item("rod", i)));
  return shape;
}

Rod rod_from(const Json& json, const std::string& where) {
  only_keys(json, {"from_mm", "to_mm", "radius_mm"}, where);
  return {vector_in(required(json, "from_mm", where), where + ", from_mm"),
          vector_in(required(json, "to_mm", where), where + ", to_mm"),
          positive_in(required(json, "radius_mm", where), where + ", radius_mm")};
}

Vector3d direction_from(const Json& json, const std::string& where) {
  const Vector3d direction = vector_in(json, where);
  if (!(direction.norm() > 0)) refuse_at(where, GLISSON_TEXT("{0} must not be zero."));
  return direction;
}

}  // namespace
}  // namespace glisson::mechanics
