#include "geometry/internal/obj_file.h"

#include <fmt/format.h>
#include <charconv>
#include <iterator>
#include <optional>
#include <string_view>

#include "base/files.h"

namespace glisson::geometry {
namespace {

namespace fs = std::filesystem;

// Takes the first word off the front of `rest`; empty at the end of the line.
std::string_view take_word(std::string_view& rest);
std::optional<Eigen::Vector3d> read_position(std::string_view rest);

// The points of a face, counted from 0; negative numbers count back from the point read last ("-1").
std::optional<std::vector<int>> read_face(std::string_view rest, std::size_t points_so_far);

}  // namespace

Result<Surface> read_obj(const fs::path& file) {
  const auto text = read_text_file(file);
  if (!text) return failure(text.error());

  Surface surface;
  std::size_t line_number = 0;
  for (std::size_t begin = 0; begin < text->size();) {
    const std::size_t end = std::min(text->find('\n', begin), text->size());
    std::string_view rest = std::string_view(*text).substr(begin, end - begin);
    begin = end + 1;
    ++line_number;

    const std::string_view keyword = take_word(rest);
    bool understood = true;
    if (keyword == "v") {
      const auto position = read_position(rest);
      understood = position.has_value();
      if (position) surface.points_mm.push_back(*position);
    } else if (keyword == "f") {
      const auto face = read_face(rest, surface.points_mm.size());
      understood = face.has_value();
      for (std::size_t i = 2; face && i < face->size(); ++i) {
        surface.triangles.push_back({(*face)[0], (*face)[i - 1], (*face)[i]});
      }
    }
    if (!understood) {
      return failure(Error{"mesh-file-invalid",
                           GLISSON_TEXT("Line {1} of {0} is neither a point nor a face."),
                           {file.filename().string(), std::to_string(line_number)},
                           {},
                           file});
    }
  }
  return surface;
}

Result<void> write_obj(const fs::path& file, const Surface& surface) {
  std::string text;
  for (const Eigen::Vector3d& point : surface.points_mm) {
    fmt::format_to(std::back_inserter(text), "v {} {} {}\n", point.x(), point.y(), point.z());
  }
  for (const auto& [a, b, c] : surface.triangles) {
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", a + 1, b + 1, c + 1);
  }
  return write_text_file(file, text);
}

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view take_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  const std::size_t length = std::min(rest.find_first_of(blanks), rest.size());
  const std::string_view word = rest.substr(0, length);
  rest.remove_prefix(length);
  return word;
}

std::optional<Eigen::Vector3d> read_position(std::string_view rest) {
  Eigen::Vector3d position;
  for (double& coordinate : position) {
    const std::string_view word = take_word(rest);
    if (std::from_chars(word.data(), word.data() + word.size(), coordinate).ec != std::errc{}) return std::nullopt;
  }
  return position;
}

std::optional<std::vector<int>> read_face(std::string_view rest, std::size_t points_so_far) {
  std::vector<int> points;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    int number = 0;
    if (std::from_chars(word.data(), word.data() + word.size(), number).ec != std::errc{}) return std::nullopt;
    if (number == 0) return std::nullopt;
    points.push_back(number > 0 ? number - 1 : static_cast<int>(points_so_far) + number);
  }
  if (points.size() < 3) return std::nullopt;
  return points;
}

}  // namespace
}  // namespace glisson::geometry
