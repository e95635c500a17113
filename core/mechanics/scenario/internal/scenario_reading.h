#pragma once
// What the readers of a scenario share: refusals with their place, and values of every kind. Inside of this room.

#include <cmath>
#include <Eigen/Core>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "base/json.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

// Inside the readers refusals travel as exceptions: each can then simply give back its value. parse_scenario ends them.

struct Refusal {
  Error error;
};

[[noreturn]] inline void refuse(const std::string& where, const std::string& text, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{where};
  arguments.insert(arguments.end(), more.begin(), more.end());
  throw Refusal{{"scenario-invalid", text, std::move(arguments), {}, {}}};
}

inline void known_keys(const Json& json, std::initializer_list<std::string_view> known, const std::string& where) {
  if (!json.is_object()) refuse(where, GLISSON_TEXT("{0} must be an object in braces."));
  if (auto checked = refuse_unknown_keys(json, known, where); !checked) {
    checked.error().code = "scenario-invalid";
    throw Refusal{std::move(checked.error())};
  }
}

inline const Json& required(const Json& json, const char* key, const std::string& where) {
  const auto found = json.find(key);
  if (found == json.end()) refuse(where, GLISSON_TEXT("{0} lacks \"{1}\"."), {key});
  return *found;
}

inline double number(const Json& json, const std::string& where) {
  if (!json.is_number() || !std::isfinite(json.get<double>()))
    refuse(where, GLISSON_TEXT("{0} must be a finite number."));
  return json.get<double>();
}

inline double positive_number(const Json& json, const std::string& where) {
  const double value = number(json, where);
  if (value <= 0) refuse(where, GLISSON_TEXT("{0} must be above zero."));
  return value;
}

inline Eigen::Vector3d vector(const Json& json, const std::string& where) {
  if (!json.is_array() || json.size() != 3) refuse(where, GLISSON_TEXT("{0} must be three numbers [x, y, z]."));
  Eigen::Vector3d value;
  for (std::size_t i = 0; i < 3; ++i) value[static_cast<Eigen::Index>(i)] = number(json[i], where);
  return value;
}

inline std::string name(const Json& json, const std::string& where) {
  if (!json.is_string() || json.get_ref<const std::string&>().empty())
    refuse(where, GLISSON_TEXT("{0} must be a name in quotes."));
  return json.get<std::string>();
}

template <typename Value>
Value one_of(const Json& json, const std::string& where, std::initializer_list<std::pair<const char*, Value>> choices) {
  std::string list;
  for (const auto& [text, value] : choices) {
    if (json == text) return value;
    list += (list.empty() ? "\"" : ", \"") + std::string(text) + "\"";
  }
  refuse(where, GLISSON_TEXT("{0} must be one of {1}."), {list});
}

inline std::string item(const char* list, std::size_t index) {
  return std::string(list) + " " + std::to_string(index + 1);
}

// "supports" -> support_from for each, and so on.
template <typename Value>
std::vector<Value> list_of(const Json& json, const char* key, const char* each,
                           Value (*read)(const Json&, const std::string&)) {
  std::vector<Value> values;
  const auto found = json.find(key);
  if (found == json.end()) return values;
  if (!found->is_array()) refuse(key, GLISSON_TEXT("{0} must be a list in brackets."));
  for (std::size_t i = 0; i < found->size(); ++i) values.push_back(read((*found)[i], item(each, i)));
  return values;
}

// "point_array", "sphere" or "box", exactly one of them.
[[nodiscard]] Region region_from(const Json& json, const std::string& where);

// scenario_surgery.cpp
[[nodiscard]] Cut cut_from(const Json& json, const std::string& where);
[[nodiscard]] ScenarioTool tool_from(const Json& json, const std::string& where);

// And back.
using glisson::json_of;  // of a vector
[[nodiscard]] Json json_of(const Region& region);
[[nodiscard]] Json json_of(const Cut& cut);
[[nodiscard]] Json json_of(const ScenarioTool& tool);

}  // namespace glisson::mechanics
