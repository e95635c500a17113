#include "widgets/register/reading_panel.h"

#include <QLabel>
#include <QPushButton>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {
namespace {

constexpr double reading_tolerances_mm[] = {10, 5, 3};  // section 2.3

}  // namespace

ReadingPanel::ReadingPanel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  QLabel* title = heading();
  column->addWidget(title);
  value_ = new QComboBox;
  value_->setObjectName("heat_value");
  for (const HeatValue value : {HeatValue::correlation, HeatValue::error, HeatValue::doubt})
    value_->addItem({}, static_cast<int>(value));
  connect(value_, &QComboBox::currentIndexChanged, this, &ReadingPanel::value_chosen);
  column->addWidget(value_);
  add_tolerance(*column);
  figures_ = new FiguresTable;
  figures_->setObjectName("figures");
  column->addWidget(figures_);
  column->addStretch(1);
  keep_translated(this, [=, this] {
    title->setText(tr("Reading"));
    value_->setAccessibleName(tr("What the colours show"));
    value_->setItemText(0, tr("Colours: SIRGn's correlation"));
    value_->setItemText(1, tr("Colours: error of the landmarks (mm)"));
    value_->setItemText(2, tr("Colours: doubt (mm)"));
    value_->setToolTip(
        tr("Correlation: whether landmarks and warp move alike over time, 1 is best. Error: mean distance of a "
           "triangle's landmarks, as registered, from where they are on the model, mm. Doubt: motion that the "
           "registration leaves unexplained, mm, to be compared within one sequence."));
  });
}

void ReadingPanel::add_tolerance(QVBoxLayout& column) {
  auto* label = new QLabel;
  column.addWidget(label);
  tolerance_ = new NumberSlider(0.5, 20, 0.5, 1);
  tolerance_->setObjectName("tolerance");
  tolerance_->set_value(5);
  label->setBuddy(tolerance_);
  connect(tolerance_, &NumberSlider::changed, this, &ReadingPanel::tolerance_changed);
  column.addWidget(tolerance_);
  auto* row = new QHBoxLayout;
  std::vector<QPushButton*> presets;
  for (const double mm : reading_tolerances_mm) {
    auto* preset = new QPushButton;
    preset->setObjectName(QString("tolerance_%1").arg(mm));
    connect(preset, &QPushButton::clicked, this, [this, mm] { tolerance_->set_value(mm); });
    row->addWidget(preset);
    presets.push_back(preset);
  }
  column.addLayout(row);
  keep_translated(tolerance_, [=, this] {
    label->setText(tr("Tolerance: rejected from"));
    tolerance_->set_suffix(tr(" mm"));
    tolerance_->setAccessibleName(tr("Tolerance"));
    tolerance_->setToolTip(tr("Triangles whose landmarks are off by this much or more, mm, are grey and hatched"));
    for (std::size_t i = 0; i < presets.size(); ++i) {
      presets[i]->setText(tr("%1 mm").arg(reading_tolerances_mm[i]));
      presets[i]->setToolTip(tr("Sets the tolerance to %1 mm").arg(reading_tolerances_mm[i]));
    }
  });
}

}  // namespace glisson::widgets
