// The format: "VTK File Formats", Kitware, section "Simple Legacy Formats"; cells as offsets and connectivity
// since 5.1.

#include "geometry/internal/legacy_vtk_guard.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/text.h"

namespace glisson::geometry {
namespace {

namespace fs = std::filesystem;

// Where reading has got to. What cannot be read is nullopt, and then nothing that follows makes sense.
class LegacyText {
 public:
  explicit LegacyText(std::string_view text) : text_(text) {}

  std::string line();
  std::string word();  // in lower case; empty at the end
  std::optional<std::uint64_t> count();
  void set_binary(bool binary) { binary_ = binary; }
  // Values of one of VTK's types; the header line before them is left first.
  bool skip_values(std::uint64_t values, const std::string& type);
  std::optional<std::vector<std::int64_t>> integers(std::uint64_t values, const std::string& type);

 private:
  [[nodiscard]] std::optional<std::string_view> block(std::uint64_t values, const std::string& type);

  std::string_view text_;
  std::size_t at_ = 0;
  bool binary_ = false;
};

using Wrong = std::optional<std::string>;  // what is wrong, if anything

struct Walk {
  LegacyText text;
  bool offsets_lead = false;  // cells as offsets and connectivity
  std::optional<std::uint64_t> cells, cell_types;

  Wrong through_geometry();
  Wrong cell_list(const std::string& name);
  Wrong counted_list(const std::string& name, std::uint64_t cells, std::uint64_t numbers);
  Wrong offset_list(const std::string& name, std::uint64_t offsets, std::uint64_t connected);
  Wrong field();
};

}  // namespace

Result<void> check_cell_lists(const fs::path& file) {
  const Result<std::string> content = read_text_file(file);
  if (!content) return failure(content.error());
  Walk walk{LegacyText(*content), false, {}, {}};
  const Wrong wrong = walk.through_geometry();
  if (!wrong) return {};
  return failure(Error{"mesh-file-invalid",
                       GLISSON_TEXT("{0} cannot be read as a mesh: {1}."),
                       {file.filename().string(), *wrong},
                       GLISSON_TEXT("Open it in ParaView to see whether it is damaged."),
                       file});
}

namespace {

Wrong Walk::through_geometry() {
  const std::string version = text.line();
  const std::size_t number = version.find("Version ");
  offsets_lead = number != std::string::npos && version.substr(number + 8) >= "5.1";
  text.line();  // the title
  text.set_binary(text.word() == "binary");
  if (text.word() != "dataset") return GLISSON_TEXT("it names no dataset");
  const std::string dataset = text.word();
  if (dataset != "polydata" && dataset != "unstructured_grid") return "it holds a " + dataset;

  for (std::string part = text.word(); !part.empty(); part = text.word()) {
    if (part == "point_data" || part == "cell_data") break;
    Wrong wrong;
    if (part == "points") {
      const auto points = text.count();
      if (!points || *points > UINT64_MAX / 3 || !text.skip_values(3 * *points, text.word())) {
        wrong = GLISSON_TEXT("its points are not all there");
      }
    } else if (part == "vertices" || part == "lines" || part == "polygons" || part == "triangle_strips" ||
               part == "cells") {
      wrong = cell_list(part);
    } else if (part == "cell_types") {
      cell_types = text.count();
      if (!cell_types || !text.integers(*cell_types, "int")) wrong = GLISSON_TEXT("its cell types are not all there");
    } else if (part == "field") {
      wrong = field();
    } else if (part == "metadata") {
      text.line();
      for (std::string line = text.line(); !line.empty(); line = text.line()) {
      }
    } else {
      wrong = "where a part should begin stands " + part.substr(0, 20);
    }
    if (wrong) return wrong;
  }
  if (dataset == "unstructured_grid" && (!cells || cells != cell_types)) {
    return GLISSON_TEXT("it has not as many cell types as cells");
  }
  return std::nullopt;
}

Wrong Walk::cell_list(const std::string& name) {
  const auto first = text.count(), second = text.count();
  if (!first || !second) return "the header of its " + name + " is no pair of counts";
  return offsets_lead ? offset_list(name, *first, *second) : counted_list(name, *first, *second);
}

Wrong Walk::counted_list(const std::string& name, std::uint64_t count, std::uint64_t numbers) {
  const auto list = text.integers(numbers, "int");
  if (!list) return "its " + name + " are not all there";
  // VTK reads them as 32 bits, and what does not fit ends its reading in the midst.
  if (std::any_of(list->begin(), list->end(), [](std::int64_t n) { return n < 0 || n > INT32_MAX; })) {
    return "its " + name + " name points that cannot be";
  }
  std::uint64_t at = 0;
  for (std::uint64_t cell = 0; cell < count; ++cell) {
    const bool fits = at < numbers && (*list)[at] >= 0 && static_cast<std::uint64_t>((*list)[at]) < numbers - at;
    if (!fits) return "number " + std::to_string(cell) + " of its " + name + " has more points than the list";
    at += static_cast<std::uint64_t>((*list)[at]) + 1;
  }
  if (at != numbers) return "its " + name + " are fewer than the list holds";
  if (name == "cells") cells = count;
  return std::nullopt;
}

Wrong Walk::offset_list(const std::string& name, std::uint64_t offsets, std::uint64_t connected) {
  std::optional<std::vector<std::int64_t>> starts;
  if (text.word() == "offsets") starts = text.integers(offsets, text.word());
  if (!starts || text.word() != "connectivity" || !text.skip_values(connected, text.word())) {
    return "its " + name + " are not all there";
  }
  const bool whole = starts->empty() ? connected == 0
                                     : starts->front() == 0 && std::is_sorted(starts->begin(), starts->end()) &&
                                           static_cast<std::uint64_t>(starts->back()) == connected;
  if (!whole) return "the offsets of its " + name + " do not lead through the list";
  if (name == "cells") cells = offsets == 0 ? 0 : offsets - 1;
  return std::nullopt;
}

Wrong Walk::field() {
  text.word();  // its name
  const auto arrays = text.count();
  if (!arrays) return GLISSON_TEXT("a field says not how many arrays it has");
  for (std::uint64_t array = 0; array < *arrays; ++array) {
    text.word();  // its name
    const auto components = text.count(), tuples = text.count();
    const bool whole = components && tuples && (*components == 0 || *tuples <= UINT64_MAX / *components) &&
                       text.skip_values(*components * *tuples, text.word());
    if (!whole) return GLISSON_TEXT("an array before its cells is not all there, or is text");
  }
  return std::nullopt;
}

// Bytes of a value in a binary file. Bits and strings have no whole number of them.
std::optional<std::size_t> bytes_of(const std::string& type) {
  static const std::map<std::string, std::size_t> bytes = {
      {"char", 1},         {"unsigned_char", 1}, {"short", 2},         {"unsigned_short", 2}, {"int", 4},
      {"unsigned_int", 4}, {"long", 8},          {"unsigned_long", 8}, {"vtktypeint64", 8},   {"vtktypeuint64", 8},
      {"float", 4},        {"double", 8},        {"vtkidtype", 4}};  // VTK writes these as int
  const auto found = bytes.find(type);
  return found == bytes.end() ? std::nullopt : std::optional(found->second);
}

std::string LegacyText::line() {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string line(text_.substr(at_, end - at_));
  at_ = std::min(end + 1, text_.size());
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

std::string LegacyText::word() {
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  std::string word;
  for (; at_ < text_.size() && !is_space(text_[at_]); ++at_) {
    word += static_cast<char>(std::tolower(static_cast<unsigned char>(text_[at_])));
  }
  return word;
}

std::optional<std::uint64_t> LegacyText::count() { return read_whole_number<std::uint64_t>(word()); }

std::optional<std::string_view> LegacyText::block(std::uint64_t values, const std::string& type) {
  const auto bytes = bytes_of(type);
  if (!bytes) return std::nullopt;
  line();  // the rest of the header line
  if (values > (text_.size() - at_) / *bytes) return std::nullopt;
  const std::string_view block = text_.substr(at_, static_cast<std::size_t>(values) * *bytes);
  at_ += block.size();
  return block;
}

bool LegacyText::skip_values(std::uint64_t values, const std::string& type) {
  if (binary_) return block(values, type).has_value();
  if (!bytes_of(type) || values > text_.size()) return false;
  for (std::uint64_t n = 0; n < values; ++n) {
    if (word().empty()) return false;
  }
  return true;
}

std::optional<std::vector<std::int64_t>> LegacyText::integers(std::uint64_t values, const std::string& type) {
  std::vector<std::int64_t> numbers;
  if (!binary_) {
    if (values > text_.size()) return std::nullopt;
    numbers.resize(static_cast<std::size_t>(values));
    for (std::int64_t& number : numbers) {
      const auto read = read_whole_number<std::int64_t>(word());
      if (!read) return std::nullopt;
      number = *read;
    }
    return numbers;
  }
  const auto big_endian = block(values, type);
  if (!big_endian) return std::nullopt;
  const std::size_t bytes = *bytes_of(type);
  if (bytes != 4 && bytes != 8) return std::nullopt;
  for (std::size_t at = 0; at < big_endian->size(); at += bytes) {
    std::uint64_t number = 0;
    for (std::size_t byte = 0; byte < bytes; ++byte) {
      number = number << 8 | static_cast<unsigned char>((*big_endian)[at + byte]);
    }
    numbers.push_back(bytes == 4 ? static_cast<std::int32_t>(number) : static_cast<std::int64_t>(number));
  }
  return numbers;
}

}  // namespace
}  // namespace glisson::geometry
