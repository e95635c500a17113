#include "widgets/main_window.h"

#include <algorithm>
#include <cmath>
#include <QCloseEvent>
#include <QDropEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QSplitter>
#include <QStackedLayout>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

#include "base/files.h"
#include "base/result.h"
#include "widgets/evidence/evidence_view.h"
#include "widgets/hardware/platform_view.h"
#include "widgets/model/model_panel.h"
#include "widgets/register/register_page.h"
#include "widgets/report/report_view.h"
#include "widgets/resect/resect_panel.h"
#include "widgets/segment/segment_panel.h"
#include "widgets/session/load_patient.h"
#include "widgets/session/placed_landmarks.h"
#include "widgets/settings/settings.h"
#include "widgets/settings/window_place.h"
#include "widgets/study/study_page.h"
#include "widgets/views/measure_list.h"
#include "widgets/views/wave_view.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/named.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

QString diary_file() {
  std::error_code problem;
  fs::create_directories(own_folder(), problem);
  return text_of(own_folder() / "glisson.log");
}

// The demo patient has its name however it was opened, and whatever was done to it.
Patient named(Patient patient) {
  if (patient.folder == own_folder() / "demo" / "demo.glisson") patient.name = demo_patient_name;
  return patient;
}

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), diary_(diary_file()), open_work_(own_folder() / "open") {
  setAcceptDrops(true);
  new WindowPlace(*this, {1600, 1000});
  study_panel_ = new StudyPanel;
  auto* left = new QWidget;
  auto* left_column = new QVBoxLayout(left);
  left_column->setContentsMargins(0, 0, 0, 0);
  left_column->setSpacing(0);
  left_column->addWidget(study_panel_, 1);
  next_step_ = new NextStepBox;
  left_column->addWidget(next_step_);
  panels_ = new QStackedWidget;
  auto* across = new QSplitter(Qt::Horizontal);
  across->addWidget(left);
  across->addWidget(make_centre());
  across->addWidget(panels_);
  across->setStretchFactor(1, 1);
  across->setSizes({250, 940, 410});
  across->setChildrenCollapsible(false);
  pages_ = new QStackedWidget;
  pages_->addWidget(across);
  bar_ = new WorkspaceBar;
  auto* whole = new QWidget;
  auto* rows = new QVBoxLayout(whole);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(bar_);
  notices_ = new Notices;
  rows->addWidget(notices_);
  rows->addWidget(pages_, 1);
  notices_->float_over(*pages_);
  tour_ = new TourCard;
  rows->addWidget(tour_);
  setCentralWidget(whole);
  patient_views_ = new PatientViews(*views_, this);
  make_menus();
  status_ = new StatusLine(work_);
  setStatusBar(status_);
  make_workspaces();
  connect_parts();
  go_to("rehearse");
  offer_lost_work();
  diary_.note("The window is made.");
  keep_translated(this, [this] {
    word_patient();
    patient_views_->reword();
    QTimer::singleShot(0, this, [this] { name_controls(*this); });  // once all of it has its words
  });
}

