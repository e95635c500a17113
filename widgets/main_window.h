#pragma once
// The window: workspaces along the top. Those about the patient have the patient on the left, four views in the middle
// and their own panel on the right. The others fill the window.

#include <filesystem>
#include <functional>
#include <QMainWindow>
#include <QStackedWidget>
#include <vector>

#include "widgets/diary/diary.h"
#include "widgets/diary/stall_watch.h"
#include "widgets/help/manual_window.h"
#include "widgets/help/tour.h"
#include "widgets/panels/export_menu.h"
#include "widgets/panels/next_step_box.h"
#include "widgets/panels/notices.h"
#include "widgets/panels/status_line.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/welcome_page.h"
#include "widgets/rehearse/rehearse_panel.h"
#include "widgets/session/case_hold.h"
#include "widgets/session/live_rehearsal.h"
#include "widgets/session/load_patient.h"
#include "widgets/session/open_work.h"
#include "widgets/session/patient.h"
#include "widgets/session/rehearsal_undo.h"
#include "widgets/session/undo.h"
#include "widgets/views/linked_views.h"
#include "widgets/views/patient_views.h"
#include "widgets/views/view_bar.h"
#include "widgets/words/translated.h"
#include "widgets/work/background_work.h"
#include "widgets/workspaces/workspace_bar.h"

namespace glisson::widgets {

class StudyPage;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  // A case folder, or anything that holds images; what it is decides what happens.
  void open_path(const std::filesystem::path& path);
  void open_demo() {
    open_demo_then([this] { rehearse_panel_->hoist_segment_vi(); });
  }
  void show_patient(const Patient& patient);

  // Opens the demo patient unless it is open, then walks through the workspaces.
  void take_tour();
  [[nodiscard]] TourCard& tour() { return *tour_; }
  // "rehearse", ...; see workspaces/workspace.h.
  void go_to(const QString& workspace_id);
  [[nodiscard]] QString workspace() const;

  [[nodiscard]] LinkedViews& views() { return *views_; }
  [[nodiscard]] LiveRehearsal& rehearsal() { return rehearsal_; }
  [[nodiscard]] BackgroundWork& work() { return work_; }
  [[nodiscard]] Undo& undo() { return undo_; }
  [[nodiscard]] const Diary& diary() const { return diary_; }
  [[nodiscard]] StallWatch& stalls() { return stalls_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void make_workspaces();
  void add_workspace(Workspace workspace);
  [[nodiscard]] WorkspaceContext context();
  void make_menus();
  QWidget* make_centre();
  void connect_parts();
  void connect_work();
  void connect_case();

  void choose_case();
  void choose_study();
  void choose_labels();
  void close_case();
  void save_picture();
  void show_manual();
  void show_diary();
  void start_tour();
  void begin_instead(const std::function<void()>& begin);
  void list_recent(QMenu& menu);
  void offer_lost_work();
  void open_lost_work();
  void keep_open_work();
  void allow_for_case();
  void show_waves();
  void about();

  void open_demo_then(std::function<void()> once_shown);
  // Loads a patient on a worker thread, then shows it or says what went wrong.
  using Loader = std::function<Result<Patient>(const Progress&, const FirstLook&)>;
  void load(const QString& title, Loader loader, std::function<void()> once_shown = {});
  // The same for work that changes the case: one step of undo.
  void change(const QString& title, std::function<Result<Patient>(const Progress&)> loader,
              std::function<void()> once_shown = {});
  void show_moved_entries(const QStringList& ids);
  void take_next_step(NextStep step);
  void keep_landmarks(const QString& what, const std::vector<mechanics::Landmark>& landmarks);
  void show_error(const Error& error);
  [[nodiscard]] bool may_change();  // or says why not
  [[nodiscard]] bool asked_to_give_up();
  void update_patient_text();

  Diary diary_;
  StallWatch stalls_;
  OpenWorkFile open_work_;
  std::optional<OpenWork> lost_work_;   // what a window before this one left open
  std::function<void()> next_of_tour_;  // waits for what it takes the place of
  Patient patient_;
  std::vector<mechanics::Landmark> landmarks_;  // set by hand on the patient
  CaseHold hold_;
  LiveRehearsal rehearsal_;
  Undo undo_;
  RehearsalUndo rehearsal_undo_{rehearsal_, undo_};
  BackgroundWork work_;
  QString last_change_;  // the title of work that changes the case, begun or waiting
  QString changing_;     // the same while it is under way
  LinkedViews* views_ = nullptr;
  MeasureTool* measure_ = nullptr;
  ViewBar* view_bar_ = nullptr;
  QWidget* viewing_ = nullptr;  // the views with what belongs to them
  PatientViews* patient_views_ = nullptr;
  StudyPanel* study_panel_ = nullptr;
  StudyPage* study_page_ = nullptr;
  RehearsePanel* rehearse_panel_ = nullptr;
  ManualWindow* manual_ = nullptr;  // from the first time that it is asked for
  WorkspaceBar* bar_ = nullptr;
  std::vector<Workspace> workspaces_;
  QStackedWidget* pages_ = nullptr;   // the patient with the views first
  QStackedWidget* panels_ = nullptr;  // to the right of the views
  TourCard* tour_ = nullptr;
  QMenu* go_menu_ = nullptr;
  Notices* notices_ = nullptr;
  WelcomePage* welcome_ = nullptr;
  NextStepBox* next_step_ = nullptr;
  StatusLine* status_ = nullptr;
  ExportMenu* export_ = nullptr;
  QAction* add_labels_ = nullptr;
  QAction* close_case_ = nullptr;
  QAction* save_picture_ = nullptr;
  QAction* show_waves_ = nullptr;
};

}  // namespace glisson::widgets
