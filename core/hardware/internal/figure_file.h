#pragma once
// Reading numbers with their sources out of JSON that may hold anything: values in, or a refusal (base/json_reading.h).
// `where` is how the object is called in it: "Device tx2-gpu".

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "base/json_reading.h"
#include "hardware/figure.h"

namespace glisson::hardware {

struct Limits {
  double minimum;
  double maximum;
};

// Refuses a document that does not say this format.
void check_format(const Json& document, const std::string& format, const std::filesystem::path& file);
// Refuses what is no object, and a key that is not known.
void known_keys(const Json& object, std::initializer_list<std::string_view> known, const std::string& where);
[[noreturn]] void refuse_missing(const char* key, const std::string& where);

[[nodiscard]] double number_under(const Json& object, const char* key, Limits limits, const std::string& where);
[[nodiscard]] std::string text_under(const Json& object, const char* key, const std::string& where);
[[nodiscard]] Source source_in(const Json& object, const std::string& where);
[[nodiscard]] Figure figure_under(const Json& object, const char* key, Limits limits, const std::string& where);

}  // namespace glisson::hardware
