#include "widgets/resect/resect_panel.h"

#include <Eigen/Geometry>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/resect/kept_cuts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;
using Removed = casefile::PlannedCut::Removed;

constexpr int farthest_apart_mm = 80;
constexpr const char* surface_key = "resect/surface";

// Null for no cut.
Sentence step_between(const QJsonValue& before, const QJsonValue& after) {
  if (before.isNull()) return {GLISSON_TEXT("Set the cut"), {}};
  if (after.isNull()) return {GLISSON_TEXT("Take the cut away"), {}};
  return {GLISSON_TEXT("Change the cut"), {}};
}

std::filesystem::path folder_of_plan(const Patient& patient) { return patient.folder / "results" / "resection"; }

}  // namespace

ResectPanel::ResectPanel(WorkspaceContext context, QWidget* parent) : QWidget(parent), context_(std::move(context)) {
  live_ = new LiveResection(this);
  handles_ = new CutHandles(context_.views, this);
  const auto [title, missing, controls, column] = lay_out_side_panel(this);
  missing_ = missing;
  controls_ = controls;

  cut_controls_ = new CutControls(controls_);
  column->addWidget(cut_controls_);
  column->addWidget(make_outcome());
  by_anatomy_ = new PlanByAnatomy(context_, controls_);
  column->addWidget(by_anatomy_);
  column->addStretch(1);

  connect(cut_controls_, &CutControls::kind_chosen, this, &ResectPanel::cut_changed);
  connect(cut_controls_, &CutControls::drawing_changed, this, &ResectPanel::set_drawing);
  connect(cut_controls_, &CutControls::through_crosshair, this, [this](const Vector3d& normal) {
    if (patient_.structures.empty()) return;
    move_plane(plane_through(context_.views.crosshair_mm(), normal));
    note();
  });
  connect(cut_controls_, &CutControls::plane_typed, this, [this](double shift_mm, double turn_deg, double tilt_deg) {
    if (!plane_) return;
    move_plane({plane_->middle_mm, shift_mm, turn_deg, tilt_deg});
    note(By::typing);
  });
  connect(cut_controls_, &CutControls::last_dropped, this, [this] {
    auto fewer_mm = points_mm_;
    if (!fewer_mm.empty()) fewer_mm.pop_back();
    set_points(std::move(fewer_mm));
  });
  connect(cut_controls_, &CutControls::cleared, this, [this] { set_points({}); });
  connect(handles_, &CutHandles::plane_moved, this, &ResectPanel::move_plane);
  connect(handles_, &CutHandles::let_go, this, [this] { note(); });
  connect(handles_, &CutHandles::point_clicked, this, &ResectPanel::take_click);
  connect(handles_, &CutHandles::point_moved, this, [this](std::size_t point, const Vector3d& position_mm) {
    if (point >= points_mm_.size()) return;
    points_mm_[point] = position_mm;
    cut_changed();
  });
  connect(handles_, &CutHandles::line_drawn, this, &ResectPanel::cut_under);
  connect(handles_, &CutHandles::place_dragged, this, &ResectPanel::show_scene);
  connect(handles_, &CutHandles::place_let_go, by_anatomy_, &PlanByAnatomy::move_told_place);
  connect(handles_, &CutHandles::place_given_up, by_anatomy_, &PlanByAnatomy::drop_told_place);
  connect(by_anatomy_, &PlanByAnatomy::told_places_changed, this, [this] {
    handles_->set_places(by_anatomy_->told_places());
    show_scene();
  });
  connect(&context_.views.space(), &SpaceView::clicked, this, [this](const scene::View::Pick& pick) {
    if (isVisible() && cut_controls_->drawing() && !cut_controls_->freehand()) take_click(pick.position_mm);
  });
  connect(&context_.patient_views, &PatientViews::slices_rebuilt, this, [this] {
    move_drawn_plane();
    handles_->draw_in_slices();
  });
  connect(&context_.patient_views, &PatientViews::space_rebuilt, this, [this] {
    move_drawn_plane();
    if (isVisible()) pieces_.draw_apart(context_.views.space().view(), apart_->value());
  });
  connect(live_, &LiveResection::changed, this, &ResectPanel::show_result);
  connect(by_anatomy_, &PlanByAnatomy::taken_changed, this, &ResectPanel::cut_changed);
  connect(by_anatomy_, &PlanByAnatomy::drawing_changed, this, &ResectPanel::show_scene);
  connect(by_anatomy_, &PlanByAnatomy::plan_chosen, this, &ResectPanel::choose);
  context_.undo.keep(surface_key, [this](const QJsonValue& value) {
    if (!patient_.structures.empty()) take_up({{}, cuts_of(value)});
  });
  keep_translated(this, [this, title = title] {
    title->setText(tr("Plan a resection"));
    missing_->setText(tr("Needs a model of the liver. Build it first, or open the demo patient."));
    update_text();
    show_result();
  });
}

