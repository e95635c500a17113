#include "imaging/internal/voxel_stream.h"

#include <zlib.h>
#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "imaging/internal/file_bytes.h"

namespace glisson::imaging {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t block_bytes = 1 << 16;  // a whole number of voxels of every type

// Bytes in order. read() gives fewer than asked for only at the end, or where is_damaged() says so.
class ByteSource {
 public:
  ByteSource() = default;
  virtual ~ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual std::size_t read(std::size_t count, char* into) = 0;
  [[nodiscard]] virtual bool is_damaged() const { return false; }
};

class PlainBytes : public ByteSource {
 public:
  // The bytes of the file from `begin` to before `end`, or to its own end.
  PlainBytes(OpenFile file, std::uint64_t begin, std::uint64_t end)
      : file_(std::move(file)), at_(begin), end_(std::min(end, file_.bytes())) {}

  std::size_t read(std::size_t count, char* into) override {
    const std::uint64_t wanted = at_ < end_ ? std::min<std::uint64_t>(count, end_ - at_) : 0;
    const auto got = static_cast<std::size_t>(file_.read(at_, wanted, into));
    at_ += got;
    return got;
  }

 private:
  OpenFile file_;
  std::uint64_t at_, end_;
};

// gzip (RFC 1952; several members may follow each other) or zlib (RFC 1950). zlib compares length and checksum at the
// end of each.
class InflatedBytes : public ByteSource {
 public:
  InflatedBytes(OpenFile file, std::uint64_t begin, std::uint64_t end)
      : compressed_(std::move(file), begin, end), input_(block_bytes) {
    constexpr int either_header = 15 + 32;
    damaged_ = ::inflateInit2(&state_, either_header) != Z_OK;
  }
  ~InflatedBytes() override { ::inflateEnd(&state_); }
  InflatedBytes(const InflatedBytes&) = delete;
  InflatedBytes& operator=(const InflatedBytes&) = delete;

  std::size_t read(std::size_t count, char* into) override {
    state_.next_out = reinterpret_cast<Bytef*>(into);
    state_.avail_out = static_cast<uInt>(count);
    while (state_.avail_out > 0 && !ended_ && !damaged_) step();
    return count - state_.avail_out;
  }
  [[nodiscard]] bool is_damaged() const override { return damaged_; }

 private:
  void step() {
    if (state_.avail_in == 0) {
      state_.next_in = reinterpret_cast<Bytef*>(input_.data());
      state_.avail_in = static_cast<uInt>(compressed_.read(input_.size(), input_.data()));
      if (state_.avail_in == 0) {
        (between_members_ ? ended_ : damaged_) = true;
        return;
      }
    }
    if (between_members_) {
      // Something else behind a whole stream is not its matter.
      ended_ = *state_.next_in != 0x1f;
      if (ended_) return;
      ::inflateReset(&state_);
      between_members_ = false;
    }
    const int outcome = ::inflate(&state_, Z_NO_FLUSH);
    between_members_ = outcome == Z_STREAM_END;
    damaged_ = outcome != Z_OK && outcome != Z_STREAM_END && outcome != Z_BUF_ERROR;
  }

  PlainBytes compressed_;
  std::vector<char> input_;
  z_stream state_{};
  bool between_members_ = false, ended_ = false, damaged_ = false;
};

std::unique_ptr<ByteSource> source_of(const VolumeHeader& header, OpenFile file) {
  constexpr auto no_end = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t begin = header.begin;
  if (header.at_the_end) begin = file.bytes() - std::min(header.voxel_bytes(), file.bytes());
  const std::uint64_t end = header.in_bytes && *header.in_bytes < no_end - begin ? begin + *header.in_bytes : no_end;
  if (header.coding != VoxelCoding::deflated) {
    return std::make_unique<PlainBytes>(std::move(file), begin, no_end);
  }
  return std::make_unique<InflatedBytes>(std::move(file), begin, end);
}

template <typename Stored>
void decode(const char* bytes, std::size_t count, bool swapped, std::vector<double>& values) {
  values.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    char one[sizeof(Stored)];
    std::memcpy(one, bytes + i * sizeof(Stored), sizeof(Stored));
    if (swapped) std::reverse(one, one + sizeof(Stored));
    values[i] = static_cast<double>(std::bit_cast<Stored>(one));
  }
}

void decode(VoxelType type, const char* bytes, std::size_t count, bool swapped, std::vector<double>& values) {
  switch (type) {
    case VoxelType::uint8: return decode<std::uint8_t>(bytes, count, swapped, values);
    case VoxelType::int8: return decode<std::int8_t>(bytes, count, swapped, values);
    case VoxelType::uint16: return decode<std::uint16_t>(bytes, count, swapped, values);
    case VoxelType::int16: return decode<std::int16_t>(bytes, count, swapped, values);
    case VoxelType::uint32: return decode<std::uint32_t>(bytes, count, swapped, values);
    case VoxelType::int32: return decode<std::int32_t>(bytes, count, swapped, values);
    case VoxelType::uint64: return decode<std::uint64_t>(bytes, count, swapped, values);
    case VoxelType::int64: return decode<std::int64_t>(bytes, count, swapped, values);
    case VoxelType::float32: return decode<float>(bytes, count, swapped, values);
    case VoxelType::float64: return decode<double>(bytes, count, swapped, values);
  }
}

