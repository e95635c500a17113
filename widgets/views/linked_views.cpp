#include "views/linked_views.h"

#include <QGridLayout>

namespace glisson::widgets {

LinkedViews::LinkedViews(QWidget* parent) : QWidget(parent) {
  slices_ = {new SliceView(SliceDirection::transverse), new SliceView(SliceDirection::coronal),
             new SliceView(SliceDirection::sagittal)};
  space_ = new SpaceView;
  // The accents are those of the crosshair's lines (slice_view.cpp).
  frames_ = {new ViewFrame(tr("Transverse"), QColor(107, 166, 250), slices_[0]),
             new ViewFrame(tr("Patient"), {}, space_), new ViewFrame(tr("Coronal"), QColor(115, 204, 128), slices_[1]),
             new ViewFrame(tr("Sagittal"), QColor(237, 140, 102), slices_[2])};
  for (const std::size_t slice : {0, 2, 3}) {
    frames_[slice]->setToolTip(
        tr("Click: crosshair. Right drag: brightness and contrast. Wheel: next slice.\n"
           "Ctrl+wheel: zoom. Shift+drag: shift."));
  }
  frames_[1]->setToolTip(tr("Drag: turn. Shift+drag: shift. Wheel: zoom. Click: crosshair there."));
  auto* square = new QGridLayout(this);
  square->setContentsMargins(0, 0, 0, 0);
  square->setSpacing(3);
  square->addWidget(frames_[0], 0, 0);
  square->addWidget(frames_[1], 0, 1);
  square->addWidget(frames_[2], 1, 0);
  square->addWidget(frames_[3], 1, 1);
  square->setColumnStretch(0, 1);
  square->setColumnStretch(1, 1);
  square->setRowStretch(0, 1);
  square->setRowStretch(1, 1);

  for (SliceView* slice : slices_) {
    connect(slice, &SliceView::crosshair_moved, this, [this, slice](const Eigen::Vector3d& position_mm) {
      for (SliceView* other : slices_) {
        if (other != slice) other->set_crosshair(position_mm);
      }
      Q_EMIT crosshair_moved(position_mm);
    });
    connect(slice, &SliceView::window_changed, this, [this, slice](double center, double width) {
      for (SliceView* other : slices_) {
        if (other != slice) other->set_window(center, width);
      }
    });
  }
  const std::array<std::pair<QString, scene::PatientView>, 4> sides{{{tr("Surgeon"), scene::PatientView::surgeon},
                                                                     {tr("Front"), scene::PatientView::anterior},
                                                                     {tr("Right"), scene::PatientView::right},
                                                                     {tr("Below"), scene::PatientView::inferior}}};
  for (const auto& [name, side] : sides) {
    QToolButton* button = frames_[1]->add_button(name, tr("Look from here, everything in view"));
    connect(button, &QToolButton::clicked, space_, [this, wanted = side] { space_->look_from(wanted); });
  }
  for (ViewFrame* frame : frames_) {
    connect(frame, &ViewFrame::maximise_requested, this, [this, frame] { toggle_maximised(frame); });
  }
}

void LinkedViews::show_slices(const SliceContent& content) {
  for (SliceView* slice : slices_) slice->show_content(content);
}

void LinkedViews::set_crosshair(const Eigen::Vector3d& position_mm) {
  for (SliceView* slice : slices_) slice->set_crosshair(position_mm);
}

void LinkedViews::redraw() {
  for (SliceView* slice : slices_) slice->redraw();
  space_->redraw();
}

void LinkedViews::toggle_maximised(ViewFrame* frame) {
  maximised_ = maximised_ == frame ? nullptr : frame;
  for (ViewFrame* each : frames_) {
    each->setVisible(maximised_ == nullptr || maximised_ == each);
    each->show_maximised(maximised_ == each);
  }
}

}  // namespace glisson::widgets
