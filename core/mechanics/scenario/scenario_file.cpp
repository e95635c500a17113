#include "mechanics/scenario/scenario_file.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "base/files.h"
#include "mechanics/materials/tissue.h"
#include "mechanics/scenario/internal/scenario_reading.h"
#include "mechanics/scenario/patient_position.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

// As "material" says them.
constexpr std::initializer_list<std::pair<const char*, MaterialLaw>> named_laws{
    {"linear", MaterialLaw::linear},
    {"corotational", MaterialLaw::corotational},
    {"neo-hookean", MaterialLaw::neo_hookean},
    {"veronda-westmann", MaterialLaw::veronda_westmann}};

Scenario scenario_from(const Json& json);
Support support_from(const Json& json, const std::string& where);
Fixed fixed_from(const Json& json, const std::string& where);
Load load_from(const Json& json, const std::string& where);
Vector3d gravity_of_patient_from(const Json& json, const std::string& where);
Capsule capsule_from(const Json& json, const std::string& where);
TransverseIsotropy anisotropy_from(const Json& json, const std::string& where);
RelaxationTerm relaxation_term_from(const Json& json, const std::string& where);
Landmark landmark_from(const Json& json, const std::string& where);
Motion motion_from(const Json& json, const std::string& where);
MeshfreeOptions meshfree_from(const Json& json, const std::string& where);
Json support_json(const Support& support);
Json load_json(const Load& load);

}  // namespace

Result<Scenario> read_scenario(const std::filesystem::path& file) {
  return read_text_file(file, std::uint64_t{64} << 20).and_then([&](const std::string& text) {
    return parse_scenario(text, file);
  });
}

Result<Scenario> parse_scenario(std::string_view json, const std::filesystem::path& file) {
  auto document = parse_json(json, file);
  if (!document) return failure(std::move(document.error()));
  return reading("scenario-invalid", file, [&] { return scenario_from(*document); });
}

Result<std::vector<Support>> parse_supports(const Json& json, const std::string& code) {
  auto scenario = reading("scenario-invalid", {}, [&] { return scenario_from(Json{{"supports", json}}); });
  if (!scenario) {
    scenario.error().code = code;
    return failure(std::move(scenario.error()));
  }
  return std::move(scenario->supports);
}

const char* name_of(MaterialLaw law) {
  return std::find_if(named_laws.begin(), named_laws.end(), [&](const auto& one) { return one.second == law; })->first;
}

std::optional<MaterialLaw> law_named(std::string_view name) {
  const auto found =
      std::find_if(named_laws.begin(), named_laws.end(), [&](const auto& one) { return one.first == name; });
  return found == named_laws.end() ? std::nullopt : std::optional(found->second);
}

