#include "widgets/resect/ablation_controls.h"

#include <array>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"

namespace glisson::widgets {

AblationControls::AblationControls(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  const auto box = [&](const char* name) {
    NumberBox* made = whole_number(name, 2, static_cast<int>(2 * planning::largest_ablation_mm), 30, this);
    connect(made, &NumberBox::valueChanged, this, &AblationControls::changed);
    return made;
  };
  length_ = box("ablation_length");
  width_ = box("ablation_width");
  direction_ = new QComboBox(this);
  direction_->setObjectName("ablation_direction");
  for (int axis = 0; axis < 3; ++axis) direction_->addItem({}, axis);
  connect(direction_, &QComboBox::activated, this, &AblationControls::changed);
  std::array<QLabel*, 3> names{};
  for (std::size_t k = 0; QWidget * field : std::initializer_list<QWidget*>{length_, width_, direction_}) {
    names[k] = new QLabel(this);
    names[k]->setBuddy(field);
    form->addRow(names[k++], field);
  }
  crosshair_ = named_button("ablate_at_crosshair", this);
  tumour_ = named_button("ablate_tumour", this);
  auto* places = new QHBoxLayout;
  places->addWidget(crosshair_);
  places->addWidget(tumour_);
  form->addRow(places);
  connect(crosshair_, &QPushButton::clicked, this, &AblationControls::at_crosshair);
  connect(tumour_, &QPushButton::clicked, this, &AblationControls::over_tumour);
  keep_translated(this, [=, this] {
    names[0]->setText(tr("Length"));
    names[1]->setText(tr("Width"));
    names[2]->setText(tr("Probe"));
    for (NumberBox* each : {length_, width_}) each->setSuffix(tr(" mm"));
    length_->setToolTip(tr("Diameter of the zone along the probe"));
    width_->setToolTip(tr("Diameter of the zone across the probe"));
    direction_->setItemText(0, tr("from the side"));
    direction_->setItemText(1, tr("from the front"));
    direction_->setItemText(2, tr("from below"));
    crosshair_->setText(tr("At the crosshair"));
    crosshair_->setToolTip(tr("Sets a zone of this size about the crosshair"));
    tumour_->setText(tr("Over this tumour"));
    tumour_->setToolTip(tr("Sets the smallest ball that holds the tumour chosen above with its margin"));
  });
}

planning::AblationCut AblationControls::zone_at(const Eigen::Vector3d& center_mm) const {
  return {center_mm, Eigen::Vector3d::Unit(direction_->currentData().toInt()), 0.5 * length_->value(),
          0.5 * width_->value()};
}

void AblationControls::show_ball(double radius_mm) {
  for (NumberBox* each : {length_, width_}) {
    const QSignalBlocker quiet(each);
    each->setValue(2 * radius_mm);
  }
}

}  // namespace glisson::widgets
