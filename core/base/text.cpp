#include "base/text.h"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace glisson {

std::optional<double> read_number(std::string_view text) {
  double number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::optional<double> read_leading_number(std::string_view text) {
  double number = 0;
  const auto problem = std::from_chars(text.data(), text.data() + text.size(), number).ec;
  if (problem != std::errc() || !std::isfinite(number)) return std::nullopt;
  return number;
}

template <typename Whole>
std::optional<Whole> read_whole_number(std::string_view text) {
  Whole number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

template std::optional<int> read_whole_number(std::string_view);
template std::optional<std::int64_t> read_whole_number(std::string_view);
template std::optional<std::uint64_t> read_whole_number(std::string_view);

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

}  // namespace glisson