std::string scenario_text(const Scenario& scenario) {
  Json json;
  json["engine"] = scenario.engine == Engine::fem ? "fem" : "meshfree";
  json["material"] = name_of(scenario.material);
  if (scenario.material == MaterialLaw::veronda_westmann) json["strain_stiffening"] = scenario.strain_stiffening;
  json["poisson_ratio"] = scenario.poisson_ratio;
  json["density_kg_m3"] = units::kg_m3_from_kg_mm3(scenario.density_kg_mm3);
  if (scenario.youngs_modulus) {
    std::visit([&](const auto& modulus) { json["youngs_modulus_kPa"] = modulus; }, *scenario.youngs_modulus);
  }
  json["supports"] = Json::array();
  for (const Support& support : scenario.supports) json["supports"].push_back(support_json(support));
  if (scenario.capsule) {
    json["capsule"] = {{"youngs_modulus_kPa", scenario.capsule->youngs_modulus_kPa},
                       {"thickness_mm", scenario.capsule->thickness_mm}};
  }
  if (scenario.anisotropy) {
    const Vector3d& axis = scenario.anisotropy->axis;
    json["grain"] = {{"axis", {axis.x(), axis.y(), axis.z()}},
                     {"ratio", scenario.anisotropy->ratio},
                     {"law", scenario.anisotropy->law == AnisotropyLaw::fibres ? "fibres" : "engineering"}};
    if (scenario.anisotropy->shear_ratio != 1) json["grain"]["shear_ratio"] = scenario.anisotropy->shear_ratio;
  }
  for (const RelaxationTerm& term : scenario.relaxation) {
    json["relaxation"].push_back({{"weight", term.weight}, {"time_s", term.time_s}});
  }
  json["loads"] = Json::array();
  for (const Load& load : scenario.loads) json["loads"].push_back(load_json(load));
  if (scenario.motion) {
    json["motion"] = {{"step_s", scenario.motion->step_s},
                      {"steps", scenario.motion->steps},
                      {"mass_damping_per_s", scenario.motion->mass_damping_per_s},
                      {"stiffness_damping_s", scenario.motion->stiffness_damping_s}};
  }
  json["landmarks"] = Json::array();
  for (const Landmark& landmark : scenario.landmarks) {
    const Vector3d& p = landmark.position_mm;
    json["landmarks"].push_back({{"id", landmark.id}, {"position_mm", {p.x(), p.y(), p.z()}}});
  }
  for (const Cut& cut : scenario.cuts) json["cuts"].push_back(json_of(cut));
  if (scenario.cut_walls == Scenario::Walls::apart) json["cut_walls"] = "apart";
  for (const ScenarioTool& tool : scenario.tools) json["tools"].push_back(json_of(tool));
  if (scenario.engine == Engine::meshfree) {
    if (scenario.meshfree.nodes > 0) json["meshfree"]["nodes"] = scenario.meshfree.nodes;
    json["meshfree"]["stiffness"] =
        scenario.meshfree.stiffness == MeshfreeOptions::Stiffness::of_cells ? "cells" : "nodes";
  }
  return json.dump(2) + "\n";
}

namespace {

// --- the scenario, from its outside in

template <typename Named>
void refuse_same_ids(const std::vector<Named>& named, const char* each) {
  for (std::size_t i = 0; i < named.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (named[i].id == named[k].id)
        refuse_at(item(each, i), GLISSON_TEXT("{0} has the same id \"{1}\" as another."), {named[i].id});
    }
  }
}

Scenario scenario_from(const Json& json) {
  only_keys(json,
            {"engine", "material", "strain_stiffening", "poisson_ratio", "density_kg_m3", "youngs_modulus_kPa",
             "tissue", "supports", "capsule", "grain", "relaxation", "loads", "motion", "landmarks", "cuts",
             "cut_walls", "tools", "meshfree"},
            "The scenario");
  Scenario scenario;
  if (json.contains("engine")) {
    scenario.engine = one_of<Engine>(json["engine"], "engine", {{"fem", Engine::fem}, {"meshfree", Engine::meshfree}});
  }
  if (json.contains("material")) {
    scenario.material = one_of<MaterialLaw>(json["material"], "material", named_laws);
  }
  if ((scenario.material == MaterialLaw::veronda_westmann) != json.contains("strain_stiffening")) {
    refuse_at("strain_stiffening",
              GLISSON_TEXT("{0} goes with the material \"veronda-westmann\": give both or neither."));
  }
  if (json.contains("strain_stiffening")) {
    scenario.strain_stiffening = positive_in(json["strain_stiffening"], "strain_stiffening");
  }
  if (json.contains("poisson_ratio")) {
    scenario.poisson_ratio = number_in(json["poisson_ratio"], "poisson_ratio");
    if (scenario.poisson_ratio <= -1.0 || scenario.poisson_ratio >= 0.5) {
      refuse_at("poisson_ratio", GLISSON_TEXT("{0} must lie between -1 and 0.5, both excluded."));
    }
  }
  if (json.contains("density_kg_m3")) {
    scenario.density_kg_mm3 = units::kg_mm3_from_kg_m3(positive_in(json["density_kg_m3"], "density_kg_m3"));
  }
  if (json.contains("youngs_modulus_kPa")) {
    const Json& modulus = json["youngs_modulus_kPa"];
    if (modulus.is_string()) {
      scenario.youngs_modulus = name_in(modulus, "youngs_modulus_kPa");
    } else {
      scenario.youngs_modulus = positive_in(modulus, "youngs_modulus_kPa");
    }
  }
  if (json.contains("tissue")) {
    if (scenario.youngs_modulus) {
      refuse_at("tissue", GLISSON_TEXT("{0} and \"youngs_modulus_kPa\" both say how stiff the body is: give one."));
    }
    const auto tissue = taken(published_tissue(name_in(json["tissue"], "tissue")));
    scenario.youngs_modulus = tissue.youngs_modulus_kPa(scenario.poisson_ratio);
  }
  if (json.contains("capsule")) scenario.capsule = capsule_from(json["capsule"], "capsule");
  scenario.relaxation = list_of<RelaxationTerm>(json, "relaxation", "relaxation", relaxation_term_from);
  if (auto checked = check_relaxation(scenario.relaxation); !checked) {
    refuse("", checked.error().text, checked.error().arguments);
  }
  if (json.contains("grain")) scenario.anisotropy = anisotropy_from(json["grain"], "grain");
  scenario.supports = list_of<Support>(json, "supports", "support", support_from);
  scenario.loads = list_of<Load>(json, "loads", "load", load_from);
  scenario.landmarks = list_of<Landmark>(json, "landmarks", "landmark", landmark_from);
  scenario.cuts = list_of<Cut>(json, "cuts", "cut", cut_from);
  if (json.contains("cut_walls")) {
    scenario.cut_walls = one_of<Scenario::Walls>(json["cut_walls"], "cut_walls",
                                                 {{"free", Scenario::Walls::free}, {"apart", Scenario::Walls::apart}});
  }
  scenario.tools = list_of<ScenarioTool>(json, "tools", "tool", tool_from);
  if (json.contains("meshfree")) scenario.meshfree = meshfree_from(json["meshfree"], "meshfree");
  if (json.contains("motion")) scenario.motion = motion_from(json["motion"], "motion");
  refuse_same_ids(scenario.landmarks, "landmark");
  refuse_same_ids(scenario.tools, "tool");
  return scenario;
}

