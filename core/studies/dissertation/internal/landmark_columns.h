#pragma once
// A patient's columns that say where landmarks go: as measured and by the atlas, by finite elements and meshfree. A
// group of landmarks is a prefix ("portal_forks"); one without a member has no columns but its number.

#include <array>
#include <utility>

#include "studies/dissertation/batch.h"
#include "studies/dissertation/liver_retraction.h"

namespace glisson::studies {

void add_landmark_columns(const MeasuredLiver& liver, const Retraction& retraction, NamedNumbers& row);

// By the meshfree engine: meshfree_answered (0 or 1), then how far the atlas is off by it (meshfree_...), and how far
// apart the two engines put the liver as measured (engines_...).
void add_engine_columns(const MeasuredLiver& liver, const Retraction& retraction, NamedNumbers& row);

// Those of add_engine_columns that are summed up, and what a legend calls them.
inline constexpr std::array<std::pair<const char*, const char*>, 12> engine_columns{
    {{"engines_mean_mm", "engines, on average"},
     {"engines_near_tool_mm", "engines, at tool"},
     {"engines_landmarks_mean_mm", "engines, landmarks"},
     {"engines_landmarks_max_mm", "engines, farthest landmark"},
     {"engines_forks_mean_mm", "engines, forks"},
     {"engines_forks_max_mm", "engines, farthest fork"},
     {"engines_near_tool_forks_mean_mm", "engines, forks at the tool"},
     {"engines_near_tool_forks_max_mm", "engines, farthest of them"},
     {"meshfree_atlas_mean_mm", "atlas, on average, meshfree"},
     {"meshfree_atlas_near_tool_mm", "atlas, at tool, meshfree"},
     {"meshfree_landmarks_max_mm", "atlas, farthest, meshfree"},
     {"meshfree_forks_max_mm", "atlas, farthest, meshfree"}}};

}  // namespace glisson::studies
