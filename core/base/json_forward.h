#pragma once
// The name of a JSON document's type, for headers whose functions give or take one. A .cpp file that looks into it
// includes base/json.h.

#include <nlohmann/json_fwd.hpp>

namespace glisson {

using Json = nlohmann::ordered_json;  // as in base/json.h

// The document as its text reads: null where a number is not finite.
[[nodiscard]] Json null_where_not_finite(Json document);

}  // namespace glisson