Workspace ResectPanel::workspace(WorkspaceContext context) {
  auto* panel = new ResectPanel(std::move(context));
  return {.id = "resect",
          .name = [] { return tr("Resect"); },
          .about = [] { return tr("Set a cut: what goes, what stays, how near the tumours it passes."); },
          .widget = panel,
          .show_patient = [panel](const Patient& patient) { panel->show_patient(patient); },
          .missing = model_missing};
}

QWidget* ResectPanel::make_outcome() {
  auto* group = new QWidget;
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 6, 0, 0);
  column->setSpacing(8);
  as_held_ = new QCheckBox(group);
  as_held_->setObjectName("as_held");
  column->addWidget(as_held_);
  held_text_ = wrapped_label("faint", group);
  column->addWidget(held_text_);
  results_ = new ResectionResults(group);
  column->addWidget(results_);
  auto* apart_name = new QLabel(group);
  apart_ = new QSlider(Qt::Horizontal, group);
  apart_->setObjectName("apart");
  apart_->setRange(0, farthest_apart_mm);
  apart_name->setBuddy(apart_);
  auto* row = new QHBoxLayout;
  row->addWidget(apart_name);
  row->addWidget(apart_, 1);
  column->addLayout(row);
  other_part_ = named_button("other_part", group);
  no_cut_ = named_button("no_cut", group);
  auto* choices = new QHBoxLayout;
  choices->addWidget(other_part_);
  choices->addWidget(no_cut_);
  column->addLayout(choices);
  connect(apart_, &QSlider::valueChanged, this, [this](int apart_mm) {
    pieces_.draw_apart(context_.views.space().view(), apart_mm);
    context_.views.space().redraw();
  });
  connect(as_held_, &QCheckBox::toggled, this, &ResectPanel::hold_as_rehearsed);
  connect(&context_.rehearsal, &LiveRehearsal::state_changed, this, &ResectPanel::hold_as_rehearsed);
  connect(other_part_, &QPushButton::clicked, this, [this] {
    removed_ = removed_ == Removed::smaller ? Removed::larger : Removed::smaller;
    cut_changed();
    note();
  });
  connect(no_cut_, &QPushButton::clicked, this, [this] {
    plane_.reset();
    points_mm_.clear();
    clicks_mm_.clear();
    note();
    by_anatomy_->clear();
    cut_changed();
  });
  keep_translated(group, [=, this] {
    as_held_->setText(tr("On the liver as the tool holds it"));
    held_text_->setText(tr("The cut lies on the liver held aside; the slices show the scan, at rest."));
    describe_holding();
    apart_name->setText(tr("Separation"));
    apart_->setToolTip(tr("Draws the part that is removed away from the rest"));
    other_part_->setText(tr("Remove the other part"));
    no_cut_->setText(tr("No cut"));
  });
  return group;
}

void ResectPanel::show_patient(const Patient& patient) {
  const bool other = patient.folder != patient_.folder || patient.name != patient_.name;
  patient_ = patient;
  missing_->setVisible(!patient.rehearsal);
  controls_->setVisible(patient.rehearsal != nullptr);
  live_->set_patient(patient);
  by_anatomy_->show_patient(patient);
  hold_as_rehearsed();
  if (other) {
    take_up_kept_plan();
    noted_ = value_of(surface());
  }
  cut_changed();
}

