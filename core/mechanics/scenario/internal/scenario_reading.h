#pragma once
// What the two files that read a scenario share.

#include <string>

#include "base/json_reading.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

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
