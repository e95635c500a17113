#pragma once
// The voxels of a volume file, block by block, with nothing missing at their end.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "base/result.h"
#include "imaging/internal/volume_header.h"

namespace glisson::imaging {

// Calls take(values, count) for one block after the other, in the order of the file, rescaled by the header. Together
// they are as many as the grid has. Memory for one block is all that is asked for. Compressed streams must end where
// the voxels do, with the right checksum. Fails with volume-file-truncated, -damaged (decompression, checksum) or
// -unreadable. Fails with volume-file-longer where a row of voxels or more lies behind the last one. Then the sizes are
// not those that the file was written with.
[[nodiscard]] Result<void> read_voxels(const VolumeHeader& header, const std::filesystem::path& file,
                                       const std::function<void(const double* values, std::size_t count)>& take);

// The first `count` bytes that come out of the stream that begins at a byte of the file; fewer where it is damaged.
[[nodiscard]] std::string beginning_of_deflated(const std::filesystem::path& file, std::uint64_t begin,
                                                std::size_t count);

}  // namespace glisson::imaging
