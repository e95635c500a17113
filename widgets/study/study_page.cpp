#include "widgets/study/study_page.h"

#include <algorithm>
#include <QDir>
#include <QSplitter>
#include <QStandardPaths>

#include "widgets/panels/ask_path.h"
#include "widgets/panels/parts.h"
#include "widgets/session/load_patient.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

std::vector<casefile::SeriesRole> as_labels(const imaging::Study& study) {
  std::vector<casefile::SeriesRole> roles;
  for (const imaging::Series& series : study.series) roles.push_back({series.uid, imaging::Role::segmentation});
  return roles;
}

}  // namespace

Workspace StudyPage::workspace(const WorkspaceContext& context) {
  auto* page = new StudyPage(context);
  return {.id = "study",
          .name = [] { return tr("Study"); },
          .about = [] { return tr("Find images, say what each series is for, and see what the case holds."); },
          .widget = page,
          .place = Workspace::Place::whole_window,
          .show_patient = [page](const Patient& patient) { page->show_patient(patient); }};
}

StudyPage::StudyPage(const WorkspaceContext& context, QWidget* parent)
    : QWidget(parent), context_(context), taking_in_(new TakingIn(context, this)) {
  setObjectName("panel");
  setAttribute(Qt::WA_StyledBackground);
  auto* images = new QWidget;
  auto* column = new QVBoxLayout(images);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  auto* top = new QHBoxLayout;
  title_ = heading();
  top->addWidget(title_, 1);
  open_ = new QPushButton;
  open_->setObjectName("browse");
  top->addWidget(open_);
  column->addLayout(top);
  found_ = new QLabel;
  found_->setWordWrap(true);
  column->addWidget(found_);
  series_ = new SeriesTable;
  column->addWidget(series_, 1);
  column->addStretch();  // where there is no table yet
  privacy_ = new QLabel;
  privacy_->setObjectName("faint");
  privacy_->setWordWrap(true);
  column->addWidget(privacy_);
  auto* keep = new QHBoxLayout;
  keep_title_ = new QLabel;
  keep->addWidget(keep_title_);
  keep_as_ = new QLineEdit;
  keep_as_->setObjectName("keep_as");
  keep->addWidget(keep_as_, 1);
  make_ = new QPushButton;
  make_->setObjectName("make_case");
  keep->addWidget(make_);
  add_ = new QPushButton;
  add_->setObjectName("add_to_case");
  keep->addWidget(add_);
  column->addLayout(keep);

  overview_ = new CaseOverview(context);
  auto* across = new QSplitter(Qt::Horizontal);
  across->addWidget(images);
  across->addWidget(overview_);
  across->setChildrenCollapsible(false);
  across->setSizes({1000, 600});
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(across);

  connect(open_, &QPushButton::clicked, this, &StudyPage::choose_folder);
  connect(series_, &SeriesTable::roles_changed, this, &StudyPage::show_state);
  connect(keep_as_, &QLineEdit::textChanged, this, &StudyPage::show_state);
  connect(make_, &QPushButton::clicked, this,
          [this] { taking_in_->take(*series_->study(), series_->roles(), path_of(keep_as_->text())); });
  connect(add_, &QPushButton::clicked, this, [this] { taking_in_->take(*series_->study(), series_->roles(), case_); });
  connect(taking_in_, &TakingIn::begun, this, [this](const fs::path& folder) { importing_into_ = folder; });
  connect(&context_.undo, &Undo::settled, this, [this] {
    if (isVisible()) overview_->show_case(case_);
  });
  keep_translated(this, [this] { update_text(); });
}

// A label map alone, while a case is open, is meant for it.
void StudyPage::browse(const fs::path& path) {
  look(path, [this, path](const imaging::Study& study) {
    const bool labels = std::all_of(study.series.begin(), study.series.end(), [](const imaging::Series& series) {
      return series.role == imaging::Role::segmentation;
    });
    if (labels && !case_.empty()) {
      taking_in_->take(study, as_labels(study), case_);
    } else {
      list(path, study);
    }
  });
}

void StudyPage::add_labels(const fs::path& file) {
  look(file, [this](const imaging::Study& study) { taking_in_->take(study, as_labels(study), case_); });
}