Support support_from(const Json& json, const std::string& where) {
  only_keys(json,
            {"point_array", "sphere", "box", "foundation_kPa_per_mm", "directions", "displacement_mm", "ligament"},
            where);
  Support support{region_from(json, where), Fixed{}};
  if (json.contains("displacement_mm") && (json.contains("ligament") || json.contains("foundation_kPa_per_mm")))
    refuse_at(where, GLISSON_TEXT("{0} moves by a displacement: it is neither a foundation nor a ligament."));
  if (json.contains("ligament")) {
    if (json.contains("directions") || json.contains("foundation_kPa_per_mm"))
      refuse_at(where,
                GLISSON_TEXT("{0} is a ligament: it takes neither \"foundation_kPa_per_mm\" nor \"directions\"."));
    const Json& band = json["ligament"];
    const std::string inside = where + ", ligament";
    only_keys(band, {"anchor_mm", "stiffness_N_per_mm", "slack_mm"}, inside);
    const double slack_mm = band.contains("slack_mm") ? not_negative_in(band["slack_mm"], inside + ", slack_mm") : 0.0;
    support.how = Ligament{
        vector_in(required(band, "anchor_mm", inside), inside + ", anchor_mm"),
        units::mN_from_N(positive_in(required(band, "stiffness_N_per_mm", inside), inside + ", stiffness_N_per_mm")),
        slack_mm};
  } else if (json.contains("foundation_kPa_per_mm")) {
    if (json.contains("directions"))
      refuse_at(where,
                GLISSON_TEXT(
                    "{0} has both \"foundation_kPa_per_mm\" and \"directions\": a foundation acts in all directions."));
    support.how = Foundation{positive_in(json["foundation_kPa_per_mm"], where + ", foundation_kPa_per_mm")};
  } else {
    support.how = fixed_from(json, where);
  }
  return support;
}

Fixed fixed_from(const Json& json, const std::string& where) {
  Fixed fixed;
  if (json.contains("directions")) {
    const Json& directions = json["directions"];
    if (!directions.is_array() || directions.empty())
      refuse_at(where, GLISSON_TEXT("The directions of {0} must be a list such as [\"x\", \"z\"]."));
    fixed.directions = {false, false, false};
    for (const Json& direction : directions) {
      fixed.directions[one_of<std::size_t>(direction, where + ", directions", {{"x", 0}, {"y", 1}, {"z", 2}})] = true;
    }
  }
  if (json.contains("displacement_mm")) {
    fixed.displacement_mm = vector_in(json["displacement_mm"], where + ", displacement_mm");
    for (int d = 0; d < 3; ++d) {
      if (!fixed.directions[static_cast<std::size_t>(d)] && fixed.displacement_mm[d] != 0)
        refuse_at(where, GLISSON_TEXT("{0} is moved in a direction that its \"directions\" leave free."));
    }
  }
  return fixed;
}

