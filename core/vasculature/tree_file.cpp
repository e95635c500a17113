#include "vasculature/tree_file.h"

#include <cmath>

#include "base/json.h"
#include "base/json_value.h"

namespace glisson::vasculature {
namespace {

constexpr const char* format_name = "glisson-vessel-trees/1";

// Arteries and bile ducts stand by themselves: a program that knows veins alone passes them over.
constexpr const char* veins_key = "branches";
constexpr const char* beside_key = "arteries_and_ducts";

double rounded(double value) { return std::round(value * 1000) / 1000; }
Json json_of_place(const Eigen::Vector3d& p) { return {rounded(p.x()), rounded(p.y()), rounded(p.z())}; }

const char* joint_name(Joint joint) {
  return joint == Joint::vessel ? "vessel" : joint == Joint::gap ? "gap" : "contact";
}

bool read_place(const Json* value, Eigen::Vector3d& place) {
  if (value == nullptr || !value->is_array() || value->size() < 3) return false;
  for (std::size_t a = 0; a < 3; ++a) {
    if (!(*value)[a].is_number()) return false;
    place[static_cast<Eigen::Index>(a)] = (*value)[a].get<double>();
  }
  return true;
}

double number_in(const Json& object, const char* key, double otherwise) {
  const Json* value = value_in(object, key);
  return value != nullptr && value->is_number() ? value->get<double>() : otherwise;
}

// One branch; false where something of it is missing or makes no sense.
bool read_branch(const Json& object, std::size_t index, TreeBranch& branch) {
  const auto system = string_in(object, "system"), name = string_in(object, "name"), joint = string_in(object, "joint");
  const Json* points = value_in(object, "points");
  if (!system || !name || !joint || points == nullptr || !points->is_array() || points->size() < 2) return false;
  const auto known = system_named(*system);
  if (!known) return false;
  branch.system = *known;
  branch.name = *name;
  branch.joint = *joint == "gap" ? Joint::gap : *joint == "contact" ? Joint::contact : Joint::vessel;
  branch.confidence = number_in(object, "confidence", 1);
  const double parent = number_in(object, "parent", -1);
  if (!(parent >= -1) || !(parent < static_cast<double>(index))) return false;
  branch.parent = static_cast<int>(parent);
  const double generation = number_in(object, "generation", 0);
  if (!(generation >= 0) || !(generation <= static_cast<double>(index))) return false;
  branch.generation = static_cast<int>(generation);
  branch.length_mm = number_in(object, "length_mm", 0);
  branch.radius_mm = number_in(object, "radius_mm", 0);
  for (const Json& point : *points) {
    CenterPoint read;
    if (!read_place(&point, read.position_mm) || point.size() != 4 || !point[3].is_number()) return false;
    read.radius_mm = point[3].get<double>();
    if (!(read.radius_mm >= 0)) return false;
    branch.points.push_back(read);
  }
  return true;
}

// False where one is no click; where there is none of them nothing was clicked on.
bool read_clicks(const Json* values, Clicks& clicks) {
  if (values == nullptr) return true;
  if (!values->is_array()) return false;
  for (const Json& value : *values) {
    const auto name = string_in(value, "vessel");
    const auto vessel = name ? vessel_named(*name) : std::nullopt;
    Click& click = clicks.emplace_back();
    if (!vessel || !read_place(value_in(value, "position_mm"), click.position_mm)) return false;
    click.vessel = *vessel;
  }
  return true;
}

bool read_borders(const Json* values, BorderPlaces& borders) {
  if (values == nullptr) return true;
  if (!values->is_array()) return false;
  for (const Json& value : *values) {
    const auto name = string_in(value, "border");
    const auto segments = name ? border_named(*name) : std::nullopt;
    BorderPlace& place = borders.emplace_back();
    if (!segments || !read_place(value_in(value, "position_mm"), place.position_mm)) return false;
    place.segments = *segments;
  }
  return true;
}

bool read_border_doubts(const Json* values, std::vector<BorderDoubt>& doubts) {
  if (values == nullptr) return true;
  if (!values->is_array()) return false;
  for (const Json& value : *values) {
    const auto name = string_in(value, "vessel");
    const auto vessel = name ? vessel_named(*name) : std::nullopt;
    const double doubt_ml = number_in(value, "doubt_ml", -1);
    if (!vessel || !(doubt_ml >= 0)) return false;
    doubts.push_back({*vessel, doubt_ml});
  }
  return true;
}

}  // namespace

Json border_doubts_json(const VesselTrees& trees) {
  Json doubts = Json::array();
  for (const BorderDoubt& doubt : trees.border_doubts) {
    doubts.push_back({{"vessel", vessel_name(doubt.vessel)}, {"doubt_ml", rounded(doubt.doubt_ml)}});
  }
  return doubts;
}

Json trees_json(const VesselTrees& trees) {
  Json document{{"format", format_name},
                {"frame", "patient coordinates, LPS, mm"},
                {"portal_entry_mm", json_of_place(trees.portal_entry_mm)},
                {"hepatic_entry_mm", json_of_place(trees.hepatic_entry_mm)},
                {"clicks", Json::array()},
                {"borders", Json::array()},
                {"border_doubts", border_doubts_json(trees)},
                {veins_key, Json::array()}};
  for (const Click& click : trees.clicks) {
    document["clicks"].push_back(
        {{"vessel", vessel_name(click.vessel)}, {"position_mm", json_of_place(click.position_mm)}});
  }
  for (const BorderPlace& place : trees.borders) {
    document["borders"].push_back(
        {{"border", border_name(place.segments)}, {"position_mm", json_of_place(place.position_mm)}});
  }
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    const TreeBranch& branch = trees.branches[b];
    Json points = Json::array();
    for (const CenterPoint& point : branch.points) {
      Json values = json_of_place(point.position_mm);
      values.push_back(rounded(point.radius_mm));
      points.push_back(std::move(values));
    }
    document[is_vein(branch.system) ? veins_key : beside_key].push_back({{"id", b},
                                                                         {"name", branch.name},
                                                                         {"parent", branch.parent},
                                                                         {"system", system_name(branch.system)},
                                                                         {"radius_mm", rounded(branch.radius_mm)},
                                                                         {"length_mm", rounded(branch.length_mm)},
                                                                         {"confidence", rounded(branch.confidence)},
                                                                         {"generation", branch.generation},
                                                                         {"joint", joint_name(branch.joint)},
                                                                         {"points", std::move(points)}});
  }
  return document;
}

