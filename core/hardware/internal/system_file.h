#pragma once
// The kernel's small files: one line each, that may go away, hold nonsense, or be forbidden.

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "base/text.h"

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
  return line ? read_leading_number(*line) : std::nullopt;
}

// It is there, but this person may not open it.
inline bool is_forbidden(const std::filesystem::path& file) {
  std::error_code problem;
  return std::filesystem::exists(file, problem) && !std::ifstream(file).is_open();
}

}  // namespace glisson::hardware
