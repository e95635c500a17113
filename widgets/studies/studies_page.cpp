#include "widgets/studies/studies_page.h"

#include <algorithm>
#include <QDesktopServices>
#include <QDir>
#include <QStandardPaths>
#include <QUrl>

#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/panels/status_line.h"
#include "widgets/studies/study_kinds.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

namespace fs = std::filesystem;

namespace {

QString usual_results(const StudyKind& kind) {
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Glisson/" + kind.id;
}

}  // namespace

StudiesPage::StudiesPage(QWidget* parent) : QWidget(parent) {
  setObjectName("studies_page");
  auto* across = new QHBoxLayout(this);
  across->setContentsMargins(0, 0, 0, 0);
  across->setSpacing(0);
  QScrollArea* question = scrolled(make_question());
  question->setFixedWidth(330);
  across->addWidget(question);
  across->addWidget(make_answer(), 1);
  connect(kind_, &QComboBox::currentIndexChanged, this, &StudiesPage::choose_kind);
  connect(&run_, &StudyRun::progressed, this, [this](double fraction, const QString& stage) {
    fraction_ = fraction;
    stage_ = stage;
    update_text();
  });
  connect(&run_, &StudyRun::ended, this, &StudiesPage::end);
  every_second_.setInterval(1000);
  connect(&every_second_, &QTimer::timeout, this, &StudiesPage::look_again);
  keep_translated(this, [this] {
    choose_kind();
    update_text();
  });
}

Workspace StudiesPage::workspace() {
  auto* page = new StudiesPage;
  return {.id = "studies",
          .name = [] { return tr("Studies"); },
          .about = [] { return tr("Run the dissertation's studies over many patients, and follow them."); },
          .widget = page,
          .place = Workspace::Place::whole_window,
          .group = Workspace::Group::research,
          .show_patient = [page](const Patient& patient) { page->show_case(patient.folder); }};
}

void StudiesPage::show_case(const fs::path& folder) {
  case_folder_ = text_of(folder);
  choose_kind();
}

void StudiesPage::choose_kind() {
  const StudyKind& kind = study_kinds().at(static_cast<std::size_t>(kind_->currentIndex()));
  about_->setText(kind.about());
  if (input_.isEmpty() && kind.of == StudyOf::one_case) input_ = case_folder_;
  if (kind.of != StudyOf::one_case && input_ == case_folder_) input_.clear();
  input_row_->setVisible(kind.of != StudyOf::nothing);
  simulated_row_->setVisible(kind.of == StudyOf::patients && input_.isEmpty());
  input_name_->setText(kind.of == StudyOf::patients   ? tr("Of the patients in")
                       : kind.of == StudyOf::one_case ? tr("Of the case")
                       : kind.of == StudyOf::livers   ? tr("Of the livers in")
                                                      : tr("Of the scans in"));
  input_text_->setText(!input_.isEmpty()              ? QDir::toNativeSeparators(input_)
                       : kind.of == StudyOf::patients ? tr("No folder: simulated patients")
                       : kind.of == StudyOf::one_case ? tr("Open a case, or choose one")
                       : kind.of == StudyOf::livers   ? tr("Choose a folder of label maps")
                                                      : tr("No folder: simulated scans"));
  drop_input_->setVisible(!input_.isEmpty());
  // What a person typed stays; a proposal follows the study.
  const bool proposed = std::any_of(study_kinds().begin(), study_kinds().end(),
                                    [this](const StudyKind& each) { return results_->text() == usual_results(each); });
  if (results_->text().isEmpty() || proposed) results_->setText(usual_results(kind));
  start_->setEnabled(!run_.running() && !(needs_folder(kind.of) && input_.isEmpty()));
}

void StudiesPage::choose_input() {
  const QString folder = ask_for_folder(this, tr("The folder with the patients or scans, or a case"));
  if (folder.isEmpty()) return;
  input_ = folder;
  choose_kind();
}

void StudiesPage::choose_results() {
  const QString folder = ask_for_folder(this, tr("The folder for the results"));
  if (!folder.isEmpty()) results_->setText(folder);
}

