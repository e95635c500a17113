#include "segmentation/mask_difference.h"

#include <limits>

namespace glisson::segmentation {

std::size_t MaskDifference::turned_voxels() const {
  std::size_t turned = 0;
  for (std::size_t run = 1; run < kept_and_turned.size(); run += 2) turned += kept_and_turned[run];
  return turned;
}

MaskDifference difference(const imaging::Mask& before, const imaging::Mask& after) {
  GLISSON_ASSERT(before.values.size() == after.values.size() && imaging::same_grid(before.grid, after.grid));
  GLISSON_ASSERT(before.values.size() <= std::numeric_limits<std::uint32_t>::max());
  MaskDifference found;
  bool turned = false;
  std::uint32_t length = 0;
  for (std::size_t voxel = 0; voxel < before.values.size(); ++voxel) {
    const bool turns = (after.values[voxel] != 0) != (before.values[voxel] != 0);
    if (turns != turned) {
      found.kept_and_turned.push_back(length);
      turned = turns;
      length = 0;
    }
    ++length;
  }
  if (turned) found.kept_and_turned.push_back(length);
  found.kept_and_turned.shrink_to_fit();
  return found;
}

void turn(imaging::Mask& mask, const MaskDifference& difference) {
  std::size_t voxel = 0;
  for (std::size_t run = 0; run < difference.kept_and_turned.size(); ++run) {
    const std::size_t end = voxel + difference.kept_and_turned[run];
    GLISSON_ASSERT(end <= mask.values.size());
    if (run % 2 == 1) {
      for (std::size_t n = voxel; n < end; ++n) mask.values[n] ^= 1;
    }
    voxel = end;
  }
}

std::string to_bytes(const MaskDifference& difference) {
  std::string bytes;
  for (std::uint32_t length : difference.kept_and_turned) {
    for (; length >= 0x80; length >>= 7) bytes.push_back(static_cast<char>((length & 0x7F) | 0x80));
    bytes.push_back(static_cast<char>(length));
  }
  return bytes;
}

Result<MaskDifference> difference_from_bytes(std::string_view bytes, std::size_t voxels) {
  MaskDifference read;
  std::uint64_t length = 0, end = 0;
  int shift = 0;
  bool within = false;
  for (const char byte : bytes) {
    const auto bits = static_cast<unsigned char>(byte);
    if (shift < 35) length |= static_cast<std::uint64_t>(bits & 0x7F) << shift;
    shift += 7;
    within = (bits & 0x80) != 0;
    if (within) continue;
    end += length;
    if (shift > 35 || length > voxels || end > voxels) {
      return failure("difference-damaged", GLISSON_TEXT("A stored step of the history reaches beyond its image."));
    }
    read.kept_and_turned.push_back(static_cast<std::uint32_t>(length));
    length = 0;
    shift = 0;
  }
  if (within) return failure("difference-damaged", GLISSON_TEXT("A stored step of the history is cut off."));
  return read;
}

}  // namespace glisson::segmentation
