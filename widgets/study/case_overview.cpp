#include "widgets/study/case_overview.h"

#include <algorithm>
#include <QHeaderView>

#include "casefile/model_upkeep.h"
#include "widgets/panels/parts.h"
#include "widgets/session/load_patient.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

using casefile::Freshness;

std::vector<EntryState> read_states(const std::filesystem::path& folder) {
  std::vector<EntryState> states;
  const auto opened = casefile::Case::open(folder);
  if (!opened) return states;
  for (const casefile::Entry& entry : opened->entries()) states.push_back({entry, opened->freshness(entry.id)});
  return states;
}

// What one click makes anew: the model and what it stands on.
bool is_of_model(const std::string& id) { return id.starts_with("meshes/") || id.starts_with("surfaces/"); }

}  // namespace

CaseOverview::CaseOverview(const WorkspaceContext& context, QWidget* parent) : QWidget(parent), context_(context) {
  readers_.setMaxThreadCount(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 14, 14, 14);
  column->setSpacing(8);
  title_ = heading();
  column->addWidget(title_);
  summary_ = new QLabel;
  summary_->setWordWrap(true);
  column->addWidget(summary_);
  table_ = new QTreeWidget;
  table_->setObjectName("case_entries");
  table_->setRootIsDecorated(false);
  table_->setColumnCount(3);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->header()->setStretchLastSection(false);
  table_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  column->addWidget(table_, 1);
  recompute_ = new QPushButton;
  recompute_->setObjectName("primary");
  connect(recompute_, &QPushButton::clicked, this, &CaseOverview::recompute);
  column->addWidget(recompute_);
  missing_title_ = heading();
  column->addWidget(missing_title_);
  missing_ = new QVBoxLayout;
  missing_->setSpacing(6);
  column->addLayout(missing_);
  column->addStretch();
  keep_translated(this, [this] { list(); });
}

CaseOverview::~CaseOverview() { readers_.waitForDone(); }

void CaseOverview::show_case(const std::filesystem::path& folder) {
  folder_ = folder;
  const int turn = ++turn_;
  if (folder.empty()) {
    entries_.clear();
    list();
    return;
  }
  run_in_background(
      this, &readers_, [folder] { return read_states(folder); },
      [this, turn](std::vector<EntryState>& states) {
        if (turn != turn_) return;
        entries_ = std::move(states);
        list();
      });
}

void CaseOverview::list() {
  title_->setText(tr("The open case"));
  table_->setHeaderLabels({tr("What"), tr("State"), tr("Made by")});
  missing_title_->setText(tr("What comes next"));
  table_->clear();
  int stale = 0, stale_model = 0;
  for (const EntryState& state : entries_) {
    auto* row = new QTreeWidgetItem(table_);
    row->setText(0, entry_name(state.entry.id));
    row->setToolTip(0, QString::fromStdString(state.entry.id + ", " + state.entry.when_utc));
    switch (state.freshness) {
      case Freshness::current: row->setText(1, tr("up to date")); break;
      case Freshness::stale: row->setText(1, tr("⚠ stale")); break;
      case Freshness::changed_outside: row->setText(1, tr("⚠ changed by another program")); break;
      case Freshness::missing: row->setText(1, tr("⚠ file is gone")); break;
    }
    row->setText(2, stage_name(state.entry.made.by));
    const bool is_stale = state.freshness == Freshness::stale;
    if (is_stale) row->setToolTip(1, tr("Something that it was made from has changed since."));
    stale += is_stale ? 1 : 0;
    stale_model += is_stale && is_of_model(state.entry.id) ? 1 : 0;
  }
  table_->setVisible(!entries_.empty());
  summary_->setText(folder_.empty()
                        ? tr("No case is open. Open images, choose what each series is for, and make a case "
                             "of them.")
                    : stale == 0 ? tr("Everything is up to date.")
                                 : tr("Stale: %1. They were made from something that has changed since.").arg(stale));
  recompute_->setText(tr("Make the model anew"));
  recompute_->setVisible(stale_model > 0);
  list_missing();
}