// Workspaces, and the windows that they opened, go before what they share, and after the work that they began; going,
// they tell this window nothing more.
MainWindow::~MainWindow() {
  hide();
  work_.end();
  for (const QObject* part : findChildren<QObject*>()) part->disconnect(this);
  qDeleteAll(findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
}

// In the order of the work, research last.
void MainWindow::make_workspaces() {
  add_workspace(StudyPage::workspace(context()));
  study_page_ = findChild<StudyPage*>();
  add_workspace(SegmentPanel::workspace(context()));
  add_workspace(ModelPanel::workspace(context()));
  rehearse_panel_ = new RehearsePanel(rehearsal_);
  add_workspace({.id = "rehearse",
                 .name = [] { return tr("Rehearse"); },
                 .about = [] { return tr("Pull with a tool, and see what moves and how far."); },
                 .widget = rehearse_panel_,
                 .show_patient =
                     [this](const Patient& patient) {
                       rehearse_panel_->set_ready(patient.rehearsal != nullptr);
                       rehearse_panel_->show_image(patient.anatomy);
                       rehearse_panel_->show_evidence(patient.evidence);
                       rehearse_panel_->show_assumed_stiffness(patient.assumed_stiffness);
                     },
                 .missing = model_missing});
  add_workspace(ResectPanel::workspace(context()));
  QWidget* platforms = PlatformView::shipped();
  add_workspace(ReportView::workspace(context(), [view = qobject_cast<PlatformView*>(platforms)] {
    return view != nullptr ? view->plan() : std::nullopt;
  }));
  add_workspace(RegisterPage::workspace(context()));
  add_workspace({.id = "platform",
                 .name = [] { return tr("Platform"); },
                 .about = [] { return tr("Find what can be worn for this case."); },
                 .widget = platforms,
                 .place = Workspace::Place::whole_window,
                 .group = Workspace::Group::research,
                 .show_patient =
                     [view = qobject_cast<PlatformView*>(platforms)](const Patient& patient) {
                       if (view == nullptr || patient.name.empty()) return;
                       const PatientStructure* liver = patient.liver();
                       view->show_case(QString::fromStdString(patient.name), liver != nullptr ? liver->volume_ml : 0,
                                       patient.mean_youngs_kPa, patient.assumed_stiffness.has_value());
                     }});
  add_workspace(EvidenceView::workspace(context()));
}

void MainWindow::add_workspace(Workspace workspace) {
  const int index = static_cast<int>(workspaces_.size());
  (workspace.place == Workspace::Place::whole_window ? pages_ : panels_)->addWidget(workspace.widget);
  bar_->add(workspace);
  QAction* go = go_menu_->addAction({}, QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + index)), bar_,
                                    [this, index] { bar_->choose(index); });
  keep_translated(go_menu_, [go, name = workspace.name] { go->setText(name()); });
  workspaces_.push_back(std::move(workspace));
}

void MainWindow::go_to(const QString& workspace_id) {
  const auto found = std::find_if(workspaces_.begin(), workspaces_.end(),
                                  [&](const Workspace& workspace) { return workspace.id == workspace_id; });
  GLISSON_ASSERT(found != workspaces_.end());
  bar_->choose(static_cast<int>(found - workspaces_.begin()));
}

QString MainWindow::workspace() const { return workspaces_.at(static_cast<std::size_t>(bar_->current())).id; }

WorkspaceContext MainWindow::context() {
  return {
      .work = work_,
      .views = *views_,
      .patient_views = *patient_views_,
      .rehearsal = rehearsal_,
      .undo = undo_,
      .patient = [this]() -> const Patient& { return patient_; },
      .change = [this](const QString& title, auto loader) { change(title, std::move(loader)); },
      .open =
          [this](const QString& title, auto loader) {
            load(title, [loader = std::move(loader)](const Progress& progress, const FirstLook& /*first_look*/) {
              return loader(progress);
            });
          },
      .may_change = [this] { return may_change(); },
      .tell_error = [this](const Error& error) { show_error(error); },
      .tell_status = [this](const QString& text) { status_->say(text); },
      .go_to = [this](const QString& workspace_id) { go_to(workspace_id); },
      .list_structures = [this](const auto& drawn) { study_panel_->list(drawn ? *drawn : patient_.all_structures()); }};
}

void MainWindow::open_path(const fs::path& opened) {
  // A file manager hands over the file that stands for the case.
  const fs::path path = opened.filename() == "case.json" ? opened.parent_path() : opened;
  if (kind_of(path) == OpenedThing::case_folder) {
    load(tr("Opening %1").arg(text_of(path.filename())), [path](const Progress& progress, const FirstLook& first_look) {
      return load_patient(path, progress, first_look);
    });
    return;
  }
  go_to("study");
  study_page_->browse(path);
}

void MainWindow::open_demo_then(std::function<void()> once_shown) {
  const fs::path folder = own_folder() / "demo";
  load(
      tr("Opening the demo patient"),
      [folder](const Progress& progress, const FirstLook& first_look) -> Result<Patient> {
        std::error_code problem;
        fs::create_directories(folder, problem);
        return load_demo(folder, progress, first_look);
      },
      std::move(once_shown));
}

