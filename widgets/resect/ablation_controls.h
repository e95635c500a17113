#pragma once
// The controls of ablation zones. They say how long and wide a zone is, which way its probe points, and where one is
// set: at the crosshair, or around a tumour.

#include <QComboBox>
#include <QPushButton>
#include <QWidget>

#include "planning/cut.h"
#include "widgets/words/number_box.h"

namespace glisson::widgets {

class AblationControls : public QWidget {
  Q_OBJECT

 public:
  explicit AblationControls(QWidget* parent = nullptr);

  // As the controls say, about that place.
  [[nodiscard]] planning::AblationCut zone_at(const Eigen::Vector3d& center_mm) const;
  // A ball's size; its direction stays.
  void show_ball(double radius_mm);
  void allow_tumour(bool has_tumour) { tumour_->setVisible(has_tumour); }

 Q_SIGNALS:
  void at_crosshair();
  void over_tumour();
  void changed();  // by the person: the zone set last is to follow

 private:
  NumberBox* length_;
  NumberBox* width_;
  QComboBox* direction_;
  QPushButton* crosshair_;
  QPushButton* tumour_;
};

}  // namespace glisson::widgets
