#pragma once
// JSON files. The one public header in which a third party's type (nlohmann::json) shows besides Eigen and
// tl::expected: include it in .cpp files only.

#include <Eigen/Core>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace glisson {

using Json = nlohmann::ordered_json;

// Reads one JSON document. The error names the file, the line and what is wrong.
Result<Json> read_json_file(const std::filesystem::path& file);
Result<Json> parse_json(std::string_view text, const std::filesystem::path& file = {});

// Writes indented, atomically; NaN and infinity do not occur in our files: they assert.
Result<void> write_json_file(const std::filesystem::path& file, const Json& document);

// Refuses a key of `object` that is not in `known`, naming `where` and the known key nearest to it in spelling.
Result<void> refuse_unknown_keys(const Json& object, std::initializer_list<std::string_view> known,
                                 const std::string& where);

// [x, y, z]
Json json_of(const Eigen::Vector3d& vector);

// Whether every number in the document is finite.
bool all_numbers_finite(const Json& document);

}  // namespace glisson