Failure damaged(const fs::path& file) {
  return failure(Error{"volume-file-damaged",
                       GLISSON_TEXT("The compressed voxels of {0} are damaged or cut short."),
                       {file.string()},
                       GLISSON_TEXT("Copy the file again from where it came."),
                       file});
}

Failure truncated(const fs::path& file, std::uint64_t declared, std::uint64_t there) {
  return failure(Error{"volume-file-truncated",
                       GLISSON_TEXT("{0} is too short: its header declares {1} bytes of voxels and the file can hold "
                                    "{2} at most."),
                       {file.string(), std::to_string(declared), std::to_string(there)},
                       GLISSON_TEXT("Copy the file again from where it came."),
                       file});
}

Failure longer(const fs::path& file) {
  return failure(Error{"volume-file-longer",
                       GLISSON_TEXT("{0} holds more voxels than its header declares: its sizes are not those that it "
                                    "was written with."),
                       {file.string()},
                       GLISSON_TEXT("Copy the file again from where it came."),
                       file});
}

// Until the stream has ended, which is where its checksum is compared; at most a row of voxels may follow the last one.
Result<void> finish(ByteSource& source, const VolumeHeader& header, const fs::path& file) {
  const std::uint64_t row = static_cast<std::uint64_t>(header.grid.size[0]) * bytes_of(header.type);
  std::vector<char> rest(4096);
  for (std::uint64_t behind = 0;;) {
    const std::size_t got = source.read(rest.size(), rest.data());
    behind += got;
    if (source.is_damaged()) return damaged(file);
    if (behind >= row) return longer(file);
    if (got < rest.size()) return {};
  }
}

Result<void> read_numbers_as_text(ByteSource& source, const VolumeHeader& header, const fs::path& file,
                                  const std::function<void(const double*, std::size_t)>& take) {
  const std::uint64_t wanted = header.grid.voxels();
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ','; };
  std::vector<double> values;
  std::string text;
  std::uint64_t taken = 0;
  for (bool ended = false; !ended && taken < wanted;) {
    const std::size_t have = text.size();
    text.resize(have + block_bytes);
    text.resize(have + source.read(block_bytes, text.data() + have));
    ended = text.size() < have + block_bytes;
    if (ended) text += ' ';
    values.clear();
    std::size_t begin = 0;
    for (std::size_t at = 0; at < text.size() && taken + values.size() < wanted; ++at) {
      if (!is_blank(text[at])) continue;
      if (begin < at) {
        double value = 0;
        const auto [end, problem] = std::from_chars(text.data() + begin, text.data() + at, value);
        if (problem != std::errc() || end != text.data() + at) {
          return volume_file_unreadable(file, GLISSON_TEXT("its numbers are of an unknown type"));
        }
        values.push_back(header.slope * value + header.intercept);
      }
      begin = at + 1;
    }
    text.erase(0, begin);
    // No number is as long as that.
    if (text.size() > 1024 && taken + values.size() < wanted) {
      return volume_file_unreadable(file, GLISSON_TEXT("its numbers are of an unknown type"));
    }
    take(values.data(), values.size());
    taken += values.size();
  }
  if (taken == wanted) return {};
  return truncated(file, header.voxel_bytes(), taken * bytes_of(header.type));
}

}  // namespace

Result<void> read_voxels(const VolumeHeader& header, const fs::path& file,
                         const std::function<void(const double*, std::size_t)>& take) {
  auto opened = OpenFile::open(header.data);
  if (!opened) return failure(opened.error());
  const std::unique_ptr<ByteSource> source = source_of(header, std::move(*opened));
  if (header.coding == VoxelCoding::text) return read_numbers_as_text(*source, header, file, take);

  std::vector<char> block(block_bytes);
  for (std::uint64_t left = header.skipped; left > 0;) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(left, block_bytes));
    if (source->read(wanted, block.data()) < wanted) break;
    left -= wanted;
  }
  const std::uint64_t size = bytes_of(header.type), all = header.voxel_bytes();
  const bool swapped = header.big_endian;
  std::vector<double> values;
  for (std::uint64_t done = 0; done < all;) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(all - done, block_bytes));
    const std::size_t got = source->read(wanted, block.data());
    if (source->is_damaged()) return damaged(file);
    if (got < wanted) return truncated(file, all, done + got);
    decode(header.type, block.data(), got / size, swapped, values);
    if (header.slope != 1 || header.intercept != 0) {
      for (double& value : values) value = header.slope * value + header.intercept;
    }
    take(values.data(), values.size());
    done += got;
  }
  return finish(*source, header, file);
}

std::string beginning_of_deflated(const fs::path& file, std::uint64_t begin, std::size_t count) {
  auto opened = OpenFile::open(file);
  if (!opened) return {};
  InflatedBytes source(std::move(*opened), begin, std::numeric_limits<std::uint64_t>::max());
  std::string bytes(count, '\0');
  bytes.resize(source.read(count, bytes.data()));
  return bytes;
}

}  // namespace glisson::imaging
