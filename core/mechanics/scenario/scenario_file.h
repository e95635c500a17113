#pragma once
// Scenarios as JSON, read strictly: nothing is passed over. Refused are a key that is not known, a number that is not
// finite or out of range, and a shape that is not understood. So is whatever this version cannot compute yet.
//
//   {"engine": "fem", "material": "linear", "poisson_ratio": 0.45, "density_kg_m3": 1000,
//    "youngs_modulus_kPa": 5.0 or "name of a cell array",
//    "supports": [{"point_array": "fixed"} | {"sphere": {"center_mm": [x,y,z], "radius_mm": r}}
//                 | {"box": {"min_mm": [x,y,z], "max_mm": [x,y,z]}},
//                 each with at most one of "foundation_kPa_per_mm": k and "directions": ["x","y","z"]],
//    "loads": [{"tool": {"center_mm": [x,y,z], "radius_mm": r, "force_N": [x,y,z]}}
//              | {"pressure_kPa": p} | {"gravity_m_s2": [x,y,z]}],
//    "relaxation": [{"weight": 0.3, "time_s": 5}],
//    "motion": {"step_s": 0.02, "steps": 50, "mass_damping_per_s": 0, "stiffness_damping_s": 0},
//    "landmarks": [{"id": "tumour-1", "position_mm": [x,y,z]}]}

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/json_forward.h"
#include "base/result.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics {

// N, kg/m3 and m/s2 become mN, kg/mm3 and mm/s2 here and nowhere else. Failures: "scenario-invalid" (what, where,
// and what was probably meant), "not-available" (a feature that this version does not compute), those of reading.
Result<Scenario> read_scenario(const std::filesystem::path& file);
Result<Scenario> parse_scenario(std::string_view json, const std::filesystem::path& file = {});

// A list of supports as a scenario has it, of another format: what is wrong in it is refused by that format's `code`.
Result<std::vector<Support>> parse_supports(const Json& json, const std::string& code);

// A law as a scenario's "material" says it, and back; nothing where no law is called so.
[[nodiscard]] const char* name_of(MaterialLaw law);
[[nodiscard]] std::optional<MaterialLaw> law_named(std::string_view name);

// The same scenario as JSON text, which parse_scenario reads back.
std::string scenario_text(const Scenario& scenario);

}  // namespace glisson::mechanics
