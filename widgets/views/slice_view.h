#pragma once
// One slice through a volume, as radiologists see it. Click or drag with the left button: the crosshair goes there.
// Right button: brightness (up and down) and contrast (across). Wheel, arrow and page keys: next slices. Ctrl and
// wheel: zoom. Middle button or Shift and left: shift. Ctrl and left: turn the picture in its plane. While the mouse is
// in the view, the crosshair's lines carry knobs: dragged, they turn the other two slices. Several of them are linked
// by LinkedViews.

#include <Eigen/Core>
#include <memory>
#include <QPointF>
#include <vector>

#include "imaging/image.h"
#include "widgets/views/render_widget.h"

namespace glisson::widgets {

enum class SliceDirection { transverse, coronal, sagittal };

// What all slice views show.
struct SliceContent {
  std::shared_ptr<const imaging::Volume> volume;
  scene::ColourMap map = scene::ColourMap::grey;
  std::string legend_title;
  double window_center = 0;
  double window_width = 1;
  std::vector<scene::CutLine> cuts;
};

class SliceView : public RenderWidget {
  Q_OBJECT

 public:
  explicit SliceView(SliceDirection direction, QWidget* parent = nullptr);

  [[nodiscard]] SliceDirection direction() const { return direction_; }
  [[nodiscard]] const Eigen::Vector3d& crosshair_mm() const { return crosshair_mm_; }

  void show_content(const SliceContent& content);
  // Moves the slice and its crosshair to that point.
  void set_crosshair(const Eigen::Vector3d& position_mm);
  void set_window(double center, double width);
  [[nodiscard]] double window_center() const { return content_.window_center; }
  [[nodiscard]] double window_width() const { return content_.window_width; }

  // The three slices' normals, a unit column each: sagittal, coronal, transverse. Straight is the identity.
  void set_axes(const Eigen::Matrix3d& axes);
  [[nodiscard]] const Eigen::Matrix3d& axes() const { return axes_; }
  [[nodiscard]] Eigen::Vector3d normal() const;
  // Turns the picture in its plane, clockwise; 0 for upright.
  void set_roll_deg(double roll_deg);
  [[nodiscard]] double roll_deg() const { return roll_deg_; }
  // The whole slice in view.
  void fit();
  // The place of the slice under a position in the widget.
  [[nodiscard]] Eigen::Vector3d place_at(const QPointF& position) const;

 Q_SIGNALS:
  void crosshair_moved(const Eigen::Vector3d& position_mm);
  void window_changed(double center, double width);
  void slice_moved();  // by whatever moved it
  void axes_turned(const Eigen::Matrix3d& axes);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class Fixed { nothing, crosshair, knob, picture };

  [[nodiscard]] scene::Camera straight_camera() const;
  void aim();
  void show_crosshair();
  [[nodiscard]] double knob_reach_px() const;
  [[nodiscard]] bool on_knob(const QPointF& position) const;
  [[nodiscard]] double angle_about_crosshair_rad(const QPointF& position) const;
  void zoom(double factor);
  void point_at(const QPointF& position);
  void step(int slices);
  void tell_position();

  SliceDirection direction_;
  SliceContent content_;
  geometry::Box box_;
  Eigen::Vector3d crosshair_mm_{0, 0, 0};
  scene::Annotations annotations_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  double roll_deg_ = 0;
  Fixed held_ = Fixed::nothing;
  bool hovered_ = false;
  QPointF last_;
  bool fitted_ = false;
};

}  // namespace glisson::widgets
