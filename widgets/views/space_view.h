#pragma once
// The patient in space: turn with the left button, shift with the middle one (or Shift and left), zoom with the wheel
// or the right button; a click without a drag picks what is under it.

#include <QPointF>

#include "vtk/render_widget.h"

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
  void frame_all();

 Q_SIGNALS:
  void clicked(const glisson::scene::View::Pick& pick);
  void camera_changed();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void zoom(double factor);
  void camera_moved_by_hand();

  scene::Scene scene_;
  QPointF pressed_at_;
  QPointF last_;
  bool dragged_ = false;
  bool keeps_all_in_view_ = false;
};

}  // namespace glisson::widgets
