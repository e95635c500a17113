// NIfTI-1 in one file (nifti1.h, https://nifti.nimh.nih.gov): 348 bytes of header, patient axes right, anterior,
// superior.

#include <bit>
#include <cmath>
#include <cstring>
#include <Eigen/Geometry>

#include "imaging/internal/volume_header.h"
#include "imaging/internal/voxel_stream.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t header_bytes = 348;

class ByteFields {
 public:
  explicit ByteFields(std::string bytes) : bytes_(std::move(bytes)) {
    const auto axes = number<std::int16_t>(40);
    swapped_ = axes < 1 || axes > 7;
  }
  [[nodiscard]] bool swapped() const { return swapped_; }

  template <typename Number>
  [[nodiscard]] Number number(std::size_t at) const {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, bytes_.data() + at, sizeof(Number));
    if (swapped_) std::reverse(bytes, bytes + sizeof(Number));
    return std::bit_cast<Number>(bytes);
  }
  [[nodiscard]] std::string_view text(std::size_t at, std::size_t count) const {
    return std::string_view(bytes_).substr(at, count);
  }

 private:
  std::string bytes_;
  bool swapped_ = false;
};

// Where the fields stand in the header.
enum At : std::size_t {
  sizeof_hdr = 0,
  dim = 40,
  datatype = 70,
  pixdim = 76,
  vox_offset = 108,
  scl_slope = 112,
  scl_inter = 116,
  xyzt_units = 123,
  qform_code = 252,
  sform_code = 254,
  quatern_b = 256,
  qoffset_x = 268,
  srow_x = 280,
  magic = 344
};

std::optional<VoxelType> type_of(int code) {
  switch (code) {
    case 2: return VoxelType::uint8;
    case 4: return VoxelType::int16;
    case 8: return VoxelType::int32;
    case 16: return VoxelType::float32;
    case 64: return VoxelType::float64;
    case 256: return VoxelType::int8;
    case 512: return VoxelType::uint16;
    case 768: return VoxelType::uint32;
    case 1024: return VoxelType::int64;
    case 1280: return VoxelType::uint64;
    default: return std::nullopt;
  }
}

// Complex numbers and colours.
int components_of(int code) {
  if (code == 128) return 3;
  if (code == 2304) return 4;
  return code == 32 || code == 1792 ? 2 : 1;
}

// Method 2 of nifti1.h: a rotation as a quaternion, whose first number follows from the others.
Eigen::Matrix3d rotation_of(const ByteFields& fields) {
  const double b = fields.number<float>(quatern_b), c = fields.number<float>(quatern_b + 4),
               d = fields.number<float>(quatern_b + 8);
  const double rest = 1 - (b * b + c * c + d * d);
  Eigen::Quaterniond quaternion(rest > 1e-7 ? std::sqrt(rest) : 0, b, c, d);
  Eigen::Matrix3d rotation = quaternion.normalized().toRotationMatrix();
  if (fields.number<float>(pixdim) < 0) rotation.col(2) *= -1;
  return rotation;
}

Grid grid_of(const ByteFields& fields) {
  Grid grid;
  Eigen::Matrix3d axes_mm = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin(0, 0, 0), spacing(0, 0, 0);
  for (int axis = 0; axis < 3; ++axis) {
    spacing[axis] = std::abs(fields.number<float>(pixdim + 4 + 4 * static_cast<std::size_t>(axis)));
  }
  const bool has_quaternion = fields.number<std::int16_t>(qform_code) > 0;
  const bool has_matrix = fields.number<std::int16_t>(sform_code) > 0;
  if (has_quaternion) {
    axes_mm = rotation_of(fields) * spacing.asDiagonal();
    for (int row = 0; row < 3; ++row) {
      origin[row] = fields.number<float>(qoffset_x + 4 * static_cast<std::size_t>(row));
    }
  } else if (has_matrix) {
    for (int row = 0; row < 3; ++row) {
      const std::size_t at = srow_x + 16 * static_cast<std::size_t>(row);
      for (int axis = 0; axis < 3; ++axis) {
        axes_mm(row, axis) = fields.number<float>(at + 4 * static_cast<std::size_t>(axis));
      }
      origin[row] = fields.number<float>(at + 12);
    }
    spacing = axes_mm.colwise().norm();
  } else {
    // Method 1: nothing is said of where it lies.
    axes_mm = spacing.asDiagonal();
    axes_mm.topRows<2>() *= -1;
  }
  // From right, anterior, superior to left, posterior, superior.
  const Eigen::Vector3d to_lps(-1, -1, 1);
  const int unit = fields.number<std::uint8_t>(xyzt_units) & 7;
  const double mm = unit == 1 ? 1000 : unit == 3 ? 0.001 : 1;
  grid.spacing_mm = mm * spacing;
  grid.origin_mm = mm * to_lps.cwiseProduct(origin);
  grid.direction = to_lps.asDiagonal() * axes_mm;
  for (int axis = 0; axis < 3; ++axis) grid.direction.col(axis).normalize();
  return grid;
}

}  // namespace

Result<FoundHeader> read_nifti_header(const fs::path& file, bool compressed) {
  // Files named .nii.gz that are not compressed are met; the first two bytes tell.
  const bool deflated = compressed && beginning_of(file, 2) == "\x1f\x8b";
  const std::string bytes = deflated ? beginning_of_deflated(file, 0, header_bytes) : beginning_of(file, header_bytes);
  if (bytes.size() < header_bytes) {
    return volume_file_unreadable(file, GLISSON_TEXT("its header is not of that format"));
  }
  const ByteFields fields(bytes);
  const int axes = fields.number<std::int16_t>(dim);
  const bool good = fields.number<std::int32_t>(sizeof_hdr) == 348 && axes >= 1 && axes <= 7 &&
                    fields.text(magic, 4) == std::string_view("n+1\0", 4);
  const int code = fields.number<std::int16_t>(datatype);
  if (!good) return volume_file_unreadable(file, GLISSON_TEXT("its header is not of that format"));
  const auto type = type_of(code);
  const int components = components_of(code);
  if (!type && components == 1) {
    return volume_file_unreadable(file, GLISSON_TEXT("its numbers are of an unknown type"));
  }
  FoundHeader found;
  found.components = components;
  VolumeHeader& header = found.header;
  for (int axis = 1; axis <= axes; ++axis) {
    found.sizes.push_back(fields.number<std::int16_t>(dim + 2 * static_cast<std::size_t>(axis)));
  }
  // The fifth axis runs over what a voxel holds.
  if (found.sizes.size() >= 5 && components == 1) {
    found.components = found.sizes[4];
    found.sizes.erase(found.sizes.begin() + 4);
  }
  header.type = type.value_or(VoxelType::uint8);
  header.big_endian = fields.swapped();
  header.data = file;
  header.grid = grid_of(fields);
  const double offset = fields.number<float>(vox_offset);
  if (!(offset >= 0 && offset < 1e9)) {
    return volume_file_unreadable(file, GLISSON_TEXT("its header is not of that format"));
  }
  const std::uint64_t begin = std::max<std::uint64_t>(static_cast<std::uint64_t>(offset), header_bytes + 4);
  header.coding = deflated ? VoxelCoding::deflated : VoxelCoding::raw;
  (deflated ? header.skipped : header.begin) = begin;
  const double slope = fields.number<float>(scl_slope), intercept = fields.number<float>(scl_inter);
  if (std::isfinite(slope) && slope != 0 && std::isfinite(intercept)) {
    header.slope = slope;
    header.intercept = intercept;
  }
  return found;
}

}  // namespace glisson::imaging