void StudyPage::look(const fs::path& path, const std::function<void(const imaging::Study&)>& then) {
  context_.work.start(tr("Looking for images"), [this, path, then](const Progress& progress) -> BackgroundWork::Then {
    auto study = std::make_shared<Result<imaging::Study>>(imaging::scan(path, progress));
    return [this, path, study, then] {
      if (!*study) {
        context_.tell_error(study->error());
      } else if ((*study)->series.empty()) {
        context_.tell_error(
            Error{"study-no-images", GLISSON_TEXT("No images were found in {0}."), {path.string()}, {}, {}});
      } else {
        then(**study);
      }
    };
  });
}

void StudyPage::list(const fs::path& path, const imaging::Study& study) {
  browsed_ = path;
  series_->show_study(std::make_shared<const imaging::Study>(study));
  keep_as_->setText(QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
                        .filePath(text_of(path.stem()) + ".glisson"));
  show_state();
  Q_EMIT listed();
}

void StudyPage::show_patient(const Patient& patient) {
  case_ = patient.folder;
  if (isVisible()) overview_->show_case(case_);
  show_state();
  if (importing_into_.empty() || importing_into_ != case_) return;
  importing_into_.clear();
  // There the images are seen with what is outlined on them, and beside them what comes next.
  if (patient.anatomy != nullptr) context_.go_to("segment");
}

void StudyPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  overview_->show_case(case_);
}

void StudyPage::update_text() {
  title_->setText(tr("Images"));
  open_->setText(tr("Look in a folder..."));
  open_->setToolTip(tr("A folder, a DICOMDIR or one file; dropping it on the window does the same"));
  privacy_->setText(
      tr("Patients' names are neither shown nor kept: a case keeps a hash of them. The images are never written to."));
  keep_title_->setText(tr("Keep the case as"));
  keep_as_->setAccessibleName(keep_title_->text());
  make_->setText(tr("Make a case"));
  add_->setText(tr("Add to the open case"));
  show_state();
}

void StudyPage::show_state() {
  const imaging::Study* study = series_->study();
  if (study == nullptr) {
    found_->setText(tr("Drop a folder of DICOM images, a DICOMDIR, or a NIfTI, NRRD or MHA file here."));
  } else {
    QString found = tr("%1: series found: %2").arg(text_of(browsed_)).arg(study->series.size());
    if (!study->skipped.empty()) found += tr("; files left out: %1").arg(study->skipped.size());
    found_->setText(found);
    QStringList skipped;
    constexpr std::size_t maximum = 20;
    for (std::size_t k = 0; k < std::min(maximum, study->skipped.size()); ++k) {
      skipped << text_of(study->skipped[k].path.filename()) + ": " + translated(study->skipped[k].reason);
    }
    found_->setToolTip(skipped.join("\n"));
  }
  const bool chosen = study != nullptr && series_->chosen() > 0;
  const bool images = study != nullptr && series_->chosen_images() > 0;  // labels alone make no case
  const fs::path wanted = path_of(keep_as_->text());
  std::error_code ignored;
  const bool taken = fs::exists(wanted, ignored);
  make_->setEnabled(images && !wanted.empty() && !taken);
  make_->setToolTip(!chosen   ? tr("Give at least one series a role first.")
                    : !images ? tr("Labels need the images that they were drawn on: give one series another role.")
                    : taken   ? tr("There is something of that name already: choose another.")
                              : tr("Copies the chosen series into a new case"));
  add_->setEnabled(chosen && !case_.empty());
  add_->setToolTip(case_.empty() ? tr("No case is open.")
                   : !chosen     ? tr("Give at least one series a role first.")
                                 : tr("Glisson asks before anything is replaced; Ctrl+Z brings it back"));
  // Nothing to be made of nothing.
  for (QWidget* each : std::initializer_list<QWidget*>{series_, keep_title_, keep_as_, make_, add_})
    each->setVisible(study != nullptr);
}

void StudyPage::choose_folder() {
  const QString folder = ask_for_file_or_folder(this, tr("Open images: a folder, or a file of them"));
  if (!folder.isEmpty()) browse(path_of(folder));
}

}  // namespace glisson::widgets
