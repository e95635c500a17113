#pragma once
// How large an image is, as it is written in every language.

#include <QString>

#include "imaging/image.h"

namespace glisson::widgets {

// "256 × 208 × 70"
[[nodiscard]] inline QString size_words(const imaging::Grid& grid) {
  return QString("%1 × %2 × %3").arg(grid.size[0]).arg(grid.size[1]).arg(grid.size[2]);
}

// "1.6 × 1.6 × 3.3 mm"
[[nodiscard]] inline QString spacing_words(const imaging::Grid& grid) {
  const auto figure = [&](int axis) { return QString::number(grid.spacing_mm[axis], 'g', 3); };
  return QString("%1 × %2 × %3 mm").arg(figure(0), figure(1), figure(2));
}

}  // namespace glisson::widgets
