// How the window's parts hear of each other.

#include "widgets/main_window.h"
#include "widgets/rehearse/planned_course.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

void MainWindow::connect_parts() {
  connect_work();
  connect_case();
  connect_rehearsal();
}

void MainWindow::connect_work() {
  connect(&work_, &BackgroundWork::started, this, [this](const QString& title) {
    changing_ = title == last_change_ ? title : QString();
    diary_.note("Long work began.");
  });
  connect(&work_, &BackgroundWork::progressed, this, [this](double fraction, const QString& stage) {
    if (!stage.isEmpty())
      welcome_->show_stage(tr("%1 (%2 %)").arg(translated_stage(stage)).arg(100 * fraction, 0, 'f', 0));
  });
  connect(&work_, &BackgroundWork::finished, this, [this] {
    changing_.clear();
    welcome_->show_stage({});
    diary_.note("Long work ended.", status_->work_ms());
  });
  connect(&work_, &BackgroundWork::refused, this, [this] {
    notices_->note([] { return tr("Something else is still under way. Wait for it, or cancel it first."); });
  });
  connect(&work_, &BackgroundWork::broke, this, [this](const QString& what) {
    diary_.note_defect();
    notices_->say([what] { return tr("A defect in Glisson stopped this: %1").arg(what); });
  });
  connect(&stalls_, &StallWatch::stood_still, this, [this](double ms) { diary_.note_stall(ms); });
  connect(&work_, &BackgroundWork::started, this, [this] { undo_.set_held_up(true); });
  connect(&work_, &BackgroundWork::finished, this, [this] { undo_.set_held_up(false); });
}

void MainWindow::connect_case() {
  connect(&hold_, &CaseHold::changed, this, [this] {
    undo_.refuse(hold_.refusal());
    if (hold_.refusal()) show_error(*hold_.refusal());
  });
  connect(tour_, &TourCard::arrived, this, &MainWindow::go_to);
  connect(next_step_, &NextStepBox::wanted, this, &MainWindow::take_next_step);
  connect(next_step_, &NextStepBox::waves_wanted, this, &MainWindow::show_waves);
  connect(&undo_, &Undo::failed, this, &MainWindow::show_error);
  connect(&undo_, &Undo::moved, this, [this](const QString& what) { status_->say(what); });
  connect(&undo_, &Undo::entries_moved, this, &MainWindow::show_moved_entries);
  connect(bar_, &WorkspaceBar::chosen, this, [this](int index) {
    const Workspace& workspace = workspaces_.at(static_cast<std::size_t>(index));
    const bool whole = workspace.place == Workspace::Place::whole_window;
    if (whole) {
      pages_->setCurrentWidget(workspace.widget);
    } else {
      pages_->setCurrentIndex(0);
      panels_->setCurrentWidget(workspace.widget);
    }
    notices_->set_origin_shown(workspace.id != "register");  // its sequence has an origin of its own
    keep_open_work();
  });
  connect(study_panel_, &StudyPanel::slice_image_chosen, patient_views_, &PatientViews::set_slice_image);
  connect(study_panel_, &StudyPanel::structure_shown, patient_views_, &PatientViews::set_structure_shown);
  connect(views_, &LinkedViews::picture_not_saved, this, [this](const QString& file) {
    notices_->say([file] { return tr("The picture could not be written to %1.").arg(file); });
  });
}

void MainWindow::connect_rehearsal() {
  connect(rehearse_panel_, &RehearsePanel::bodies_chosen, patient_views_, &PatientViews::set_bodies);
  connect(rehearse_panel_, &RehearsePanel::liver_colour_chosen, patient_views_, &PatientViews::set_liver_colour);
  connect(rehearse_panel_, &RehearsePanel::landmark_chosen, patient_views_, &PatientViews::set_marked_landmark);
  connect(rehearse_panel_, &RehearsePanel::placing_changed, this, [this](bool placing) {
    views_->space().setCursor(placing ? Qt::CrossCursor : Qt::ArrowCursor);
    status_->say(placing ? tr("Click on the liver where the tool is to touch it.") : QString());
  });
  const auto place_tool = [this](const std::optional<PatientViews::PlaceOnLiver>& place) {
    if (place) rehearse_panel_->place_at(place->at_rest_mm, place->outward);
  };
  for (SpaceView* space : {&views_->space(), &views_->second_space()}) {
    connect(space, &SpaceView::clicked, this, [this, place_tool](const scene::View::Pick& pick) {
      if (rehearse_panel_->placing()) {
        place_tool(patient_views_->place_on_liver(pick));
      } else {
        views_->set_crosshair(pick.position_mm);
      }
    });
    connect(space, &SpaceView::touch_dragged, this,
            [this, place_tool](const scene::View::Pick& over) { place_tool(patient_views_->place_on_liver(over)); });
    connect(space, &SpaceView::free_end_dragged, rehearse_panel_, &RehearsePanel::drag_arrow);
    connect(space, &SpaceView::grip_released, rehearse_panel_, &RehearsePanel::let_arrow_go);
  }
  connect(rehearse_panel_, &RehearsePanel::place_at_crosshair, this,
          [this, place_tool] { place_tool(patient_views_->nearest_on_liver(views_->crosshair_mm())); });
  connect(rehearse_panel_, &RehearsePanel::landmark_wanted, this, [this](const std::string& name) {
    std::vector<mechanics::Landmark> landmarks = landmarks_;
    landmarks.push_back({name, views_->crosshair_mm()});
    keep_landmarks(tr("Set landmark"), landmarks);
  });
  connect(rehearse_panel_, &RehearsePanel::landmarks_wanted, this, &MainWindow::keep_landmarks);
  connect(rehearse_panel_, &RehearsePanel::at_work, patient_views_, &PatientViews::set_tool_movable);
  connect(rehearse_panel_, &RehearsePanel::at_work, this, [this](bool here) {
    if (!here) return;
    std::vector<std::string> names;
    for (const PatientStructure& structure : patient_.structures) names.push_back(structure.name);
    const PlannedCourse plan = planned_course(patient_);
    rehearse_panel_->show_plan(plan.course, plan.why_not, std::move(names));
  });
  connect(rehearse_panel_, &RehearsePanel::failed, this, &MainWindow::show_error);
  connect(rehearse_panel_, &RehearsePanel::said, status_, &StatusLine::say);
  rehearse_panel_->track().set_camera([this] { return views_->space().picture(); });
  connect(&rehearsal_, &LiveRehearsal::frame_changed, this, &MainWindow::show_frame);
  connect(&rehearsal_, &LiveRehearsal::placed, this,
          [this](double solve_ms) { status_->say(tr("Tool placed in %1 ms.").arg(solve_ms, 0, 'f', 0)); });
}

}  // namespace glisson::widgets
