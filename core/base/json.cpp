#include "base/json.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/json_forward.h"

namespace glisson {
namespace {

std::size_t line_of(std::string_view text, std::size_t byte) {
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + std::min(byte, text.size()), '\n'));
}

// Levenshtein distance, for "did you mean".
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
    }
  }
  return row.back();
}

// nlohmann's parser recurses once a level; a hostile file must not choose the depth of our stack.
bool nested_too_deep(std::string_view text) {
  constexpr int limit = 200;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > limit) return true;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return false;
}

}  // namespace

Result<Json> parse_json(std::string_view text, const std::filesystem::path& file) {
  if (nested_too_deep(text)) {
    return failure(Error{
        "json-too-deep", GLISSON_TEXT("{0} is nested too deep to be one of our files."), {file.string()}, {}, file});
  }
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& problem) {
    return failure(Error{"json-invalid",
                         GLISSON_TEXT("{0} is not valid JSON at line {1}."),
                         {file.string(), std::to_string(line_of(text, problem.byte))},
                         GLISSON_TEXT("Look for a missing comma, quote or bracket there."),
                         file});
  } catch (const Json::out_of_range&) {
    return failure(Error{"json-invalid",
                         GLISSON_TEXT("{0} holds a number too large for a computer's arithmetic."),
                         {file.string()},
                         {},
                         file});
  }
}

Result<Json> read_json_file(const std::filesystem::path& file) {
  return read_text_file(file, std::uint64_t{64} << 20).and_then([&](const std::string& text) {
    return parse_json(text, file);
  });
}

Result<void> write_json_file(const std::filesystem::path& file, const Json& document) {
  GLISSON_ASSERT(all_numbers_finite(document));
  return write_text_file(file, document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Result<void> refuse_unknown_keys(const Json& object, std::initializer_list<std::string_view> known,
                                 const std::string& where) {
  if (!object.is_object()) {
    return failure("json-not-an-object", GLISSON_TEXT("{0} should be an object in braces."), {where});
  }
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const auto nearest = std::min_element(known.begin(), known.end(), [&, &name = key](auto a, auto b) {
      return edit_distance(name, a) < edit_distance(name, b);
    });
    return failure(Error{"json-unknown-key",
                         GLISSON_TEXT("{0} has a key that is not known: \"{1}\"."),
                         {where, key, nearest == known.end() ? "" : std::string(*nearest)},
                         GLISSON_TEXT("Did you mean \"{2}\"?"),
                         {}});
  }
  return {};
}

Json json_of(const Eigen::Vector3d& vector) { return Json::array({vector.x(), vector.y(), vector.z()}); }

bool all_numbers_finite(const Json& document) {
  if (document.is_number_float()) return std::isfinite(document.get<double>());
  if (!document.is_structured()) return true;
  return std::all_of(document.begin(), document.end(), [](const Json& item) { return all_numbers_finite(item); });
}

Json null_where_not_finite(Json document) {
  if (document.is_number_float() && !std::isfinite(document.get<double>())) return nullptr;
  if (document.is_structured())
    for (Json& item : document) item = null_where_not_finite(std::move(item));
  return document;
}

}  // namespace glisson
