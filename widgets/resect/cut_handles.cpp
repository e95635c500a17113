#include "widgets/resect/cut_handles.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <QKeyEvent>
#include <QMouseEvent>
#include <utility>

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;

constexpr scene::Colour handle_colour{0.20, 0.83, 0.85};
constexpr double end_mm = 45;          // of a line's handles from its middle
constexpr double normal_mm = 45;       // of the normal's tip
constexpr double handle_reach_px = 9;  // how near a hand must come
constexpr double line_reach_px = 6;
constexpr double ball_px = 5;          // in slices
constexpr double ball_mm = 3.5;        // in space
constexpr double shown_within_mm = 5;  // of a slice: its points

Vector3d normal_of(const SliceView& slice) { return slice.view().camera().sight; }

QPointF device(const QWidget& view, const QPointF& position) { return position * view.devicePixelRatioF(); }

// Where the pointer is in the slice.
Vector3d position_in(const SliceView& slice, const QPointF& pixel) {
  const QPointF at = device(slice, pixel);
  const Vector3d in_plane_mm = slice.view().position_in_focal_plane(at.x(), at.y());
  const Vector3d normal = normal_of(slice);
  return in_plane_mm + normal * normal.dot(slice.crosshair_mm() - in_plane_mm);
}

double pixels_between(const RenderWidget& view, const Vector3d& position_mm, const QPointF& pixel) {
  const Eigen::Vector2d seen = view.view().pixel_of(position_mm) / view.devicePixelRatioF();
  return std::hypot(seen.x() - pixel.x(), seen.y() - pixel.y());
}

}  // namespace

CutHandles::CutHandles(LinkedViews& views, QObject* parent) : QObject(parent), views_(views) {
  connect(&views_, &LinkedViews::crosshair_moved, this, &CutHandles::draw_in_slices);
}

void CutHandles::set_active(bool active) {
  if (active == active_) return;
  active_ = active;
  held_ = {};
  chosen_place_.reset();
  if (!active) set_freehand(false);
  std::vector<RenderWidget*> all{&views_.space()};
  all.insert(all.end(), views_.slices().begin(), views_.slices().end());
  for (RenderWidget* view : all) {
    view->setMouseTracking(active);
    active ? view->installEventFilter(this) : view->removeEventFilter(this);
    if (!active) view->unsetCursor();
  }
  if (!active) {
    for (SliceView* slice : views_.slices()) slice->view().set_landmarks({});
  }
  draw_in_slices();
}

void CutHandles::set_plane(const std::optional<CutPlane>& plane) {
  plane_ = plane;
  draw_in_slices();
}

void CutHandles::set_points(const std::vector<Vector3d>& points_mm) {
  points_mm_ = points_mm;
  draw_in_slices();
}

void CutHandles::set_places(const std::vector<ToldPlace>& places) {
  const auto same = [](const ToldPlace& a, const ToldPlace& b) {
    return a.label == b.label && a.position_mm == b.position_mm;
  };
  if (std::equal(places.begin(), places.end(), places_.begin(), places_.end(), same)) return;
  places_ = places;
  chosen_place_.reset();
  if (held_.part == Part::place) held_ = {};
  draw_in_slices();
}

void CutHandles::set_drawing(bool drawing) { drawing_ = drawing; }

void CutHandles::set_freehand(bool freehand) {
  freehand_ = freehand;
  line_begun_ = false;
  line_.clear();
  line_mm_.clear();
  draw_line_in_space();
}

LineInSlice CutHandles::line_in(const SliceView& slice) const {
  return line_in_slice(*plane_, slice.crosshair_mm(), normal_of(slice));
}

Vector3d CutHandles::tip_mm() const { return plane_->point_mm() + normal_mm * plane_->normal(); }