Load load_from(const Json& json, const std::string& where) {
  only_keys(json, {"tool", "pressure_kPa", "gravity_m_s2", "gravity_of_patient"}, where);
  if (json.size() != 1)
    refuse_at(where, GLISSON_TEXT("{0} needs exactly one of \"tool\", \"pressure_kPa\", \"gravity_m_s2\" and "
                                  "\"gravity_of_patient\"."));
  if (json.contains("gravity_of_patient"))
    return GravityLoad{gravity_of_patient_from(json["gravity_of_patient"], where + ", gravity_of_patient")};
  if (json.contains("pressure_kPa")) return PressureLoad{number_in(json["pressure_kPa"], where + ", pressure_kPa")};
  if (json.contains("gravity_m_s2")) {
    return GravityLoad{vector_in(json["gravity_m_s2"], where + ", gravity_m_s2").unaryExpr(&units::mm_s2_from_m_s2)};
  }
  const Json& tool = json["tool"];
  only_keys(tool, {"center_mm", "radius_mm", "force_N"}, where + ", tool");
  return ToolLoad{
      vector_in(required(tool, "center_mm", where + ", tool"), where + ", center_mm"),
      positive_in(required(tool, "radius_mm", where + ", tool"), where + ", radius_mm"),
      vector_in(required(tool, "force_N", where + ", tool"), where + ", force_N").unaryExpr(&units::mN_from_N)};
}

Vector3d gravity_of_patient_from(const Json& json, const std::string& where) {
  only_keys(json, {"reverse_trendelenburg_deg", "left_tilt_deg", "right_tilt_deg", "scanned_supine"}, where);
  const auto angle = [&](const char* key) {
    const double value = json.contains(key) ? number_in(json[key], where + ", " + key) : 0.0;
    if (std::abs(value) > 90) refuse_at(where + ", " + key, GLISSON_TEXT("{0} must lie between -90 and 90 degrees."));
    return value;
  };
  if (json.contains("left_tilt_deg") && json.contains("right_tilt_deg"))
    refuse_at(where, GLISSON_TEXT("{0} has both \"left_tilt_deg\" and \"right_tilt_deg\": give one."));
  const PatientPosition position{angle("reverse_trendelenburg_deg"), angle("left_tilt_deg") - angle("right_tilt_deg")};
  const bool scanned_supine =
      json.contains("scanned_supine") && truth_in(json["scanned_supine"], where + ", scanned_supine");
  return gravity_mm_s2(position) - (scanned_supine ? gravity_mm_s2(supine) : Vector3d::Zero());
}

Capsule capsule_from(const Json& json, const std::string& where) {
  only_keys(json, {"youngs_modulus_kPa", "thickness_mm"}, where);
  Capsule capsule;
  if (json.contains("youngs_modulus_kPa")) {
    capsule.youngs_modulus_kPa = positive_in(json["youngs_modulus_kPa"], where + ", youngs_modulus_kPa");
  }
  capsule.thickness_mm = positive_in(required(json, "thickness_mm", where), where + ", thickness_mm");
  return capsule;
}

TransverseIsotropy anisotropy_from(const Json& json, const std::string& where) {
  only_keys(json, {"axis", "ratio", "law", "shear_ratio"}, where);
  TransverseIsotropy anisotropy;
  anisotropy.axis = vector_in(required(json, "axis", where), where + ", axis");
  anisotropy.ratio = positive_in(required(json, "ratio", where), where + ", ratio");
  if (json.contains("shear_ratio")) {
    anisotropy.shear_ratio = positive_in(json["shear_ratio"], where + ", shear_ratio");
  }
  if (json.contains("law")) {
    anisotropy.law = one_of<AnisotropyLaw>(
        json["law"], where + ", law", {{"fibres", AnisotropyLaw::fibres}, {"engineering", AnisotropyLaw::engineering}});
  }
  return anisotropy;
}

