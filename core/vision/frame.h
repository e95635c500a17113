#pragma once
// One picture of a video, and where pictures come from: a picture file, a folder of them, or a video file.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"

namespace glisson::vision {

// 8-bit red, green, blue; rows from the top, no padding.
struct Frame {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  // rgb[3 * (x + width * y) + channel]

  [[nodiscard]] std::uint8_t* at(int x, int y) {
    return &rgb[3 * (static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(y))];
  }
  [[nodiscard]] const std::uint8_t* at(int x, int y) const { return const_cast<Frame*>(this)->at(x, y); }
};

// PNG, JPEG, TIFF, BMP, PNM. Failure: "image-not-readable".
Result<Frame> read_frame(const std::filesystem::path& file);

// By the extension; the whole file or nothing. Failure: "image-not-written".
Result<void> write_frame(const Frame& frame, const std::filesystem::path& file);

// The pictures of a video one after another.
class FrameSource {
 public:
  // A folder's pictures are taken in the order of their names, numbers in them by value (f2 before f10). Failures:
  // "video-not-readable", "video-no-frames" (a folder without pictures).
  static Result<FrameSource> open(const std::filesystem::path& video_or_folder);

  FrameSource(FrameSource&&) noexcept;
  FrameSource& operator=(FrameSource&&) noexcept;
  ~FrameSource();

  // The next picture, or nothing at the end. Failures: those of read_frame; "video-frame-sizes" (a picture of another
  // size than the first).
  Result<std::optional<Frame>> next();

  // How many there are; nothing where a video file does not say.
  [[nodiscard]] std::optional<int> count() const;

 private:
  struct Inside;
  explicit FrameSource(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace glisson::vision