void CutHandles::draw_in_slices() {
  if (!active_) return;
  for (SliceView* slice : views_.slices()) {
    const double radius_mm = ball_px * slice->view().camera().visible_height_mm / std::max(1, slice->height());
    std::vector<scene::LandmarkItem> balls;
    const auto put = [&](const Vector3d& position_mm) { balls.push_back({{}, position_mm, radius_mm, handle_colour}); };
    if (plane_) {
      const LineInSlice line = line_in(*slice);
      if (line.along.norm() > 0) {
        for (const double along_mm : {-end_mm, end_mm}) put(line.at_mm + along_mm * line.along);
      }
    }
    for (const Vector3d& point : points_mm_) {
      const double off_mm = normal_of(*slice).dot(point - slice->crosshair_mm());
      if (std::abs(off_mm) < shown_within_mm) put(point - off_mm * normal_of(*slice));
    }
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const double off_mm = normal_of(*slice).dot(places_[k].position_mm - slice->crosshair_mm());
      if (std::abs(off_mm) >= shown_within_mm) continue;
      const double wide_mm = (k == chosen_place_ ? 1.4 : 1.0) * radius_mm;
      balls.push_back(
          {places_[k].label, places_[k].position_mm - off_mm * normal_of(*slice), wide_mm, places_[k].colour});
    }
    slice->view().set_landmarks(balls);
    slice->redraw();
  }
}

std::vector<scene::LandmarkItem> CutHandles::marks_in_space() const {
  std::vector<scene::LandmarkItem> marks;
  if (plane_) {
    marks.push_back({{}, plane_->point_mm(), ball_mm, handle_colour});
    marks.push_back({{}, tip_mm(), ball_mm, handle_colour});
  }
  for (const Vector3d& point : points_mm_) marks.push_back({{}, point, ball_mm, handle_colour});
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const double wide_mm = (k == chosen_place_ ? 1.2 : 0.8) * ball_mm;
    marks.push_back({places_[k].label, places_[k].position_mm, wide_mm, places_[k].colour});
  }
  return marks;
}

std::vector<scene::ArrowItem> CutHandles::arrows_in_space() const {
  if (!plane_) return {};
  return {{plane_->point_mm(), tip_mm(), 1.6, handle_colour, {}}};
}

bool CutHandles::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  if (type == QEvent::KeyPress) return key_event(static_cast<const QKeyEvent&>(*event));
  if (type != QEvent::MouseButtonPress && type != QEvent::MouseMove && type != QEvent::MouseButtonRelease) return false;
  auto& mouse = static_cast<QMouseEvent&>(*event);
  if (watched == &views_.space()) return space_event(mouse);
  for (SliceView* slice : views_.slices()) {
    if (watched == slice) return slice_event(*slice, mouse);
  }
  return false;
}

bool CutHandles::key_event(const QKeyEvent& event) {
  const bool deletes = event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace;
  if (!deletes || !chosen_place_) return false;
  Q_EMIT place_given_up(*chosen_place_);
  return true;
}

void CutHandles::take_hold(const Fixed& held) {
  held_ = held;
  const auto before = chosen_place_;
  chosen_place_ = held.part == Part::place ? std::optional(held.point) : std::nullopt;
  place_moved_ = false;
  if (chosen_place_ == before) return;
  draw_in_slices();
  Q_EMIT place_dragged();
}

void CutHandles::drag_place(const Vector3d& to_mm) {
  place_moved_ = true;
  places_[held_.point].position_mm = to_mm;
  draw_in_slices();
  Q_EMIT place_dragged();
}

void CutHandles::end_drag() {
  const Fixed held = std::exchange(held_, {});
  if (held.part != Part::place) {
    Q_EMIT let_go();
  } else if (place_moved_) {
    Q_EMIT place_let_go(held.point, places_[held.point].position_mm);
  }
}

