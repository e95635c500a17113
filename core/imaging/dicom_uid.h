#pragma once
// Unique identifiers that follow from what they name, so that the same study gets the same ones every time.

#include <string>
#include <string_view>

namespace glisson::imaging {

// "2.25." and 128 bits of the name's SHA-256 in decimal (DICOM PS3.5 B.2), at most 44 characters.
[[nodiscard]] std::string uid_from_name(std::string_view name);

}  // namespace glisson::imaging
