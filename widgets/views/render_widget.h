#pragma once
// A scene in the window. What is shown, and the camera, belong to its scene::View: change that, then call redraw().
//
// Frames are drawn on a thread that serves all views, and shown when they are done. Until then the last one stands. So
// the window itself waits for no drawing, however large the scene and slow the machine. Changes that come while a frame
// is drawn are in the next one, all together. No part of the window is drawn by OpenGL: Qt puts together in memory what
// changed, which takes a fraction of the time where a processor does the graphics card's work.

#include <memory>
#include <QImage>
#include <QWidget>

#include "scene/view.h"

namespace glisson::widgets {

class RenderWidget : public QWidget {
  Q_OBJECT

 public:
  explicit RenderWidget(QWidget* parent = nullptr);
  ~RenderWidget() override;

  [[nodiscard]] scene::View& view() { return view_; }
  [[nodiscard]] const scene::View& view() const { return view_; }
  void redraw();
  // The view as it is now, for others than who sits before it; waits until it is drawn.
  [[nodiscard]] QImage picture();
  // The same with smooth edges, in four times the time: for paper.
  [[nodiscard]] QImage smooth_picture();
  // On a band below pictures, not below the view itself; empty for none.
  void set_caption_of_pictures(const QString& caption) { caption_ = caption; }

  // What drawing the last frame took.
  [[nodiscard]] double last_frame_ms() const { return last_frame_ms_; }
  // Who draws, "llvmpipe (LLVM 15.0.6, 256 bits)"; "unknown" before the first frame.
  [[nodiscard]] QString drawn_by() const { return drawn_by_; }
  // False before the first frame of any view, and once the application has ended: it waits for the frame under way.
  [[nodiscard]] static bool drawing_thread_runs();

 Q_SIGNALS:
  void frame_drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

  // 2 to draw at half the size each way and enlarge: coarser, and four times as fast where pixels are what takes time.
  [[nodiscard]] virtual int shrink() const { return 1; }
  // From the next frame on as finely as can be: what leaves the screen never shows what haste has left out.
  virtual void draw_finely() {}

  // A widget position (logical pixels) in the device pixels that the view counts in.
  [[nodiscard]] QPointF device_position(const QPointF& position) const { return position * devicePixelRatioF(); }
  [[nodiscard]] int device_width() const { return static_cast<int>(width() * devicePixelRatioF()); }
  [[nodiscard]] int device_height() const { return static_cast<int>(height() * devicePixelRatioF()); }
  // mm in the focal plane that one logical pixel spans.
  [[nodiscard]] double mm_per_pixel() const;

 private:
  struct Drawer;
  struct Drawn;

  [[nodiscard]] std::shared_ptr<scene::ViewChanges> take_changes(int oversampling = 1);
  [[nodiscard]] Drawn draw_now(const scene::ViewChanges& changes);
  [[nodiscard]] QImage as_large_as_shown(const QImage& frame) const;
  void begin_frame();
  void show_frame(const Drawn& drawn);

  scene::View view_;
  std::shared_ptr<Drawer> drawer_;  // used on the drawing thread alone
  QImage frame_;
  QString drawn_by_ = "unknown";
  QString caption_;
  QString why_none_;  // nothing can be drawn on this machine
  bool out_of_date_ = true;
  bool due_ = false;        // a frame is to begin in the next turn of the event loop
  bool under_way_ = false;  // one is being drawn
  int frames_begun_ = 0;
  int frame_shown_ = 0;
  double last_frame_ms_ = 0;
};

}  // namespace glisson::widgets
