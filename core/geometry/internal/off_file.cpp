#include "geometry/internal/off_file.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "base/files.h"

namespace glisson::geometry {
namespace {

namespace fs = std::filesystem;

// The numbers of a file, line by line; blank lines and what follows a '#' are passed over.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  bool next();  // false at the end
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] std::size_t number() const { return number_; }

  template <typename Number>
  std::optional<Number> take() {
    skip_blanks();
    Number value{};
    const auto [end, problem] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (problem != std::errc{}) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size())); }

  std::string_view text_;
  std::string_view rest_;
  std::size_t number_ = 0;
};

bool Lines::next() {
  while (!text_.empty()) {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    rest_ = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++number_;
    rest_ = rest_.substr(0, std::min(rest_.find('#'), rest_.size()));
    skip_blanks();
    if (!rest_.empty()) return true;
  }
  return false;
}

bool read_point(Lines& lines, Surface& surface) {
  Eigen::Vector3d point;
  for (double& coordinate : point) {
    const auto value = lines.take<double>();
    if (!value) return false;
    coordinate = *value;
  }
  surface.points_mm.push_back(point);
  return true;
}

bool read_face(Lines& lines, Surface& surface) {
  const auto corners = lines.take<int>();
  if (!corners || *corners < 3) return false;
  std::vector<int> polygon;
  for (int corner = 0; corner < *corners; ++corner) {
    const auto point = lines.take<int>();
    if (!point) return false;
    polygon.push_back(*point);
  }
  for (std::size_t i = 2; i < polygon.size(); ++i)
    surface.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
  return true;
}

}  // namespace

Result<Surface> read_off(const fs::path& file) {
  const auto text = read_text_file(file);
  if (!text) return failure(text.error());

  Lines lines(*text);
  const auto invalid = [&] {
    return failure(Error{"mesh-file-invalid",
                         GLISSON_TEXT("Line {1} of {0} is not what an OFF file holds there."),
                         {file.filename().string(), std::to_string(lines.number())},
                         {},
                         file});
  };
  if (!lines.next() || !lines.rest().starts_with("OFF") || !lines.next()) return invalid();
  const auto points = lines.take<std::uint64_t>();
  const auto faces = lines.take<std::uint64_t>();
  // A point or face takes a line of two characters at the very least.
  if (!points || !faces || *points > text->size() / 2 || *faces > text->size() / 2) return invalid();

  Surface surface;
  surface.points_mm.reserve(*points);
  surface.triangles.reserve(*faces);
  for (std::uint64_t i = 0; i < *points; ++i) {
    if (!lines.next() || !read_point(lines, surface)) return invalid();
  }
  for (std::uint64_t i = 0; i < *faces; ++i) {
    if (!lines.next() || !read_face(lines, surface)) return invalid();
  }
  return surface;
}

}  // namespace glisson::geometry
