#include "geometry/ply_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "geometry/internal/mesh_file_guard.h"

namespace glisson::geometry {
namespace {

namespace fs = std::filesystem;

enum class Number { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Encoding { text, little_endian, big_endian };

struct Property {
  std::string name;
  Number type = Number::float32;
  std::optional<Number> count_type;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
  std::size_t body = 0;  // where it begins
};
std::optional<Header> read_header(std::string_view text);

// Takes numbers off the body, one after the other; nothing once it has ended.
class Body {
 public:
  Body(std::string_view bytes, Encoding encoding) : rest_(bytes), encoding_(encoding) {}
  std::optional<double> next(Number type);

 private:
  std::optional<double> next_in_text();
  std::string_view rest_;
  Encoding encoding_;
};

// One vertex or face (or whatever else the file holds) into the surface; false where the body does not hold it.
bool read_item(const Element& element, Body& body, Surface& surface);

}  // namespace

Result<Surface> read_ply(const fs::path& file) {
  const auto invalid = [&](const std::string& reason) {
    return failure(Error{"mesh-file-invalid",
                         GLISSON_TEXT("{0} cannot be read as a mesh: {1}."),
                         {file.filename().string(), reason},
                         {},
                         file});
  };
  if (auto checked = check_announced_counts(file); !checked) return failure(checked.error());
  const auto text = read_text_file(file);
  if (!text) return failure(text.error());
  const auto header = read_header(*text);
  if (!header) return invalid(GLISSON_TEXT("its header is not that of a PLY file"));

  Surface surface;
  Body body(std::string_view(*text).substr(header->body), header->encoding);
  for (const Element& element : header->elements) {
    if (element.properties.empty()) continue;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_item(element, body, surface)) {
        return invalid("it ends or is damaged in " + element.name + " " + std::to_string(i));
      }
    }
  }
  return surface;
}

namespace {

std::optional<Number> number_named(const std::string& name) {
  static constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                         {"uchar", "uint8"},
                                                                         {"short", "int16"},
                                                                         {"ushort", "uint16"},
                                                                         {"int", "int32"},
                                                                         {"uint", "uint32"},
                                                                         {"float", "float32"},
                                                                         {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i][0] || name == names[i][1]) return static_cast<Number>(i);
  }
  return std::nullopt;
}

std::optional<Property> read_property(std::istringstream& words) {
  Property property;
  std::string type;
  words >> type;
  if (type == "list") {
    std::string count_type;
    words >> count_type >> type;
    property.count_type = number_named(count_type);
    if (!property.count_type) return std::nullopt;
  }
  const auto number = number_named(type);
  if (!number || !(words >> property.name)) return std::nullopt;
  property.type = *number;
  return property;
}

std::optional<Header> read_header(std::string_view text) {
  Header header;
  bool has_format = false;
  for (std::size_t begin = 0, line = 0; begin < text.size(); ++line) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) return std::nullopt;
    std::istringstream words{std::string(text.substr(begin, std::min<std::size_t>(end - begin, 1024)))};
    begin = end + 1;
    std::string keyword;
    words >> keyword;
    if (line == 0) {
      if (keyword != "ply") return std::nullopt;
    } else if (keyword == "format") {
      std::string name;
      words >> name;
      has_format = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
      if (name == "binary_little_endian") header.encoding = Encoding::little_endian;
      if (name == "binary_big_endian") header.encoding = Encoding::big_endian;
    } else if (keyword == "element") {
      Element element;
      if (!(words >> element.name >> element.count)) return std::nullopt;
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      const auto property = read_property(words);
      if (!property || header.elements.empty()) return std::nullopt;
      header.elements.back().properties.push_back(*property);
    } else if (keyword == "end_header") {
      header.body = begin;
      return has_format ? std::optional(header) : std::nullopt;
    } else if (keyword != "comment" && keyword != "obj_info") {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

template <typename Value>
double value_of(std::array<char, 8> bytes) {
  Value value{};
  std::memcpy(&value, bytes.data(), sizeof(Value));
  return static_cast<double>(value);
}

std::optional<double> Body::next(Number type) {
  static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  if (encoding_ == Encoding::text) return next_in_text();
  const std::size_t size = sizes[static_cast<std::size_t>(type)];
  if (rest_.size() < size) return std::nullopt;
  std::array<char, 8> bytes{};
  std::copy_n(rest_.begin(), size, bytes.begin());
  rest_.remove_prefix(size);
  const bool file_is_little = encoding_ == Encoding::little_endian;
  const bool machine_is_little = std::endian::native == std::endian::little;
  if (file_is_little != machine_is_little)
    std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
  switch (type) {
    case Number::int8: return value_of<std::int8_t>(bytes);
    case Number::uint8: return value_of<std::uint8_t>(bytes);
    case Number::int16: return value_of<std::int16_t>(bytes);
    case Number::uint16: return value_of<std::uint16_t>(bytes);
    case Number::int32: return value_of<std::int32_t>(bytes);
    case Number::uint32: return value_of<std::uint32_t>(bytes);
    case Number::float32: return value_of<float>(bytes);
    case Number::float64: return value_of<double>(bytes);
  }
  return std::nullopt;
}

std::optional<double> Body::next_in_text() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
  double value = 0;
  const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
  if (error != std::errc{}) return std::nullopt;
  rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
  return value;
}

// -1, which no point has, for what is no index.
int index_from(double value) {
  return value >= 0 && value < 2147483648.0 && value == std::floor(value) ? static_cast<int>(value) : -1;
}

bool read_item(const Element& element, Body& body, Surface& surface) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  for (const Property& property : element.properties) {
    const auto first = body.next(property.count_type.value_or(property.type));
    if (!first) return false;
    if (!property.count_type) {
      for (int axis = 0; axis < 3; ++axis) {
        if (property.name == std::string(1, "xyz"[axis])) position[axis] = *first;
      }
      continue;
    }
    const int count = index_from(*first);
    if (count < 0) return false;
    const bool is_polygon = property.name == "vertex_indices" || property.name == "vertex_index";
    std::array<int, 2> fan{};  // the polygon's first corner, and the one before this
    for (int i = 0; i < count; ++i) {
      const auto value = body.next(property.type);
      if (!value) return false;
      const int corner = index_from(*value);
      if (i == 0) fan[0] = corner;
      if (is_polygon && i >= 2) surface.triangles.push_back({fan[0], fan[1], corner});
      fan[1] = corner;
    }
  }
  if (element.name == "vertex") surface.points_mm.push_back(position);
  return true;
}

}  // namespace
}  // namespace glisson::geometry
