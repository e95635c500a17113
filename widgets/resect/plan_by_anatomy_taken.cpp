// What is taken besides plane or sheet: segments, around a tumour, along a territory, ablation zones. Each is a step of
// undo, and told in a line with a cross to give it back.

#include <algorithm>
#include <cmath>
#include <QLocale>
#include <QVBoxLayout>

#include "vasculature/couinaud.h"
#include "widgets/panels/parts.h"
#include "widgets/resect/kept_cuts.h"
#include "widgets/resect/plan_by_anatomy.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

using planning::Cut;

// In words, as a list of what goes says it.
QString told(const Cut& cut);

}  // namespace

QWidget* PlanByAnatomy::make_territory_and_ablation() {
  auto* group = new QWidget;
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  along_ = new QWidget(group);
  auto* rows = new QVBoxLayout(along_);
  rows->setContentsMargins(0, 0, 0, 0);
  territory_ = new QComboBox(along_);
  territory_->setObjectName("along_territory");
  territory_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  take_territory_ = named_button("take_territory", along_);
  rows->addWidget(territory_);
  rows->addWidget(take_territory_);
  column->addWidget(along_);
  ablation_ = new AblationControls;
  ablating_ = new Fold("ablating", ablation_, Fold::At::closed, group);
  column->addWidget(ablating_);
  stages_ = new TwoStageControls;
  staging_ = new Fold("staging", stages_, Fold::At::closed, group);
  column->addWidget(staging_);
  connect(stages_, &TwoStageControls::changed, this, [this] { live_->set_embolisation(stages_->embolisation()); });
  taken_text_ = wrapped_label("taken_told", group);
  taken_text_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  column->addWidget(taken_text_);
  connect(take_territory_, &QPushButton::clicked, this, &PlanByAnatomy::take_territory);
  connect(tumour_, &QComboBox::activated, this, &PlanByAnatomy::suggest_territory);
  connect(ablation_, &AblationControls::at_crosshair, this,
          [this] { take(ablation_->zone_at(context_.views.crosshair_mm())); });
  connect(ablation_, &AblationControls::over_tumour, this, &PlanByAnatomy::ablate_tumour);
  connect(ablation_, &AblationControls::changed, this, &PlanByAnatomy::resize_last_ablation);
  connect(taken_text_, &QLabel::linkActivated, this, [this](const QString& cut) { give_back(cut.toULong()); });
  keep_translated(group, [this] {
    take_territory_->setText(tr("Along this territory"));
    take_territory_->setToolTip(
        tr("Removes all that this branch feeds or drains, with what grows from it. Proposed: "
           "the smallest portal territory that holds the tumour above"));
    ablating_->set_title(tr("Ablation"));
    staging_->set_title(tr("Two stages"));
  });
  return group;
}

