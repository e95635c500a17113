#pragma once
// A scene in the window: Qt 6's OpenGL widget as the host of a VTK render window.
//
// The widget owns the render window and its renderer; what is shown, and the camera, belong to its scene::View. Change
// the view, then call redraw(): frames are drawn when Qt asks for them, never in between.

#include <memory>
#include <QOpenGLWidget>

#include "scene/view.h"

namespace glisson::widgets {

class RenderWidget : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit RenderWidget(QWidget* parent = nullptr);
  ~RenderWidget() override;

  [[nodiscard]] scene::View& view();
  [[nodiscard]] const scene::View& view() const;
  void redraw() { update(); }

  // What drawing the last frame took, without Qt's own copying to the screen.
  [[nodiscard]] double last_frame_ms() const { return last_frame_ms_; }

 protected:
  void initializeGL() override;
  void paintGL() override;

  // 2 to draw at half the size each way and enlarge: coarser, and four times as fast where pixels are what takes time.
  [[nodiscard]] virtual int shrink() const { return 1; }

  // A widget position (logical pixels) in the device pixels that the view counts in.
  [[nodiscard]] QPointF device_position(const QPointF& position) const { return position * devicePixelRatioF(); }
  [[nodiscard]] int device_width() const { return static_cast<int>(width() * devicePixelRatioF()); }
  [[nodiscard]] int device_height() const { return static_cast<int>(height() * devicePixelRatioF()); }
  // mm in the focal plane that one logical pixel spans.
  [[nodiscard]] double mm_per_pixel() const;

 private:
  void make_context_current();
  void release_graphics();

  struct Vtk;
  std::unique_ptr<Vtk> vtk_;
  std::unique_ptr<scene::View> view_;
  double last_frame_ms_ = 0;
};

}  // namespace glisson::widgets
