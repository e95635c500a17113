#include "widgets/resect/plan_list.h"

#include <algorithm>
#include <numeric>
#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>

#include "planning/ranking.h"
#include "widgets/panels/parts.h"
#include "widgets/panels/small_table.h"
#include "widgets/theme.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

using planning::PlanAnswer;
using planning::RankBy;

constexpr int as_kept = -1;

QString percent(double value) { return QLocale().toString(value, 'f', 0) + " %"; }

// The places of those that hold, with their answers.
std::pair<std::vector<std::size_t>, std::vector<PlanAnswer>> those_that_hold(const std::vector<KeptPlanAnswer>& kept) {
  std::pair<std::vector<std::size_t>, std::vector<PlanAnswer>> found;
  for (std::size_t plan = 0; plan < kept.size(); ++plan) {
    if (!kept[plan].answer) continue;
    found.first.push_back(plan);
    found.second.push_back(*kept[plan].answer);
  }
  return found;
}

}  // namespace

PlanList::PlanList(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  title_ = heading(this);
  rank_by_ = new QComboBox(this);
  rank_by_->setObjectName("rank_plans");
  for (const int by : {as_kept, int(RankBy::margin), int(RankBy::living), int(RankBy::branches)}) {
    rank_by_->addItem({}, by);
  }
  auto* top = new QHBoxLayout;
  top->addWidget(title_);
  top->addWidget(rank_by_, 1);
  column->addLayout(top);
  plans_ = small_table("plans", 5, this);
  plans_->setSelectionBehavior(QAbstractItemView::SelectRows);
  plans_->setSelectionMode(QAbstractItemView::SingleSelection);
  column->addWidget(plans_);
  plot_ = new PlanPlot(this);
  column->addWidget(plot_);
  plot_text_ = wrapped_label("faint", this);
  column->addWidget(plot_text_);
  name_ = new QLineEdit(this);
  name_->setObjectName("plan_name");
  keep_ = named_button("keep_plan", this);
  auto* keeping = new QHBoxLayout;
  keeping->addWidget(name_, 1);
  keeping->addWidget(keep_);
  column->addLayout(keeping);
  copy_ = named_button("copy_plan", this);
  drop_ = named_button("drop_plan", this);
  auto* others = new QHBoxLayout;
  others->addWidget(copy_);
  others->addWidget(drop_);
  column->addLayout(others);

  connect(rank_by_, &QComboBox::currentIndexChanged, this, [this] { show_plans(std::vector(kept_)); });
  connect(plans_, &QTableWidget::cellClicked, this, &PlanList::choose_row);
  connect(plot_, &PlanPlot::clicked, this, [this](std::size_t dot) {
    const auto row = std::find(order_.begin(), order_.end(), plotted_[dot]) - order_.begin();
    plans_->selectRow(static_cast<int>(row));
    choose_row(static_cast<int>(row));
  });
  connect(plans_, &QTableWidget::itemSelectionChanged, this, [this] {
    for (QPushButton* each : {copy_, drop_}) each->setEnabled(!plans_->selectedItems().isEmpty());
  });
  connect(keep_, &QPushButton::clicked, this, [this] {
    const QString name = name_->text().trimmed();
    name_->clear();
    Q_EMIT keep_wanted(name.isEmpty() ? tr("Plan %1").arg(kept_.size() + 1) : name);
  });
  const auto marked = [this] { return plan_in(plans_->currentRow()); };
  connect(copy_, &QPushButton::clicked, this, [this, marked] { Q_EMIT copy_wanted(marked()); });
  connect(drop_, &QPushButton::clicked, this, [this, marked] { Q_EMIT drop_wanted(marked()); });
  keep_translated(this, [this] { update_text(); });
}

void PlanList::update_text() {
  title_->setText(tr("Plans"));
  rank_by_->setItemText(0, tr("as they were kept"));
  rank_by_->setItemText(1, tr("widest margin first"));
  rank_by_->setItemText(2, tr("most tissue alive first"));
  rank_by_->setItemText(3, tr("least tissue cut off first"));
  rank_by_->setToolTip(tr("Plans that leave a tumour, or cut through one, come after those that do not"));
  plans_->setHorizontalHeaderLabels({tr("Plan"), tr("Stays"), tr("Alive"), tr("Margin"), tr("Cut")});
  plans_->horizontalHeaderItem(stays_percent_column)->setToolTip(tr("Of the liver without its tumours"));
  plans_->horizontalHeaderItem(alive_column)->setToolTip(tr("What stays perfused and drained, of the same"));
  plans_->horizontalHeaderItem(cut_branches_column)->setToolTip(tr("Branches that are cut"));
  plot_text_->setText(tr("A ring: another plan is no worse in margin, living tissue and tumours, and better in one."));
  name_->setPlaceholderText(tr("Name of the plan"));
  keep_->setText(tr("Keep this plan"));
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Keeps the plan that is marked a second time, to be changed"));
  drop_->setText(tr("Drop"));
  drop_->setToolTip(tr("Takes the plan that is marked out of the case"));
  show_plans(std::vector(kept_));
}

