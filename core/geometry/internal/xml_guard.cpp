// The format: "VTK File Formats", Kitware, section "XML File Formats".

#include "geometry/internal/xml_guard.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace glisson::geometry {
namespace {

namespace fs = std::filesystem;
using Wrong = std::optional<std::string>;

constexpr std::size_t longest_element = 4096;

// Looks at one element after the other: remembers the arrays of the section it is in, and where compressed ones begin.
class Elements {
 public:
  struct Offset {
    std::uint64_t bytes;
    bool may_be_empty;
  };
  Wrong next(std::string_view element);
  // Is what follows the element an array in base64?
  [[nodiscard]] bool before_binary() const { return before_binary_; }
  // The head of a compressed array: how many blocks there are, the bytes in each, in the last, and of each compressed.
  [[nodiscard]] Wrong head(std::string_view bytes, bool may_be_empty, std::uint64_t file_bytes) const;
  [[nodiscard]] std::uint64_t word(std::string_view bytes, std::size_t number) const;
  [[nodiscard]] std::size_t word_bytes() const { return word_bytes_; }
  [[nodiscard]] bool may_be_empty() const { return may_be_empty_; }
  [[nodiscard]] bool compressed() const { return compressed_; }
  [[nodiscard]] const std::vector<Offset>& offsets() const { return offsets_; }

 private:
  void count_items(std::string_view piece);

  std::set<std::string, std::less<>> arrays_;
  std::map<std::string, std::uint64_t, std::less<>> items_;  // of the piece, by section
  std::vector<Offset> offsets_;                              // into the appended data
  std::size_t word_bytes_ = 4;
  bool compressed_ = false, big_endian_ = false, before_binary_ = false, may_be_empty_ = false;
};
Wrong wrong_appended(std::ifstream& stream, std::string_view element, const Elements& elements,
                     std::uint64_t file_bytes);

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
std::optional<std::string_view> attribute(std::string_view element, std::string_view name);
Wrong wrong_count(std::string_view element);
std::string from_base64(std::string_view text);

}  // namespace

Result<void> check_xml_elements(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code problem;
  const std::uint64_t size = fs::file_size(file, problem);
  if (!stream || problem) {
    return failure(Error{"file-not-readable",
                         GLISSON_TEXT("The file {0} cannot be read."),
                         {file.string()},
                         GLISSON_TEXT("Check that it exists and that you may read it."),
                         file});
  }
  const auto refused = [&](const std::string& why) {
    return failure(Error{"mesh-file-invalid",
                         GLISSON_TEXT("{0} cannot be read as a mesh: {1}."),
                         {file.filename().string(), why},
                         GLISSON_TEXT("Open it in ParaView to see whether it is damaged."),
                         file});
  };
  Elements elements;
  std::string element, head;
  constexpr std::size_t longest_head = 4096;  // of an array between its tags, in base64
  bool inside = false;
  for (std::istreambuf_iterator<char> at(stream), end; at != end; ++at) {
    if (*at == '<') {
      if (!head.empty() && head.size() < longest_head) {
        if (const Wrong wrong = elements.head(from_base64(head), elements.may_be_empty(), size)) return refused(*wrong);
      }
      head.clear();
      inside = true;
      element.clear();
    } else if (inside && *at == '>') {
      inside = false;
      if (element.starts_with("AppendedData")) {
        stream.clear();
        const Wrong wrong = wrong_appended(stream, element, elements, size);
        return wrong ? refused(*wrong) : Result<void>();
      }
      if (const Wrong wrong = elements.next(element)) return refused(*wrong);
      head.clear();
    } else if (!inside && elements.before_binary() && head.size() < longest_head && !is_space(*at)) {
      head += *at;
      if (head.size() < longest_head) continue;
      if (const Wrong wrong = elements.head(from_base64(head), elements.may_be_empty(), size)) return refused(*wrong);
    } else if (inside) {
      element += *at;
      if (element.size() > longest_element) return refused(GLISSON_TEXT("one of its elements does not end"));
    }
  }
  return {};
}

namespace {

// How many items the arrays of each section have.
void Elements::count_items(std::string_view piece) {
  const auto count = [&](std::string_view name) {
    const auto text = attribute(piece, name).value_or("0");
    std::uint64_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
  };
  items_ = {{"Points", count("NumberOfPoints")}, {"PointData", count("NumberOfPoints")},
            {"Cells", count("NumberOfCells")},   {"Verts", count("NumberOfVerts")},
            {"Lines", count("NumberOfLines")},   {"Strips", count("NumberOfStrips")},
            {"Polys", count("NumberOfPolys")}};
  items_["CellData"] = items_["Cells"] + items_["Verts"] + items_["Lines"] + items_["Strips"] + items_["Polys"];
}

Wrong Elements::next(std::string_view element) {
  if (const Wrong wrong = wrong_count(element)) return wrong;
  if (element.starts_with("VTKFile")) {
    compressed_ = attribute(element, "compressor").has_value();
    big_endian_ = attribute(element, "byte_order") == "BigEndian";
    word_bytes_ = attribute(element, "header_type") == "UInt64" ? 8 : 4;
  }
  before_binary_ = false;
  if (!element.starts_with("DataArray") && !element.starts_with("Array")) {
    arrays_.clear();
    if (element.starts_with("Piece")) count_items(element);
    const auto section = items_.find(element.substr(0, element.find_first_of(" \t\r\n/")));
    if (section != items_.end()) may_be_empty_ = section->second == 0;
    return std::nullopt;
  }
  before_binary_ = attribute(element, "format") == "binary";
  if (const auto offset = attribute(element, "offset"); offset && attribute(element, "format") == "appended") {
    std::uint64_t number = 0;
    std::from_chars(offset->data(), offset->data() + offset->size(), number);
    offsets_.push_back({number, may_be_empty_});
  }
  const auto name = attribute(element, "Name");
  if (!name || arrays_.insert(std::string(*name)).second) return std::nullopt;
  return "it has two arrays of the name " + std::string(name->substr(0, 40));
}

// The bytes that base64 stands for, up to the first character that is none of it.
std::string from_base64(std::string_view text) {
  static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xFF);
  }
  return bytes;
}

