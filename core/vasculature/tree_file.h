#pragma once
// Vessel trees in a JSON file, `glisson-vessel-trees/1` (docs/file-formats.md).

#include <filesystem>

#include "base/json_forward.h"
#include "base/result.h"
#include "vasculature/systems.h"

namespace glisson::vasculature {

[[nodiscard]] Json trees_json(const VesselTrees& trees);
[[nodiscard]] Json border_doubts_json(const VesselTrees& trees);  // {"vessel", "doubt_ml"} each

Result<void> write_trees(const std::filesystem::path& file, const VesselTrees& trees);

// Fails with trees-unreadable, naming what is missing or damaged.
Result<VesselTrees> read_trees(const std::filesystem::path& file);

}  // namespace glisson::vasculature
