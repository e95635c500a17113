#include "views/space_view.h"

#include <algorithm>
#include <cmath>
#include <QMouseEvent>
#include <QWheelEvent>

namespace glisson::widgets {
namespace {

constexpr double degrees_per_pixel = 0.4;
constexpr double click_slack_px = 4;
// From the whole body down to a small vessel.
constexpr double least_visible_mm = 5;
constexpr double most_visible_mm = 3000;

}  // namespace

SpaceView::SpaceView(QWidget* parent) : RenderWidget(parent) { setObjectName("space_view"); }

void SpaceView::look_from(scene::PatientView side) {
  view().set_camera(scene::fit(scene_, side, static_cast<double>(std::max(1, width())) / std::max(1, height())));
  redraw();
  Q_EMIT camera_changed();
}

void SpaceView::show_scene(const scene::Scene& scene) {
  scene_ = scene;
  if (auto shown = view().show(scene); !shown) return;
  redraw();
}

void SpaceView::frame_all() {
  keeps_all_in_view_ = true;
  look_from(scene::PatientView::surgeon);
}

void SpaceView::resizeEvent(QResizeEvent* event) {
  RenderWidget::resizeEvent(event);
  if (keeps_all_in_view_) look_from(scene::PatientView::surgeon);
}

void SpaceView::camera_moved_by_hand() {
  keeps_all_in_view_ = false;
  redraw();
  Q_EMIT camera_changed();
}

void SpaceView::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = last_ = event->position();
  dragged_ = false;
}

void SpaceView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return;
  const QPointF moved = event->position() - last_;
  if ((event->position() - pressed_at_).manhattanLength() < click_slack_px && !dragged_) return;
  dragged_ = true;
  last_ = event->position();
  const bool shifts = (event->buttons() & Qt::MiddleButton) != 0 || (event->modifiers() & Qt::ShiftModifier) != 0;
  if (shifts) {
    view().set_camera(scene::shifted(view().camera(), moved.x() * mm_per_pixel(), -moved.y() * mm_per_pixel()));
  } else if ((event->buttons() & Qt::RightButton) != 0) {
    zoom(std::exp(0.008 * moved.y()));
  } else {
    view().set_camera(scene::turned(view().camera(), moved.x() * degrees_per_pixel, -moved.y() * degrees_per_pixel));
  }
  camera_moved_by_hand();
}

void SpaceView::mouseReleaseEvent(QMouseEvent* event) {
  if (dragged_ || event->button() != Qt::LeftButton) return;
  const QPointF at = device_position(event->position());
  if (const auto pick = view().pick(at.x(), at.y())) Q_EMIT clicked(*pick);
}

void SpaceView::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(0.999, event->angleDelta().y()));
  camera_moved_by_hand();
}

void SpaceView::zoom(double factor) {
  scene::Camera camera = view().camera();
  camera.visible_height_mm = std::clamp(camera.visible_height_mm * factor, least_visible_mm, most_visible_mm);
  view().set_camera(camera);
}

}  // namespace glisson::widgets
