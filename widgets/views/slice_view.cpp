#include "views/slice_view.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <QMouseEvent>
#include <QWheelEvent>

namespace glisson::widgets {
namespace {

constexpr int wheel_units_per_slice = 120;
constexpr double least_visible_mm = 10;
constexpr double most_visible_mm = 2000;

// The lines carry the colours of the views that they stand for, here and in the views' frames.
const std::array<scene::Colour, 3> axis_colours{scene::Colour{0.93, 0.55, 0.40}, scene::Colour{0.45, 0.80, 0.50},
                                                scene::Colour{0.42, 0.65, 0.98}};

}  // namespace

SliceView::SliceView(SliceDirection direction, QWidget* parent) : RenderWidget(parent), direction_(direction) {
  furniture_.orientation = scene::Furniture::Orientation::letters;
  furniture_.text_scale = 0.9;
}

Eigen::Vector3d SliceView::normal() const {
  switch (direction_) {
    case SliceDirection::transverse: return Eigen::Vector3d::UnitZ();
    case SliceDirection::coronal: return Eigen::Vector3d::UnitY();
    case SliceDirection::sagittal: return Eigen::Vector3d::UnitX();
  }
  return Eigen::Vector3d::UnitZ();
}

void SliceView::show_content(const SliceContent& content) {
  const bool same_volume = content.volume == content_.volume;
  content_ = content;
  scene::Scene scene;
  if (content.volume) {
    scene::SliceItem slice;
    slice.volume = content.volume;
    slice.center_mm = crosshair_mm_;
    slice.normal = normal();
    slice.window_center = content.window_center;
    slice.window_width = content.window_width;
    slice.map = content.map;
    // One legend for the three views is enough.
    if (direction_ == SliceDirection::transverse) slice.legend_title = content.legend_title;
    slice.cuts = content.cuts;
    scene.slices.push_back(std::move(slice));
  }
  scene.furniture = furniture_;
  box_ = scene::bounds(scene);
  if (auto shown = view().show(scene); !shown) return;
  if (!same_volume && !fitted_) fit();
  set_crosshair(crosshair_mm_);
}

void SliceView::set_crosshair(const Eigen::Vector3d& position_mm) {
  const double shift_mm = normal().dot(position_mm - crosshair_mm_);
  crosshair_mm_ = position_mm;
  if (content_.volume) view().move_slice(0, position_mm);
  view().set_crosshair(scene::CrosshairItem{position_mm, axis_colours});
  scene::Camera camera = view().camera();
  camera.focus_mm += shift_mm * normal();
  view().set_camera(camera);
  tell_position();
  redraw();
  Q_EMIT slice_moved();
}

Eigen::Vector3d SliceView::place_at(const QPointF& position) const {
  const QPointF at = device_position(position);
  const Eigen::Vector3d place_mm = view().position_in_focal_plane(at.x(), at.y());
  return place_mm + normal() * normal().dot(crosshair_mm_ - place_mm);
}

void SliceView::set_window(double center, double width) {
  content_.window_center = center;
  content_.window_width = width;
  if (content_.volume) view().set_window(0, center, width);
  redraw();
}

void SliceView::fit() {
  if (!content_.volume) return;
  Eigen::Vector3d center_mm = box_.center_mm();
  center_mm += normal() * normal().dot(crosshair_mm_ - center_mm);
  scene::Camera camera = scene::look_at_slice(center_mm, normal(), 100);
  const Eigen::Vector3d extent_mm = box_.max_mm - box_.min_mm;
  const Eigen::Vector3d right = camera.sight.cross(camera.up).cwiseAbs();
  const double aspect = static_cast<double>(std::max(1, width())) / std::max(1, height());
  camera.visible_height_mm =
      std::max(1.03 * std::max(extent_mm.dot(camera.up.cwiseAbs()), extent_mm.dot(right) / aspect), least_visible_mm);
  view().set_camera(camera);
  redraw();
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  last_ = event->position();
  if (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ShiftModifier) == 0) point_at(event->position());
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return;
  const QPointF moved = event->position() - last_;
  last_ = event->position();
  const bool shifts = (event->buttons() & Qt::MiddleButton) != 0 || (event->modifiers() & Qt::ShiftModifier) != 0;
  if (shifts) {
    fitted_ = true;  // the person's own framing is kept from here on
    view().set_camera(scene::shifted(view().camera(), moved.x() * mm_per_pixel(), -moved.y() * mm_per_pixel()));
    redraw();
  } else if ((event->buttons() & Qt::RightButton) != 0) {
    const double width = std::max(content_.window_width * std::exp(0.006 * moved.x()), 1e-6);
    const double center = content_.window_center + 0.004 * width * moved.y();
    set_window(center, width);
    Q_EMIT window_changed(center, width);
  } else if ((event->buttons() & Qt::LeftButton) != 0) {
    point_at(event->position());
  }
}

void SliceView::wheelEvent(QWheelEvent* event) {
  const int units = event->angleDelta().y();
  if ((event->modifiers() & Qt::ControlModifier) != 0) {
    scene::Camera camera = view().camera();
    camera.visible_height_mm =
        std::clamp(camera.visible_height_mm * std::pow(0.999, units), least_visible_mm, most_visible_mm);
    view().set_camera(camera);
    fitted_ = true;
    redraw();
    return;
  }
  step(units / wheel_units_per_slice != 0 ? units / wheel_units_per_slice : (units > 0 ? 1 : -1));
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up: step(1); break;
    case Qt::Key_Down: step(-1); break;
    case Qt::Key_PageUp: step(5); break;
    case Qt::Key_PageDown: step(-5); break;
    default: RenderWidget::keyPressEvent(event);
  }
}

void SliceView::resizeEvent(QResizeEvent* event) {
  RenderWidget::resizeEvent(event);
  if (!fitted_) fit();
}

void SliceView::point_at(const QPointF& position) {
  if (!content_.volume) return;
  const Eigen::Vector3d target_mm = place_at(position).cwiseMax(box_.min_mm).cwiseMin(box_.max_mm);
  set_crosshair(target_mm);
  Q_EMIT crosshair_moved(target_mm);
}

// By the volume's own slice distance along this view's normal.
void SliceView::step(int slices) {
  if (!content_.volume) return;
  const imaging::Grid& grid = content_.volume->grid;
  Eigen::Index axis = 0;
  (grid.direction.transpose() * normal()).cwiseAbs().maxCoeff(&axis);
  const Eigen::Vector3d target_mm =
      (crosshair_mm_ + slices * grid.spacing_mm[axis] * normal()).cwiseMax(box_.min_mm).cwiseMin(box_.max_mm);
  set_crosshair(target_mm);
  Q_EMIT crosshair_moved(target_mm);
}

// "L 12.4 mm": how far the slice stands from the scanner's centre, in the patient's directions.
void SliceView::tell_position() {
  constexpr std::array<const char*, 3> towards{"L", "P", "H"};
  constexpr std::array<const char*, 3> away{"R", "A", "F"};
  Eigen::Index axis = 0;
  normal().maxCoeff(&axis);
  const double along_mm = crosshair_mm_[axis];
  const auto k = static_cast<std::size_t>(axis);
  furniture_.subtitle = content_.volume ? QString("%1 %2 mm")
                                              .arg(along_mm >= 0 ? towards[k] : away[k])
                                              .arg(std::abs(along_mm), 0, 'f', 1)
                                              .toStdString()
                                        : "";
  view().set_furniture(furniture_);
}

}  // namespace glisson::widgets
