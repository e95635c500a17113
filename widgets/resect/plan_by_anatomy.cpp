#include "widgets/resect/plan_by_anatomy.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "casefile/vascular.h"
#include "widgets/panels/parts.h"
#include "widgets/resect/small_table.h"
#include "widgets/session/load_patient.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

// The vessels and segments of a case, kept in it.
Result<void> find_anatomy(const std::filesystem::path& folder, const Progress& progress) {
  using casefile::SegmentsBy;
  auto patient = casefile::Case::open(folder);
  if (!patient) return failure(std::move(patient.error()));
  const bool has_vessels =
      patient->find("labels/vessels") != nullptr ||
      (patient->find("labels/portal-vein") != nullptr && patient->find("labels/hepatic-vein") != nullptr);
  if (has_vessels) {
    const auto trees = casefile::find_vessels(*patient, {}, {}, progress.part(0, 0.6));
    if (!trees) return failure(trees.error());
  }
  const bool by_trees = patient->find("vessels/trees") != nullptr;
  const auto found =
      casefile::find_territories(*patient, by_trees ? SegmentsBy::trees : SegmentsBy::shape, progress.part(0.6, 1));
  return found ? Result<void>() : failure(found.error());
}

}  // namespace

PlanByAnatomy::PlanByAnatomy(WorkspaceContext context, QWidget* parent)
    : QWidget(parent), context_(std::move(context)) {
  live_ = new LivePlan(this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 6, 0, 0);
  column->setSpacing(8);
  column->addWidget(make_anatomy());
  column->addWidget(make_answer());
  column->addWidget(make_plans());
  connect(live_, &LivePlan::opened, this, &PlanByAnatomy::show_anatomy);
  connect(live_, &LivePlan::changed, this, &PlanByAnatomy::show_answer);
  connect(live_, &LivePlan::kept_changed, this, &PlanByAnatomy::show_plans);
  connect(&context_.undo, &Undo::entries_moved, this, [this](const QStringList& ids) {
    const bool plans = std::any_of(ids.begin(), ids.end(), [](const QString& id) {
      return id.startsWith("plans/") || id.startsWith("results/");  // the list, and which of them is followed
    });
    if (plans) live_->read_kept();
  });
  keep_translated(this, [this] {
    show_anatomy();
    show_answer();
    show_plans();
  });
}

QWidget* PlanByAnatomy::make_anatomy() {
  by_anatomy_ = new QWidget(this);
  QWidget* group = by_anatomy_;
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  QLabel* title = heading(group);
  column->addWidget(title);
  told_ = wrapped_label("anatomy_told", group);
  column->addWidget(told_);
  find_ = named_button("find_segments", group);
  column->addWidget(find_);

  anatomy_ = new QWidget(group);
  auto* rows = new QVBoxLayout(anatomy_);
  rows->setContentsMargins(0, 0, 0, 0);
  segments_ = small_table("segments", 4, anatomy_);
  rows->addWidget(segments_);
  show_segments_ = new QCheckBox(anatomy_);
  show_segments_->setObjectName("show_segments");
  take_segments_ = named_button("take_segments", anatomy_);
  auto* row = new QHBoxLayout;
  row->addWidget(show_segments_);
  row->addWidget(take_segments_, 1);
  rows->addLayout(row);
  column->addWidget(anatomy_);

  around_ = new QWidget(group);
  auto* around = new QHBoxLayout(around_);
  around->setContentsMargins(0, 0, 0, 0);
  tumour_ = new QComboBox(around_);
  tumour_->setObjectName("around_tumour");
  margin_ = new NumberBox(around_);
  margin_->setObjectName("around_margin");
  margin_->setRange(0, planning::largest_margin_mm);
  margin_->setDecimals(0);
  margin_->setValue(10);
  take_around_ = named_button("take_around", around_);
  around->addWidget(tumour_, 1);
  around->addWidget(margin_);
  around->addWidget(take_around_, 1);
  column->addWidget(around_);

  connect(find_, &QPushButton::clicked, this, &PlanByAnatomy::find_segments);
  connect(take_segments_, &QPushButton::clicked, this, &PlanByAnatomy::take_segments);
  connect(take_around_, &QPushButton::clicked, this, &PlanByAnatomy::take_around);
  connect(show_segments_, &QCheckBox::toggled, this, &PlanByAnatomy::drawing_changed);
  connect(segments_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (item->column() == segment_column) take_segments_->setEnabled(!ticked().empty());
  });
  keep_translated(group, [=, this] {
    title->setText(tr("Segments and tumours"));
    find_->setText(tr("Find segments"));
    find_->setToolTip(tr("By the portal and hepatic veins where both are outlined, else by the liver's shape alone"));
    segments_->setHorizontalHeaderLabels({tr("Segment"), tr("ml"), tr("Stays, ml"), tr("kPa")});
    segments_->horizontalHeaderItem(stiffness_column)
        ->setToolTip(tr("Mean stiffness (Young's modulus) of the tissue that was measured; faint under half of it"));
    show_segments_->setText(tr("Show segments"));
    take_segments_->setText(tr("Take these segments"));
    take_segments_->setToolTip(tr("Removes the segments that are ticked"));
    margin_->setSuffix(tr(" mm"));
    take_around_->setText(tr("Around this tumour"));
    take_around_->setToolTip(tr("Removes the tumour with all tissue up to this margin"));
  });
  return group;
}

