#pragma once
// The mouse in a picture, by places of the patient (LPS, mm): where a place is seen, and a drag from one to another.

#include <QtTest>

#include "widgets/views/render_widget.h"

namespace glisson::widgets {

[[nodiscard]] inline QPoint pixel_in(const RenderWidget& view, const Eigen::Vector3d& position_mm) {
  const Eigen::Vector2d at = view.view().pixel_of(position_mm) / view.devicePixelRatioF();
  return QPointF(at.x(), at.y()).toPoint();
}

inline void drag_in(RenderWidget& view, const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm) {
  const QPoint from = pixel_in(view, from_mm), to = pixel_in(view, to_mm);
  QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
  for (int step = 1; step <= 5; ++step) QTest::mouseMove(&view, from + (to - from) * step / 5);
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, to);
}

}  // namespace glisson::widgets
