#include "widgets/resect/plan_by_anatomy.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/panels/small_table.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

Result<void> keep_in(const std::filesystem::path& folder, const planning::Plan& plan,
                     const planning::PlanAnswer& answer, const OpenedAnatomy& anatomy) {
  auto patient = casefile::Case::open(folder);
  if (!patient) return failure(std::move(patient.error()));
  const auto id = casefile::keep_plan(*patient, plan, answer, anatomy.planner.trees());
  return id ? Result<void>() : failure(id.error());
}

}  // namespace

PlanByAnatomy::PlanByAnatomy(WorkspaceContext context, QWidget* parent)
    : QWidget(parent), context_(std::move(context)) {
  live_ = new LivePlan(this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 6, 0, 0);
  column->setSpacing(8);
  column->addWidget(make_unrolled());
  column->addWidget(make_anatomy());
  column->addWidget(make_answer());
  make_plans();
  column->addWidget(plans_);
  column->addWidget(make_growth());
  connect(live_, &LivePlan::opened, this, &PlanByAnatomy::show_anatomy);
  connect(live_, &LivePlan::changed, this, &PlanByAnatomy::show_answer);
  connect(live_, &LivePlan::kept_changed, this, [this] {
    plans_->show_plans(live_->kept());
    growth_->offer(live_->kept());
  });
  connect(&context_.undo, &Undo::entries_moved, this, [this](const QStringList& ids) {
    const bool plans = std::any_of(ids.begin(), ids.end(), [](const QString& id) {
      return id.startsWith("plans/") || id.startsWith("results/");  // the list, and which of them is followed
    });
    if (plans) live_->read_kept();
  });
  keep_translated(this, [this] {
    show_anatomy();
    show_answer();
    show_keeping();
    show_taken();
    Q_EMIT told_places_changed();
  });
  keep_taken();
}

QWidget* PlanByAnatomy::make_anatomy() {
  by_anatomy_ = new QWidget(this);
  QWidget* group = by_anatomy_;
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  QLabel* title = heading(group);
  column->addWidget(title);
  text_ = wrapped_label("anatomy_told", group);
  column->addWidget(text_);
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
  vessel_click_ = new VesselClick(anatomy_);
  rows->addWidget(vessel_click_);
  border_by_hand_ = new BorderByHand(anatomy_);
  rows->addWidget(border_by_hand_);
  column->addWidget(anatomy_);

  around_ = new QWidget(group);
  auto* around = new QHBoxLayout(around_);
  around->setContentsMargins(0, 0, 0, 0);
  tumour_ = new QComboBox(around_);
  tumour_->setObjectName("around_tumour");
  margin_ = whole_number("around_margin", 0, static_cast<int>(planning::largest_margin_mm), 10, around_);
  take_around_ = named_button("take_around", around_);
  around->addWidget(tumour_, 1);
  around->addWidget(margin_);
  around->addWidget(take_around_, 1);
  column->addWidget(around_);
  column->addWidget(make_territory_and_ablation());

  connect(find_, &QPushButton::clicked, this, [this] { find_segments(told_before()); });
  connect_what_is_told();
  connect(take_segments_, &QPushButton::clicked, this, &PlanByAnatomy::take_segments);
  connect(take_around_, &QPushButton::clicked, this, &PlanByAnatomy::take_around);
  connect(show_segments_, &QCheckBox::toggled, this, &PlanByAnatomy::drawing_changed);
  connect(segments_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (item->column() == segment_column) take_segments_->setEnabled(!ticked().empty());
  });
  keep_translated(group, [=, this] {
    title->setText(tr("Segments and tumours"));
    find_->setText(tr("Find segments"));
    find_->setToolTip(
        tr("By the portal and hepatic veins where both are outlined, else by the liver's shape alone. Arteries "
           "and bile ducts that are outlined get trees too"));
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
    branches_->setHorizontalHeaderLabels({tr("Branch"), tr("mm"), tr("Beyond"), tr("Left")});
    branches_->horizontalHeaderItem(width_column)->setToolTip(tr("Diameter where it is cut"));
    branches_->horizontalHeaderItem(beyond_column)
        ->setToolTip(
            tr("All tissue that it feeds or drains beyond the cut; of an artery or a bile duct its own length"));
    branches_->horizontalHeaderItem(left_column)->setToolTip(tr("What of that stays in the patient without it"));
  });
  return answer_;
}

