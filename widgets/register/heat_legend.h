#pragma once
// The one colour scale that two heat meshes are read by, with its numbers, and how a rejected triangle looks.

#include <QWidget>

#include "scene/heat_overlay.h"

namespace glisson::widgets {

class HeatLegend : public QWidget {
  Q_OBJECT

 public:
  explicit HeatLegend(QWidget* parent = nullptr);

  void set_words(const QString& title, const QString& good, const QString& bad, const QString& rejected);
  void show_scale(const scene::HeatScale& scale);
  [[nodiscard]] const scene::HeatScale& scale() const { return scale_; }

  [[nodiscard]] QSize sizeHint() const override { return {96, 300}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString title_, good_, bad_, rejected_;
  scene::HeatScale scale_;
};

}  // namespace glisson::widgets