void PlanList::allow_keeping(bool allowed, const QString& told) {
  keep_->setEnabled(allowed);
  keep_->setToolTip(told);
}

void PlanList::show_plans(const std::vector<KeptPlanAnswer>& kept) {
  const std::string marked = marked_name();
  kept_ = kept;
  fill();
  mark(marked);
}

std::string PlanList::marked_name() const {
  return plans_->selectedItems().isEmpty() ? std::string() : kept_[plan_in(plans_->currentRow())].kept.plan.name;
}

void PlanList::mark(const std::string& name) {
  for (int row = 0; row < plans_->rowCount(); ++row) {
    if (kept_[plan_in(row)].kept.plan.name == name) plans_->selectRow(row);
  }
}

void PlanList::fill() {
  for (QWidget* each : std::initializer_list<QWidget*>{plans_, copy_, drop_}) each->setVisible(!kept_.empty());
  rank_by_->setVisible(kept_.size() > 1);
  const auto [hold, answers] = those_that_hold(kept_);
  beaten_by_.assign(kept_.size(), {});
  const auto better = planning::beaten_by(answers);
  for (std::size_t n = 0; n < hold.size(); ++n) {
    for (const std::size_t other : better[n]) {
      beaten_by_[hold[n]] << QString::fromStdString(kept_[hold[other]].kept.plan.name);
    }
  }
  order_.resize(kept_.size());
  std::iota(order_.begin(), order_.end(), 0);
  if (const int by = rank_by_->currentData().toInt(); by != as_kept) {  // those that no longer hold stand last
    std::stable_partition(order_.begin(), order_.end(),
                          [this](std::size_t plan) { return kept_[plan].answer.has_value(); });
    const auto ranked = planning::ranked(answers, static_cast<RankBy>(by));
    std::transform(ranked.begin(), ranked.end(), order_.begin(), [&hold = hold](std::size_t n) { return hold[n]; });
  }
  plans_->clearSelection();
  plans_->setRowCount(static_cast<int>(kept_.size()));
  for (QPushButton* each : {copy_, drop_}) each->setEnabled(false);
  for (int row = 0; row < plans_->rowCount(); ++row) fill_row(row, kept_[plan_in(row)]);
  fit_height(*plans_);
  plot();
}

void PlanList::fill_row(int row, const KeptPlanAnswer& plan) {
  const auto put = [&](int column, const auto& value) {
    QTableWidgetItem* cell = put_text(*plans_, row, column, plan.answer ? value(*plan.answer) : QString("–"));
    cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  };
  QTableWidgetItem* name = put_text(*plans_, row, name_column, QString::fromStdString(plan.kept.plan.name));
  QFont font = plans_->font();
  font.setBold(plan.followed);
  name->setFont(font);
  QStringList told;
  if (plan.followed) told << tr("Rehearse, Guide and the report follow this plan");
  if (!plan.kept.remarks.empty() || plan.problem) {
    name->setText("▲ " + name->text());
    told = QStringList{plan.problem ? translated(*plan.problem)
                                    : tr("What it was made from has changed since; the figures are those of now.")};
  }
  if (const QStringList& better = beaten_by_[plan_in(row)]; !better.isEmpty()) {
    told << tr("No worse in anything, and better in something: %1").arg(better.join(", "));
    name->setForeground(theme_colour("faint"));
  }
  if (!told.isEmpty()) name->setToolTip(told.join("\n"));
  put(stays_percent_column, [](const PlanAnswer& answer) { return percent(answer.remnant_percent()); });
  put(alive_column,
      [](const PlanAnswer& answer) { return answer.living_ml ? percent(answer.living_percent()) : QString("–"); });
  put(margin_column, [](const PlanAnswer& answer) {
    if (!answer.margin_mm) return QString("–");
    return (answer.margin_is_at_least ? "≥ " : "") + QLocale().toString(*answer.margin_mm, 'f', 1);
  });
  put(cut_branches_column, [](const PlanAnswer& answer) { return QString::number(answer.branches.size()); });
}

// Two plans and more that can be compared: with a margin.
void PlanList::plot() {
  std::vector<PlottedPlan> dots;
  plotted_.clear();
  bool any_beaten = false;
  for (std::size_t plan = 0; plan < kept_.size(); ++plan) {
    const auto& answer = kept_[plan].answer;
    if (!answer || !answer->margin_mm) continue;
    const bool beaten = !beaten_by_[plan].isEmpty();
    any_beaten = any_beaten || beaten;
    dots.push_back({QString::fromStdString(kept_[plan].kept.plan.name), *answer->margin_mm,
                    answer->living_ml.value_or(answer->functional_remnant_ml), beaten});
    plotted_.push_back(plan);
  }
  plot_->setVisible(dots.size() > 1);
  plot_text_->setVisible(dots.size() > 1 && any_beaten);
  plot_->show_plans(dots);
}

void PlanList::choose_row(int row) {
  if (row >= 0 && static_cast<std::size_t>(row) < order_.size()) Q_EMIT chosen(plan_in(row));
}

}  // namespace glisson::widgets
