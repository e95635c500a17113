#include "widgets/panels/swatch.h"

#include <QPainter>

namespace glisson::widgets {

QIcon swatch(const scene::Colour& colour) {
  QPixmap pixmap(28, 28);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(QColor::fromRgbF(float(colour.red), float(colour.green), float(colour.blue)));
  painter.setPen(Qt::NoPen);
  painter.drawRoundedRect(4, 4, 20, 20, 5, 5);
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // the colour says what it is: not tinted where the row is chosen
  return icon;
}

}  // namespace glisson::widgets
