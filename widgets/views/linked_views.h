#pragma once
// Three slices through one point, and the patient in space: four views in a square, any of which can fill it.

#include <array>
#include <QWidget>

#include "views/slice_view.h"
#include "views/space_view.h"
#include "views/view_frame.h"

namespace glisson::widgets {

class LinkedViews : public QWidget {
  Q_OBJECT

 public:
  explicit LinkedViews(QWidget* parent = nullptr);

  [[nodiscard]] SpaceView& space() { return *space_; }
  [[nodiscard]] SliceView& slice(SliceDirection direction) { return *slices_[static_cast<std::size_t>(direction)]; }
  [[nodiscard]] const std::array<SliceView*, 3>& slices() const { return slices_; }

  void show_slices(const SliceContent& content);
  void set_crosshair(const Eigen::Vector3d& position_mm);
  [[nodiscard]] const Eigen::Vector3d& crosshair_mm() const { return slices_[0]->crosshair_mm(); }
  void redraw();

 Q_SIGNALS:
  void crosshair_moved(const Eigen::Vector3d& position_mm);

 private:
  void toggle_maximised(ViewFrame* frame);

  std::array<SliceView*, 3> slices_{};
  SpaceView* space_ = nullptr;
  std::array<ViewFrame*, 4> frames_{};
  ViewFrame* maximised_ = nullptr;
};

}  // namespace glisson::widgets
