// Stored values to real ones: bytes in order, unused bits away, the sign extended, slope and intercept applied.

#include "imaging/internal/frame_reader.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "imaging/internal/compressed_frame.h"

namespace glisson::imaging {
namespace {

static_assert(std::endian::native == std::endian::little, "the samples of a file are taken as they lie");

// What stands between a stored sample and its value.
struct SampleCoding {
  int shift_up = 0;  // brings the highest used bit to bit 31, then shift_down the lowest to bit 0
  int shift_down = 0;
  double slope = 1, intercept = 0;
};

template <typename Stored, typename Wide>
void convert(const std::uint8_t* samples, int count, const SampleCoding& coding, float* values) {
  for (int i = 0; i < count; ++i) {
    Stored stored;
    std::memcpy(&stored, samples + static_cast<std::size_t>(i) * sizeof(Stored), sizeof(Stored));
    const auto up = static_cast<Wide>(static_cast<std::make_unsigned_t<Wide>>(stored) << coding.shift_up);
    values[i] = static_cast<float>(coding.slope * static_cast<double>(up >> coding.shift_down) + coding.intercept);
  }
}

template <typename Stored>
void convert_real(const std::uint8_t* samples, int count, const SampleCoding& coding, float* values) {
  for (int i = 0; i < count; ++i) {
    Stored stored;
    std::memcpy(&stored, samples + static_cast<std::size_t>(i) * sizeof(Stored), sizeof(Stored));
    const auto value = static_cast<float>(coding.slope * static_cast<double>(stored) + coding.intercept);
    values[i] = std::isfinite(value) ? value : 0.0F;
  }
}

using Converter = void (*)(const std::uint8_t*, int, const SampleCoding&, float*);

Converter converter_of(const PixelFile& file) {
  if (file.pixels.element == 0x0008) return convert_real<float>;
  if (file.pixels.element == 0x0009) return convert_real<double>;
  const bool is_signed = file.format.is_signed;
  switch (file.format.bits_allocated) {
    case 8: return is_signed ? convert<std::uint8_t, std::int32_t> : convert<std::uint8_t, std::uint32_t>;
    case 16: return is_signed ? convert<std::uint16_t, std::int32_t> : convert<std::uint16_t, std::uint32_t>;
    default: return is_signed ? convert<std::uint32_t, std::int32_t> : convert<std::uint32_t, std::uint32_t>;
  }
}

void swap_bytes(std::vector<std::uint8_t>& bytes, std::size_t word) {
  for (std::size_t i = 0; i + word <= bytes.size(); i += word) {
    for (std::size_t k = 0; k < word / 2; ++k) std::swap(bytes[i + k], bytes[i + word - 1 - k]);
  }
}

Failure changed(const PixelFile& file) {
  return failure(Error{"dicom-changed",
                       GLISSON_TEXT("{0} is not any more as it was when the folder was scanned."),
                       {file.path.string()},
                       GLISSON_TEXT("Scan the folder again."),
                       file.path});
}

// The fragments of one frame: all, one each, or as the table of offsets says.
std::optional<std::pair<std::size_t, std::size_t>> fragments_of(const PixelFile& file, int frame) {
  const std::vector<ByteRange>& fragments = file.pixels.fragments;
  const auto wanted = static_cast<std::size_t>(frame);
  if (file.frames == 1) return std::pair{std::size_t{0}, fragments.size()};
  if (fragments.size() == static_cast<std::size_t>(file.frames)) return std::pair{wanted, wanted + 1};
  const std::vector<std::uint32_t>& table = file.pixels.first_byte_of_frame;
  if (table.size() != static_cast<std::size_t>(file.frames)) return std::nullopt;
  const auto fragment_at = [&](std::uint64_t first_byte) -> std::optional<std::size_t> {
    for (std::size_t k = 0; k < fragments.size(); ++k) {
      if (fragments[k].offset - fragments.front().offset == first_byte) return k;
    }
    return std::nullopt;
  };
  const auto begin = fragment_at(table[wanted]);
  const auto end = wanted + 1 < table.size() ? fragment_at(table[wanted + 1]) : std::optional(fragments.size());
  if (!begin || !end || *begin >= *end) return std::nullopt;
  return std::pair{*begin, *end};
}

// What a mask of overlays, or anything else, has left in bits beside the value.
template <typename Stored>
void clear_unused_bits(std::vector<std::uint8_t>& bytes, const PixelFormat& format) {
  const int above = static_cast<int>(sizeof(Stored)) * 8 - 1 - format.high_bit;
  const int below = format.high_bit + 1 - format.bits_stored;
  for (std::size_t at = 0; at + sizeof(Stored) <= bytes.size(); at += sizeof(Stored)) {
    Stored value;
    std::memcpy(&value, bytes.data() + at, sizeof(Stored));
    // Through the type's own sign: shifted down again, an unsigned value is followed by zeros.
    value = static_cast<Stored>(static_cast<std::make_unsigned_t<Stored>>(value) << above);
    value = static_cast<Stored>(value >> (above + below));
    value = static_cast<Stored>(static_cast<std::make_unsigned_t<Stored>>(value) << below);
    std::memcpy(bytes.data() + at, &value, sizeof(Stored));
  }
}

void clear_unused_bits(std::vector<std::uint8_t>& bytes, const PixelFile& file) {
  if (file.pixels.element != 0x0010 || file.format.bits_stored == file.format.bits_allocated) return;
  const bool is_signed = file.format.is_signed;
  switch (file.format.bits_allocated) {
    case 8:
      return is_signed ? clear_unused_bits<std::int8_t>(bytes, file.format)
                       : clear_unused_bits<std::uint8_t>(bytes, file.format);
    case 16:
      return is_signed ? clear_unused_bits<std::int16_t>(bytes, file.format)
                       : clear_unused_bits<std::uint16_t>(bytes, file.format);
    case 32:
      return is_signed ? clear_unused_bits<std::int32_t>(bytes, file.format)
                       : clear_unused_bits<std::uint32_t>(bytes, file.format);
    default: return;
  }
}

}  // namespace

Result<std::vector<std::uint8_t>> FrameReader::stored_pixels(int index) {
  const PixelFile& file = layout_.files[static_cast<std::size_t>(index)];
  const std::uint64_t needed = (file.format.frame_bits() * static_cast<std::uint64_t>(file.frames) + 7) / 8;
  if (needed >= 0xFFFFFFFEu) {
    return failure(Error{"dicom-size",
                         GLISSON_TEXT("{0} declares compressed pictures too large to be true."),
                         {file.path.string()},
                         "",
                         file.path});
  }
  if (const Result<void> opened = open(index); !opened) return failure(opened.error());
  std::vector<std::uint8_t> all;
  if (file.format.bits_allocated == 1 && !file.syntax.encapsulated) {
    // Frames of single bits follow each other without a gap.
    all.resize(needed);
    if (stream_->read(file.pixels.native.offset, needed, all.data()) != needed) return changed(file);
    const std::uint64_t used = file.format.frame_bits() * static_cast<std::uint64_t>(file.frames) % 8;
    if (used != 0) all.back() = static_cast<std::uint8_t>(all.back() & ((1u << used) - 1));
    return all;
  }
  const auto frame_bytes = static_cast<std::size_t>(file.format.frame_bits() / 8);
  for (int frame = 0; frame < file.frames; ++frame) {
    const Result<void> loaded = file.syntax.encapsulated
                                    ? load_compressed_frame(file, frame)
                                    : load_native_rows(file, {index, frame, 0, 0, 1, 0}, file.format.rows);
    if (!loaded) return failure(loaded.error());
    const auto begin = samples_.begin() + static_cast<std::ptrdiff_t>(file.syntax.encapsulated ? 0 : first_sample_);
    all.insert(all.end(), begin, begin + static_cast<std::ptrdiff_t>(frame_bytes));
  }
  clear_unused_bits(all, file);
  return all;
}

Result<void> FrameReader::read(const SliceSource& source, int columns, int rows, float* values) {
  const PixelFile& file = layout_.files[static_cast<std::size_t>(source.file)];
  if (const Result<void> opened = open(source.file); !opened) return opened;
  const Result<void> loaded =
      file.syntax.encapsulated ? load_compressed_frame(file, source.frame) : load_native_rows(file, source, rows);
  if (!loaded) return loaded;

  const auto sample_bytes = static_cast<std::size_t>(file.format.bits_allocated) / 8;
  const auto row_bytes = static_cast<std::size_t>(file.format.columns) * sample_bytes;
  SampleCoding coding{31 - file.format.high_bit, 32 - file.format.bits_stored, source.slope, source.intercept};
  const Converter to_values = converter_of(file);
  const std::size_t top = file.syntax.encapsulated ? static_cast<std::size_t>(source.top) * row_bytes : 0;
  const std::uint8_t* samples =
      samples_.data() + first_sample_ + top + static_cast<std::size_t>(source.left) * sample_bytes;
  if (columns == file.format.columns) {
    to_values(samples, columns * rows, coding, values);
    return {};
  }
  for (int j = 0; j < rows; ++j) {
    to_values(samples + static_cast<std::size_t>(j) * row_bytes, columns, coding, values + std::ptrdiff_t(j) * columns);
  }
  return {};
}

Result<void> FrameReader::open(int file) {
  if (file == open_file_) return {};
  const PixelFile& wanted = layout_.files[static_cast<std::size_t>(file)];
  Result<OpenFile> opened = OpenFile::open(wanted.path);
  if (!opened) return failure(opened.error());
  if (opened->bytes() != wanted.file_bytes) return changed(wanted);
  stream_.emplace(std::move(*opened));
  open_file_ = file;
  decoded_frame_ = -1;
  return {};
}

// Of an uncompressed file only the rows of the picture are read. In big endian, bytes that a file holds as 16-bit words
// come in swapped pairs, so reading begins at an even place.
Result<void> FrameReader::load_native_rows(const PixelFile& file, const SliceSource& source, int rows) {
  const std::uint64_t row_bytes = file.format.frame_bits() / 8 / static_cast<std::uint64_t>(file.format.rows);
  const std::uint64_t frame_bytes = row_bytes * static_cast<std::uint64_t>(file.format.rows);
  const std::uint64_t begin =
      static_cast<std::uint64_t>(source.frame) * frame_bytes + static_cast<std::uint64_t>(source.top) * row_bytes;
  const std::uint64_t even_begin = begin / 2 * 2;
  const std::uint64_t end =
      std::min((begin + static_cast<std::uint64_t>(rows) * row_bytes + 1) / 2 * 2, file.pixels.native.length);
  samples_.resize(end - even_begin);
  if (stream_->read(file.pixels.native.offset + even_begin, samples_.size(), samples_.data()) != samples_.size()) {
    open_file_ = -1;
    return changed(file);
  }
  first_sample_ = begin - even_begin;
  if (!file.syntax.little_endian) {
    const auto sample_bytes = static_cast<std::size_t>(file.format.bits_allocated) / 8;
    if (sample_bytes > 1) swap_bytes(samples_, sample_bytes);
    if (sample_bytes == 1 && !file.pixels.is_byte_string) swap_bytes(samples_, 2);
  }
  return {};
}

Result<void> FrameReader::load_compressed_frame(const PixelFile& file, int frame) {
  if (frame == decoded_frame_) return {};
  const auto range = fragments_of(file, frame);
  if (!range) {
    return failure(Error{"dicom-pixels-damaged",
                         GLISSON_TEXT("{0} does not say which of its compressed pieces belong to frame {1}."),
                         {file.path.string(), std::to_string(frame + 1)},
                         "",
                         file.path});
  }
  std::string compressed;
  for (std::size_t k = range->first; k < range->second; ++k) {
    const ByteRange& fragment = file.pixels.fragments[k];
    const std::size_t have = compressed.size();
    compressed.resize(have + fragment.length);
    if (stream_->read(fragment.offset, fragment.length, compressed.data() + have) != fragment.length) {
      open_file_ = -1;
      return changed(file);
    }
  }
  const std::string name =
      file.frames == 1 ? file.path.string() : file.path.string() + ", frame " + std::to_string(frame + 1);
  Result<std::vector<std::uint8_t>> decoded = decode_frame(file.syntax, file.format, compressed, name);
  if (!decoded) return failure(std::move(decoded.error()).in_file(file.path));
  samples_ = std::move(*decoded);
  first_sample_ = 0;
  decoded_frame_ = frame;
  return {};
}

}  // namespace glisson::imaging
