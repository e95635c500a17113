#pragma once
// The gate that every DICOM file passes before a library sees a byte of it.
//
// DCMTK follows nested sequences by recursion and trusts declared lengths far enough to be hurt by them. So the
// structure of the file is walked here first, without recursion. Every length is compared in 64 bits with what encloses
// it. What is let through is the data set up to the pixels, held in memory. So what was checked is what is parsed, even
// if the file changes meanwhile. The pixels stay in the file; here they are only located.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace glisson::imaging {

struct TransferSyntax {
  std::string uid;
  bool explicit_vr = true;
  bool little_endian = true;
  bool encapsulated = false;  // the pixels are compressed, in fragments
};

struct ByteRange {
  std::uint64_t offset = 0;  // from the start of the file
  std::uint64_t length = 0;
};

// Where the pixels lie: one range for all frames, or fragments when they are compressed.
struct PixelElement {
  std::uint16_t element = 0x0010;  // of group 7FE0: 0010 integers, 0008 floats, 0009 doubles
  bool is_byte_string = false;     // OB: bytes in the order of the file, whatever the transfer syntax
  ByteRange native;
  std::vector<ByteRange> fragments;                // without the table of offsets
  std::vector<std::uint32_t> first_byte_of_frame;  // the basic table of offsets, counted from the first fragment's item
};

struct CheckedDicom {
  TransferSyntax syntax;
  std::string data_set;  // as in the file, up to the pixels; top-level values above 1 MiB are left out
  std::optional<PixelElement> pixels;
  std::uint64_t file_bytes = 0;
};

// Fails with one sentence naming the file: "file-not-readable", "file-empty", "not-dicom", "dicom-damaged" or
// "dicom-deflated". Fails with "dicom-truncated" where it ends inside something, and with "dicom-length" where a length
// leaves what encloses it. Fails with "dicom-nesting" beyond 32 sequences deep, and with "dicom-header-too-large"
// beyond 64 MiB or two million elements.
[[nodiscard]] Result<CheckedDicom> check_dicom_file(const std::filesystem::path& file);

}  // namespace glisson::imaging
