#pragma once
// The pictures of a video's frames: read when they are asked for, and kept while there is room.

#include <Eigen/Core>
#include <filesystem>
#include <QCache>
#include <QImage>

#include "base/result.h"

namespace glisson::widgets {

class FrameImages {
 public:
  // Null where the frame has no picture, which an empty path says. Failure: that of vision::read_frame.
  Result<QImage> image(int frame, const std::filesystem::path& file);
  void clear() { images_.clear(); }  // for another video

 private:
  QCache<int, QImage> images_{256 << 10};  // kB
};

// How large the pictures of a camera of that matrix are, where none is there to tell: its middle is theirs.
[[nodiscard]] QSize picture_size(const Eigen::Matrix3d& camera_matrix);

}  // namespace glisson::widgets