QWidget* PlanByAnatomy::make_unrolled() {
  auto* held = new QWidget;
  auto* column = new QVBoxLayout(held);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  resectogram_ = new ResectogramView(held);
  column->addWidget(resectogram_);
  nearest_ = wrapped_label("unrolled_told", held);
  column->addWidget(nearest_);
  resectogram_key_ = wrapped_label("faint", held);
  column->addWidget(resectogram_key_);
  unrolled_ = new Fold("unrolled", held, Fold::At::open, this);
  live_->set_unrolling(true);
  connect(unrolled_, &Fold::toggled, live_, &LivePlan::set_unrolling);
  keep_translated(unrolled_, [this] {
    unrolled_->set_title(tr("The cut unrolled flat"));
    resectogram_key_->setText(resectogram_key());
  });
  return unrolled_;
}

void PlanByAnatomy::make_plans() {
  plans_ = new PlanList(this);
  connect(plans_, &PlanList::chosen, this,
          [this](std::size_t plan) { Q_EMIT plan_chosen(live_->kept()[plan].kept.plan); });
  connect(plans_, &PlanList::keep_wanted, this, &PlanByAnatomy::keep);
  connect(plans_, &PlanList::copy_wanted, this, &PlanByAnatomy::copy);
  connect(plans_, &PlanList::drop_wanted, this, &PlanByAnatomy::drop);
}

QWidget* PlanByAnatomy::make_growth() {
  growth_ = new GrowthControls;
  growing_ = new Fold("growing", growth_, Fold::At::closed, this);
  keep_translated(growing_, [this] { growing_->set_title(tr("Growth since an earlier study")); });
  return growing_;
}

void PlanByAnatomy::show_patient(const Patient& patient) {
  if (patient.folder != folder_) {
    taken_.clear();
    plans_->set_name({});
    show_taken();
  } else if (looked_at_mm_) {
    context_.views.set_crosshair(*looked_at_mm_);  // a patient shown anew is looked at in the middle
  }
  looked_at_mm_.reset();
  folder_ = patient.folder;
  by_anatomy_->setVisible(!folder_.empty());
  growing_->setVisible(!folder_.empty());
  growth_->show_case(folder_);
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

std::vector<planning::Cut> PlanByAnatomy::cuts() const {
  std::vector<planning::Cut> all = taken_;
  const bool at_rest = surface_ && surface_->liver == casefile::PlannedCut::Liver::at_rest;
  if (at_rest) all.insert(all.begin(), casefile::cut_of(*surface_));
  return all;
}

void PlanByAnatomy::cuts_changed() {
  show_taken();
  live_->set_cuts(cuts());
  Q_EMIT taken_changed();
}

bool PlanByAnatomy::complete() const {
  const std::vector<planning::Cut> wanted = cuts();
  if (folder_.empty() || live_->opening() || (wanted.empty() && !divides_liver())) return false;
  if (divides_liver() && (!resection_ || resection_->cut != *surface_)) return false;
  if (!live_->anatomy() || wanted.empty() || live_->problem()) return divides_liver();
  return live_->result() && live_->result()->cuts == wanted;
}

void PlanByAnatomy::keep(const QString& name) {
  if (!complete() || !context_.may_change()) return;
  const auto resection = divides_liver() ? resection_ : nullptr;
  const auto anatomy = live_->anatomy();
  const auto answered = anatomy && !cuts().empty() ? live_->result() : nullptr;
  context_.undo.change(
      {GLISSON_TEXT("Keep the plan {0}"), {name.toStdString()}}, {},
      [folder = folder_, name = name.toStdString(), resection, anatomy, answered]() -> Result<void> {
        if (answered) {
          const planning::Plan plan{name, answered->cuts};
          auto kept = keep_in(folder, plan, answered->answer, *anatomy);
          if (!kept || !resection) return kept;
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
}

// "Right hemihepatectomy (2)", or as far as one must count.
void PlanByAnatomy::copy(std::size_t number) {
  if (number >= live_->kept().size() || !context_.may_change()) return;
  const KeptPlanAnswer original = live_->kept()[number];
  if (!original.answer) return context_.tell_error(*original.problem);
  planning::Plan plan = original.kept.plan;
  const auto is_kept = [&](const std::string& name) {
    return std::any_of(live_->kept().begin(), live_->kept().end(),
                       [&](const KeptPlanAnswer& other) { return other.kept.plan.name == name; });
  };
  for (int n = 2; is_kept(plan.name); ++n) plan.name = original.kept.plan.name + " (" + std::to_string(n) + ")";
  Q_EMIT plan_chosen(plan);
  context_.undo.change(
      {GLISSON_TEXT("Copy the plan {0}"), {original.kept.plan.name}}, {},
      [folder = folder_, plan, answer = *original.answer, anatomy = live_->anatomy()] {
        return keep_in(folder, plan, answer, *anatomy);
      },
      [this](const Result<void>& kept) {
        if (!kept) context_.tell_error(kept.error());
        live_->read_kept();
      });
}

void PlanByAnatomy::drop(std::size_t number) {
  if (number >= live_->kept().size() || !context_.may_change()) return;
  const std::string name = live_->kept()[number].kept.plan.name;
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
