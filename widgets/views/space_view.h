#pragma once
// The patient in space. The left button turns, the middle one (or Shift and left) shifts, the wheel or the right button
// zooms. A click without a drag picks what is under it. A tool in it is moved by its ends.

#include <optional>
#include <QElapsedTimer>
#include <QPointF>
#include <QTimer>

#include "widgets/views/render_widget.h"

namespace glisson::widgets {

class SpaceView : public RenderWidget {
  Q_OBJECT

 public:
  explicit SpaceView(QWidget* parent = nullptr);

  // Looks from that side at everything that the scene shows.
  void look_from(scene::PatientView side);
  // Replaces what is shown; the camera stays.
  void show_scene(const scene::Scene& scene);
  // Keeps everything in view, from the surgeon's side, until the person moves the camera.
  // What is shown has been moved: one of many in a row is drawn coarser, as while the camera moves.
  void shape_moved();
  void frame_all();
  // As the other view of the same patient looks; says nothing of it.
  void follow(const scene::Camera& camera);
  // Another size leaves the camera to the view that this one follows.
  void set_follower() { follows_ = true; }

  // The ends of a tool's arrow, which can be dragged. The one that touches slides over what is under the mouse, the
  // free one moves in parallel with the picture.
  struct Grips {
    Eigen::Vector3d touch_mm{0, 0, 0};
    Eigen::Vector3d free_end_mm{0, 0, 0};
  };
  void set_grips(const std::optional<Grips>& grips);
  [[nodiscard]] bool over_grip(const QPointF& position) const { return grip_at(position) != Grip::none; }

 Q_SIGNALS:
  void clicked(const glisson::scene::View::Pick& pick);
  void camera_changed();
  void touch_dragged(const glisson::scene::View::Pick& over);
  void free_end_dragged(const Eigen::Vector3d& to_mm, const Eigen::Vector3d& touch_mm);
  void grip_released();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  [[nodiscard]] int shrink() const override;
  void draw_finely() override;

 private:
  enum class Grip { none, touch, free_end };

  [[nodiscard]] Grip grip_at(const QPointF& position) const;
  void drag_grip(const QPointF& position);
  void zoom(double factor);
  void hurry();
  void camera_moved_by_hand();

  scene::Scene scene_;
  QPointF pressed_at_;
  QPointF last_;
  // Full detail again once nothing has moved for a moment.
  QTimer calm_;
  QElapsedTimer since_moved_;
  double full_frame_ms_ = 0;
  bool coarse_ = false;
  bool dragged_ = false;
  std::optional<Grips> grips_;
  Grips at_press_;  // tissue yields under a drag; measured from where it is then, the force would run away
  Grip held_ = Grip::none;
  bool keeps_all_in_view_ = false;
  bool follows_ = false;
};

}  // namespace glisson::widgets
