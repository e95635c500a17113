#pragma once
// Pictures from files, as real values.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "imaging/internal/file_bytes.h"
#include "imaging/internal/voxel_layout.h"

namespace glisson::imaging {

// One thread's reader: keeps the last file open and the last compressed frame decoded, since tiles and frames of one
// file follow each other.
class FrameReader {
 public:
  explicit FrameReader(const VoxelLayout& layout) : layout_(layout) {}

  // columns x rows values of one picture into `values`, row by row. Values that are not numbers become 0.
  Result<void> read(const SliceSource& source, int columns, int rows, float* values);

  // All frames of a file as its header describes them and no byte more: uncompressed, in this machine's byte order.
  // Bits that no value uses repeat the sign, or are 0. Fails too with "dicom-size" above 4 GiB, which no element can
  // hold.
  Result<std::vector<std::uint8_t>> stored_pixels(int file);

 private:
  Result<void> open(int file);
  Result<void> load_native_rows(const PixelFile& file, const SliceSource& source, int rows);
  Result<void> load_compressed_frame(const PixelFile& file, int frame);

  const VoxelLayout& layout_;
  int open_file_ = -1;
  std::optional<OpenFile> stream_;
  int decoded_frame_ = -1;
  std::vector<std::uint8_t> samples_;
  std::size_t first_sample_ = 0;  // of the picture, in bytes
};

}  // namespace glisson::imaging
