#include "widgets/guide/guide_film.h"

#include <algorithm>
#include <cmath>
#include <QImage>

#include "vision/movie.h"

namespace glisson::widgets {
namespace {

constexpr int fine_height_px = 720;

QImage picture_of(const FilmedFrame& frame, const vision::Frame* image, const OverlayLook& look) {
  const int scale = std::max(1, static_cast<int>(std::ceil(1.0 * fine_height_px / frame.size_px.height())));
  const QSize size = frame.size_px * scale;
  const int band = std::max(28, size.height() / 24);
  QImage picture(size.width(), size.height() + band, QImage::Format_RGB888);
  picture.fill(Qt::black);
  QPainter painter(&picture);
  const QRect place(QPoint(0, 0), size);
  if (image != nullptr) {
    const QImage seen(image->rgb.data(), image->width, image->height, 3 * image->width, QImage::Format_RGB888);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(place, seen);
  }
  QFont font = painter.font();
  font.setPixelSize(band / 2);
  painter.setFont(font);
  painter.setClipRect(place);
  paint_overlay(painter, QTransform::fromTranslate(0.5, 0.5) * QTransform::fromScale(scale, scale), frame.overlay,
                look);
  painter.setClipping(false);
  painter.setPen(Qt::white);
  painter.drawText(QRect(band / 2, size.height(), size.width() - band, band), Qt::AlignLeft | Qt::AlignVCenter,
                   frame.caption);
  return picture;
}

vision::Frame frame_of_rgb(const QImage& picture) {
  vision::Frame frame{picture.width(), picture.height(), {}};
  for (int y = 0; y < picture.height(); ++y) {
    const uchar* row = picture.constScanLine(y);
    frame.rgb.insert(frame.rgb.end(), row, row + std::ptrdiff_t{3} * picture.width());
  }
  return frame;
}

}  // namespace

Result<void> write_film(const std::filesystem::path& file, const std::vector<FilmedFrame>& frames,
                        const OverlayLook& look, double frames_per_second, const Progress& progress) {
  auto film = vision::MovieWriter::begin(file, frames_per_second);
  if (!film) return failure(film.error());
  for (std::size_t f = 0; f < frames.size(); ++f) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(f) / static_cast<double>(frames.size()), GLISSON_TEXT("Writing the video"));
    std::optional<vision::Frame> image;
    if (!frames[f].image.empty()) {
      auto read = vision::read_frame(frames[f].image);
      if (!read) return failure(read.error());
      image = *std::move(read);
    }
    const QImage picture = picture_of(frames[f], image ? &*image : nullptr, look);
    if (auto added = film->add(frame_of_rgb(picture)); !added) return added;
  }
  return film->finish();
}

}  // namespace glisson::widgets
