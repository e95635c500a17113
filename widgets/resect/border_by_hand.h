#pragma once
// Setting a border of segments by hand: through the crosshair. First stands the border that runs nearest to it.

#include <map>
#include <QComboBox>
#include <QPushButton>
#include <QWidget>
#include <vector>

#include "vasculature/borders.h"

namespace glisson::widgets {

class BorderByHand : public QWidget {
  Q_OBJECT

 public:
  explicit BorderByHand(QWidget* parent = nullptr);

  // Places on each border that the segments have, and those that hands set; hidden where there are none of the former.
  void offer(const vasculature::DrawnBorders& drawn, const vasculature::BorderPlaces& set);
  void crosshair_moved(const Eigen::Vector3d& position_mm);

 Q_SIGNALS:
  void told(const glisson::vasculature::SegmentPair& border);
  void last_dropped();

 private:
  void show_nearest();
  void show_dropping();

  QComboBox* border_;
  QPushButton* tell_;
  QPushButton* drop_;
  vasculature::DrawnBorders drawn_;
  vasculature::BorderPlaces set_;
  Eigen::Vector3d crosshair_mm_{0, 0, 0};
};

// "V–VIII".
[[nodiscard]] QString border_label(const vasculature::SegmentPair& segments);

}  // namespace glisson::widgets
