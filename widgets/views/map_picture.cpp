#include "widgets/views/map_picture.h"

#include <algorithm>
#include <cmath>
#include <QLocale>
#include <QPainter>

#include "base/result.h"

namespace glisson::widgets {
namespace {

// The side of the patient towards which a direction (LPS) points most: DICOM's letters, the same in every language.
QString side_of(const Eigen::Vector3d& direction) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const bool up = direction[axis] > 0;
  switch (axis) {
    case 0: return up ? "L" : "R";
    case 1: return up ? "P" : "A";
    default: return up ? "H" : "F";
  }
}

}  // namespace

MapPicture::MapPicture(Scale scale, QWidget* parent) : QWidget(parent), scale_(scale) {
  setMinimumSize(200, 240);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MapPicture::set_words(const QString& title, const QString& unit) {
  title_ = title;
  unit_ = unit;
  setAccessibleName(title);
  update();
}

void MapPicture::show_slice(const imaging::Grid& grid, const std::vector<float>& values,
                            const std::vector<std::uint8_t>& shown, double range) {
  GLISSON_ASSERT(values.size() == static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]));
  range_ = range > 0 ? range : 1;
  voxel_mm_ = {grid.spacing_mm[0], grid.spacing_mm[1]};
  sides_ = {side_of(-grid.direction.col(0)), side_of(grid.direction.col(0)), side_of(-grid.direction.col(1)),
            side_of(grid.direction.col(1))};
  image_ = QImage(grid.size[0], grid.size[1], QImage::Format_ARGB32);
  std::size_t v = 0;
  for (int j = 0; j < grid.size[1]; ++j) {
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(j));
    for (int i = 0; i < grid.size[0]; ++i, ++v) {
      const bool empty = !shown.empty() && shown[v] == 0;
      line[i] = empty ? qRgba(0, 0, 0, 0) : colour_of(static_cast<double>(values[v]) / range_);
    }
  }
  update();
}

void MapPicture::look_at(const QRect& part) {
  part_ = part;
  update();
}

QRgb MapPicture::colour_of(double fraction) const {
  scene::Colour colour;
  if (scale_ == Scale::from_zero) {
    colour = scene::colour_at(scene::ColourMap::viridis, fraction);
  } else {
    // Dark at rest, so that crests and troughs stand out of the dark window.
    const double strength = std::min(1.0, std::abs(fraction));
    const scene::Colour crest = fraction > 0 ? scene::Colour{1.0, 0.45, 0.2} : scene::Colour{0.25, 0.6, 1.0};
    constexpr double rest = 0.08;
    colour = {rest + strength * (crest.red - rest), rest + strength * (crest.green - rest),
              rest + strength * (crest.blue - rest)};
  }
  const auto byte = [](double value) { return static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0))); };
  return qRgb(byte(colour.red), byte(colour.green), byte(colour.blue));
}

void MapPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  const int line = fontMetrics().height();
  painter.setPen(palette().color(QPalette::Text));
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.drawText(QRect(10, 6, width() - 20, line), Qt::AlignLeft, title_);
  painter.setFont(font());
  const QRect room(24, line + 14, width() - 48, height() - 3 * line - 44);
  if (image_.isNull() || room.width() < 20 || room.height() < 20) return;

  const QRect part = part_.isNull() ? image_.rect() : part_.intersected(image_.rect());
  const QSizeF size_mm(part.width() * voxel_mm_.width(), part.height() * voxel_mm_.height());
  const QSize size = size_mm.scaled(room.size(), Qt::KeepAspectRatio).toSize();
  const QRect place(QPoint(room.center().x() - size.width() / 2, room.center().y() - size.height() / 2), size);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place, image_, part);
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRect(place.left() - 22, place.top(), 20, place.height()), Qt::AlignRight | Qt::AlignVCenter,
                   sides_[0]);
  painter.drawText(QRect(place.right() + 4, place.top(), 20, place.height()), Qt::AlignLeft | Qt::AlignVCenter,
                   sides_[1]);
  painter.drawText(QRect(place.left(), place.top() - line - 1, place.width(), line), Qt::AlignCenter, sides_[2]);
  painter.drawText(QRect(place.left(), place.bottom() + 2, place.width(), line), Qt::AlignCenter, sides_[3]);

  const QRect bar(24, height() - line - 18, width() - 48, 10);
  for (int x = 0; x < bar.width(); ++x) {
    const double along = static_cast<double>(x) / (bar.width() - 1);
    painter.setPen(QColor(colour_of(scale_ == Scale::from_zero ? along : 2 * along - 1)));
    painter.drawLine(bar.left() + x, bar.top(), bar.left() + x, bar.bottom());
  }
  painter.setPen(palette().color(QPalette::Text));
  const QRect words(bar.left(), bar.bottom() + 3, bar.width(), line);
  const double low = scale_ == Scale::from_zero ? 0 : -range_;
  painter.drawText(words, Qt::AlignLeft, locale().toString(low, 'g', 2));
  painter.drawText(words, Qt::AlignRight, QString("%1 %2").arg(locale().toString(range_, 'g', 2), unit_).trimmed());
}

}  // namespace glisson::widgets
