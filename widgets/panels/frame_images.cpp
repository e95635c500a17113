#include "widgets/panels/frame_images.h"

#include <cmath>

#include "vision/frame.h"

namespace glisson::widgets {

Result<QImage> FrameImages::image(int frame, const std::filesystem::path& file) {
  if (const QImage* known = images_.object(frame)) return *known;
  if (file.empty()) return QImage();
  const auto read = vision::read_frame(file);
  if (!read) return failure(read.error());
  const QImage image =
      QImage(read->rgb.data(), read->width, read->height, 3 * read->width, QImage::Format_RGB888).copy();
  images_.insert(frame, new QImage(image), static_cast<qsizetype>(image.sizeInBytes() >> 10));
  return image;
}

QSize picture_size(const Eigen::Matrix3d& camera_matrix) {
  return {static_cast<int>(std::lround(2 * camera_matrix(0, 2))),
          static_cast<int>(std::lround(2 * camera_matrix(1, 2)))};
}

}  // namespace glisson::widgets