void StudiesPage::choose_followed() {
  const QString folder = ask_for_folder(this, tr("The folder that a study is written to"));
  if (!folder.isEmpty()) follow(path_of(folder));
}

void StudiesPage::start() {
  const StudyKind& kind = study_kinds().at(static_cast<std::size_t>(kind_->currentIndex()));
  const QString out = results_->text().trimmed();
  if (out.isEmpty() || run_.running()) return;
  fraction_ = 0;
  stage_.clear();
  trouble_.clear();
  since_.start();
  state_ = State::running;
  follow(path_of(out));
  run_.start(study_arguments(kind, {static_cast<int>(simulated_->value()), input_, out}));
  choose_kind();
  update_text();
}

void StudiesPage::end(bool done, const QString& trouble) {
  trouble_ = trouble;
  state_ = done ? State::done : trouble.isEmpty() ? State::stopped : State::failed;
  look_again();
  choose_kind();
  update_text();
}

void StudiesPage::follow(const fs::path& folder) {
  if (!run_.running() && state_ != State::running) state_ = State::nothing;
  followed_ = folder;
  rows_->follow(folder);
  every_second_.start();
  look_again();
}

void StudiesPage::look_again() {
  rows_->look_again();
  std::error_code problem;
  open_page_->setEnabled(fs::exists(followed_ / "report.html", problem));
  update_text();
}

void StudiesPage::open_page() { QDesktopServices::openUrl(QUrl::fromLocalFile(text_of(followed_ / "report.html"))); }

// What is done of it, what is done now, and how long it still takes.
void StudiesPage::update_text() {
  const bool running = run_.running();
  stop_->setVisible(running || state_ == State::running);
  stop_->setEnabled(state_ == State::running);
  progress_->setVisible(running);
  progress_->setValue(static_cast<int>(1000 * fraction_));
  QStringList told;
  if (!followed_.empty()) told << QDir::toNativeSeparators(text_of(followed_));
  if (rows_->done() > 0) told << tr("Patients done: %1").arg(rows_->done());
  if (rows_->failed() > 0) told << tr("Could not be used: %1").arg(rows_->failed());
  text_->setText(followed_.empty() ? tr("Start a study, or follow a folder that another program fills.")
                                   : told.join(QStringLiteral("  ·  ")));
  QString stage;
  switch (state_) {
    case State::nothing: break;
    case State::running: {
      stage = translated_stage(stage_);
      const auto elapsed_ms = static_cast<double>(since_.elapsed());
      if (fraction_ >= 0.05 && elapsed_ms > 5000) {
        const QString left = time_left(elapsed_ms * (1 - fraction_) / fraction_);
        if (!left.isEmpty()) stage = tr("%1, %2").arg(stage, left);
      }
      break;
    }
    case State::stopping: stage = tr("Stopping..."); break;
    case State::done: stage = tr("Done."); break;
    case State::stopped: stage = tr("Stopped. Started again, it goes on from there."); break;
    case State::failed: stage = trouble_; break;
  }
  stage_text_->setText(stage);
}

