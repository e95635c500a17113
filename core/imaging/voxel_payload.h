#pragma once
// How many voxels a volume file can hold at most, whatever its header says. Inside this room only.

#include <filesystem>
#include <string>

namespace glisson::imaging {

// Where the numbers are and how many bytes of them one byte of that file can stand for at most.
struct VoxelPayload {
  std::filesystem::path file;  // the volume file itself, or the one that a detached header names
  double most_bytes_per_byte = 1;
};
[[nodiscard]] VoxelPayload voxel_payload(const std::filesystem::path& file);

// The file's name without its folder, in lower case.
[[nodiscard]] std::string lower_case_name(const std::filesystem::path& file);

}  // namespace glisson::imaging
