#pragma once
// Which of the two bodies is looked at: the patient's own stiffness, the atlas, or both in red and blue, or beside each
// other.

#include <QButtonGroup>
#include <QWidget>

#include "widgets/views/patient_views.h"

namespace glisson::widgets {

class ComparisonChoice : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonChoice(QWidget* parent = nullptr);

  void choose(Bodies bodies);
  // Without a measured stiffness there is the patient alone.
  void set_comparable(bool comparable);
  [[nodiscard]] Bodies chosen() const { return static_cast<Bodies>(group_->checkedId()); }

 Q_SIGNALS:
  void changed(glisson::widgets::Bodies bodies);

 private:
  void update_text();

  QButtonGroup* group_;
  bool comparable_ = true;
};

}  // namespace glisson::widgets