QWidget* PlanByAnatomy::make_answer() {
  answer_ = new QWidget(this);
  auto* column = new QVBoxLayout(answer_);
  column->setContentsMargins(0, 0, 0, 0);
  alive_ = wrapped_label("alive_told", answer_);
  column->addWidget(alive_);
  branches_title_ = heading(answer_);
  column->addWidget(branches_title_);
  branches_ = small_table("branches_cut", 4, answer_);
  column->addWidget(branches_);
  keep_translated(answer_, [this] {
    branches_title_->setText(tr("Branches cut"));
    branches_->setHorizontalHeaderLabels({tr("Branch"), tr("mm"), tr("Beyond, ml"), tr("Left, ml")});
    branches_->horizontalHeaderItem(width_column)->setToolTip(tr("Diameter where it is cut"));
    branches_->horizontalHeaderItem(beyond_column)->setToolTip(tr("All tissue that it feeds or drains beyond the cut"));
    branches_->horizontalHeaderItem(left_column)->setToolTip(tr("What of that stays in the patient without it"));
  });
  return answer_;
}

QWidget* PlanByAnatomy::make_plans() {
  plans_box_ = new QWidget(this);
  auto* column = new QVBoxLayout(plans_box_);
  column->setContentsMargins(0, 0, 0, 0);
  QLabel* title = heading(plans_box_);
  column->addWidget(title);
  plans_ = small_table("plans", 5, plans_box_);
  plans_->setSelectionBehavior(QAbstractItemView::SelectRows);
  plans_->setSelectionMode(QAbstractItemView::SingleSelection);
  column->addWidget(plans_);
  name_ = new QLineEdit(plans_box_);
  name_->setObjectName("plan_name");
  keep_ = named_button("keep_plan", plans_box_);
  drop_ = named_button("drop_plan", plans_box_);
  auto* row = new QHBoxLayout;
  row->addWidget(name_, 1);
  row->addWidget(keep_);
  row->addWidget(drop_);
  column->addLayout(row);
  connect(plans_, &QTableWidget::cellClicked, this, [this](int plan) {
    if (plan < 0 || static_cast<std::size_t>(plan) >= live_->kept().size()) return;
    const planning::Plan& chosen = live_->kept()[static_cast<std::size_t>(plan)].kept.plan;
    taken_.clear();
    for (const planning::Cut& cut : chosen.cuts) {
      if (!std::holds_alternative<planning::PlaneCut>(cut) && !std::holds_alternative<planning::SheetCut>(cut)) {
        taken_.push_back(cut);
      }
    }
    name_->setText(QString::fromStdString(chosen.name));
    Q_EMIT plan_chosen(chosen);
    cuts_changed();
  });
  connect(plans_, &QTableWidget::itemSelectionChanged, this,
          [this] { drop_->setEnabled(!plans_->selectedItems().isEmpty()); });
  connect(keep_, &QPushButton::clicked, this, &PlanByAnatomy::keep);
  connect(drop_, &QPushButton::clicked, this, &PlanByAnatomy::drop);
  keep_translated(plans_box_, [=, this] {
    title->setText(tr("Plans"));
    plans_->setHorizontalHeaderLabels({tr("Plan"), tr("Stays"), tr("Alive"), tr("Margin"), tr("Cut")});
    plans_->horizontalHeaderItem(stays_percent_column)->setToolTip(tr("Of the liver without its tumours"));
    plans_->horizontalHeaderItem(alive_column)->setToolTip(tr("What stays perfused and drained, of the same"));
    plans_->horizontalHeaderItem(cut_branches_column)->setToolTip(tr("Branches that are cut"));
    name_->setPlaceholderText(tr("Name of the plan"));
    keep_->setText(tr("Keep this plan"));
    show_keeping();
    drop_->setText(tr("Drop"));
    drop_->setToolTip(tr("Takes the plan that is marked out of the case"));
  });
  return plans_box_;
}

void PlanByAnatomy::show_patient(const Patient& patient) {
  if (patient.folder != folder_) {
    taken_.clear();
    name_->clear();
  }
  folder_ = patient.folder;
  by_anatomy_->setVisible(!folder_.empty());
  live_->open(patient.liver() != nullptr ? folder_ : std::filesystem::path());
}

