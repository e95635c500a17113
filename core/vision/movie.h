#pragma once
// Pictures into a film: an MP4 file, or a folder of numbered PNG pictures.

#include <filesystem>
#include <memory>

#include "base/result.h"
#include "vision/frame.h"

namespace glisson::vision {

class MovieWriter {
 public:
  // NAME.mp4 becomes a video (MPEG-4, without sound); any other name a folder of 00001.png, 00002.png, ...
  // Failure: "movie-not-written" (the folder above it is missing, or the folder itself is there already).
  static Result<MovieWriter> begin(const std::filesystem::path& file, double frames_per_second);

  MovieWriter(MovieWriter&&) noexcept;
  MovieWriter& operator=(MovieWriter&&) noexcept;
  ~MovieWriter();

  // All of the size of the first; a video leaves out the last row and column of an odd size. Failure:
  // "movie-not-written" (no encoder for MPEG-4 here, a full disk, another size).
  Result<void> add(const Frame& frame);

  // Until then there is nothing under that name, and without it nothing stays. Failure: "movie-not-written".
  Result<void> finish();

 private:
  struct Inside;
  explicit MovieWriter(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace glisson::vision
