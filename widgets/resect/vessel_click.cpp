#include "widgets/resect/vessel_click.h"

#include <QCoreApplication>
#include <QVBoxLayout>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/numbers.h"

namespace glisson::widgets {

using vasculature::Vessel;

VesselClick::VesselClick(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  vessel_ = new QComboBox(this);
  vessel_->setObjectName("vessel_at_crosshair");
  vessel_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  tell_ = named_button("tell_vessel", this);
  rows->addWidget(vessel_);
  rows->addWidget(tell_);
  connect(tell_, &QPushButton::clicked, this, [this] {
    if (vessel_->currentIndex() >= 0) Q_EMIT told(static_cast<Vessel>(vessel_->currentData().toInt()));
  });
  keep_translated(this, [this] {
    tell_->setText(tr("Lies at the crosshair"));
    tell_->setToolTip(tr(
        "Put the crosshair on this vessel, in the middle of its course. Vessels and segments are found again by it"));
    vessel_->setToolTip(tr("First stands the vessel whose place would tell most of the borders of segments"));
  });
}

void VesselClick::offer(const vasculature::VesselTrees* trees) {
  setVisible(trees != nullptr && !trees->border_doubts.empty());
  vessel_->clear();
  if (trees == nullptr) return;
  for (const vasculature::BorderDoubt& doubt : trees->border_doubts) {
    vessel_->addItem(tr("%1 (%2 ml in doubt)").arg(vessel_label(doubt.vessel), number(doubt.doubt_ml, 0)),
                     static_cast<int>(doubt.vessel));
  }
  for (const Vessel vessel : {Vessel::portal_vein, Vessel::hepatic_vein}) {
    vessel_->addItem(vessel_label(vessel), static_cast<int>(vessel));
  }
}

QString vessel_label(Vessel vessel) {
  static constexpr std::array<const char*, vasculature::all_vessels.size()> words = {
      QT_TRANSLATE_NOOP("vessels", "Portal vein"),
      QT_TRANSLATE_NOOP("vessels", "Hepatic vein"),
      QT_TRANSLATE_NOOP("vessels", "Middle hepatic vein"),
      QT_TRANSLATE_NOOP("vessels", "Right hepatic vein"),
      QT_TRANSLATE_NOOP("vessels", "Umbilical portion of the left portal vein"),
      QT_TRANSLATE_NOOP("vessels", "Left hepatic vein")};
  return QCoreApplication::translate("vessels", words.at(static_cast<std::size_t>(vessel)));
}

}  // namespace glisson::widgets
