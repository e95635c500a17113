#pragma once
// What lies in a folder. std::filesystem's own loop over a folder throws where a disk or a network fails in its midst.

#include <filesystem>
#include <vector>

namespace glisson {

// In the order of their names, as many as could be read: none where it is no folder.
[[nodiscard]] std::vector<std::filesystem::path> contents_of(const std::filesystem::path& folder);

}  // namespace glisson