void PlanByAnatomy::keep_taken() {
  context_.undo.keep(taken_key, [this](const QJsonValue& value) {
    taken_ = cuts_of(value);
    cuts_changed();
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

void PlanByAnatomy::take_segments() { take(planning::SegmentsCut{ticked()}); }

void PlanByAnatomy::take_around() {
  take(planning::MarginCut{tumour_->currentData().toString().toStdString(), margin_->value()});
}

void PlanByAnatomy::take_territory() {
  take(planning::TerritoryCut{territory_->currentData().toString().toStdString()});
}

// About the middle of the tumour's box, in whole millimetres of diameter.
void PlanByAnatomy::ablate_tumour() {
  const auto& structures = context_.patient().structures;
  const auto tumour = std::find_if(structures.begin(), structures.end(), [this](const PatientStructure& structure) {
    return QString::fromStdString(structure.name) == tumour_->currentData().toString();
  });
  if (tumour == structures.end()) return;
  const Eigen::Vector3d middle_mm = geometry::bounding_box(tumour->surface->points_mm).center_mm();
  double radius_mm = 0;
  for (const Eigen::Vector3d& point_mm : tumour->surface->points_mm) {
    radius_mm = std::max(radius_mm, (point_mm - middle_mm).norm());
  }
  radius_mm = 0.5 * std::ceil(2 * (radius_mm + margin_->value()));
  if (radius_mm > planning::largest_ablation_mm) {
    return context_.tell_status(tr("%1 with %2 mm around it needs a zone %3 mm wide; %4 mm is the widest. Set several.")
                                    .arg(structure_label(tumour->name))
                                    .arg(margin_->value())
                                    .arg(2 * radius_mm)
                                    .arg(2 * planning::largest_ablation_mm));
  }
  ablation_->show_ball(radius_mm);
  take(ablation_->zone_at(middle_mm));
}

void PlanByAnatomy::take(const Cut& cut) {
  const bool ablation = std::holds_alternative<planning::AblationCut>(cut);
  const Sentence step{ablation                                              ? GLISSON_TEXT("Set an ablation zone")
                      : std::holds_alternative<planning::MarginCut>(cut)    ? GLISSON_TEXT("Cut around a tumour")
                      : std::holds_alternative<planning::TerritoryCut>(cut) ? GLISSON_TEXT("Cut along a territory")
                                                                            : GLISSON_TEXT("Cut by segments"),
                      {}};
  std::vector<Cut> taken = taken_;
  if (!ablation) std::erase_if(taken, [&](const Cut& other) { return other.index() == cut.index(); });
  taken.push_back(cut);
  set_taken(step, std::move(taken));
}

void PlanByAnatomy::resize_last_ablation() {
  std::vector<Cut> taken = taken_;
  for (auto cut = taken.rbegin(); cut != taken.rend(); ++cut) {
    if (const auto* zone = std::get_if<planning::AblationCut>(&*cut)) {
      *cut = ablation_->zone_at(zone->center_mm);
      return set_taken({GLISSON_TEXT("Change an ablation zone"), {}}, std::move(taken), Step::joins_the_last);
    }
  }
}

void PlanByAnatomy::give_back(std::size_t cut) {
  if (cut >= taken_.size()) return;
  std::vector<Cut> fewer = taken_;
  fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(cut));
  set_taken({GLISSON_TEXT("Give back what was to go"), {}}, std::move(fewer));
}

void PlanByAnatomy::clear() { set_taken({GLISSON_TEXT("Give back what was to go"), {}}, {}); }

void PlanByAnatomy::set_taken(const Sentence& step, std::vector<Cut> taken, Step which) {
  const QJsonValue before = value_of(taken_), after = value_of(taken);
  taken_ = std::move(taken);
  if (before != after) {
    context_.undo.value_changed(step, taken_key, before, after,
                                which == Step::joins_the_last ? Undo::Joins::with_same : Undo::Joins::never);
  }
  cuts_changed();
}

void PlanByAnatomy::take_up(const planning::Plan& plan) {
  taken_.clear();
  for (const Cut& cut : plan.cuts) {
    if (!std::holds_alternative<planning::PlaneCut>(cut) && !std::holds_alternative<planning::SheetCut>(cut)) {
      taken_.push_back(cut);
    }
  }
  plans_->set_name(QString::fromStdString(plan.name));
  cuts_changed();
}

void PlanByAnatomy::show_taken() {
  QStringList lines;
  for (std::size_t cut = 0; cut < taken_.size(); ++cut) {
    lines << QString("%1 <a href=\"%2\" style=\"text-decoration:none\">✕</a>").arg(told(taken_[cut])).arg(cut);
  }
  show_text(taken_text_, lines.join("<br>"));
  taken_text_->setToolTip(tr("✕ gives it back"));
}

void PlanByAnatomy::suggest_territory() {
  const auto& anatomy = live_->anatomy();
  if (!anatomy) return;
  const auto around = anatomy->territory_around.find(tumour_->currentData().toString().toStdString());
  if (around == anatomy->territory_around.end()) return;
  territory_->setCurrentIndex(std::max(0, territory_->findData(QString::fromStdString(around->second))));
}

namespace {

QString told(const Cut& cut) {
  if (const auto* segments = std::get_if<planning::SegmentsCut>(&cut)) {
    QStringList names;
    for (const int segment : segments->segments) names << vasculature::segment_name(static_cast<std::size_t>(segment));
    return PlanByAnatomy::tr("Segments: %1").arg(names.join(", "));
  }
  if (const auto* territory = std::get_if<planning::TerritoryCut>(&cut)) {
    return PlanByAnatomy::tr("Territory: %1").arg(branch_label(territory->branch).toHtmlEscaped());
  }
  if (const auto* around = std::get_if<planning::MarginCut>(&cut)) {
    return PlanByAnatomy::tr("%1 with %2 mm around it")
        .arg(structure_label(around->tumour).toHtmlEscaped())
        .arg(around->margin_mm);
  }
  if (const auto* zone = std::get_if<planning::AblationCut>(&cut)) {
    return PlanByAnatomy::tr("Ablation, %1 × %2 mm")
        .arg(QLocale().toString(2 * zone->radius_along_mm, 'f', 0),
             QLocale().toString(2 * zone->radius_across_mm, 'f', 0));
  }
  return {};
}

}  // namespace
}  // namespace glisson::widgets