void MainWindow::show_patient(const Patient& patient) {
  if (patient.folder != patient_.folder || patient.name != patient_.name) measure_->clear();
  const bool same_case = !patient.folder.empty() && patient.folder == patient_.folder;
  patient_ = patient;
  welcome_->hide();
  viewing_->show();
  notices_->close_notice();
  notices_->show_origin(patient.origin);
  if (!patient.remarks.empty()) {
    notices_->note([remarks = patient.remarks] {
      QStringList sentences;
      for (const Sentence& remark : remarks) sentences << translated(remark);
      return sentences.join(" ");
    });
  }
  hold_.take(patient.folder);
  study_panel_->show_patient(patient);
  view_bar_->show_patient(patient);
  patient_views_->show_patient(patient);
  landmarks_ = kept_landmarks(patient.folder);
  rehearse_panel_->show_placed_landmarks(landmarks_);
  if (same_case) {
    rehearsal_.exchange_body(patient.rehearsal, patient.rehearsal_setup);
  } else {
    rehearsal_.set_body(patient.rehearsal, patient.rehearsal_setup);
  }
  rehearsal_undo_.begin();
  undo_.refuse(hold_.refusal());
  undo_.open_case(hold_.refusal() ? fs::path() : patient.folder);
  for (const Workspace& workspace : workspaces_) workspace.show_patient(patient);
  bar_->show_patient(patient);
  allow_for_case();
  next_step_->show_case(patient.folder);
  word_patient();
  if (!patient.folder.empty()) remember_case(patient.folder);
  keep_open_work();
  diary_.note("A patient is shown.");
}

// What of the menu has something to do.
void MainWindow::allow_for_case() {
  const bool has_case = !patient_.folder.empty();
  save_picture_->setEnabled(!viewing_->isHidden());
  show_waves_->setEnabled(has_case && WaveView::has_waves(patient_.folder));
  add_labels_->setEnabled(has_case);
  export_->setEnabled(has_case);
  close_case_->setEnabled(has_case);
}

void MainWindow::word_patient() {
  setWindowTitle(patient_.name.empty() ? tr("Glisson") : tr("%1 - Glisson").arg(patient_label(patient_.name)));
}

QWidget* MainWindow::make_centre() {
  auto* centre = new QWidget;
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);

  views_ = new LinkedViews;
  auto* measure = new MeasureTool(*views_, this);
  view_bar_ = new ViewBar(*views_, *measure);
  auto* viewing = new QWidget;
  auto* viewed = new QVBoxLayout(viewing);
  viewed->setContentsMargins(0, 0, 0, 0);
  viewed->setSpacing(0);
  viewed->addWidget(view_bar_);
  viewed->addWidget(views_, 1);
  viewed->addWidget(new MeasureList(*measure, *views_));
  viewing_ = viewing;
  measure_ = measure;
  viewing_->hide();
  column->addWidget(viewing_, 1);

  welcome_ = new WelcomePage;
  connect(welcome_, &WelcomePage::demo_wanted, this, &MainWindow::open_demo);
  connect(welcome_, &WelcomePage::case_wanted, this, &MainWindow::choose_case);
  connect(welcome_, &WelcomePage::images_wanted, this, &MainWindow::choose_study);
  connect(welcome_, &WelcomePage::recent_wanted, this, &MainWindow::open_path);
  connect(welcome_, &WelcomePage::lost_wanted, this, &MainWindow::open_lost_work);
  column->addWidget(welcome_, 1);
  return centre;
}

