#include <fmt/format.h>

#include "base/json_value.h"
#include "hardware/device.h"
#include "hardware/internal/figure_file.h"

namespace glisson::hardware {
namespace {

constexpr std::size_t longest_text = 2000;

}  // namespace

std::string to_string(Source source) {
  switch (source) {
    case Source::measured: return "measured";
    case Source::computed: return "computed";
    case Source::dissertation: return "dissertation";
    case Source::assumed: return "assumed";
  }
  return "assumed";
}

void check_format(const Json& document, const std::string& format, const std::filesystem::path& file) {
  if (!says(document, "format", format)) {
    refuse("format-unknown", GLISSON_TEXT("{0} does not say \"format\": \"{1}\"."), {file.string(), format},
           GLISSON_TEXT("Check that it is the file you meant."));
  }
}

void known_keys(const Json& object, std::initializer_list<std::string_view> known, const std::string& where) {
  if (auto checked = refuse_unknown_keys(object, known, where); !checked) throw Refusal{std::move(checked.error())};
}

void refuse_missing(const char* key, const std::string& where) {
  refuse("key-missing", GLISSON_TEXT("{0} has no \"{1}\", or not of the right kind."), {where, key},
         GLISSON_TEXT("The shipped devices.json shows every key."));
}

double number_under(const Json& object, const char* key, Limits limits, const std::string& where) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) refuse_missing(key, where);
  const double value = found->get<double>();
  if (value >= limits.minimum && value <= limits.maximum) return value;
  refuse("figure-out-of-range", GLISSON_TEXT("{0} has \"{1}\" {2}; it must lie between {3} and {4}."),
         {where, key, fmt::format("{:g}", value), fmt::format("{:g}", limits.minimum),
          fmt::format("{:g}", limits.maximum)});
}

std::string text_under(const Json& object, const char* key, const std::string& where) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string()) refuse_missing(key, where);
  auto value = found->get<std::string>();
  if (!value.empty() && value.size() <= longest_text) return value;
  refuse("text-invalid", GLISSON_TEXT("{0} has \"{1}\" empty or longer than {2} characters."),
         {where, key, std::to_string(longest_text)});
}

Source source_in(const Json& object, const std::string& where) {
  const std::string name = text_under(object, "source", where);
  for (const Source source : {Source::measured, Source::computed, Source::dissertation, Source::assumed}) {
    if (name == to_string(source)) return source;
  }
  refuse("source-unknown", GLISSON_TEXT("{0} has the source \"{1}\"."), {where, name},
         GLISSON_TEXT("A figure is measured, computed, from the dissertation (dissertation), or assumed."));
}

Figure figure_under(const Json& object, const char* key, Limits limits, const std::string& where) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_object()) refuse_missing(key, where);
  const std::string here = where + ", " + key;
  known_keys(*found, {"value", "source", "note"}, here);
  return {number_under(*found, "value", limits, here), source_in(*found, here), text_under(*found, "note", here)};
}

}  // namespace glisson::hardware
