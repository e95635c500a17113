#pragma once
// One algorithm's heat mesh over a frame of the video. A rejected triangle is grey and hatched, the chosen one has a
// thick white rim: none of it is told by colour alone.

#include <functional>
#include <optional>
#include <QImage>
#include <QWidget>
#include <vector>

#include "scene/heat_overlay.h"

namespace glisson::widgets {

class HeatVideo : public QWidget {
  Q_OBJECT

 public:
  explicit HeatVideo(QWidget* parent = nullptr);

  // What stands above the picture, and what is said in place of the mesh where there is none.
  void set_words(const QString& title, const QString& remark);
  // A null image is drawn as an empty frame of its size in pixels.
  void show_frame(const QImage& frame, QSize size_px);
  void show_mesh(const scene::HeatMesh& mesh, const vision::Camera& camera, const scene::HeatScale& scale);
  void show_no_mesh();
  void choose(std::optional<std::size_t> triangle);
  // What hovering over a triangle says.
  void set_hint(std::function<QString(std::size_t triangle)> hint) { hint_ = std::move(hint); }

  // In pixels of the frame. The nearest of those that lie over one another.
  [[nodiscard]] std::optional<std::size_t> triangle_at(const QPointF& pixel) const;
  [[nodiscard]] std::optional<QPointF> middle_of(std::size_t triangle) const;
  // From the frame's pixels to the widget's.
  [[nodiscard]] QPointF on_widget(const QPointF& pixel) const;
  [[nodiscard]] const std::vector<scene::SeenTriangle>& seen() const { return seen_; }
  [[nodiscard]] const QString& title() const { return title_; }

  [[nodiscard]] QSize sizeHint() const override { return {520, 420}; }

 Q_SIGNALS:
  void clicked(const QPointF& pixel);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QRectF place() const;  // of the frame on the widget
  [[nodiscard]] QPointF on_frame(const QPointF& widget) const;
  void draw_mesh(QPainter& painter) const;

  QString title_, remark_;
  QImage frame_;
  QSize size_px_;
  scene::HeatMesh mesh_;
  scene::HeatScale scale_;
  std::vector<scene::SeenTriangle> seen_;
  std::optional<std::size_t> chosen_;
  std::function<QString(std::size_t)> hint_;
};

}  // namespace glisson::widgets
