#include "geometry/internal/mesh_file_guard.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace glisson::geometry {
namespace {

namespace fs = std::filesystem;

// Values a byte of file may stand for. zlib cannot do better than about 1030 to 1, and a value has at least one byte;
// meshes compress 2 to 1, so that a hundred is generous and still keeps what a small file can ask for small.
constexpr std::uint64_t maximum_values_a_byte = 100;

// Bytes of a binary file that may be scanned for header lines at once.
constexpr std::size_t block_bytes = std::size_t{1} << 20;

// A header line longer than this announces nothing (data in text form has such lines).
constexpr std::size_t longest_header_line = 1024;

// Calls visit(line) for every line up to the longest that can be a header's; false from visit ends it.
template <typename Visit>
void for_each_line(std::ifstream& stream, Visit&& visit);

// The largest whole number that the line announces as a count, if it announces any.
std::optional<std::uint64_t> count_in_xml(std::string_view line);
std::optional<std::uint64_t> count_in_text(std::string_view line);

}  // namespace

Result<void> check_announced_counts(const fs::path& file) {
  std::error_code problem;
  const std::uint64_t size = fs::file_size(file, problem);
  std::ifstream stream(file, std::ios::binary);
  if (problem || !stream) {
    return failure(Error{"file-not-readable",
                         GLISSON_TEXT("The file {0} cannot be read."),
                         {file.string()},
                         GLISSON_TEXT("Check that it exists and that you may read it."),
                         file});
  }
  const std::string extension = file.extension().string();
  const bool is_xml = extension == ".vtp" || extension == ".vtu";
  const std::uint64_t limit = is_xml ? maximum_values_a_byte * size : size;

  std::uint64_t announced = 0;
  std::size_t line_number = 0;
  for_each_line(stream, [&](std::string_view line) {
    ++line_number;
    if (extension == ".vtk" && line_number == 2) return true;  // its title, free text
    if (const auto count = is_xml ? count_in_xml(line) : count_in_text(line)) announced = std::max(announced, *count);
    return announced <= limit && !(extension == ".ply" && line.starts_with("end_header"));
  });
  if (announced <= limit) return {};
  return failure(Error{"mesh-too-large",
                       GLISSON_TEXT("The header of {0} announces {1} items; a file of {2} bytes cannot hold them."),
                       {file.filename().string(), std::to_string(announced), std::to_string(size)},
                       GLISSON_TEXT("The file is damaged or cut off; get it again from where it came."),
                       file});
}

namespace {

template <typename Visit>
void for_each_line(std::ifstream& stream, Visit&& visit) {
  std::string block(block_bytes, '\0');
  std::string line;
  do {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    for (const char c : std::string_view(block).substr(0, static_cast<std::size_t>(stream.gcount()))) {
      // An XML element ends a line too, since nothing says that it is followed by one.
      const bool ends = c == '\n' || c == '\r' || c == '>';
      if (!ends && line.size() <= longest_header_line) line += c;
      if (!ends) continue;
      if (line.size() <= longest_header_line && !visit(std::string_view(line))) return;
      line.clear();
    }
  } while (stream);
  if (line.size() <= longest_header_line) visit(std::string_view(line));
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  const auto digits = std::find_if_not(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (digits == text.begin()) return std::nullopt;
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + (digits - text.begin()), number);
  return error == std::errc{} ? number : UINT64_MAX;
}

std::optional<std::uint64_t> count_in_xml(std::string_view line) {
  std::optional<std::uint64_t> largest;
  for (std::size_t at = line.find("NumberOf"); at != std::string_view::npos; at = line.find("NumberOf", at + 1)) {
    const std::size_t quote = line.find_first_of("\"'", at);
    if (quote == std::string_view::npos) break;
    const auto count = whole_number(line.substr(quote + 1));
    if (count) largest = std::max(largest.value_or(0), *count);
  }
  return largest;
}

// A header line of legacy VTK, PLY or text STL begins with a letter; a line of numbers does not.
std::optional<std::uint64_t> count_in_text(std::string_view line) {
  if (line.empty() || std::isalpha(static_cast<unsigned char>(line.front())) == 0) return std::nullopt;
  std::optional<std::uint64_t> largest;
  for (std::size_t space = line.find(' '); space != std::string_view::npos; space = line.find(' ', space + 1)) {
    const std::string_view word = line.substr(space + 1, line.find(' ', space + 1) - space - 1);
    if (!std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) continue;
    if (const auto count = whole_number(word)) largest = std::max(largest.value_or(0), *count);
  }
  return largest;
}

}  // namespace
}  // namespace glisson::geometry
