#pragma once
// Values of a JSON document by their type: whatever else stands there counts as not there. Include it in .cpp files
// only.

#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "base/json.h"

namespace glisson {

// What stands under `key`; null where `object` is no object or lacks it.
[[nodiscard]] inline const Json* value_in(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

[[nodiscard]] inline std::optional<std::string> string_in(const Json& object, const char* key) {
  const Json* value = value_in(object, key);
  return value != nullptr && value->is_string() ? std::optional(value->get<std::string>()) : std::nullopt;
}

// Whether the object says exactly this, as in "format": "glisson-session/1".
[[nodiscard]] inline bool says(const Json& object, const char* key, std::string_view text) {
  const Json* value = value_in(object, key);
  return value != nullptr && value->is_string() && value->get_ref<const std::string&>() == text;
}

[[nodiscard]] inline bool says(const Json& object, const char* key, std::same_as<bool> auto truth) {
  const Json* value = value_in(object, key);
  return value != nullptr && value->is_boolean() && value->get<bool>() == truth;
}

}  // namespace glisson
