#include "widgets/resect/two_stage_controls.h"

#include <QFormLayout>
#include <QLocale>
#include <QSignalBlocker>

#include "widgets/panels/parts.h"
#include "widgets/resect/plan_by_anatomy.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

TwoStageControls::TwoStageControls(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  branch_ = new QComboBox(this);
  branch_->setObjectName("embolised");
  branch_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  branch_->addItem({});
  growth_ = new NumberBox(this);
  growth_->setObjectName("growth");
  growth_->setRange(0, planning::largest_growth_percent);
  growth_->setDecimals(1);
  growth_->setValue(planning::mean_growth_percent);
  auto* branch_name = new QLabel(this);
  auto* growth_name = new QLabel(this);
  branch_name->setBuddy(branch_);
  growth_name->setBuddy(growth_);
  form->addRow(branch_name, branch_);
  form->addRow(growth_name, growth_);
  text_ = wrapped_label("two_stages_told", this);
  form->addRow(text_);
  connect(branch_, &QComboBox::currentIndexChanged, this, &TwoStageControls::changed);
  connect(growth_, &NumberBox::valueChanged, this, &TwoStageControls::changed);
  keep_translated(this, [=, this] {
    branch_name->setText(tr("Embolised"));
    branch_->setItemText(0, tr("nothing"));
    growth_name->setText(tr("The rest grows"));
    growth_->setSuffix(tr(" %"));
    growth_->setToolTip(
        tr("By how much what keeps its portal inflow grows until the cut. On average it was 37.9 % in "
           "44 studies (van Lienden et al. 2013), less in a cirrhotic liver"));
  });
}

void TwoStageControls::offer(const std::vector<NamedTerritory>& territories) {
  const QString before = branch_->currentData().toString();
  const QSignalBlocker quiet(branch_);
  while (branch_->count() > 1) branch_->removeItem(1);
  for (const NamedTerritory& territory : territories) {
    if (territory.branch.rfind("portal/", 0) != 0) continue;
    branch_->addItem(branch_label(territory.branch), QString::fromStdString(territory.branch));
  }
  branch_->setCurrentIndex(std::max(0, branch_->findData(before)));
}

std::optional<Embolisation> TwoStageControls::embolisation() const {
  if (branch_->currentIndex() <= 0) return {};
  return Embolisation{branch_->currentData().toString().toStdString(), growth_->value()};
}

void TwoStageControls::show(const LivePlanResult* result) {
  const auto number = [](double value, int decimals) { return QLocale().toString(value, 'f', decimals); };
  QStringList lines;
  if (result != nullptr && result->stages_problem) lines << "▲ " + translated(*result->stages_problem);
  if (result != nullptr && result->stages) {
    const planning::TwoStages& stages = *result->stages;
    lines << tr("%1 ml lose their portal inflow and shrink.").arg(number(stages.embolised_ml, 0));
    lines << tr("%1 ml of what stays grow to <b>%2 ml</b>: %3 % of the liver without tumours, %4 % now.")
                 .arg(number(stages.grows_ml, 0), number(stages.grown_ml, 0), number(stages.grown_percent, 1),
                      number(stages.remnant_percent, 1));
    if (stages.embolised_left_ml >= 0.5) {
      lines << tr("▲ %1 ml of the embolised tissue stay in the patient and are not counted.")
                   .arg(number(stages.embolised_left_ml, 0));
    }
    lines << tr("An estimate by the growth above, not a forecast.");
  }
  show_text(text_, lines.join("<br>"));
}

}  // namespace glisson::widgets
