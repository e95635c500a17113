#include "widgets/views/linked_views.h"

#include <algorithm>

#include "widgets/panels/ask_path.h"
#include "widgets/panels/write_picture.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {

LinkedViews::LinkedViews(QWidget* parent) : QWidget(parent) {
  slices_ = {new SliceView(SliceDirection::transverse), new SliceView(SliceDirection::coronal),
             new SliceView(SliceDirection::sagittal)};
  space_ = new SpaceView;
  second_space_ = new SpaceView;
  second_space_->setObjectName("second_space_view");
  second_space_->set_follower();
  // The accents are those of the crosshair's lines (slice_view.cpp).
  frames_ = {new ViewFrame(QColor(107, 166, 250), slices_[0]), new ViewFrame({}, space_),
             new ViewFrame(QColor(115, 204, 128), slices_[1]), new ViewFrame(QColor(237, 140, 102), slices_[2]),
             new ViewFrame({}, second_space_)};
  for (ViewFrame* frame : frames_) frame->setParent(this);
  grid_ = new QGridLayout(this);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(3);
  set_layout(ViewLayout::square);

  connect(space_, &SpaceView::camera_changed, second_space_, [this] {
    if (layout_ == ViewLayout::side_by_side) second_space_->follow(space_->view().camera());
  });
  connect(second_space_, &SpaceView::camera_changed, space_,
          [this] { space_->follow(second_space_->view().camera()); });
  for (SliceView* slice : slices_) {
    connect(slice, &SliceView::crosshair_moved, this, [this, slice](const Eigen::Vector3d& position_mm) {
      for (SliceView* other : slices_) {
        if (other != slice) other->set_crosshair(position_mm);
      }
      Q_EMIT crosshair_moved(position_mm);
    });
    connect(slice, &SliceView::axes_turned, this, [this, slice](const Eigen::Matrix3d& axes) {
      for (SliceView* other : slices_) {
        if (other != slice) other->set_axes(axes);
      }
    });
    connect(slice, &SliceView::window_changed, this, [this, slice](double center, double width) {
      for (SliceView* other : slices_) {
        if (other != slice) other->set_window(center, width);
      }
      Q_EMIT window_chosen();
      Q_EMIT window_shown();
    });
  }
  std::array<QToolButton*, 4> sides{};
  for (std::size_t k = 0; const scene::PatientView side : {scene::PatientView::surgeon, scene::PatientView::anterior,
                                                           scene::PatientView::right, scene::PatientView::inferior}) {
    sides[k] = frames_[1]->add_button();
    connect(sides[k], &QToolButton::clicked, space_, [this, side] { space_->look_from(side); });
    ++k;
  }
  scan_ = frames_[1]->add_button();
  scan_->setObjectName("scan_behind");
  scan_->setCheckable(true);
  scan_->setEnabled(false);
  connect(scan_, &QToolButton::toggled, this, &LinkedViews::hang_scan);
  keep_translated(this, [=, this] {
    frames_[0]->set_name(tr("Transverse"));
    frames_[1]->set_name(tr("Patient"));
    frames_[2]->set_name(tr("Coronal"));
    frames_[3]->set_name(tr("Sagittal"));
    frames_[4]->set_name(tr("Atlas"));
    for (const std::size_t slice : {0, 2, 3}) {
      frames_[slice]->setToolTip(
          tr("Click: crosshair. Right drag: brightness and contrast. Wheel: next slice.\n"
             "Ctrl+wheel: zoom. Shift+drag: shift. Ctrl+drag: turn. Knobs of the crosshair: tilt the other slices."));
    }
    frames_[1]->setToolTip(tr("Drag: turn. Shift+drag: shift. Wheel: zoom. Click: crosshair there."));
    sides[0]->setText(tr("Surgeon"));
    sides[1]->setText(tr("Front"));
    sides[2]->setText(tr("Right"));
    sides[3]->setText(tr("Below"));
    scan_->setText(tr("Scan"));
    scan_->setToolTip(tr("The scan itself as a soft backdrop: bones and bright vessels behind the organ"));
    for (QToolButton* side : sides) side->setToolTip(tr("Look from here, everything in view"));
  });
  for (ViewFrame* frame : frames_) {
    const auto index = static_cast<std::size_t>(std::find(frames_.begin(), frames_.end(), frame) - frames_.begin());
    connect(frame, &ViewFrame::picture_requested, this, [this, index] { save_picture(index); });
    connect(frame, &ViewFrame::maximise_requested, this, [this, frame] { toggle_maximised(frame); });
  }
}

void LinkedViews::set_window(double center, double width) {
  for (SliceView* slice : slices_) slice->set_window(center, width);
  Q_EMIT window_chosen();
  Q_EMIT window_shown();
}

void LinkedViews::choose_window(WindowPreset preset) {
  if (!volume_) return;
  if (const auto window = window_of(preset, *volume_)) set_window(window->center, window->width);
}

WindowPreset LinkedViews::window_preset() const {
  return volume_ ? preset_of(window(), *volume_) : WindowPreset::automatic;
}

bool LinkedViews::shows_hounsfield_units() const { return volume_ && in_hounsfield_units(*volume_); }

void LinkedViews::set_axes(const Eigen::Matrix3d& axes) {
  for (SliceView* slice : slices_) slice->set_axes(axes);
}

void LinkedViews::turn_to_surgeon() {
  const scene::Camera surgeon = scene::look_from(scene::PatientView::surgeon, {{0, 0, 0}, {1, 1, 1}}, 1);
  Eigen::Matrix3d axes;
  axes << surgeon.sight.cross(surgeon.up), surgeon.sight, surgeon.up;
  for (SliceView* slice : slices_) slice->set_roll_deg(0);
  set_axes(axes);
}

