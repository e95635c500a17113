#pragma once
// Names of the case as a reader of the report knows them. Inside the room.

#include <string>

namespace glisson::report {

// "portal-vein-2" -> "Portal vein 2".
[[nodiscard]] std::string plain_name(const std::string& id);
// An entry of the case: "labels/portal-vein-2" -> "Outline: portal vein 2".
[[nodiscard]] std::string plain_entry(const std::string& id);
// What made an entry, by the command that does: "segment" -> "outlined". Any other stays.
[[nodiscard]] std::string plain_way(const std::string& command);

}  // namespace glisson::report
