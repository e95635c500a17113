#pragma once
// One slice of a quantity, coloured, with its title, scale and the patient's sides.

#include <cstdint>
#include <Eigen/Core>
#include <QImage>
#include <QWidget>
#include <vector>

#include "imaging/image.h"
#include "scene/colour.h"

namespace glisson::widgets {

// How values become colours: from 0 up by one of the maps, or both ways from 0, blue below and red above.
enum class Scale { from_zero, both_ways };

class MapPicture : public QWidget {
  Q_OBJECT

 public:
  explicit MapPicture(Scale scale, QWidget* parent = nullptr);

  void set_words(const QString& title, const QString& unit);

  // One value a voxel of the slice, row after row of the grid; `range` is what the strongest colour stands for. Voxels
  // whose `shown` is 0 are left empty; an empty list shows all.
  void show_slice(const imaging::Grid& grid, const std::vector<float>& values, const std::vector<std::uint8_t>& shown,
                  double range);
  // Shows this part of the slices, in voxels, from now on.
  void look_at(const QRect& part);
  [[nodiscard]] const QImage& image() const { return image_; }

  [[nodiscard]] QSize sizeHint() const override { return {420, 460}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QRgb colour_of(double fraction) const;  // -1 or 0 to 1
  QString title_, unit_;
  Scale scale_;
  QImage image_;
  QRect part_;  // of the slice; a null rectangle: all of it
  QSizeF voxel_mm_{1, 1};
  double range_ = 0;
  std::array<QString, 4> sides_;  // of the patient: left, right, top, bottom of the picture
};

}  // namespace glisson::widgets