std::uint64_t Elements::word(std::string_view bytes, std::size_t number) const {
  std::uint64_t word = 0;
  for (std::size_t b = 0; b < word_bytes_; ++b) {
    const std::size_t at = number * word_bytes_ + (big_endian_ ? b : word_bytes_ - 1 - b);
    word = word << 8 | (at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0U);
  }
  return word;
}

Wrong Elements::head(std::string_view bytes, bool may_be_empty, std::uint64_t file_bytes) const {
  const std::uint64_t blocks = word(bytes, 0), block_bytes = word(bytes, 1), last_bytes = word(bytes, 2);
  if (!compressed_ || (blocks == 0 && may_be_empty)) return std::nullopt;
  if (blocks == 0) return GLISSON_TEXT("a compressed array has no blocks");
  constexpr std::uint64_t maximum_bytes_a_byte = 1100;  // zlib cannot do better
  const std::uint64_t maximum = maximum_bytes_a_byte * file_bytes;
  if (block_bytes == 0) return GLISSON_TEXT("the blocks of a compressed array have no size");
  const std::string too_large = GLISSON_TEXT("a compressed array has more bytes than the file can hold");
  if (blocks > file_bytes / word_bytes_ || block_bytes > std::max<std::uint64_t>(maximum, 1U << 20) ||
      (blocks > 1 && block_bytes > maximum / (blocks - 1)) || last_bytes > block_bytes) {
    return too_large;
  }
  std::uint64_t compressed = 0;  // of the blocks whose sizes are among the bytes
  for (std::uint64_t block = 3; block < 3 + blocks && (block + 1) * word_bytes_ <= bytes.size(); ++block) {
    compressed += std::min(word(bytes, block), file_bytes + 1);
    if (compressed > file_bytes) return too_large;
  }
  return std::nullopt;
}

Wrong wrong_appended(std::ifstream& stream, std::string_view element, const Elements& elements,
                     std::uint64_t file_bytes) {
  const bool base64 = attribute(element, "encoding").value_or("base64") != "raw";
  char mark = 0;
  while (stream.get(mark) && mark != '_') {
  }
  const auto begin = stream.tellg();
  const auto bytes_at = [&](std::uint64_t offset, std::size_t count) {
    std::string bytes(base64 ? 4 * ((count + 2) / 3) : count, '\0');
    stream.clear();
    stream.seekg(begin + static_cast<std::streamoff>(offset));
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    return base64 ? from_base64(bytes) : bytes;
  };
  for (const auto& [offset, may_be_empty] : elements.offsets()) {
    if (begin < 0 || offset > file_bytes) return GLISSON_TEXT("an array begins behind its end");
    const std::string counts = bytes_at(offset, 3 * elements.word_bytes());
    if (const Wrong wrong = elements.head(counts, may_be_empty, file_bytes)) return wrong;
    if (!elements.compressed()) continue;
    const auto words = static_cast<std::size_t>(3 + elements.word(counts, 0));
    const std::string whole = bytes_at(offset, words * elements.word_bytes());
    if (const Wrong wrong = elements.head(whole, may_be_empty, file_bytes)) return wrong;
  }
  return std::nullopt;
}

// The text in quotes behind the attribute's name.
std::optional<std::string_view> attribute(std::string_view element, std::string_view name) {
  for (std::size_t at = element.find(name); at != std::string_view::npos; at = element.find(name, at + 1)) {
    std::size_t behind = at + name.size();
    while (behind < element.size() && is_space(element[behind])) ++behind;
    if (at == 0 || !is_space(element[at - 1]) || behind >= element.size() || element[behind] != '=') continue;
    const std::size_t open = element.find_first_of("\"'", behind);
    if (open == std::string_view::npos) return std::nullopt;
    const std::size_t close = element.find(element[open], open + 1);
    return element.substr(open + 1, close == std::string_view::npos ? close : close - open - 1);
  }
  return std::nullopt;
}

Wrong wrong_count(std::string_view element) {
  for (const std::string_view name : {"NumberOfPoints", "NumberOfCells", "NumberOfVerts", "NumberOfLines",
                                      "NumberOfStrips", "NumberOfPolys", "NumberOfComponents", "NumberOfTuples"}) {
    auto count = attribute(element, name);
    if (!count) continue;
    while (!count->empty() && is_space(count->back())) count->remove_suffix(1);
    while (!count->empty() && is_space(count->front())) count->remove_prefix(1);
    const bool whole = !count->empty() && count->size() <= 18 &&
                       std::all_of(count->begin(), count->end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!whole) return std::string(name) + " is no whole number";
  }
  return std::nullopt;
}

}  // namespace
}  // namespace glisson::geometry