RelaxationTerm relaxation_term_from(const Json& json, const std::string& where) {
  only_keys(json, {"weight", "time_s"}, where);
  return {positive_in(required(json, "weight", where), where + ", weight"),
          positive_in(required(json, "time_s", where), where + ", time_s")};
}

Landmark landmark_from(const Json& json, const std::string& where) {
  only_keys(json, {"id", "position_mm"}, where);
  return {name_in(required(json, "id", where), where + ", id"),
          vector_in(required(json, "position_mm", where), where + ", position_mm")};
}

Motion motion_from(const Json& json, const std::string& where) {
  only_keys(json, {"step_s", "steps", "mass_damping_per_s", "stiffness_damping_s"}, where);
  Motion motion;
  const auto damping = [&](const char* key) {
    return json.contains(key) ? not_negative_in(json[key], where + ", " + key) : 0.0;
  };
  motion.mass_damping_per_s = damping("mass_damping_per_s");
  motion.stiffness_damping_s = damping("stiffness_damping_s");
  motion.step_s = positive_in(required(json, "step_s", where), where + ", step_s");
  const Json& steps = required(json, "steps", where);
  if (!steps.is_number_integer() || steps.get<double>() < 1 || steps.get<double>() > 1e6) {
    refuse_at(where, GLISSON_TEXT("The steps of {0} must be a whole number from 1 to 1000000."));
  }
  motion.steps = steps.get<int>();
  return motion;
}

MeshfreeOptions meshfree_from(const Json& json, const std::string& where) {
  only_keys(json, {"nodes", "stiffness"}, where);
  MeshfreeOptions options;
  if (json.contains("nodes")) {
    const Json& nodes = json["nodes"];
    if (!nodes.is_number_integer() || nodes.get<double>() < 1 || nodes.get<double>() > 1e6) {
      refuse_at(where, GLISSON_TEXT("The nodes of {0} must be a whole number from 1 to 1000000."));
    }
    options.nodes = nodes.get<int>();
  }
  if (json.contains("stiffness")) {
    using Stiffness = MeshfreeOptions::Stiffness;
    options.stiffness = one_of<Stiffness>(json["stiffness"], where + ", stiffness",
                                          {{"cells", Stiffness::of_cells}, {"nodes", Stiffness::of_nodes}});
  }
  return options;
}

// --- and back

Json support_json(const Support& support) {
  Json json = json_of(support.where);
  if (const auto* ligament = std::get_if<Ligament>(&support.how)) {
    json["ligament"] = {{"anchor_mm", json_of(ligament->anchor_mm)},
                        {"stiffness_N_per_mm", units::N_from_mN(ligament->stiffness_mN_per_mm)},
                        {"slack_mm", ligament->slack_mm}};
  } else if (const auto* foundation = std::get_if<Foundation>(&support.how)) {
    json["foundation_kPa_per_mm"] = foundation->stiffness_kPa_per_mm;
  } else {
    const Fixed& fixed = std::get<Fixed>(support.how);
    for (std::size_t d = 0; d < 3 && fixed.directions != std::array{true, true, true}; ++d) {
      if (fixed.directions[d]) json["directions"].push_back(std::string(1, "xyz"[d]));
    }
    if (fixed.displacement_mm != Vector3d::Zero()) json["displacement_mm"] = json_of(fixed.displacement_mm);
  }
  return json;
}

Json load_json(const Load& load) {
  if (const auto* tool = std::get_if<ToolLoad>(&load)) {
    return {{"tool",
             {{"center_mm", json_of(tool->center_mm)},
              {"radius_mm", tool->radius_mm},
              {"force_N", json_of(tool->force_mN.unaryExpr(&units::N_from_mN))}}}};
  }
  if (const auto* pressure = std::get_if<PressureLoad>(&load)) return {{"pressure_kPa", pressure->pressure_kPa}};
  return {{"gravity_m_s2", json_of(std::get<GravityLoad>(load).acceleration_mm_s2.unaryExpr(&units::m_s2_from_mm_s2))}};
}

}  // namespace
}  // namespace glisson::mechanics
