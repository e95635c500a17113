#pragma once
// One compressed picture to its stored values. Inside this room only.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "imaging/dicom_image.h"

namespace glisson::imaging {

// What a JPEG, JPEG-LS or JPEG 2000 stream says of itself, read from its marker segments alone.
struct CodestreamSize {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  int components = 0;
  int bits = 0;
};
[[nodiscard]] std::optional<CodestreamSize> codestream_size(const std::string& stream);

// The samples in the order of rows, each of bits_allocated in the byte order of this machine. JPEG baseline,
// extended, lossless and JPEG-LS by DCMTK, JPEG 2000 by GDCM, run lengths by ourselves. The size that the stream
// declares is compared with the header's before a decoder sees it. Fails with "dicom-compression-unknown" or
// "dicom-pixels-damaged"; `name` is what they call the picture.
[[nodiscard]] Result<std::vector<std::uint8_t>> decode_frame(const TransferSyntax& syntax, const PixelFormat& format,
                                                             const std::string& stream, const std::string& name);

}  // namespace glisson::imaging
