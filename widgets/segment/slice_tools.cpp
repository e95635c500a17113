#include "widgets/segment/slice_tools.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <QMouseEvent>
#include <QWheelEvent>

#include "scene/anatomy.h"
#include "segmentation/part_at_neck.h"

namespace glisson::widgets {
namespace {

constexpr scene::Colour pencil{1.0, 0.93, 0.35}, refusing{1.0, 0.15, 0.15};
constexpr double near_mm = 3, arm_mm = 3.5;  // of a point: from how near a slice it is seen, and how large its mark is
constexpr std::size_t minimum_outline = 3;

// At the points that the slice shows, or that lie near it: upright inside, and slanted outside, since outlines may be
// red too.
scene::DrawnLines crosses(const SliceView& view, const std::vector<Eigen::Vector3d>& points_mm, bool outside) {
  scene::DrawnLines lines{{}, outside ? refusing : pencil, 2.0};
  const Eigen::Vector3d normal = view.normal(), right = normal.unitOrthogonal(), up = normal.cross(right);
  const Eigen::Vector3d across = outside ? (right + up).normalized() : right, along = normal.cross(across);
  for (const Eigen::Vector3d& point_mm : points_mm) {
    const double off_mm = normal.dot(point_mm - view.crosshair_mm());
    if (std::abs(off_mm) > near_mm) continue;
    const Eigen::Vector3d here_mm = point_mm - off_mm * normal;
    for (const Eigen::Vector3d& arm : {across, along}) {
      lines.ends_mm.push_back(here_mm - arm_mm * arm);
      lines.ends_mm.push_back(here_mm + arm_mm * arm);
    }
  }
  return lines;
}

}  // namespace

SliceTools::SliceTools(LinkedViews& views, StructureEditor& editor, SliceOverlay& overlay, QObject* parent)
    : QObject(parent), views_(views), editor_(editor), overlay_(overlay) {
  for (SliceView* view : views_.slices()) view->installEventFilter(this);
}

void SliceTools::set_tool(Tool tool) {
  if (drawing_in_ != nullptr) release(drawing_in_);
  tool_ = tool;
  for (SliceView* view : views_.slices()) {
    overlay_.set_sketch(view, {});
    view->setMouseTracking(tool != Tool::none);
    view->setCursor(tool == Tool::none ? Qt::ArrowCursor : Qt::CrossCursor);
    if (tool == Tool::seeds) sketch(view, {});
  }
}

void SliceTools::clear_points() {
  points_ = {};
  Q_EMIT points_changed();
  if (tool_ != Tool::seeds) return;
  for (SliceView* view : views_.slices()) sketch(view, {});
}

bool SliceTools::is_brush() const {
  return tool_ == Tool::brush || tool_ == Tool::eraser || tool_ == Tool::smart_brush;
}

bool SliceTools::eventFilter(QObject* watched, QEvent* event) {
  auto* view = qobject_cast<SliceView*>(watched);
  if (view == nullptr || tool_ == Tool::none) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      const bool ours = mouse->button() == Qt::LeftButton && (mouse->modifiers() & Qt::ShiftModifier) == 0;
      return ours && press(view, mouse->position(), (mouse->modifiers() & Qt::ControlModifier) != 0);
    }
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (drawing_in_ == view) drag(view, mouse->position());
      sketch(view, mouse->position());
      return drawing_in_ == view;
    }
    case QEvent::MouseButtonRelease:
      if (drawing_in_ != view || static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton) return false;
      release(view);
      return true;
    case QEvent::Leave:
      if (drawing_in_ != view && tool_ != Tool::seeds) overlay_.set_sketch(view, {});
      return false;
    case QEvent::Wheel: {
      const auto* wheel = static_cast<QWheelEvent*>(event);
      if ((wheel->modifiers() & Qt::ShiftModifier) == 0 || !is_brush()) return false;
      // Some systems turn the wheel across under Shift.
      const int units = wheel->angleDelta().y() != 0 ? wheel->angleDelta().y() : wheel->angleDelta().x();
      options_.radius_mm =
          std::clamp(options_.radius_mm * std::pow(1.0012, units), minimum_radius_mm, maximum_radius_mm);
      Q_EMIT radius_changed(options_.radius_mm);
      sketch(view, wheel->position());
      return true;
    }
    default: return false;
  }
}

