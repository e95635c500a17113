#pragma once
// The frames of a video with their outlines, written as a film.

#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "widgets/guide/overlay_painter.h"

namespace glisson::widgets {

struct FilmedFrame {
  std::filesystem::path image;  // empty: black, of that size
  QSize size_px;
  OverlayPicture overlay;
  QString caption;  // on a band below the picture
};

// Long work, on any thread. Small frames are drawn larger, so that lines and words are fine. Failures: those of reading
// the images and of vision::MovieWriter; "cancelled", which leaves nothing behind.
Result<void> write_film(const std::filesystem::path& file, const std::vector<FilmedFrame>& frames,
                        const OverlayLook& look, double frames_per_second, const Progress& progress);

}  // namespace glisson::widgets
