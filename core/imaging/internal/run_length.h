#pragma once
// DICOM's run-length coding.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glisson::imaging {

// PS3.5 annex G: a table of segments, one for each byte of a sample, the highest first, each packed in runs. Gives
// `pixels` little-endian samples of `sample_bytes` bytes; nothing when the frame holds fewer or its table is wrong.
// (DCMTK 3.6.7's decoder read behind the end of damaged frames, found by tests/fuzz; hence ours.)
[[nodiscard]] std::optional<std::vector<std::uint8_t>> decode_run_lengths(const std::string& frame, std::size_t pixels,
                                                                          std::size_t sample_bytes);

}  // namespace glisson::imaging
