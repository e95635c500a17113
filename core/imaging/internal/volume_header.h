#pragma once
// What the header of a NIfTI, NRRD or MetaImage file says, believed as far as it can be checked.
//
// The headers are read here and not by a library. Anybody may have made the file, so every field is doubted before it
// is used. Each format promises where its voxels lie, and that is compared with what is there.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "imaging/image.h"

namespace glisson::imaging {

enum class VoxelType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };
[[nodiscard]] std::uint64_t bytes_of(VoxelType type);

enum class VoxelCoding {
  raw,
  deflated,  // gzip or zlib, as the stream itself says
  text       // decimal numbers
};

struct VolumeHeader {
  Grid grid;
  VoxelType type = VoxelType::uint8;
  bool big_endian = false;
  VoxelCoding coding = VoxelCoding::raw;
  std::filesystem::path data;             // the file that holds the voxels: this one, or one that it names
  std::uint64_t begin = 0;                // of the voxels, or of the compressed stream, in that file
  std::uint64_t skipped = 0;              // bytes before the voxels in what comes out of the compressed stream
  bool at_the_end = false;                // raw voxels end with the file, whatever stands before them
  std::optional<std::uint64_t> in_bytes;  // of the compressed stream, where the header says so
  double slope = 1, intercept = 0;        // value = slope * stored + intercept
  std::map<std::string, std::string> notes;

  [[nodiscard]] std::uint64_t voxel_bytes() const { return grid.voxels() * bytes_of(type); }
};

// By the file's name: .nii .nii.gz, .nrrd .nhdr, .mha .mhd. Sizes are positive, below 2^31 along each axis and at most
// maximum_voxels together, spacings positive, axes at right angles. Fails with volume-file-unknown-type, -unreadable,
// -not-scalar, -not-3d, -bad-grid, -too-large, -truncated (the file cannot hold that many).
[[nodiscard]] Result<VolumeHeader> read_volume_header(const std::filesystem::path& file);

// Twice what the largest scans have (512 x 512 x 1000); as floats, 2 GiB.
inline constexpr std::uint64_t maximum_voxels = std::uint64_t{1} << 29;

[[nodiscard]] bool has_volume_header_name(const std::filesystem::path& file);

// The formats, one each; read_volume_header checks what they found.
struct FoundHeader {
  VolumeHeader header;
  std::vector<std::int64_t> sizes;  // of the axes in space, at least as many as there are
  std::int64_t components = 1;      // values at each voxel
};
[[nodiscard]] Result<FoundHeader> read_nifti_header(const std::filesystem::path& file, bool compressed);
[[nodiscard]] Result<FoundHeader> read_nrrd_header(const std::filesystem::path& file);
[[nodiscard]] Result<FoundHeader> read_metaimage_header(const std::filesystem::path& file);

[[nodiscard]] Failure volume_file_unreadable(const std::filesystem::path& file, const std::string& reason);

// The first bytes of a file, at most `count`; nothing where it cannot be opened.
[[nodiscard]] std::string beginning_of(const std::filesystem::path& file, std::size_t count);

// Numbers parted by blanks, or nothing where something else stands there. Not finite ones ("nan") are kept.
[[nodiscard]] std::optional<std::vector<double>> numbers_in(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> whole_number_in(std::string_view text);
[[nodiscard]] std::string_view without_blanks(std::string_view text);

// The file's name without its folder, in lower case.
[[nodiscard]] std::string lower_case_name(const std::filesystem::path& file);

}  // namespace glisson::imaging