bool CutHandles::slice_event(SliceView& slice, QMouseEvent& event) {
  if (event.type() == QEvent::MouseMove && event.buttons() == Qt::NoButton) {
    const bool something = under(slice, event.position()).part != Part::none;
    slice.setCursor(drawing_ ? Qt::CrossCursor : something ? Qt::SizeAllCursor : Qt::ArrowCursor);
    return false;
  }
  if (event.type() == QEvent::MouseButtonPress) {
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
    take_hold(under(slice, event.position()));
    if (held_.part == Part::none && drawing_) {
      Q_EMIT point_clicked(position_in(slice, event.position()));
      return true;
    }
    held_.from_mm = position_in(slice, event.position());
    if (plane_) held_.pivot_mm = line_in(slice).at_mm;
    return held_.part != Part::none;
  }
  if (held_.part == Part::none) return false;
  if (event.type() == QEvent::MouseButtonRelease) {
    end_drag();
  } else {
    drag_in_slice(slice, position_in(slice, event.position()));
  }
  return true;
}

CutHandles::Fixed CutHandles::under(const SliceView& slice, const QPointF& pixel) const {
  for (std::size_t k = 0; k < points_mm_.size(); ++k) {
    const double off_mm = normal_of(slice).dot(points_mm_[k] - slice.crosshair_mm());
    if (std::abs(off_mm) < shown_within_mm && pixels_between(slice, points_mm_[k], pixel) < handle_reach_px) {
      return {Part::point, k, {}, {}};
    }
  }
  for (std::size_t k = 0; k < places_.size() && !drawing_; ++k) {
    const double off_mm = normal_of(slice).dot(places_[k].position_mm - slice.crosshair_mm());
    if (std::abs(off_mm) < shown_within_mm && pixels_between(slice, places_[k].position_mm, pixel) < handle_reach_px) {
      return {Part::place, k, {}, {}};
    }
  }
  if (!plane_) return {};
  const LineInSlice line = line_in(slice);
  if (line.along.norm() == 0) return {};
  if (pixels_between(slice, line.at_mm + end_mm * line.along, pixel) < handle_reach_px)
    return {Part::far_end, 0, {}, {}};
  if (pixels_between(slice, line.at_mm - end_mm * line.along, pixel) < handle_reach_px)
    return {Part::near_end, 0, {}, {}};
  const Vector3d from_line_mm = position_in(slice, pixel) - line.at_mm;
  const Vector3d on_line_mm = line.at_mm + line.along * line.along.dot(from_line_mm);
  return pixels_between(slice, on_line_mm, pixel) < line_reach_px ? Fixed{Part::line, 0, {}, {}} : Fixed{};
}

void CutHandles::drag_in_slice(const SliceView& slice, const Vector3d& to_mm) {
  if (held_.part == Part::point) {
    Q_EMIT point_moved(held_.point, to_mm);
    return;
  }
  if (held_.part == Part::place) return drag_place(to_mm);
  if (!plane_) return;
  CutPlane plane = *plane_;
  if (held_.part == Part::line) {
    plane.shift_mm += plane.normal().dot(to_mm - held_.from_mm);
  } else {
    // Turned about the line's middle until its end lies under the hand; the slice's normal is the axis.
    const Vector3d along = line_in(slice).along;
    const Vector3d towards = (held_.part == Part::far_end ? 1.0 : -1.0) * (to_mm - held_.pivot_mm);
    if (along.norm() == 0 || towards.norm() < 1) return;
    plane.put(held_.pivot_mm, Eigen::Quaterniond::FromTwoVectors(along, towards) * plane.normal());
  }
  held_.from_mm = to_mm;
  Q_EMIT plane_moved(plane);
}

bool CutHandles::space_event(QMouseEvent& event) {
  SpaceView& space = views_.space();
  if (freehand_) return freehand_event(event);
  const QPointF at = device(space, event.position());
  if (event.type() == QEvent::MouseMove && event.buttons() == Qt::NoButton) {
    const bool something = under_in_space(event.position()).part != Part::none;
    space.setCursor(drawing_ ? Qt::CrossCursor : something ? Qt::SizeAllCursor : Qt::ArrowCursor);
    return false;
  }
  if (event.type() == QEvent::MouseButtonPress) {
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
    take_hold(under_in_space(event.position()));
    held_.from_mm = space.view().position_in_focal_plane(at.x(), at.y());
    return held_.part != Part::none;
  }
  if (held_.part == Part::none) return false;
  if (event.type() == QEvent::MouseButtonRelease) {
    end_drag();
  } else if (held_.part == Part::place) {
    drag_place(space.view().position_beside(places_[held_.point].position_mm, at.x(), at.y()));  // as deep as it was
  } else if (held_.part == Part::point) {
    // On whatever is seen there, as it was set.
    if (const auto pick = space.view().pick(at.x(), at.y())) Q_EMIT point_moved(held_.point, pick->position_mm);
  } else {
    drag_in_space(space.view().position_in_focal_plane(at.x(), at.y()));
  }
  return true;
}

