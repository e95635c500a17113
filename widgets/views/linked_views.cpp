#include "views/linked_views.h"

#include <QGridLayout>

#include "words/worded.h"

namespace glisson::widgets {

LinkedViews::LinkedViews(QWidget* parent) : QWidget(parent) {
  slices_ = {new SliceView(SliceDirection::transverse), new SliceView(SliceDirection::coronal),
             new SliceView(SliceDirection::sagittal)};
  space_ = new SpaceView;
  // The accents are those of the crosshair's lines (slice_view.cpp).
  frames_ = {new ViewFrame(QColor(107, 166, 250), slices_[0]), new ViewFrame({}, space_),
             new ViewFrame(QColor(115, 204, 128), slices_[1]), new ViewFrame(QColor(237, 140, 102), slices_[2])};
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
  std::array<QToolButton*, 4> sides{};
  for (std::size_t k = 0; const scene::PatientView side : {scene::PatientView::surgeon, scene::PatientView::anterior,
                                                           scene::PatientView::right, scene::PatientView::inferior}) {
    sides[k] = frames_[1]->add_button();
    connect(sides[k], &QToolButton::clicked, space_, [this, side] { space_->look_from(side); });
    ++k;
  }
  worded(this, [=, this] {
    frames_[0]->set_name(tr("Transverse"));
    frames_[1]->set_name(tr("Patient"));
    frames_[2]->set_name(tr("Coronal"));
    frames_[3]->set_name(tr("Sagittal"));
    for (const std::size_t slice : {0, 2, 3}) {
      frames_[slice]->setToolTip(
          tr("Click: crosshair. Right drag: brightness and contrast. Wheel: next slice.\n"
             "Ctrl+wheel: zoom. Shift+drag: shift."));
    }
    frames_[1]->setToolTip(tr("Drag: turn. Shift+drag: shift. Wheel: zoom. Click: crosshair there."));
    sides[0]->setText(tr("Surgeon"));
    sides[1]->setText(tr("Front"));
    sides[2]->setText(tr("Right"));
    sides[3]->setText(tr("Below"));
    for (QToolButton* side : sides) side->setToolTip(tr("Look from here, everything in view"));
  });
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
