#pragma once
// One compressed picture to its stored values.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "imaging/internal/dicom_image.h"

namespace glisson::imaging {

// The samples in the order of rows, each of bits_allocated in the byte order of this machine. JPEG baseline,
// extended, lossless and JPEG-LS by DCMTK, JPEG 2000 by GDCM, run lengths by ourselves. The size that the stream
// declares is compared with the header's before a decoder sees it. Fails with "dicom-compression-unknown" or
// "dicom-pixels-damaged"; `name` is what they call the picture.
[[nodiscard]] Result<std::vector<std::uint8_t>> decode_frame(const TransferSyntax& syntax, const PixelFormat& format,
                                                             const std::string& stream, const std::string& name);

}  // namespace glisson::imaging