Result<void> write_trees(const std::filesystem::path& file, const VesselTrees& trees) {
  return write_json_file(file, trees_json(trees));
}

Result<VesselTrees> read_trees(const std::filesystem::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  const auto unreadable = [&](const std::string& what) {
    return failure(Error{"trees-unreadable",
                         GLISSON_TEXT("The vessel trees cannot be read: {0} is missing or makes no sense."),
                         {what},
                         GLISSON_TEXT("Find the vessels again."),
                         file});
  };
  if (!says(*document, "format", format_name)) return unreadable("format");
  VesselTrees trees;
  if (!read_place(value_in(*document, "portal_entry_mm"), trees.portal_entry_mm)) return unreadable("portal_entry_mm");
  if (!read_place(value_in(*document, "hepatic_entry_mm"), trees.hepatic_entry_mm)) {
    return unreadable("hepatic_entry_mm");
  }
  if (!read_clicks(value_in(*document, "clicks"), trees.clicks)) return unreadable("clicks");
  if (!read_borders(value_in(*document, "borders"), trees.borders)) return unreadable("borders");
  if (!read_border_doubts(value_in(*document, "border_doubts"), trees.border_doubts))
    return unreadable("border_doubts");
  for (const bool veins : {true, false}) {
    const char* key = veins ? veins_key : beside_key;
    const Json* branches = value_in(*document, key);
    if (branches == nullptr && !veins) continue;
    if (branches == nullptr || !branches->is_array()) return unreadable(key);
    for (std::size_t n = 0; n < branches->size(); ++n) {
      TreeBranch branch;
      if (!read_branch((*branches)[n], trees.branches.size(), branch) || is_vein(branch.system) != veins) {
        return unreadable(std::string(key) + "[" + std::to_string(n) + "]");
      }
      trees.branches.push_back(std::move(branch));
    }
  }
  return trees;
}

}  // namespace glisson::vasculature
