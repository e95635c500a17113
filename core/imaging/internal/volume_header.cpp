#include "imaging/internal/volume_header.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <limits>

#include "base/text.h"
#include "imaging/internal/file_bytes.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

// The sentence of whoever tried, by this reader's code.
Failure not_opened(Error why, const fs::path& file) {
  why.code = "volume-file-unreadable";
  return failure(std::move(why).in_file(file));
}

enum class Format { nifti, compressed_nifti, nrrd, metaimage };

std::optional<Format> format_of(const fs::path& file) {
  const std::string name = lower_case_name(file);
  if (name.ends_with(".nii")) return Format::nifti;
  if (name.ends_with(".nii.gz")) return Format::compressed_nifti;
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr")) return Format::nrrd;
  if (name.ends_with(".mha") || name.ends_with(".mhd")) return Format::metaimage;
  return std::nullopt;
}

Result<FoundHeader> found_header(const fs::path& file, Format format) {
  switch (format) {
    case Format::nifti: return read_nifti_header(file, false);
    case Format::compressed_nifti: return read_nifti_header(file, true);
    case Format::nrrd: return read_nrrd_header(file);
    case Format::metaimage: break;
  }
  return read_metaimage_header(file);
}

Result<void> check_sizes(const FoundHeader& found, const fs::path& file);
Result<void> check_grid(const Grid& grid, const fs::path& file);
Result<void> check_room(const VolumeHeader& header, const fs::path& file);

}  // namespace

std::uint64_t bytes_of(VoxelType type) {
  switch (type) {
    case VoxelType::uint8:
    case VoxelType::int8: return 1;
    case VoxelType::uint16:
    case VoxelType::int16: return 2;
    case VoxelType::uint32:
    case VoxelType::int32:
    case VoxelType::float32: return 4;
    case VoxelType::uint64:
    case VoxelType::int64:
    case VoxelType::float64: break;
  }
  return 8;
}

bool has_volume_header_name(const fs::path& file) { return format_of(file).has_value(); }

Result<VolumeHeader> read_volume_header(const fs::path& file) {
  const auto format = format_of(file);
  if (!format) {
    return failure(Error{"volume-file-unknown-type",
                         GLISSON_TEXT("{0} is not of a known kind of volume file."),
                         {file.string()},
                         GLISSON_TEXT("Known are .nii, .nii.gz, .nrrd, .nhdr, .mha and .mhd."),
                         file});
  }
  const auto opened = OpenFile::open(file);
  if (!opened) return not_opened(opened.error(), file);
  if (opened->bytes() == 0) return volume_file_unreadable(file, GLISSON_TEXT("it is empty"));
  auto found = found_header(file, *format);
  if (!found) return failure(std::move(found.error()));
  if (const auto checked = check_sizes(*found, file); !checked) return failure(checked.error());
  VolumeHeader& header = found->header;
  for (std::size_t axis = 0; axis < 3; ++axis) header.grid.size[axis] = static_cast<int>(found->sizes[axis]);
  if (const auto checked = check_grid(header.grid, file); !checked) return failure(checked.error());
  if (const auto checked = check_room(header, file); !checked) return failure(checked.error());
  return std::move(header);
}

namespace {

Failure bad_grid(const fs::path& file) {
  return failure(Error{"volume-file-bad-grid",
                       GLISSON_TEXT("The header of {0} gives no usable grid: sizes and spacings must be positive and "
                                    "the axes at right angles."),
                       {file.string()},
                       GLISSON_TEXT("Resample the volume onto a regular grid and save it again."),
                       file});
}

Result<void> check_sizes(const FoundHeader& found, const fs::path& file) {
  if (found.components != 1) {
    return failure(Error{"volume-file-not-scalar",
                         GLISSON_TEXT("{0} holds {1} values at each voxel; one is needed."),
                         {file.string(), std::to_string(found.components)},
                         GLISSON_TEXT("Save one component (or a grey image in place of a colour one)."),
                         file});
  }
  const std::vector<std::int64_t>& sizes = found.sizes;
  if (sizes.size() < 3 || std::any_of(sizes.begin() + 3, sizes.end(), [](std::int64_t size) { return size != 1; })) {
    return failure(Error{"volume-file-not-3d",
                         GLISSON_TEXT("{0} is not a three-dimensional volume: it has {1} axes."),
                         {file.string(), std::to_string(sizes.size())},
                         GLISSON_TEXT("Save one volume (one point in time) to a file."),
                         file});
  }
  double voxels = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (sizes[axis] < 1 || sizes[axis] > std::numeric_limits<int>::max()) return bad_grid(file);
    voxels *= static_cast<double>(sizes[axis]);
  }
  // What no file of this size can hold is said to be missing before it is said to be too much.
  std::error_code ignored;
  const auto bytes = fs::file_size(found.header.data, ignored);
  const bool could_be =
      voxels * static_cast<double>(bytes_of(found.header.type)) <= 1032.0 * static_cast<double>(bytes);
  if (voxels <= static_cast<double>(maximum_voxels) || ignored || !could_be) return {};
  return failure(Error{"volume-file-too-large",
                       GLISSON_TEXT("{0} has {1} million voxels; at most {2} million are read."),
                       {file.string(), fmt::format("{:.0f}", voxels / 1e6), std::to_string(maximum_voxels / 1'000'000)},
                       GLISSON_TEXT("Cut out the part that is needed, or resample it to larger voxels."),
                       file});
}

