#include "widgets/rehearse/marked_slider.h"

#include <cmath>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>

#include "widgets/theme.h"

namespace glisson::widgets {

void MarkedSlider::set_mark(std::optional<double> value) {
  if (mark_ == value) return;
  mark_ = value;
  update();
}

void MarkedSlider::paintEvent(QPaintEvent* event) {
  QSlider::paintEvent(event);
  if (!mark_ || *mark_ >= maximum()) return;
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect groove = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
  const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
  const int from = groove.left() + handle.width() / 2 +
                   QStyle::sliderPositionFromValue(minimum(), maximum(), static_cast<int>(std::lround(*mark_)),
                                                   groove.width() - handle.width());
  constexpr int thickness = 4;
  QPainter painter(this);
  painter.setClipRegion(QRegion(rect()).subtracted(handle));
  painter.fillRect(QRect(from, groove.center().y() - thickness / 2 + 1, groove.right() - from + 1, thickness),
                   theme_colour("warning"));
}

}  // namespace glisson::widgets