void MainWindow::connect_parts() {
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
  connect(&hold_, &CaseHold::changed, this, [this] {
    undo_.refuse(hold_.refusal());
    if (hold_.refusal()) show_error(*hold_.refusal());
  });
  connect(&work_, &BackgroundWork::broke, this, [this](const QString& what) {
    diary_.note_defect();
    notices_->say([what] { return tr("A defect in Glisson stopped this: %1").arg(what); });
  });
  connect(tour_, &TourCard::arrived, this, &MainWindow::go_to);
  connect(&stalls_, &StallWatch::stood_still, this, [this](double ms) { diary_.note_stall(ms); });
  connect(next_step_, &NextStepBox::wanted, this, &MainWindow::take_next_step);
  connect(next_step_, &NextStepBox::waves_wanted, this, &MainWindow::show_waves);
  connect(&work_, &BackgroundWork::started, this, [this] { undo_.set_held_up(true); });
  connect(&work_, &BackgroundWork::finished, this, [this] { undo_.set_held_up(false); });
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
  for (SpaceView* space : {&views_->space(), &views_->twin()}) {
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
  connect(rehearse_panel_, &RehearsePanel::failed, this, &MainWindow::show_error);
  connect(rehearse_panel_, &RehearsePanel::said, status_, &StatusLine::say);
  connect(views_, &LinkedViews::picture_not_saved, this, [this](const QString& file) {
    notices_->say([file] { return tr("The picture could not be written to %1.").arg(file); });
  });
  rehearse_panel_->track().set_camera([this] { return views_->space().picture(); });
  connect(&rehearsal_, &LiveRehearsal::frame_changed, this, &MainWindow::show_frame);
  connect(&rehearsal_, &LiveRehearsal::placed, this,
          [this](double solve_ms) { status_->say(tr("Tool placed in %1 ms.").arg(solve_ms, 0, 'f', 0)); });
}

void MainWindow::close_case() {
  if (work_.busy()) {
    notices_->note([] { return tr("Something else is still under way. Wait for it, or cancel it first."); });
    return;
  }
  show_patient({});
  viewing_->hide();
  welcome_->show();
  allow_for_case();
  open_work_.forget();
  diary_.note("The case is closed.");
}

void MainWindow::offer_lost_work() {
  lost_work_ = open_work_.take_lost();
  if (lost_work_) welcome_->offer_lost(lost_work_->case_folder);
}

void MainWindow::open_lost_work() {
  const OpenWork work = *lost_work_;
  load(
      tr("Opening %1").arg(text_of(work.case_folder.filename())),
      [folder = work.case_folder](const Progress& progress, const FirstLook& first_look) {
        return load_patient(folder, progress, first_look);
      },
      [this, work] {
        for (const Workspace& workspace : workspaces_) {
          if (workspace.id.toStdString() == work.workspace) go_to(workspace.id);
        }
        if (work.tool && patient_.rehearsal) {
          rehearse_panel_->hold_again({.preset = {},
                                       .center_mm = work.tool->center_mm,
                                       .outward = -work.tool->direction,
                                       .radius_mm = work.tool->radius_mm,
                                       .direction = work.tool->direction,
                                       .force_N = work.tool->force_N});
        }
      });
}

void MainWindow::keep_open_work() {
  if (patient_.folder.empty()) return;
  OpenWork work{.case_folder = patient_.folder, .workspace = workspace().toStdString(), .tool = {}};
  if (rehearsal_.has_tool()) {
    const PlacedTool& tool = rehearsal_.tools().back();
    work.tool = {tool.center_mm, tool.radius_mm, tool.force_N, tool.direction};
  }
  if (const auto kept = open_work_.keep(work); !kept) diary_.note(kept.error());
}

void MainWindow::show_waves() {
  auto* view = new WaveView(patient_.folder, this);
  view->setWindowFlag(Qt::Window);
  view->setAttribute(Qt::WA_DeleteOnClose);
  view->set_guard([this] { return may_change(); });
  connect(view, &WaveView::accepted, this, [this] { open_path(patient_.folder); });
  view->show();
  view->invert();
}

void MainWindow::load(const QString& title, Loader loader, std::function<void()> once_shown) {
  if (patient_.preparing && work_.busy()) {  // a model that nobody will use: what is asked for now comes instead
    constexpr auto once_later = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    connect(
        &work_, &BackgroundWork::finished, this,
        [this, title, loader = std::move(loader), once_shown = std::move(once_shown)] {
          load(title, loader, once_shown);
        },
        once_later);
    work_.cancel();
    return;
  }
  work_.start(title, [this, loader = std::move(loader), once_shown = std::move(once_shown)](const Progress& progress) {
    const FirstLook first_look = [this](const Patient& patient) {
      QMetaObject::invokeMethod(
          this, [this, patient] { show_patient(named(patient)); }, Qt::QueuedConnection);
    };
    auto patient = std::make_shared<Result<Patient>>(loader(progress, first_look));
    return BackgroundWork::Then([this, patient, once_shown] {
      if (!*patient) {
        if (patient_.preparing) {  // shown, and its model will not come
          Patient without_model = patient_;
          without_model.preparing = false;
          show_patient(without_model);
        }
        show_error(patient->error());
        return;
      }
      show_patient(named(**patient));
      if (once_shown) once_shown();
    });
  });
}

void MainWindow::change(const QString& title, std::function<Result<Patient>(const Progress&)> loader,
                        std::function<void()> once_shown) {
  if (!may_change()) return;
  last_change_ = title;  // it may have to wait for other work to give up
  auto change_recorded = [this, name = Sentence{title.toStdString(), {}}, loader = std::move(loader)](
                             const Progress& progress, const FirstLook& /*first_look*/) {
    Result<Patient> patient = failure("cancelled", {});
    undo_.wait();  // what was drawn before belongs to what is worked on now
    const auto recorded = undo_.recorded(name, [&]() -> Result<void> {
      patient = loader(progress);
      return patient ? Result<void>() : failure(patient.error());
    });
    if (patient && !recorded) patient->remarks.push_back({recorded.error().message(), {}});
    return patient;
  };
  load(title, std::move(change_recorded), std::move(once_shown));
}

bool MainWindow::may_change() {
  if (hold_.refusal()) show_error(*hold_.refusal());
  return !hold_.refusal();
}

// Undone or done again. What a workspace shows of its own it reads itself; the patient is read anew.
void MainWindow::show_moved_entries(const QStringList& ids) {
  const bool outlines_alone =
      std::all_of(ids.begin(), ids.end(), [](const QString& id) { return id.startsWith("labels/"); });
  if (outlines_alone && workspace() == "segment") return;
  const bool landmarks_alone =
      std::all_of(ids.begin(), ids.end(), [](const QString& id) { return id.startsWith("landmarks/"); });
  load(tr("Opening %1").arg(text_of(patient_.folder.filename())), [patient = patient_, shown = landmarks_,
                                                                   landmarks_alone](const Progress& progress,
                                                                                    const FirstLook& /*first_look*/) {
    return landmarks_alone ? with_kept_landmarks(patient, shown, progress) : load_patient(patient.folder, progress);
  });
}

void MainWindow::keep_landmarks(const QString& what, const std::vector<mechanics::Landmark>& landmarks) {
  if (patient_.folder.empty() || patient_.preparing) return;
  change(what, [patient = patient_, shown = landmarks_, landmarks](const Progress& progress) {
    return with_landmarks(patient, shown, landmarks, progress);
  });
}

void MainWindow::take_next_step(NextStep step) {
  const fs::path folder = patient_.folder;
  if (step == NextStep::outline_liver) {
    change(tr("Outlining the liver"), [folder, inside_mm = views_->crosshair_mm()](const Progress& progress) {
      return outline_liver(folder, inside_mm, progress);
    });
  } else {
    change(
        tr("Building the model"), [folder](const Progress& progress) { return build_model(folder, progress); },
        [this] { go_to("rehearse"); });
  }
}

void MainWindow::show_error(const Error& error) {
  diary_.note(error);
  if (error.code == "cancelled") {
    status_->say(tr("Cancelled."));
    return;
  }
  const auto words = [error] { return translated(error); };
  if (error.code == "case-open-elsewhere") return notices_->note(words);  // nothing went wrong
  notices_->say(words);
}

void MainWindow::show_frame() {
  const auto& frame = rehearsal_.frame();
  patient_views_->show_frame(frame ? &*frame : nullptr, rehearse_panel_->tools_in_view());
  rehearse_panel_->show_drawing_ms(views_->space().last_frame_ms());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().size() == 1 &&
      event->mimeData()->urls().front().isLocalFile()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  open_path(path_of(event->mimeData()->urls().front().toLocalFile()));
}

// What is half built is lost, which is worth a question; what only reads is given up without one.
bool MainWindow::asked_to_give_up() {
  QMessageBox question(
      QMessageBox::Question, tr("Glisson"),
      tr("%1 is still under way. If you close now, it is given up, and the case stays as it was.").arg(changing_),
      QMessageBox::NoButton, this);
  question.setObjectName("ask_close");
  QPushButton* go_on = question.addButton(tr("Keep working"), QMessageBox::RejectRole);
  QPushButton* give_up = question.addButton(tr("Give it up and close"), QMessageBox::AcceptRole);
  give_up->setObjectName("give_up");
  question.setDefaultButton(go_on);
  question.setEscapeButton(go_on);
  question.exec();
  return question.clickedButton() == give_up;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (work_.busy() && !changing_.isEmpty() && !asked_to_give_up()) {
    event->ignore();
    return;
  }
  work_.cancel();
  open_work_.forget();
  QMainWindow::closeEvent(event);
}

}  // namespace glisson::widgets
