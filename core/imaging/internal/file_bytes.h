#pragma once
// The beginning of a file in memory, read as far as it is looked at, with stretches that can be left out.

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/result.h"

namespace glisson::imaging {

// A file opened for reading; closed with the object. Reads at a place, so that threads may share it.
class OpenFile {
 public:
  [[nodiscard]] static Result<OpenFile> open(const std::filesystem::path& file);
  OpenFile(OpenFile&& other) noexcept;
  OpenFile& operator=(OpenFile&& other) noexcept;
  ~OpenFile();

  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  // How many bytes came; less than asked for at the end of the file, or where it cannot be read any more.
  [[nodiscard]] std::uint64_t read(std::uint64_t offset, std::uint64_t count, void* into) const;

 private:
  OpenFile(int descriptor, std::uint64_t bytes) : descriptor_(descriptor), bytes_(bytes) {}
  int descriptor_ = -1;
  std::uint64_t bytes_ = 0;
};

// An index counts the bytes that were not left out; offset() gives the place in the file.
class FileBytes {
 public:
  [[nodiscard]] static Result<FileBytes> open(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& file() const { return path_; }
  [[nodiscard]] std::uint64_t file_bytes() const { return file_.bytes(); }
  [[nodiscard]] std::uint64_t end() const { return file_.bytes() - left_out_; }
  [[nodiscard]] std::uint64_t offset(std::uint64_t index) const { return index + left_out_; }

  // `count` bytes from `index`, valid until the next call; null beyond the end. `view` keeps all that was read.
  // `view_far` keeps only what it returns: it is for the pixels, far behind the header.
  [[nodiscard]] const std::uint8_t* view(std::uint64_t index, std::uint64_t count) const;
  [[nodiscard]] const std::uint8_t* view_far(std::uint64_t index, std::uint64_t count) const;

  // Takes the bytes from begin to end out; nothing before `end` may have been kept from after it.
  void leave_out(std::uint64_t begin, std::uint64_t end);

  [[nodiscard]] std::string copy(std::uint64_t begin, std::uint64_t end) const;

 private:
  FileBytes(std::filesystem::path path, OpenFile file) : path_(std::move(path)), file_(std::move(file)) {}

  std::filesystem::path path_;
  OpenFile file_;
  std::uint64_t left_out_ = 0;
  mutable std::string kept_;
  mutable std::string far_;
  mutable std::uint64_t far_begin_ = 0;
};

}  // namespace glisson::imaging