bool SliceTools::press(SliceView* view, const QPointF& at, bool opposite) {
  const Eigen::Vector3d place_mm = view->place_at(at);
  if (tool_ == Tool::seeds) {
    const EditedStructure* into = editor_.active_structure();
    if (opposite && (into == nullptr || into->name != "liver")) {
      Q_EMIT refused(tr("Points outside count for the liver alone."));
    } else {
      click(*view, place_mm, opposite);
    }
    return true;
  }
  const EditedStructure* active = editor_.active_structure();
  if (active == nullptr) {
    Q_EMIT refused(tr("Choose a structure first, or add one."));
    return true;
  }
  if (!editor_.can_edit()) {
    Q_EMIT refused(tr("One moment: the last change is being worked off."));
    return true;
  }
  if (tool_ == Tool::piece) {
    editor_.apply(opposite ? GLISSON_TEXT("Take a part off {0}") : GLISSON_TEXT("Keep one piece of {0}"),
                  [place_mm, opposite](imaging::Mask mask) {
                    return opposite ? segmentation::without_part_at(std::move(mask), place_mm)
                                    : segmentation::keep_piece_at(std::move(mask), place_mm);
                  });
    return true;
  }
  drawing_in_ = view;
  if (tool_ == Tool::scissors) {
    outline_mm_ = {place_mm};
    return true;
  }
  only_ = options_.only;
  if (tool_ == Tool::smart_brush && editor_.anatomy() != nullptr) {
    segmentation::LikenessOptions likeness;
    likeness.spread = options_.likeness;
    only_ = segmentation::grey_range_at(*editor_.anatomy(), place_mm, likeness);
    if (!only_) {
      drawing_in_ = nullptr;
      return true;
    }
  }
  const bool erases = (tool_ == Tool::eraser) != opposite;
  paint_ = erases ? segmentation::Paint::take_away : segmentation::Paint::add;
  last_mm_ = place_mm;
  dab(view, place_mm);
  return true;
}

void SliceTools::click(const SliceView& view, const Eigen::Vector3d& place_mm, bool outside) {
  std::size_t taken_away = 0;
  for (auto* points_mm : {&points_.inside_mm, &points_.outside_mm}) {
    taken_away += std::erase_if(*points_mm, [&](const Eigen::Vector3d& point_mm) {
      const Eigen::Vector3d off_mm = point_mm - place_mm;
      return std::abs(view.normal().dot(off_mm)) <= near_mm && off_mm.norm() <= std::hypot(near_mm, arm_mm);
    });
  }
  if (taken_away == 0) (outside ? points_.outside_mm : points_.inside_mm).push_back(place_mm);
  Q_EMIT points_changed();
  for (SliceView* each : views_.slices()) sketch(each, {});
}

void SliceTools::drag(SliceView* view, const QPointF& at) {
  const Eigen::Vector3d place_mm = view->place_at(at);
  if (tool_ == Tool::scissors) {
    outline_mm_.push_back(place_mm);
  } else if (is_brush()) {
    dab(view, place_mm);
  }
}

void SliceTools::dab(SliceView* view, const Eigen::Vector3d& to_mm) {
  segmentation::Dab dab{last_mm_, to_mm, options_.radius_mm, std::nullopt, std::nullopt};
  if (options_.shape == ToolOptions::Shape::disc) {
    if (const auto layer = overlay_.layer_of(*view, editor_.active_structure()->mask->grid)) {
      dab.layer_axis = layer->axis;
    } else {
      dab.plane_normal = view->normal();
    }
  }
  editor_.draw(dab, paint_, only_);
  last_mm_ = to_mm;
}

