#pragma once
// Two stages: the portal branch that is embolised before the cut, by how much the rest grows, and what the cut then
// leaves.

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "widgets/resect/live_plan.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {

class TwoStageControls : public QWidget {
  Q_OBJECT

 public:
  explicit TwoStageControls(QWidget* parent = nullptr);

  // The portal ones of these can be embolised.
  void offer(const std::vector<NamedTerritory>& territories);
  [[nodiscard]] std::optional<Embolisation> embolisation() const;
  void show(const LivePlanResult* result);

 Q_SIGNALS:
  void changed();

 private:
  QComboBox* branch_;  // the first: none
  NumberBox* growth_;
  QLabel* text_;
};

}  // namespace glisson::widgets
