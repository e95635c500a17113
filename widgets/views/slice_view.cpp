#include "widgets/views/slice_view.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <QMouseEvent>
#include <QWheelEvent>

namespace glisson::widgets {
namespace {

constexpr int wheel_units_per_slice = 120;
constexpr double roll_step_deg = 5;
constexpr double minimum_slice_mm = 10;
constexpr double maximum_slice_mm = 2000;

// The lines carry the colours of the views that they stand for, here and in the views' frames.
const std::array<scene::Colour, 3> axis_colours{scene::Colour{0.93, 0.55, 0.40}, scene::Colour{0.45, 0.80, 0.50},
                                                scene::Colour{0.42, 0.65, 0.98}};

}  // namespace

SliceView::SliceView(SliceDirection direction, QWidget* parent) : RenderWidget(parent), direction_(direction) {
  annotations_.orientation = scene::Annotations::Orientation::letters;
  annotations_.text_scale = 0.9;
}

Eigen::Vector3d SliceView::normal() const {
  switch (direction_) {
    case SliceDirection::transverse: return axes_.col(2);
    case SliceDirection::coronal: return axes_.col(1);
    case SliceDirection::sagittal: return axes_.col(0);
  }
  return axes_.col(2);
}

// Where the reader looks from when nothing is turned, taken along with the axes.
scene::Camera SliceView::straight_camera() const {
  scene::Camera camera = scene::look_at_slice({0, 0, 0}, axes_.transpose() * normal(), 100);
  camera.sight = axes_ * camera.sight;
  camera.up = axes_ * camera.up;
  return camera;
}

// The crosshair stays where it is in the picture.
void SliceView::aim() {
  scene::Camera camera = view().camera();
  const Eigen::Vector3d from_focus_mm = crosshair_mm_ - camera.focus_mm;
  const double right_mm = from_focus_mm.dot(camera.sight.cross(camera.up));
  const double up_mm = from_focus_mm.dot(camera.up);
  const scene::Camera straight = straight_camera();
  camera.sight = straight.sight;
  camera.up = Eigen::AngleAxisd(-roll_deg_ * std::numbers::pi / 180, camera.sight) * straight.up;
  camera.focus_mm = crosshair_mm_ - right_mm * camera.sight.cross(camera.up) - up_mm * camera.up;
  view().set_camera(camera);
}

void SliceView::set_axes(const Eigen::Matrix3d& axes) {
  axes_ = axes;
  if (!content_.volume) return;
  view().turn_slice(0, normal());
  aim();
  set_crosshair(crosshair_mm_);
}

void SliceView::set_roll_deg(double roll_deg) {
  roll_deg_ = std::remainder(roll_deg, 360);
  if (!content_.volume) return;
  aim();
  set_crosshair(crosshair_mm_);
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
    slice.window_center = content_.window_center;
    slice.window_width = content_.window_width;
    slice.map = content.map;
    // One legend for the three views is enough.
    if (direction_ == SliceDirection::transverse) slice.legend_title = content.legend_title;
    slice.cuts = content.cuts;
    scene.slices.push_back(std::move(slice));
  }
  scene.annotations = annotations_;
  box_ = scene::bounds(scene);
  if (auto shown = view().show(scene); !shown) return;
  if (!same_volume && !fitted_) fit();
  set_crosshair(crosshair_mm_);
}

void SliceView::set_crosshair(const Eigen::Vector3d& position_mm) {
  const double shift_mm = normal().dot(position_mm - crosshair_mm_);
  crosshair_mm_ = position_mm;
  if (content_.volume) view().move_slice(0, position_mm);
  scene::Camera camera = view().camera();
  camera.focus_mm += shift_mm * normal();
  view().set_camera(camera);
  show_crosshair();
  tell_position();
  redraw();
  Q_EMIT slice_moved();
}

Eigen::Vector3d SliceView::place_at(const QPointF& position) const {
  const QPointF at = device_position(position);
  const Eigen::Vector3d place_mm = view().position_in_focal_plane(at.x(), at.y());
  return place_mm + normal() * normal().dot(crosshair_mm_ - place_mm);
}

void SliceView::show_crosshair() {
  view().set_crosshair(
      scene::CrosshairItem{crosshair_mm_, axis_colours, axes_, hovered_ ? knob_reach_px() * devicePixelRatioF() : 0});
}

double SliceView::knob_reach_px() const { return 0.34 * std::min(width(), height()); }

bool SliceView::on_knob(const QPointF& position) const {
  if (!content_.volume) return false;
  constexpr double reach_px = 9;
  const Eigen::Vector2d center = view().pixel_of(crosshair_mm_) / devicePixelRatioF();
  const Eigen::Vector2d away = Eigen::Vector2d(position.x(), position.y()) - center;
  const scene::Camera& camera = view().camera();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Vector3d along = axes_.col(k).cross(camera.sight);
    if (along.norm() < 0.5) continue;
    Eigen::Vector2d way(along.dot(camera.sight.cross(camera.up)), -along.dot(camera.up));
    way *= knob_reach_px() / way.norm();
    if (std::min((away - way).norm(), (away + way).norm()) <= reach_px) return true;
  }
  return false;
}