bool CutHandles::freehand_event(QMouseEvent& event) {
  SpaceView& space = views_.space();
  space.setCursor(Qt::CrossCursor);
  if (event.type() == QEvent::MouseButtonPress) {
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
    line_begun_ = true;
  }
  if (!line_begun_) return false;
  const QPointF at = device(space, event.position());
  const scene::View& view = space.view();
  const Vector3d through_mm = view.position_in_focal_plane(at.x(), at.y());
  constexpr double deeper_mm = 100;
  const Vector3d below_mm = view.position_beside(through_mm + deeper_mm * view.camera().sight, at.x(), at.y());
  line_.push_back({through_mm, below_mm - through_mm});
  constexpr double lifted_mm = 1.5;  // off the surface, which would hide it
  if (const auto pick = view.pick(at.x(), at.y())) line_mm_.push_back(pick->position_mm + lifted_mm * pick->normal);
  if (event.type() == QEvent::MouseButtonRelease) {
    const std::vector<planning::SightLine> line = line_;
    set_freehand(true);
    Q_EMIT line_drawn(line);
  } else {
    draw_line_in_space();
  }
  return true;
}

void CutHandles::draw_line_in_space() {
  std::vector<scene::DrawnLines> lines;
  if (line_mm_.size() > 1) {
    scene::DrawnLines& line = lines.emplace_back(scene::DrawnLines{{}, handle_colour, 3});
    for (std::size_t p = 1; p < line_mm_.size(); ++p) {
      line.ends_mm.insert(line.ends_mm.end(), {line_mm_[p - 1], line_mm_[p]});
    }
  }
  views_.space().view().set_drawn_lines(lines);
  views_.space().redraw();
}

CutHandles::Fixed CutHandles::under_in_space(const QPointF& pixel) const {
  const SpaceView& space = views_.space();
  for (std::size_t k = 0; k < points_mm_.size(); ++k) {
    if (pixels_between(space, points_mm_[k], pixel) < handle_reach_px) return {Part::point, k, {}, {}};
  }
  for (std::size_t k = 0; k < places_.size() && !drawing_; ++k) {
    if (pixels_between(space, places_[k].position_mm, pixel) < handle_reach_px) return {Part::place, k, {}, {}};
  }
  if (!plane_) return {};
  if (pixels_between(space, tip_mm(), pixel) < 1.5 * handle_reach_px) return {Part::tip, 0, {}, {}};
  if (pixels_between(space, plane_->point_mm(), pixel) < 1.5 * handle_reach_px) return {Part::middle, 0, {}, {}};
  return {};
}

// The hand moves in a plane across the line of sight.
void CutHandles::drag_in_space(const Vector3d& to_mm) {
  if (!plane_) return;
  CutPlane plane = *plane_;
  const Vector3d moved_mm = to_mm - held_.from_mm;
  const Vector3d normal = plane.normal();
  if (held_.part == Part::tip) {
    const Vector3d towards = tip_mm() + moved_mm - plane.point_mm();
    if (towards.norm() < 1) return;
    plane.put(plane.point_mm(), towards);
  } else {
    // Along the normal as it is seen; seen end-on it cannot be followed.
    const Vector3d sight = views_.space().view().camera().sight;
    const double foreshortened = 1 - std::pow(normal.dot(sight), 2);
    if (foreshortened < 0.02) return;
    plane.shift_mm += normal.dot(moved_mm) / foreshortened;
  }
  held_.from_mm = to_mm;
  Q_EMIT plane_moved(plane);
}

}  // namespace glisson::widgets
