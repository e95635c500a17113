#include "widgets/main_window.h"

#include <algorithm>
#include <QCloseEvent>
#include <QDropEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>

#include "base/result.h"
#include "widgets/evidence/evidence_view.h"
#include "widgets/guide/guide_page.h"
#include "widgets/hardware/platform_view.h"
#include "widgets/model/model_panel.h"
#include "widgets/register/register_page.h"
#include "widgets/report/report_view.h"
#include "widgets/resect/resect_panel.h"
#include "widgets/segment/segment_panel.h"
#include "widgets/settings/settings.h"
#include "widgets/settings/window_place.h"
#include "widgets/studies/studies_page.h"
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
    update_patient_text();
    patient_views_->reword();
    QTimer::singleShot(0, this, [this] { name_controls(*this); });  // once all of it has its words
  });
}

// In this order: the work that workspaces began, the workspaces with their windows, then what they share. A workspace
// that goes tells this window nothing more.
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
  add_workspace(RehearsePanel::workspace(
      context(), [this](const QString& what, const auto& kept) { keep_landmarks(what, kept); }));
  rehearse_panel_ = findChild<RehearsePanel*>();
  add_workspace(ResectPanel::workspace(context()));
  const Workspace platform = PlatformView::workspace();
  add_workspace(ReportView::workspace(context(), [view = qobject_cast<PlatformView*>(platform.widget)] {
    return view != nullptr ? view->plan() : std::nullopt;
  }));
  add_workspace(GuidePage::workspace(context()));
  add_workspace(RegisterPage::workspace(context()));
  add_workspace(platform);
  add_workspace(EvidenceView::workspace(context()));
  add_workspace(StudiesPage::workspace());
}

void MainWindow::add_workspace(Workspace workspace) {
  const int index = static_cast<int>(workspaces_.size());
  (workspace.place == Workspace::Place::whole_window ? pages_ : panels_)->addWidget(workspace.widget);
  bar_->add(workspace);
  // The first ten have a key.
  const QKeySequence key =
      index < 10 ? QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_0 + (index + 1) % 10)) : QKeySequence();
  QAction* go = go_menu_->addAction({}, key, bar_, [this, index] { bar_->choose(index); });
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

void MainWindow::show_waves() {
  auto* view = new WaveView(patient_.folder, this);
  view->setWindowFlag(Qt::Window);
  view->setAttribute(Qt::WA_DeleteOnClose);
  view->set_guard([this] { return may_change(); });
  view->set_recorder([this](const auto& change) { return undo_.recorded(maps_of_waves, change); });
  connect(view, &WaveView::accepted, this, [this] { open_path(patient_.folder); });
  view->show();
  view->invert();
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
