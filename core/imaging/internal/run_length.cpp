// DICOM's run-length coding, every index checked.

#include "imaging/internal/run_length.h"

#include <algorithm>
#include <string_view>

namespace glisson::imaging {
namespace {

constexpr std::size_t table_bytes = 64;

std::uint32_t table_entry(const std::string& frame, std::size_t n) {
  std::uint32_t entry = 0;
  for (std::size_t i = 4; i-- > 0;) entry = entry << 8 | static_cast<unsigned char>(frame[4 * n + i]);
  return entry;
}

// Writes every `stride`-th byte. A control byte n below 128 announces n + 1 bytes as they are, above 128 a run of
// 257 - n times the next byte; 128 means nothing.
bool unpack(std::string_view segment, std::size_t count, std::uint8_t* out, std::size_t stride) {
  std::size_t done = 0;
  std::size_t at = 0;
  while (done < count && at < segment.size()) {
    const auto control = static_cast<unsigned char>(segment[at++]);
    if (control == 128) continue;
    const bool is_run = control > 128;
    const std::size_t announced = is_run ? 257U - control : control + 1U;
    const std::size_t taken = std::min(announced, count - done);
    if (is_run ? at >= segment.size() : taken > segment.size() - at) return false;
    for (std::size_t i = 0; i < taken; ++i) {
      out[(done + i) * stride] = static_cast<std::uint8_t>(segment[is_run ? at : at + i]);
    }
    done += taken;
    at += is_run ? 1 : announced;
  }
  return done == count;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> decode_run_lengths(const std::string& frame, std::size_t pixels,
                                                            std::size_t sample_bytes) {
  if (frame.size() < table_bytes || table_entry(frame, 0) != sample_bytes) return std::nullopt;
  std::vector<std::uint8_t> samples(pixels * sample_bytes);
  for (std::size_t byte = 0; byte < sample_bytes; ++byte) {
    const std::size_t begin = table_entry(frame, 1 + byte);
    const std::size_t end = byte + 1 < sample_bytes ? table_entry(frame, 2 + byte) : frame.size();
    if (begin < table_bytes || begin > end || end > frame.size()) return std::nullopt;
    const std::string_view segment = std::string_view(frame).substr(begin, end - begin);
    if (!unpack(segment, pixels, samples.data() + (sample_bytes - 1 - byte), sample_bytes)) return std::nullopt;
  }
  return samples;
}

}  // namespace glisson::imaging
