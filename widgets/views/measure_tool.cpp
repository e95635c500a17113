#include "widgets/views/measure_tool.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace glisson::widgets {
namespace {

constexpr double reach_mm = 2.5;  // off a slice, up to which a measurement is drawn in it
constexpr double point_reach_px = 8;
constexpr double measure_slack_px = 4;

}  // namespace

MeasureTool::MeasureTool(LinkedViews& views, QObject* parent) : QObject(parent), views_(views) {
  for (SliceView* slice : views_.slices()) {
    slice->installEventFilter(this);
    connect(slice, &SliceView::slice_moved, this, &MeasureTool::draw);
  }
  for (SpaceView* space : {&views_.space(), &views_.second_space()}) space->installEventFilter(this);
}

void MeasureTool::begin(std::optional<MeasureKind> kind) {
  kind_ = kind;
  set_mm_.clear();
  next_mm_.reset();
  draw();
  Q_EMIT kind_changed();
}

void MeasureTool::add(Measurement measurement) {
  measurements_.push_back(std::move(measurement));
  draw();
  Q_EMIT changed();
}

void MeasureTool::remove(std::size_t measurement) {
  GLISSON_ASSERT(measurement < measurements_.size());
  measurements_.erase(measurements_.begin() + static_cast<std::ptrdiff_t>(measurement));
  held_.reset();
  draw();
  Q_EMIT changed();
}

void MeasureTool::clear() {
  measurements_.clear();
  held_.reset();
  begin(std::nullopt);
  Q_EMIT changed();
}

bool MeasureTool::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && kind_) return key_event(*static_cast<QKeyEvent*>(event));
  const bool mouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseMove ||
                     event->type() == QEvent::MouseButtonRelease;
  if (!mouse) return false;
  auto& moved = *static_cast<QMouseEvent*>(event);
  if (auto* slice = qobject_cast<SliceView*>(watched)) return slice_event(*slice, moved);
  if (auto* space = qobject_cast<SpaceView*>(watched)) return space_event(*space, moved);
  return false;
}

bool MeasureTool::slice_event(SliceView& slice, QMouseEvent& event) {
  const bool left = event.button() == Qt::LeftButton && event.modifiers() == Qt::NoModifier;
  if (event.type() == QEvent::MouseButtonPress && left) {
    if (kind_) {
      set_point(slice.place_at(event.position()));
      return true;
    }
    held_ = under(slice, event.position());
    return held_.has_value();
  }
  if (event.type() == QEvent::MouseButtonRelease && held_) {
    held_.reset();
    return true;
  }
  if (event.type() != QEvent::MouseMove) return kind_ && left;
  if (held_ && (event.buttons() & Qt::LeftButton) != 0) {
    measurements_[held_->measurement].points_mm[held_->point] = slice.place_at(event.position());
    draw();
    Q_EMIT changed();
    return true;
  }
  if (event.buttons() != Qt::NoButton) return false;
  if (kind_) {
    slice.setCursor(Qt::CrossCursor);
    preview(slice.place_at(event.position()));
    return true;
  }
  if (under(slice, event.position())) {
    slice.setCursor(Qt::PointingHandCursor);
    return true;
  }
  return false;
}

// In space, points are set on what is under the mouse, by a click that is no drag: drags still turn the patient.
bool MeasureTool::space_event(SpaceView& space, QMouseEvent& event) {
  if (!kind_ || event.button() != Qt::LeftButton) return false;
  if (event.type() == QEvent::MouseButtonPress) pressed_at_ = event.position();
  if (event.type() != QEvent::MouseButtonRelease) return false;
  if ((event.position() - pressed_at_).manhattanLength() >= measure_slack_px) return false;
  const QPointF at = event.position() * space.devicePixelRatioF();
  const auto pick = space.view().pick(at.x(), at.y());
  if (!pick) return false;
  set_point(pick->position_mm);
  return true;
}

bool MeasureTool::key_event(QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_Escape: begin(std::nullopt); return true;
    case Qt::Key_Return:
    case Qt::Key_Enter: set_point(views_.crosshair_mm()); return true;
    default: return false;
  }
}

void MeasureTool::set_point(const Eigen::Vector3d& position_mm) {
  set_mm_.push_back(position_mm);
  next_mm_.reset();
  if (set_mm_.size() < points_needed(*kind_)) {
    draw();
    return;
  }
  Measurement made{*kind_, set_mm_, {}, 0};
  begin(std::nullopt);
  add(std::move(made));
}

void MeasureTool::preview(const Eigen::Vector3d& position_mm) {
  if (set_mm_.empty()) return;
  next_mm_ = position_mm;
  draw();
}

std::optional<MeasureTool::Fixed> MeasureTool::under(const SliceView& slice, const QPointF& position) const {
  for (std::size_t m = 0; m < measurements_.size(); ++m) {
    for (std::size_t p = 0; p < measurements_[m].points_mm.size(); ++p) {
      const Eigen::Vector3d& point_mm = measurements_[m].points_mm[p];
      if (std::abs(slice.normal().dot(point_mm - slice.crosshair_mm())) > reach_mm) continue;
      const Eigen::Vector2d at = slice.view().pixel_of(point_mm) / slice.devicePixelRatioF();
      if ((at - Eigen::Vector2d(position.x(), position.y())).norm() <= point_reach_px) return Fixed{m, p};
    }
  }
  return std::nullopt;
}

void MeasureTool::draw() {
  std::vector<Measurement> all = measurements_;
  if (kind_ && !set_mm_.empty()) {
    all.push_back({*kind_, set_mm_, {}, 0});
    if (next_mm_) all.back().points_mm.push_back(*next_mm_);
  }
  const auto append = [](std::vector<scene::LineItem>& lines, std::vector<scene::LineItem> more) {
    lines.insert(lines.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  for (SliceView* slice : views_.slices()) {
    std::vector<scene::LineItem> lines;
    for (const Measurement& each : all) {
      append(lines, lines_in_slice(each, slice->crosshair_mm(), slice->normal(), reach_mm));
    }
    slice->view().set_lines(lines);
    slice->redraw();
  }
  std::vector<scene::LineItem> lines;
  for (const Measurement& each : all) append(lines, lines_in_space(each));
  for (SpaceView* space : {&views_.space(), &views_.second_space()}) {
    space->view().set_lines(lines);
    space->redraw();
  }
}

}  // namespace glisson::widgets
