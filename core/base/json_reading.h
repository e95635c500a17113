#pragma once
// Reading a JSON document that somebody wrote: values in, or the first refusal, which says where it stands and what is
// wrong there. A reader of a part gives back its value and nothing else: its refusal travels as an exception, which
// reading() ends. Include it in .cpp files and internal headers only.
//
//   Lens lens_from(const Json& json, const std::string& where) {
//     only_keys(json, {"radius_mm"}, where);
//     return {positive_in(required(json, "radius_mm", where), where + ", radius_mm")};
//   }
//   Result<Lens> lens = reading("lens-invalid", file, [&] { return lens_from(*document, "The lens"); });
//
// `where` is how a person finds the place: "support 2, sphere", "trial p01, tool, radius_mm".

#include <Eigen/Core>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/json.h"

namespace glisson {

struct Refusal {
  Error error;
};

// What `read` gives, or the refusal in it: with `code` where it has none of its own, and in `file` where it names none.
template <typename Read>
Result<std::invoke_result_t<Read>> reading(const char* code, const std::filesystem::path& file, const Read& read) {
  try {
    return read();
  } catch (Refusal& refusal) {
    if (refusal.error.code.empty()) refusal.error.code = code;
    if (refusal.error.file.empty()) refusal.error.file = file;
    return failure(std::move(refusal.error));
  }
}

// Refuses what is wrong at a place: `text` has {0} for it, and {1}, {2}, ... for `more`.
[[noreturn]] void refuse_at(const std::string& where, std::string text, std::vector<std::string> more = {});
// Refuses by a sentence of its own.
[[noreturn]] void refuse(std::string code, std::string text, std::vector<std::string> arguments, std::string hint = {},
                         std::filesystem::path file = {});
// What something else read, or its refusal.
template <typename Value>
Value taken(Result<Value> result) {
  if (!result) throw Refusal{std::move(result.error())};
  return *std::move(result);
}

// An object without any other key.
void only_keys(const Json& json, std::initializer_list<std::string_view> known, const std::string& where);
[[nodiscard]] const Json& required(const Json& json, const char* key, const std::string& where);

// What `json` itself is.
[[nodiscard]] double number_in(const Json& json, const std::string& where);  // finite
[[nodiscard]] double positive_in(const Json& json, const std::string& where);
[[nodiscard]] double not_negative_in(const Json& json, const std::string& where);
[[nodiscard]] bool truth_in(const Json& json, const std::string& where);
[[nodiscard]] std::string text_in(const Json& json, const std::string& where);
[[nodiscard]] std::string name_in(const Json& json, const std::string& where);  // not empty
[[nodiscard]] Eigen::Vector3d vector_in(const Json& json, const std::string& where);

[[nodiscard]] std::optional<double> optional_positive(const Json& json, const char* key, const std::string& where);

// ("support", 0): "support 1"
[[nodiscard]] std::string item(const char* each, std::size_t index);

// One of the words, as the value that stands beside it.
template <typename Value>
Value one_of(const Json& json, const std::string& where, std::initializer_list<std::pair<const char*, Value>> choices) {
  std::string list;
  for (const auto& [text, value] : choices) {
    if (json == text) return value;
    list += (list.empty() ? "\"" : ", \"") + std::string(text) + "\"";
  }
  refuse_at(where, GLISSON_TEXT("{0} must be one of {1}."), {list});
}

// "supports" -> support_from(json, "support 1") and so on; none where the key is not there.
template <typename Value>
std::vector<Value> list_of(const Json& json, const char* key, const char* each,
                           Value (*read)(const Json&, const std::string&)) {
  std::vector<Value> values;
  const auto found = json.find(key);
  if (found == json.end()) return values;
  if (!found->is_array()) refuse_at(key, GLISSON_TEXT("{0} must be a list in brackets."));
  for (std::size_t i = 0; i < found->size(); ++i) values.push_back(read((*found)[i], item(each, i)));
  return values;
}

}  // namespace glisson
