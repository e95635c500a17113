#pragma once
// The kernel's small files: one line each, that may go away, hold nonsense, or be forbidden.

#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace glisson::hardware {

inline std::optional<std::string> first_line(const std::filesystem::path& file) {
  std::ifstream stream(file);
  char line[256];
  if (!stream.getline(line, sizeof line)) return {};
  return std::string(line);
}

// A finite number at the beginning of the first line.
inline std::optional<double> number_in(const std::filesystem::path& file) {
  const auto line = first_line(file);
  if (!line) return {};
  double number = 0;
  const auto [end, problem] = std::from_chars(line->data(), line->data() + line->size(), number);
  if (problem != std::errc() || number - number != 0) return {};
  return number;
}

// It is there, but this person may not open it.
inline bool is_forbidden(const std::filesystem::path& file) {
  std::error_code problem;
  return std::filesystem::exists(file, problem) && !std::ifstream(file).is_open();
}

}  // namespace glisson::hardware