// Clockwise, as the widget's y goes down.
double SliceView::angle_about_crosshair_rad(const QPointF& position) const {
  const Eigen::Vector2d center = view().pixel_of(crosshair_mm_) / devicePixelRatioF();
  return std::atan2(position.y() - center.y(), position.x() - center.x());
}

void SliceView::enterEvent(QEnterEvent* event) {
  RenderWidget::enterEvent(event);
  hovered_ = true;
  show_crosshair();
  redraw();
}

void SliceView::leaveEvent(QEvent* event) {
  RenderWidget::leaveEvent(event);
  hovered_ = false;
  show_crosshair();
  redraw();
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
  scene::Camera camera = straight_camera();
  camera.up = Eigen::AngleAxisd(-roll_deg_ * std::numbers::pi / 180, camera.sight) * camera.up;
  camera.focus_mm = center_mm;
  const Eigen::Vector3d extent_mm = box_.max_mm - box_.min_mm;
  const Eigen::Vector3d right = camera.sight.cross(camera.up).cwiseAbs();
  const double aspect = static_cast<double>(std::max(1, width())) / std::max(1, height());
  camera.visible_height_mm =
      std::max(1.03 * std::max(extent_mm.dot(camera.up.cwiseAbs()), extent_mm.dot(right) / aspect), minimum_slice_mm);
  view().set_camera(camera);
  redraw();
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  last_ = event->position();
  held_ = Fixed::nothing;
  if (event->button() != Qt::LeftButton || (event->modifiers() & Qt::ShiftModifier) != 0) return;
  if ((event->modifiers() & Qt::ControlModifier) != 0) {
    held_ = Fixed::picture;
  } else if (on_knob(event->position())) {
    held_ = Fixed::knob;
  } else {
    held_ = Fixed::crosshair;
    point_at(event->position());
  }
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) {
    setCursor(on_knob(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    return;
  }
  const QPointF before = last_;
  const QPointF moved = event->position() - before;
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
  } else if (held_ == Fixed::crosshair) {
    point_at(event->position());
  } else if (held_ == Fixed::knob || held_ == Fixed::picture) {
    const double turn_rad = std::remainder(
        angle_about_crosshair_rad(event->position()) - angle_about_crosshair_rad(before), 2 * std::numbers::pi);
    const double turn_deg = turn_rad * 180 / std::numbers::pi;
    if (held_ == Fixed::picture) {
      set_roll_deg(roll_deg_ + turn_deg);
      return;
    }
    // The other two slices turn about this one's line of sight; this picture stays as it is.
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(turn_rad, view().camera().sight).toRotationMatrix() * axes_;
    roll_deg_ = std::remainder(roll_deg_ + turn_deg, 360);
    set_axes(turned);
    Q_EMIT axes_turned(turned);
  }
}

void SliceView::mouseReleaseEvent(QMouseEvent* /*event*/) { held_ = Fixed::nothing; }

void SliceView::wheelEvent(QWheelEvent* event) {
  const int units = event->angleDelta().y();
  if ((event->modifiers() & Qt::ControlModifier) != 0) {
    zoom(std::pow(0.999, units));
    return;
  }
  step(units / wheel_units_per_slice != 0 ? units / wheel_units_per_slice : (units > 0 ? 1 : -1));
}

void SliceView::zoom(double factor) {
  scene::Camera camera = view().camera();
  camera.visible_height_mm = std::clamp(camera.visible_height_mm * factor, minimum_slice_mm, maximum_slice_mm);
  view().set_camera(camera);
  fitted_ = true;
  redraw();
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up: step(1); break;
    case Qt::Key_Down: step(-1); break;
    case Qt::Key_PageUp: step(5); break;
    case Qt::Key_PageDown: step(-5); break;
    case Qt::Key_Plus: zoom(0.9); break;
    case Qt::Key_Minus: zoom(1 / 0.9); break;
    case Qt::Key_BracketLeft: set_roll_deg(roll_deg_ - roll_step_deg); break;
    case Qt::Key_BracketRight: set_roll_deg(roll_deg_ + roll_step_deg); break;
    case Qt::Key_Home:
      fitted_ = false;
      set_roll_deg(0);
      fit();
      break;
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

// "L 12.4 mm": how far the slice stands from the scanner's centre, in the patient's directions; "L 12.4 mm (20°)"
// where it is tilted out of them.
void SliceView::tell_position() {
  constexpr std::array<const char*, 3> towards{"L", "P", "H"};
  constexpr std::array<const char*, 3> away{"R", "A", "F"};
  Eigen::Index axis = 0;
  const double straightness = std::min(1.0, normal().cwiseAbs().maxCoeff(&axis));
  const double tilt_deg = std::acos(straightness) * 180 / std::numbers::pi;
  const double along_mm = crosshair_mm_[axis];
  const auto k = static_cast<std::size_t>(axis);
  annotations_.subtitle = content_.volume ? QString("%1 %2 mm")
                                                .arg(along_mm >= 0 ? towards[k] : away[k])
                                                .arg(std::abs(along_mm), 0, 'f', 1)
                                                .toStdString()
                                          : "";
  if (content_.volume && tilt_deg > 0.5) {
    annotations_.subtitle += QString::fromUtf8(" (%1°)").arg(tilt_deg, 0, 'f', 0).toStdString();
  }
  view().set_annotations(annotations_);
}

}  // namespace glisson::widgets
