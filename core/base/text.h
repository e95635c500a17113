#pragma once
// What somebody typed, as numbers and in lower case: numbers with a dot and letters of ASCII, whatever the locale.

#include <optional>
#include <string>
#include <string_view>

namespace glisson {

// The whole text is one finite number; a sign of plus, blanks and what follows are not.
[[nodiscard]] std::optional<double> read_number(std::string_view text);
// The finite number that the text begins with.
[[nodiscard]] std::optional<double> read_leading_number(std::string_view text);
// The whole text is one whole number that fits. For int, std::int64_t and std::uint64_t.
template <typename Whole>
[[nodiscard]] std::optional<Whole> read_whole_number(std::string_view text);

[[nodiscard]] std::string in_lower_case(std::string_view text);

}  // namespace glisson
