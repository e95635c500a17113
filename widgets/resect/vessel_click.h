#pragma once
// Telling which vessel lies at the crosshair: offered are those along whose borders most is in doubt, the first first.

#include <QComboBox>
#include <QPushButton>
#include <QWidget>

#include "vasculature/systems.h"

namespace glisson::widgets {

class VesselClick : public QWidget {
  Q_OBJECT

 public:
  explicit VesselClick(QWidget* parent = nullptr);

  // By what these trees say of their borders; hidden where there are none.
  void offer(const vasculature::VesselTrees* trees);

 Q_SIGNALS:
  void told(glisson::vasculature::Vessel vessel);

 private:
  QComboBox* vessel_;
  QPushButton* tell_;
};

// "Right hepatic vein".
[[nodiscard]] QString vessel_label(vasculature::Vessel vessel);

}  // namespace glisson::widgets
