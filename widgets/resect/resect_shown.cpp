// What the workspace Resect shows of the cut: the liver in parts, the cut's plane, and why there is nothing yet.

#include "scene/anatomy.h"
#include "widgets/resect/resect_panel.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;

constexpr scene::Colour cut_colour{0.20, 0.83, 0.85};

}  // namespace

void ResectPanel::show_result() {
  by_anatomy_->set_resection(live_->result());
  results_->show(live_->result().get(), live_->problem() ? translated(*live_->problem()) : why_nothing());
  pieces_ = ResectionScene(live_->result());
  show_scene();
  update_text();
}

void ResectPanel::show_scene() {
  if (!isVisible()) return;
  WorkspaceScene scene;
  const bool drawing = cut_controls_->drawing();
  const bool by_anatomy = by_anatomy_->draws_liver() && !drawing;
  const bool in_parts = by_anatomy || (live_->result() != nullptr && !drawing);
  scene.patient = in_parts           ? WorkspaceScene::Patient::at_rest_in_slices_only
                  : live_->holding() ? WorkspaceScene::Patient::as_rehearsed
                                     : WorkspaceScene::Patient::at_rest;
  if (by_anatomy) {
    by_anatomy_->add_to(scene);
    for (const PatientStructure& structure : patient_.structures) {
      if (structure.name == "liver") continue;
      const scene::Appearance look = scene::appearance_of(structure.name);
      scene.surfaces.push_back({structure.name, structure.surface, look.colour, look.opacity, look.finish, {}});
    }
  } else if (in_parts) {
    pieces_.add_to(scene);
    scene.key = {{specimen_colour(), tr("Removed").toStdString()}, {remnant_colour(), tr("Stays").toStdString()}};
  }
  if (cut_controls_->kind() == CutControls::plane_cut && plane_ && !cut_controls_->by_clicks()) {
    if (!drawn_plane_) drawn_plane_ = std::make_shared<geometry::Surface>(part_within(*plane_, around_liver()));
    scene.surfaces.push_back({"cut", drawn_plane_, cut_colour, 0.14, scene::Finish::solid, {}, false});
    scene.cuts.push_back({drawn_plane_, cut_colour, 2.0});
  } else {
    drawn_plane_.reset();
    if (live_->result()) {
      scene.cuts.push_back({std::make_shared<geometry::Surface>(live_->result()->plan.cut), cut_colour, 2.0});
    }
  }
  const auto handles = handles_->marks_in_space();
  scene.marks.insert(scene.marks.end(), handles.begin(), handles.end());
  scene.arrows = handles_->arrows_in_space();
  context_.patient_views.set_workspace_scene(std::move(scene));
}

// It stays the same surface while it moves, so that the views need not be built anew.
void ResectPanel::move_drawn_plane() {
  if (!drawn_plane_ || !plane_ || !isVisible()) return;
  const auto points = points_within(*plane_, around_liver());
  const auto moved_mm = std::make_shared<const std::vector<Vector3d>>(points.begin(), points.end());
  context_.views.space().view().move_surface(drawn_plane_, moved_mm);
  for (SliceView* slice : context_.views.slices()) slice->view().move_surface(drawn_plane_, moved_mm);
}

void ResectPanel::update_text() {
  cut_controls_->show_plane(plane_);
  cut_controls_->show_points(points_mm_.size());
  const bool planned = live_->result() != nullptr;
  for (QWidget* each : std::initializer_list<QWidget*>{apart_, other_part_}) each->setEnabled(planned);
  no_cut_->setEnabled(plane_ || !points_mm_.empty() || !by_anatomy_->taken().empty());
}

QString ResectPanel::why_nothing() const {
  if (live_->result() || !by_anatomy_->taken().empty()) return {};
  if (cut_controls_->kind() == CutControls::sheet_cut) {
    return tr("Set three or more points where the cut is to pass: on the liver, or in the slices.");
  }
  if (cut_controls_->by_clicks()) return tr("Click three places through which the plane is to pass.");
  return plane_ ? tr("Planning...")
                : tr("Put the crosshair where the cut is to pass, then the plane through it. "
                     "Drag its line in a slice to shift it, a line's end to tilt it.");
}

geometry::Box ResectPanel::around_liver() const {
  constexpr double beyond_mm = 10;
  if (patient_.structures.empty()) return {};
  geometry::Box box = geometry::bounding_box(patient_.structures.front().surface->points_mm);
  box.min_mm.array() -= beyond_mm;
  box.max_mm.array() += beyond_mm;
  return box;
}

}  // namespace glisson::widgets
