// How the window's parts hear of each other.

#include "widgets/main_window.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

void MainWindow::connect_parts() {
  connect_work();
  connect_case();
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

}  // namespace glisson::widgets