Result<void> check_grid(const Grid& grid, const fs::path& file) {
  const bool good = grid.spacing_mm.allFinite() && grid.origin_mm.allFinite() && grid.direction.allFinite() &&
                    grid.spacing_mm.minCoeff() > 0 &&
                    // 1e-3 is what seven-digit headers lose.
                    (grid.direction.transpose() * grid.direction).isIdentity(1e-3);
  if (!good) return bad_grid(file);
  return {};
}

// Whether the file can hold what its header declares: in floating point, which no product overflows.
Result<void> check_room(const VolumeHeader& header, const fs::path& file) {
  const auto data = OpenFile::open(header.data);
  if (!data) return not_opened(data.error(), file);
  const double there = static_cast<double>(data->bytes() - std::min(header.begin, data->bytes()));
  double voxels = 1;
  for (const int size : header.grid.size) voxels *= size;
  const double declared = voxels * static_cast<double>(bytes_of(header.type));
  // Deflate's own bound is 258 bytes by two bits; a number in decimals takes a digit and a blank.
  const double maximum = header.coding == VoxelCoding::deflated ? 1032 * there
                         : header.coding == VoxelCoding::text
                             ? there / 2 * static_cast<double>(bytes_of(header.type)) + 8
                             : there;
  // Label maps shrink to a 200th, images to a third; what shrinks more is one value, or made to fill the memory.
  constexpr double any_size = 256.0 * 1024 * 1024, maximum_ratio = 500;
  // Each voxel becomes a float: what is stored as bytes grows fourfold.
  const double in_memory = voxels * std::max<double>(static_cast<double>(bytes_of(header.type)), sizeof(float));
  const bool hollow = declared > maximum_ratio * there || in_memory > 2 * maximum_ratio * there;
  if (header.coding == VoxelCoding::deflated && declared > any_size && hollow && declared <= maximum) {
    return failure(Error{"volume-file-hollow",
                         GLISSON_TEXT("{0} holds {1} MB of voxels in {2} MB: nearly all of them have one value."),
                         {file.string(), fmt::format("{:.0f}", declared / 1e6), fmt::format("{:.1f}", there / 1e6)},
                         GLISSON_TEXT("Cut out the part that is needed, or resample it to larger voxels."),
                         file});
  }
  if (declared <= maximum) return {};
  return failure(Error{"volume-file-truncated",
                       GLISSON_TEXT("{0} is too short: its header declares {1} bytes of voxels and the file can hold "
                                    "{2} at most."),
                       {file.string(), fmt::format("{:.0f}", declared), fmt::format("{:.0f}", maximum)},
                       GLISSON_TEXT("Copy the file again from where it came."),
                       file});
}

}  // namespace

Failure volume_file_unreadable(const fs::path& file, const std::string& reason) {
  return failure(Error{"volume-file-unreadable",
                       GLISSON_TEXT("{0} cannot be read: {1}."),
                       {file.string(), reason},
                       GLISSON_TEXT("Check that the file is whole, for example by opening it in 3D Slicer."),
                       file});
}

std::string beginning_of(const fs::path& file, std::size_t count) {
  const auto opened = OpenFile::open(file);
  if (!opened) return {};
  std::string bytes(std::min<std::uint64_t>(count, opened->bytes()), '\0');
  bytes.resize(opened->read(0, bytes.size(), bytes.data()));
  return bytes;
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (std::string_view rest = without_blanks(text); !rest.empty();) {
    if (rest.front() == '+') rest.remove_prefix(1);
    double number = 0;
    const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (problem != std::errc() || numbers.size() >= 64) return std::nullopt;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (!rest.empty() && rest.front() != ' ' && rest.front() != '\t') return std::nullopt;
    rest = without_blanks(rest);
    numbers.push_back(number);
  }
  return numbers;
}

std::optional<std::int64_t> whole_number_in(std::string_view text) {
  return read_whole_number<std::int64_t>(without_blanks(text));
}

std::string lower_case_name(const fs::path& file) { return in_lower_case(file.filename().string()); }

}  // namespace glisson::imaging