void ResectPanel::take_up_kept_plan() {
  plane_.reset();
  points_mm_.clear();
  clicks_mm_.clear();
  drawn_plane_.reset();
  removed_ = Removed::smaller;
  cut_controls_->choose(CutControls::plane_cut);
  if (patient_.folder.empty() || !patient_.rehearsal) return;
  const auto kept = casefile::read_planned_cut(folder_of_plan(patient_));
  // A cut through a liver that was held aside means nothing at rest.
  if (!kept || (kept->liver == casefile::PlannedCut::Liver::held_aside && !live_->holding())) return;
  removed_ = kept->removed;
  points_mm_ = kept->through_mm;
  if (points_mm_.empty()) {
    plane_ = plane_through(kept->point_mm, kept->normal);
  } else {
    cut_controls_->choose(CutControls::sheet_cut);
  }
}

void ResectPanel::choose(const planning::Plan& plan) {
  const QJsonValue surface_before = noted_, taken_before = value_of(by_anatomy_->taken());
  by_anatomy_->take_up(plan);
  take_up(plan);
  last_noted_ = By::hand;
  context_.undo.values_changed({GLISSON_TEXT("Choose the plan {0}"), {plan.name}},
                               {{surface_key, surface_before, noted_},
                                {PlanByAnatomy::taken_key, taken_before, value_of(by_anatomy_->taken())}});
}

void ResectPanel::take_up(const planning::Plan& plan) {
  plane_.reset();
  points_mm_.clear();
  clicks_mm_.clear();
  cut_controls_->choose(CutControls::plane_cut);
  for (const planning::Cut& cut : plan.cuts) {
    if (const auto* plane = std::get_if<planning::PlaneCut>(&cut)) {
      plane_ = plane_through(plane->point_mm, plane->normal);
      removed_ = plane->removed == planning::Removed::larger ? Removed::larger : Removed::smaller;
    } else if (const auto* sheet = std::get_if<planning::SheetCut>(&cut)) {
      cut_controls_->choose(CutControls::sheet_cut);
      points_mm_ = sheet->through_mm;
      removed_ = sheet->removed == planning::Removed::larger ? Removed::larger : Removed::smaller;
    }
  }
  noted_ = value_of(surface());
  cut_changed();
}

void ResectPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  handles_->set_active(true);
  hold_as_rehearsed();
  cut_changed();
  show_scene();
}

void ResectPanel::hideEvent(QHideEvent* event) {
  cut_controls_->stop_drawing();
  handles_->set_active(false);
  context_.patient_views.set_workspace_scene({});
  QWidget::hideEvent(event);
}

CutPlane ResectPanel::plane_through(const Vector3d& place_mm, const Vector3d& normal) const {
  CutPlane plane{geometry::bounding_box(patient_.structures.front().surface->points_mm).center_mm(), 0, 0, 0};
  plane.put(place_mm, normal);
  return plane;
}

void ResectPanel::take_click(const Vector3d& position_mm) {
  if (patient_.structures.empty()) return;
  if (!cut_controls_->by_clicks()) {
    auto more_mm = points_mm_;
    more_mm.push_back(position_mm);
    set_points(std::move(more_mm));
    return;
  }
  clicks_mm_.push_back(position_mm);
  if (clicks_mm_.size() == 3) {
    const Vector3d first_mm = clicks_mm_[0], along_mm = clicks_mm_[1] - first_mm, aside_mm = clicks_mm_[2] - first_mm;
    const Vector3d normal = along_mm.cross(aside_mm);
    constexpr double narrowest = 0.02;  // sine of the angle between them
    if (normal.norm() < narrowest * along_mm.norm() * aside_mm.norm()) {
      clicks_mm_.clear();
      context_.tell_status(tr("The three places lie almost on one line. Click three others."));
    } else {
      plane_ = plane_through(first_mm, normal);
      cut_controls_->stop_drawing();
      note();
    }
  }
  cut_changed();
}

// In the place of the points that were set.
void ResectPanel::cut_under(const std::vector<planning::SightLine>& line) {
  if (patient_.structures.empty()) return;
  auto sheet = planning::sheet_under(*patient_.structures.front().surface, line);
  if (!sheet) return context_.tell_status(translated(sheet.error()));  // to be drawn again
  cut_controls_->stop_drawing();
  set_points(std::move(sheet->through_mm));
}

void ResectPanel::move_plane(const CutPlane& plane) {
  plane_ = plane;
  cut_changed();
}