void SliceTools::release(SliceView* view) {
  drawing_in_ = nullptr;
  if (tool_ == Tool::scissors) return cut(view);
  editor_.end_stroke(tool_ == Tool::smart_brush           ? GLISSON_TEXT("Smart brush on {0}")
                     : paint_ == segmentation::Paint::add ? GLISSON_TEXT("Brush on {0}")
                                                          : GLISSON_TEXT("Eraser on {0}"));
}

void SliceTools::cut(SliceView* view) {
  overlay_.set_sketch(view, {});
  const bool is_drawn = outline_mm_.size() >= minimum_outline && editor_.active_structure() != nullptr;
  if (is_drawn) {
    editor_.apply(GLISSON_TEXT("Scissors on {0}"),
                  [outline = outline_in(*view), side = options_.cut](imaging::Mask mask) -> Result<imaging::Mask> {
                    return segmentation::cut(std::move(mask), outline, side);
                  });
  }
  outline_mm_.clear();
}

// A slice is as thick as the voxels that its plane goes through; between two layers of voxels, it is the one that is
// shown there.
segmentation::Outline SliceTools::outline_in(const SliceView& view) const {
  const imaging::Grid& grid = editor_.active_structure()->mask->grid;
  segmentation::Outline outline{outline_mm_, view.view().camera().sight};
  const double half_mm = segmentation::half_extent_mm(grid, outline.direction);
  double middle_mm = 0;
  if (const auto layer = overlay_.layer_of(view, grid)) {
    Eigen::Vector3d index = grid.index_of(outline_mm_.front());
    index[layer->axis] = layer->index;
    middle_mm = outline.direction.dot(grid.position_mm(index) - outline_mm_.front());
  }
  const double slice_begins_mm = middle_mm - half_mm, slice_ends_mm = middle_mm + half_mm;
  switch (options_.depth) {
    case ToolOptions::Depth::all_slices: break;
    case ToolOptions::Depth::this_slice:
      outline.from_mm = slice_begins_mm;
      outline.to_mm = slice_ends_mm;
      break;
    case ToolOptions::Depth::both_sides:
      outline.from_mm = std::min(slice_begins_mm, middle_mm - options_.depth_mm);
      outline.to_mm = std::max(slice_ends_mm, middle_mm + options_.depth_mm);
      break;
    case ToolOptions::Depth::towards_viewer: outline.to_mm = slice_ends_mm; break;
    case ToolOptions::Depth::away_from_viewer: outline.from_mm = slice_begins_mm; break;
  }
  return outline;
}

void SliceTools::sketch(SliceView* view, const QPointF& at) {
  std::vector<scene::DrawnLines> lines;
  if (is_brush() && editor_.active_structure() != nullptr) {
    const scene::Colour colour =
        tool_ == Tool::eraser ? pencil : scene::appearance_of(editor_.active_structure()->name).colour;
    scene::DrawnLines circle{{}, colour, 1.4};
    add_circle(circle.ends_mm, view->place_at(at), view->normal(), options_.radius_mm);
    lines.push_back(std::move(circle));
  }
  if (tool_ == Tool::scissors && outline_mm_.size() > 1) {
    scene::DrawnLines path{{}, pencil, 1.8};
    for (std::size_t k = 0; k < outline_mm_.size(); ++k) {
      path.ends_mm.push_back(outline_mm_[k]);
      path.ends_mm.push_back(outline_mm_[(k + 1) % outline_mm_.size()]);
    }
    lines.push_back(std::move(path));
  }
  if (tool_ == Tool::seeds) {
    for (const bool outside : {false, true}) {
      const auto& points_mm = outside ? points_.outside_mm : points_.inside_mm;
      if (scene::DrawnLines marks = crosses(*view, points_mm, outside); !marks.ends_mm.empty()) {
        lines.push_back(std::move(marks));
      }
    }
  }
  overlay_.set_sketch(view, std::move(lines));
}

}  // namespace glisson::widgets