void CaseOverview::list_missing() {
  while (QLayoutItem* old = missing_->takeAt(0)) {
    delete old->widget();
    delete old;
  }
  missing_title_->setVisible(!folder_.empty());
  if (folder_.empty()) return;
  const auto has = [this](const std::string& beginning) {
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const EntryState& state) { return state.entry.id.starts_with(beginning); });
  };
  const bool waves = has("volumes/phase") || has("volumes/wave");
  if (!has("volumes/anatomy")) {
    add_step(tr("There are no anatomical images: without them nothing can be outlined. Open them on the left."), {}, {},
             "step_anatomy");
  }
  if (waves && !has("volumes/stiffness")) {
    add_step(tr("The elastography has not been inverted: File, Elastography waves (Ctrl+W) makes the stiffness of it."),
             {}, {}, "step_invert");
  }
  if (has("volumes/anatomy") && !has("labels/liver")) {
    add_step(
        tr("The liver is not outlined yet."), tr("Outline it in Segment"), [this] { context_.go_to("segment"); },
        "step_outline");
  }
  if (has("labels/liver") && !has("meshes/model")) {
    add_step(
        has("volumes/stiffness")
            ? tr("There is no model yet.")
            : tr("There is no model yet. Without elastography its stiffness is assumed: the atlas's."),
        tr("Build the model"), [this] { recompute(); }, "step_model");
  }
  if (has("meshes/model")) {
    add_step(
        tr("The model is there."), tr("Rehearse"), [this] { context_.go_to("rehearse"); }, "step_rehearse");
  }
}

void CaseOverview::add_step(const QString& words, const QString& button, const std::function<void()>& act,
                            const char* name) {
  auto* line = new QWidget;
  line->setObjectName(name);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  auto* text = new QLabel(words);
  text->setWordWrap(true);
  row->addWidget(text, 1);
  if (!button.isEmpty()) {
    auto* go = new QPushButton(button);
    connect(go, &QPushButton::clicked, this, act);
    row->addWidget(go);
  }
  missing_->addWidget(line);
}

// With the stiffness that it has, where there is a model.
void CaseOverview::recompute() {
  context_.change(tr("Building the model"), [folder = folder_](const Progress& progress) -> Result<Patient> {
    auto opened = casefile::Case::open(folder);
    if (!opened) return failure(opened.error());
    const casefile::Upkeep upkeep{std::nullopt, casefile::stiffness_choice_of(*opened)};
    if (auto made = casefile::bring_model_up_to_date(*opened, upkeep, progress.part(0, 0.22)); !made) {
      return failure(made.error());
    }
    return load_patient(folder, progress.part(0.22, 1));
  });
}

QString CaseOverview::entry_name(const std::string& id) {
  const std::size_t slash = id.find('/');
  const std::string kind = id.substr(0, slash), name = slash == std::string::npos ? id : id.substr(slash + 1);
  if (kind == "labels") return tr("Outline: %1").arg(structure_label(name));
  if (kind == "surfaces") return tr("Surface: %1").arg(structure_label(name));
  if (id == "meshes/liver") return tr("Tetrahedra of the liver");
  if (id == "meshes/model") return tr("Model: stiffness of each cell");
  if (id == "volumes/anatomy") return tr("Images: anatomy");
  if (id == "volumes/stiffness") return tr("Map: stiffness (kPa)");
  if (id == "volumes/confidence") return tr("Map: confidence");
  const QString number = QString::fromStdString(name.substr(std::min(name.find('-'), name.size()))).replace('-', ' ');
  if (id.starts_with("volumes/magnitude")) return tr("MRE magnitude") + number;
  if (id.starts_with("volumes/phase")) return tr("MRE phase") + number;
  if (id.starts_with("volumes/wave")) return tr("MRE waves") + number;
  return QString::fromStdString(id);
}

QString CaseOverview::stage_name(const std::string& stage) {
  if (stage == "import") return tr("import");
  if (stage == "segment") return tr("outlining");
  if (stage == "mesh") return tr("meshing");
  if (stage == "stiffness") return tr("giving stiffness");
  if (stage == "invert") return tr("inversion of waves");
  return QString::fromStdString(stage);
}

}  // namespace glisson::widgets