void ResectPanel::set_points(std::vector<Vector3d> points_mm) {
  points_mm_ = std::move(points_mm);
  cut_changed();
  note();
}

std::vector<planning::Cut> ResectPanel::surface() const {
  const auto removed = removed_ == Removed::larger ? planning::Removed::larger : planning::Removed::smaller;
  std::vector<planning::Cut> set;
  if (cut_controls_->kind() == CutControls::sheet_cut) {
    if (!points_mm_.empty()) set.emplace_back(planning::SheetCut{points_mm_, removed});
  } else if (plane_) {
    set.emplace_back(planning::PlaneCut{plane_->point_mm(), plane_->normal(), removed});
  }
  return set;
}

void ResectPanel::note(By by) {
  const QJsonValue before = noted_;
  noted_ = value_of(surface());
  const bool goes_on = by == By::typing && last_noted_ == By::typing;
  last_noted_ = by;
  context_.undo.value_changed(step_between(before, noted_), surface_key, before, noted_,
                              goes_on ? Undo::Joins::with_same : Undo::Joins::never);
}

void ResectPanel::set_drawing(bool drawing) {
  clicks_mm_.clear();
  handles_->set_drawing(drawing && !cut_controls_->freehand());
  handles_->set_freehand(cut_controls_->freehand());
  if (drawing) apart_->setValue(0);
  context_.tell_status(!drawing                    ? QString()
                       : cut_controls_->freehand() ? tr("Draw a line over the liver in the 3D view.")
                       : cut_controls_->by_clicks()
                           ? tr("Click three places on the liver or in the slices.")
                           : tr("Click on the liver or in the slices where the cut is to pass."));
  cut_changed();
}

std::optional<casefile::PlannedCut> ResectPanel::cut() const {
  casefile::PlannedCut cut;
  cut.removed = removed_;
  if (live_->holding()) cut.liver = casefile::PlannedCut::Liver::held_aside;
  if (cut_controls_->kind() == CutControls::sheet_cut) {
    if (points_mm_.size() < 3) return {};
    cut.through_mm = points_mm_;
  } else {
    if (!plane_ || cut_controls_->by_clicks()) return {};
    cut.point_mm = plane_->point_mm();
    cut.normal = plane_->normal();
  }
  return cut;
}

std::optional<casefile::PlannedCut> ResectPanel::cut_of_mesh() const {
  return by_anatomy_->taken().empty() ? cut() : std::nullopt;
}

std::optional<LiveResection::Holding> ResectPanel::holding() const {
  const LiveRehearsal& rehearsal = context_.rehearsal;
  const auto& state = rehearsal.state();
  const bool at_once = rehearsal.touch() == Touch::patch && rehearsal.deformations() == Deformations::small;
  if (!state || !state->validity.usable() || !at_once || !rehearsal.has_tool()) return {};
  const PlacedTool& tool = rehearsal.tools().back();
  return LiveResection::Holding{tool.center_mm, tool.radius_mm, state->force_N};
}

void ResectPanel::hold_as_rehearsed() {
  const auto held = holding();
  as_held_->setEnabled(held.has_value());
  describe_holding();
  const auto wanted = as_held_->isChecked() ? held : std::nullopt;
  held_text_->setVisible(wanted.has_value());
  if (wanted == live_->holding()) return;
  live_->set_holding(wanted);
  if (isVisible()) cut_changed();
}

void ResectPanel::describe_holding() {
  as_held_->setToolTip(
      holding()
          ? tr("Margins, widths and places are those on the liver under the tool of Rehearse; volumes are at rest")
          : tr("Place a tool in Rehearse first: a patch at small deformations that the model bears, not a rigid "
               "tool."));
}

void ResectPanel::cut_changed() {
  const bool by_plane = cut_controls_->kind() == CutControls::plane_cut;
  const auto shown = by_plane && !cut_controls_->by_clicks() ? plane_ : std::nullopt;
  handles_->set_plane(shown);
  handles_->set_points(by_plane ? clicks_mm_ : points_mm_);
  move_drawn_plane();
  live_->set_cut(cut_of_mesh());
  by_anatomy_->set_surface(cut());
  update_text();
  if (!live_->result() || !drawn_plane_ || !shown) show_scene();
  context_.views.redraw();
}

}  // namespace glisson::widgets
