#include "widgets/views/space_view.h"

#include <algorithm>
#include <cmath>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

namespace glisson::widgets {
namespace {

constexpr double degrees_per_pixel = 0.4;
constexpr double click_slack_px = 4;
constexpr double grip_reach_px = 14;
constexpr double slow_frame_ms = 16;  // drawing takes half of a thirtieth of a second; the other half is the window's
constexpr int calm_after_ms = 250;
// From the whole body down to a small vessel.
constexpr double minimum_visible_mm = 5;
constexpr double maximum_visible_mm = 3000;

}  // namespace

SpaceView::SpaceView(QWidget* parent) : RenderWidget(parent) {
  setObjectName("space_view");
  calm_.setSingleShot(true);
  calm_.setInterval(calm_after_ms);
  connect(this, &RenderWidget::frame_drawn, this, [this] {
    if (!coarse_) full_frame_ms_ = last_frame_ms();
  });
  connect(&calm_, &QTimer::timeout, this, [this] {
    draw_finely();
    redraw();
  });
}

// While something moves, pictures come often rather than fine, where a fine one takes too long.
void SpaceView::hurry() {
  if (!coarse_ && full_frame_ms_ > slow_frame_ms) {
    coarse_ = true;
    view().set_detail(scene::Detail::coarse);
  }
  if (coarse_) calm_.start();
}

void SpaceView::shape_moved() {
  if (since_moved_.isValid() && since_moved_.elapsed() < calm_after_ms) hurry();
  since_moved_.start();
}

void SpaceView::draw_finely() {
  calm_.stop();
  coarse_ = false;
  view().set_detail(scene::Detail::full);
}

int SpaceView::shrink() const {
  constexpr int many_pixels = 250000;
  return coarse_ && device_width() * device_height() > many_pixels ? 2 : 1;
}

void SpaceView::keyPressEvent(QKeyEvent* event) {
  constexpr double step_deg = 5;
  const auto turn = [this](double right_deg, double up_deg) {
    view().set_camera(scene::turned(view().camera(), right_deg, up_deg));
    camera_moved_by_hand();
  };
  switch (event->key()) {
    case Qt::Key_Left: turn(-step_deg, 0); break;
    case Qt::Key_Right: turn(step_deg, 0); break;
    case Qt::Key_Up: turn(0, step_deg); break;
    case Qt::Key_Down: turn(0, -step_deg); break;
    case Qt::Key_Plus:
    case Qt::Key_Minus:
      zoom(event->key() == Qt::Key_Plus ? 0.9 : 1 / 0.9);
      camera_moved_by_hand();
      break;
    case Qt::Key_Home: frame_all(); break;
    default: RenderWidget::keyPressEvent(event);
  }
}

void SpaceView::follow(const scene::Camera& camera) {
  keeps_all_in_view_ = false;
  view().set_camera(camera);
  hurry();
  redraw();
}

void SpaceView::set_grips(const std::optional<Grips>& grips) { grips_ = grips; }

SpaceView::Grip SpaceView::grip_at(const QPointF& position) const {
  if (!grips_) return Grip::none;
  const QPointF at = device_position(position);
  const auto away_px = [&](const Eigen::Vector3d& place_mm) {
    return (view().pixel_of(place_mm) - Eigen::Vector2d(at.x(), at.y())).norm() / devicePixelRatioF();
  };
  const double from_touch = away_px(grips_->touch_mm);
  const double from_free_end = away_px(grips_->free_end_mm);
  if (std::min(from_touch, from_free_end) > grip_reach_px) return Grip::none;
  return from_touch <= from_free_end ? Grip::touch : Grip::free_end;
}

void SpaceView::drag_grip(const QPointF& position) {
  const QPointF at = device_position(position);
  if (held_ == Grip::touch) {
    if (const auto pick = view().pick(at.x(), at.y())) Q_EMIT touch_dragged(*pick);
  } else {
    Q_EMIT free_end_dragged(view().position_beside(at_press_.free_end_mm, at.x(), at.y()), at_press_.touch_mm);
  }
}

void SpaceView::look_from(scene::PatientView side) {
  view().set_camera(scene::fit(scene_, side, static_cast<double>(std::max(1, width())) / std::max(1, height())));
  redraw();
  Q_EMIT camera_changed();
}

void SpaceView::show_scene(const scene::Scene& scene) {
  const bool held_nothing = scene_.surfaces.empty();
  scene_ = scene;
  if (auto shown = view().show(scene); !shown) return;
  // Nothing was there to be framed when it was asked for.
  if (keeps_all_in_view_ && held_nothing && !scene_.surfaces.empty()) look_from(scene::PatientView::surgeon);
  if (coarse_) view().set_detail(scene::Detail::coarse);
  redraw();
}

void SpaceView::frame_all() {
  keeps_all_in_view_ = true;
  look_from(scene::PatientView::surgeon);
}

void SpaceView::resizeEvent(QResizeEvent* event) {
  RenderWidget::resizeEvent(event);
  if (keeps_all_in_view_) {
    look_from(scene::PatientView::surgeon);
    return;
  }
  // As much is in view as was, across the shorter side.
  const auto shorter_share = [](const QSize& size) {
    return std::min(1.0, static_cast<double>(std::max(1, size.width())) / std::max(1, size.height()));
  };
  if (!event->oldSize().isValid() || follows_) return;
  zoom(shorter_share(event->oldSize()) / shorter_share(event->size()));
  Q_EMIT camera_changed();
}

void SpaceView::camera_moved_by_hand() {
  keeps_all_in_view_ = false;
  hurry();
  redraw();
  Q_EMIT camera_changed();
}

void SpaceView::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = last_ = event->position();
  dragged_ = false;
  held_ = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier ? grip_at(event->position())
                                                                                    : Grip::none;
  if (grips_) at_press_ = *grips_;
}

void SpaceView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) {
    if (grips_) {
      if (grip_at(event->position()) != Grip::none) {
        setCursor(Qt::PointingHandCursor);
      } else if (cursor().shape() == Qt::PointingHandCursor) {
        unsetCursor();
      }
    }
    return;
  }
  const QPointF moved = event->position() - last_;
  if ((event->position() - pressed_at_).manhattanLength() < click_slack_px && !dragged_) return;
  dragged_ = true;
  last_ = event->position();
  if (held_ != Grip::none) {
    drag_grip(event->position());
    return;
  }
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
  if (held_ != Grip::none) {
    held_ = Grip::none;
    if (dragged_) Q_EMIT grip_released();
  }
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
  camera.visible_height_mm = std::clamp(camera.visible_height_mm * factor, minimum_visible_mm, maximum_visible_mm);
  view().set_camera(camera);
}

}  // namespace glisson::widgets