void LinkedViews::straighten() {
  for (SliceView* slice : slices_) slice->set_roll_deg(0);
  set_axes(Eigen::Matrix3d::Identity());
}

void LinkedViews::set_caption_of_pictures(const QString& caption) {
  for (RenderWidget* view :
       std::initializer_list<RenderWidget*>{slices_[0], slices_[1], slices_[2], space_, second_space_})
    view->set_caption_of_pictures(caption);
}

void LinkedViews::save_view_in_use() { save_picture(static_cast<std::size_t>(frame_in_use())); }

void LinkedViews::save_picture(std::size_t frame) {
  const std::array<RenderWidget*, 5> views{slices_[0], space_, slices_[1], slices_[2], second_space_};
  const QImage picture = views[frame]->smooth_picture();  // as it is now, before a dialog lies over it
  static constexpr const char* proposed = "view.png";
  const QString file = ask_where_to_save(this, tr("Save the picture"), proposed, tr("Pictures (*.png)"));
  if (!file.isEmpty() && !write_picture(picture, path_of(file))) Q_EMIT picture_not_saved(file);
}

void LinkedViews::show_slices(const SliceContent& content) {
  const bool another = volume_ != content.volume;
  volume_ = content.volume;
  scan_->setEnabled(volume_ != nullptr);
  if (another) hang_scan();
  for (SliceView* slice : slices_) slice->show_content(content);
  Q_EMIT window_shown();
}

void LinkedViews::set_scan_behind(bool behind) { scan_->setChecked(behind); }

void LinkedViews::hang_scan() {
  const bool behind = scan_->isChecked() && volume_ != nullptr;
  const std::optional<scene::Backdrop> backdrop =
      behind ? std::optional(shows_hounsfield_units() ? scene::ct_backdrop(volume_)
                                                      : scene::backdrop_by_brightness(volume_))
             : std::nullopt;
  space_->view().set_backdrop(backdrop);
  space_->redraw();
}

void LinkedViews::set_crosshair(const Eigen::Vector3d& position_mm) {
  for (SliceView* slice : slices_) slice->set_crosshair(position_mm);
  Q_EMIT crosshair_moved(position_mm);
}

void LinkedViews::redraw() {
  for (SliceView* slice : slices_) slice->redraw();
  space_->redraw();
  second_space_->redraw();
}

void LinkedViews::toggle_maximised(ViewFrame* frame) {
  last_used_ = static_cast<int>(std::find(frames_.begin(), frames_.end(), frame) - frames_.begin());
  set_layout(layout_ == ViewLayout::one ? before_one_ : ViewLayout::one);
}

int LinkedViews::frame_in_use() const {
  for (int k = 0; k < static_cast<int>(frames_.size()); ++k) {
    if (frames_[static_cast<std::size_t>(k)]->isAncestorOf(focusWidget())) return k;
  }
  return last_used_;
}

void LinkedViews::show_second_space(bool shown) {
  if (shown == (layout_ == ViewLayout::side_by_side)) return;
  if (shown) before_side_by_side_ = layout_;
  set_layout(shown ? ViewLayout::side_by_side : before_side_by_side_);
}

void LinkedViews::set_layout(ViewLayout layout) {
  if (layout == ViewLayout::one && layout_ != ViewLayout::one) {
    before_one_ = layout_;
    if (focusWidget() != nullptr) last_used_ = frame_in_use();
  }
  layout_ = layout;
  // Which frame, its row and column, and how many of them it spans.
  switch (layout) {
    case ViewLayout::square:
      arrange({{0, 0, 0, 1, 1}, {1, 0, 1, 1, 1}, {2, 1, 0, 1, 1}, {3, 1, 1, 1, 1}}, {1, 1}, {1, 1});
      break;
    case ViewLayout::space_large:
      arrange({{1, 0, 0, 3, 1}, {0, 0, 1, 1, 1}, {2, 1, 1, 1, 1}, {3, 2, 1, 1, 1}}, {1, 1, 1}, {5, 2});
      break;
    case ViewLayout::slices_in_a_row:
      arrange({{0, 0, 0, 1, 1}, {2, 0, 1, 1, 1}, {3, 0, 2, 1, 1}}, {1}, {1, 1, 1});
      break;
    case ViewLayout::one: arrange({{last_used_, 0, 0, 1, 1}}, {1}, {1}); break;
    case ViewLayout::side_by_side: arrange({{1, 0, 0, 1, 1}, {4, 0, 1, 1, 1}}, {1}, {1, 1}); break;
  }
  Q_EMIT layout_changed();
}

void LinkedViews::arrange(const std::vector<std::array<int, 5>>& places, const std::vector<int>& row_stretches,
                          const std::vector<int>& column_stretches) {
  for (ViewFrame* frame : frames_) grid_->removeWidget(frame);
  for (int k = 0; k < 3; ++k) {
    const auto stretch = [k](const std::vector<int>& all) {
      return k < static_cast<int>(all.size()) ? all[static_cast<std::size_t>(k)] : 0;
    };
    grid_->setRowStretch(k, stretch(row_stretches));
    grid_->setColumnStretch(k, stretch(column_stretches));
  }
  for (int k = 0; k < static_cast<int>(frames_.size()); ++k) {
    ViewFrame* frame = frames_[static_cast<std::size_t>(k)];
    const auto place = std::find_if(places.begin(), places.end(), [k](const auto& wanted) { return wanted[0] == k; });
    if (place != places.end()) {
      const auto& [which, row, column, rows, columns] = *place;
      grid_->addWidget(frame, row, column, rows, columns);
      frame->show_maximised(layout_ == ViewLayout::one);
    }
    frame->setVisible(place != places.end());
  }
}

}  // namespace glisson::widgets