void PlanByAnatomy::set_surface(const std::optional<casefile::PlannedCut>& surface) {
  surface_ = surface;
  live_->set_cuts(cuts());
  show_keeping();
}

void PlanByAnatomy::set_resection(const std::shared_ptr<const LiveResectionResult>& resection) {
  resection_ = resection;
  show_keeping();
}

void PlanByAnatomy::clear() {
  taken_.clear();
  cuts_changed();
}

std::vector<planning::Cut> PlanByAnatomy::cuts() const {
  std::vector<planning::Cut> all = taken_;
  const bool at_rest = surface_ && surface_->liver == casefile::PlannedCut::Liver::at_rest;
  if (at_rest) all.insert(all.begin(), casefile::cut_of(*surface_));
  return all;
}

void PlanByAnatomy::cuts_changed() {
  live_->set_cuts(cuts());
  Q_EMIT taken_changed();
}

void PlanByAnatomy::find_segments() {
  context_.change(tr("Finding vessels and segments"), [folder = folder_](const Progress& progress) -> Result<Patient> {
    if (auto found = find_anatomy(folder, progress.part(0, 0.8)); !found) return failure(std::move(found.error()));
    return load_patient(folder, progress.part(0.8, 1));
  });
}

std::vector<int> PlanByAnatomy::ticked() const {
  std::vector<int> numbers;
  for (int row = 0; row < segments_->rowCount(); ++row) {
    const QTableWidgetItem* item = segments_->item(row, segment_column);
    if (item != nullptr && item->checkState() == Qt::Checked) numbers.push_back(item->data(Qt::UserRole).toInt());
  }
  return numbers;
}

// One cut of its kind at a time; kinds add to each other.
void PlanByAnatomy::take(const planning::Cut& cut) {
  std::erase_if(taken_, [&](const planning::Cut& other) { return other.index() == cut.index(); });
  taken_.push_back(cut);
  cuts_changed();
}

void PlanByAnatomy::take_segments() { take(planning::SegmentsCut{ticked()}); }

void PlanByAnatomy::take_around() {
  take(planning::MarginCut{tumour_->currentData().toString().toStdString(), margin_->value()});
}

bool PlanByAnatomy::complete() const {
  const std::vector<planning::Cut> wanted = cuts();
  if (folder_.empty() || live_->opening() || (wanted.empty() && !divides_liver())) return false;
  if (divides_liver() && (!resection_ || resection_->cut != *surface_)) return false;
  if (!live_->anatomy() || wanted.empty() || live_->problem()) return divides_liver();
  return live_->result() && live_->result()->cuts == wanted;
}

void PlanByAnatomy::keep() {
  if (!complete() || !context_.may_change()) return;
  const auto resection = divides_liver() ? resection_ : nullptr;
  const auto anatomy = live_->anatomy();
  const auto answered = anatomy && !cuts().empty() ? live_->result() : nullptr;
  QString name = name_->text().trimmed();
  if (name.isEmpty()) name = tr("Plan %1").arg(live_->kept().size() + 1);
  context_.undo.change(
      {GLISSON_TEXT("Keep the plan {0}"), {name.toStdString()}}, {},
      [folder = folder_, name = name.toStdString(), resection, anatomy, answered]() -> Result<void> {
        if (answered) {
          auto patient = casefile::Case::open(folder);
          if (!patient) return failure(std::move(patient.error()));
          const planning::Plan plan{name, answered->cuts};
          const auto id = casefile::keep_plan(*patient, plan, answered->answer, anatomy->planner.trees());
          if (!id) return failure(id.error());
        }
        if (!resection) return {};
        return casefile::write_resection(folder / "results" / "resection", resection->cut, resection->plan);
      },
      [this, name, followed = resection != nullptr](const Result<void>& kept) {
        if (!kept) {
          context_.tell_error(kept.error());
        } else {
          context_.tell_status(followed ? tr("%1 is kept. Rehearse, Guide and the report follow it.").arg(name)
                                        : tr("%1 is kept.").arg(name));
        }
        live_->read_kept();
      });
  name_->clear();
}

void PlanByAnatomy::drop() {
  const int row = plans_->currentRow();
  if (row < 0 || static_cast<std::size_t>(row) >= live_->kept().size() || !context_.may_change()) return;
  const std::string name = live_->kept()[static_cast<std::size_t>(row)].kept.plan.name;
  context_.undo.change(
      {GLISSON_TEXT("Drop the plan {0}"), {name}}, {},
      [folder = folder_, name]() -> Result<void> {
        auto patient = casefile::Case::open(folder);
        if (!patient) return failure(std::move(patient.error()));
        return casefile::drop_plan(*patient, name);
      },
      [this](const Result<void>& dropped) {
        if (!dropped) context_.tell_error(dropped.error());
        live_->read_kept();
      });
}

}  // namespace glisson::widgets
