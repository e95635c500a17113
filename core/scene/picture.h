#pragma once
// A drawn picture: 8-bit red, green, blue, rows from the top, no padding.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/result.h"

namespace glisson::scene {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  // rgb[3 * (x + width * y) + channel]

  [[nodiscard]] const std::uint8_t* at(int x, int y) const {
    return &rgb[3 * (static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(y))];
  }
};

// The whole file or nothing (base/files.h). Fails where the folder cannot be written ("picture-not-written").
Result<void> write_png(const Picture& picture, const std::filesystem::path& file);

// Refuses what is no PNG, is cut short, or is larger than 16384 pixels a side ("picture-unreadable").
Result<Picture> read_png(const std::filesystem::path& file);

}  // namespace glisson::scene