QWidget* StudiesPage::make_question() {
  auto* panel = new QWidget;
  panel->setObjectName("panel");
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  QLabel* title = heading();
  column->addWidget(title);
  kind_ = new QComboBox;
  kind_->setObjectName("study_kind");
  kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (std::size_t i = 0; i < study_kinds().size(); ++i) kind_->addItem({});
  column->addWidget(kind_);
  about_ = wrapped_label("faint");
  column->addWidget(about_);
  column->addSpacing(8);

  input_row_ = new QWidget;
  auto* input_column = new QVBoxLayout(input_row_);
  input_column->setContentsMargins(0, 0, 0, 0);
  input_name_ = heading();
  input_text_ = wrapped_label("study_input");
  choose_input_ = named_button("choose_study_input");
  drop_input_ = named_button("drop_study_input");
  input_column->addWidget(input_name_);
  input_column->addWidget(input_text_);
  auto* input_buttons = new QHBoxLayout;
  input_buttons->addWidget(choose_input_, 1);
  input_buttons->addWidget(drop_input_);
  input_column->addLayout(input_buttons);
  column->addWidget(input_row_);
  simulated_row_ = new QWidget;
  auto* simulated_column = new QHBoxLayout(simulated_row_);
  simulated_column->setContentsMargins(0, 0, 0, 0);
  auto* simulated_name = new QLabel;
  simulated_ = whole_number("study_simulated", 1, 100'000, 119);  // as many as the dissertation's
  simulated_name->setBuddy(simulated_);
  simulated_column->addWidget(simulated_name, 1);
  simulated_column->addWidget(simulated_);
  column->addWidget(simulated_row_);

  QLabel* results_title = heading();
  column->addWidget(results_title);
  auto* results_row = new QHBoxLayout;
  results_ = new QLineEdit;
  results_->setObjectName("study_results");
  QPushButton* choose_results = named_button("choose_study_results");
  results_row->addWidget(results_, 1);
  results_row->addWidget(choose_results);
  column->addLayout(results_row);
  column->addSpacing(8);
  start_ = named_button("primary");
  column->addWidget(start_);
  column->addStretch(1);
  QPushButton* follow = named_button("follow_study");
  column->addWidget(follow);
  connect(choose_input_, &QPushButton::clicked, this, &StudiesPage::choose_input);
  connect(drop_input_, &QPushButton::clicked, this, [this] {
    input_.clear();
    choose_kind();
  });
  connect(choose_results, &QPushButton::clicked, this, &StudiesPage::choose_results);
  connect(start_, &QPushButton::clicked, this, &StudiesPage::start);
  connect(follow, &QPushButton::clicked, this, &StudiesPage::choose_followed);

  keep_translated(panel, [=, this] {
    title->setText(tr("Study"));
    for (int row = 0; row < kind_->count(); ++row) {
      kind_->setItemText(row, study_kinds().at(static_cast<std::size_t>(row)).name());
    }
    choose_input_->setText(tr("Choose..."));
    drop_input_->setText(tr("None"));
    drop_input_->setToolTip(tr("Without a folder"));
    simulated_name->setText(tr("Simulated patients"));
    results_title->setText(tr("Results go to"));
    results_->setToolTip(tr("A folder. What lies there from an earlier run of the same study is not computed again."));
    choose_results->setText(tr("..."));
    choose_results->setToolTip(tr("Choose the folder for the results"));
    start_->setText(tr("Start"));
    start_->setToolTip(tr("Runs beside the window; closing the window stops it. Started again, it goes on."));
    follow->setText(tr("Follow a folder..."));
    follow->setToolTip(tr("Shows what another program, or a cluster, writes to a study's folder"));
  });
  return panel;
}

QWidget* StudiesPage::make_answer() {
  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  text_ = wrapped_label("study_told");
  column->addWidget(text_);
  auto* under_way = new QHBoxLayout;
  stage_text_ = wrapped_label("study_stage");
  progress_ = new QProgressBar;
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(220);
  stop_ = named_button("stop_study");
  under_way->addWidget(stage_text_, 1);
  under_way->addWidget(progress_);
  under_way->addWidget(stop_);
  column->addLayout(under_way);
  rows_ = new StudyRows;
  column->addWidget(rows_, 1);
  auto* below = new QHBoxLayout;
  open_page_ = named_button("open_study_page");
  open_page_->setEnabled(false);
  below->addStretch(1);
  below->addWidget(open_page_);
  column->addLayout(below);
  connect(stop_, &QPushButton::clicked, this, [this] {
    state_ = State::stopping;
    run_.stop();
    update_text();
  });
  connect(open_page_, &QPushButton::clicked, this, &StudiesPage::open_page);
  keep_translated(right, [this] {
    stop_->setText(tr("Stop"));
    stop_->setToolTip(tr("What is done stays"));
    open_page_->setText(tr("Open the page"));
    open_page_->setToolTip(tr("The study's report, in the browser"));
  });
  return right;
}

}  // namespace glisson::widgets
