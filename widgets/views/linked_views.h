#pragma once
// Three slices through one point, and the patient in space: four views in a square, or laid out otherwise, any of which
// can fill it. A second view in space turns with the first when two bodies are compared.

#include <array>
#include <QGridLayout>
#include <QWidget>
#include <vector>

#include "widgets/views/grey_window.h"
#include "widgets/views/slice_view.h"
#include "widgets/views/space_view.h"
#include "widgets/views/view_frame.h"

namespace glisson::widgets {

enum class ViewLayout { square, space_large, slices_in_a_row, one, side_by_side };

class LinkedViews : public QWidget {
  Q_OBJECT

 public:
  explicit LinkedViews(QWidget* parent = nullptr);

  [[nodiscard]] SpaceView& space() { return *space_; }
  [[nodiscard]] SpaceView& second_space() { return *second_space_; }
  [[nodiscard]] SliceView& slice(SliceDirection direction) { return *slices_[static_cast<std::size_t>(direction)]; }
  [[nodiscard]] const std::array<SliceView*, 3>& slices() const { return slices_; }

  void show_slices(const SliceContent& content);
  void set_crosshair(const Eigen::Vector3d& position_mm);
  [[nodiscard]] const Eigen::Vector3d& crosshair_mm() const { return slices_[0]->crosshair_mm(); }
  void redraw();

  void set_window(double center, double width);
  void choose_window(WindowPreset preset);  // nothing happens for one that the image has not
  [[nodiscard]] GreyWindow window() const { return {slices_[0]->window_center(), slices_[0]->window_width()}; }
  [[nodiscard]] WindowPreset window_preset() const;
  [[nodiscard]] bool shows_hounsfield_units() const;

  // The scan behind the patient in space, where there is one.
  void set_scan_behind(bool behind);
  [[nodiscard]] bool scan_behind() const { return scan_->isChecked(); }

  // The slices' normals; see SliceView::set_axes.
  void set_axes(const Eigen::Matrix3d& axes);
  // The coronal slice across the surgeon's line of sight (scene/camera.h), the others upright and level to it.
  void turn_to_surgeon();
  void straighten();

  // Stands in every picture that is saved; empty for none.
  void set_caption_of_pictures(const QString& caption);
  // Asks where to, for the view that was used last.
  void save_view_in_use();

  // One: the view that was used last.
  void set_layout(ViewLayout layout);
  [[nodiscard]] ViewLayout view_layout() const { return layout_; }
  // Two views in space beside each other, or the layout of before.
  void show_second_space(bool shown);

 Q_SIGNALS:
  void crosshair_moved(const Eigen::Vector3d& position_mm);
  void layout_changed();
  void window_shown();   // brightness and contrast are others, or those of another image
  void window_chosen();  // by a person
  void picture_not_saved(const QString& file);

 private:
  void toggle_maximised(ViewFrame* frame);
  void save_picture(std::size_t frame);
  void arrange(const std::vector<std::array<int, 5>>& places, const std::vector<int>& row_stretches,
               const std::vector<int>& column_stretches);
  [[nodiscard]] int frame_in_use() const;
  void hang_scan();

  std::array<SliceView*, 3> slices_{};
  SpaceView* space_ = nullptr;
  SpaceView* second_space_ = nullptr;
  std::array<ViewFrame*, 5> frames_{};  // transverse, space, coronal, sagittal, second space
  QToolButton* scan_ = nullptr;         // switches the scan behind the patient
  QGridLayout* grid_ = nullptr;
  ViewLayout layout_ = ViewLayout::square;
  ViewLayout before_one_ = ViewLayout::square;
  ViewLayout before_side_by_side_ = ViewLayout::square;
  int last_used_ = 1;
  std::shared_ptr<const imaging::Volume> volume_;  // in the slices
};

}  // namespace glisson::widgets
