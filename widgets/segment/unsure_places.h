#pragma once
// Where the border of the chosen structure cannot be seen, whoever drew it. A button goes from one such place to the
// next. A ring in the slices stands around each.

#include <Eigen/Core>
#include <QLabel>
#include <QPushButton>
#include <string>
#include <vector>

#include "segmentation/unsure_border.h"
#include "widgets/segment/slice_overlay.h"
#include "widgets/views/linked_views.h"

namespace glisson::widgets {

class UnsurePlaces : public QWidget {
  Q_OBJECT

 public:
  UnsurePlaces(LinkedViews& views, const StructureEditor& editor, SliceOverlay& overlay, QWidget* parent = nullptr);

 private:
  void look();
  void take(const segmentation::UnsureBorder& found);
  void go_to_next();
  void forget();
  void tell();

  LinkedViews& views_;
  const StructureEditor& editor_;
  SliceOverlay& overlay_;
  QPushButton* button_;
  QLabel* text_;
  enum class State { not_asked, looking, found } state_ = State::not_asked;
  std::string of_;  // the structure that was asked about
  int asked_ = 0;   // counts, so that an answer about an outline of before is not shown
  segmentation::UnsureBorder found_;
  std::size_t at_ = 0;  // the place that the crosshair was put to
};

}  // namespace glisson::widgets
