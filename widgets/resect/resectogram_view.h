#pragma once
// The surface of a cut unrolled flat (planning/resectogram.h). It shows in bands how near the tumours are at each place
// of it, and which vessels it cuts where. It is seen upright: the head up, or the front where the cut is seen from the
// head. On the right is the patient's left, or else the back. The pointer is told what is under it.

#include <optional>
#include <QTransform>
#include <QWidget>

#include "planning/resectogram.h"

namespace glisson::widgets {

// Bands as in the plan's report.
inline constexpr double near_band_mm = 5, wide_band_mm = 10;

class ResectogramView : public QWidget {
  Q_OBJECT

 public:
  explicit ResectogramView(QWidget* parent = nullptr);

  void show_map(const planning::Resectogram& map);
  [[nodiscard]] const planning::Resectogram& map() const { return map_; }
  // Where a place of the map, in columns and rows, is drawn.
  [[nodiscard]] QPointF drawn_at(double column, double row) const;
  // "6.1 mm from a tumour", with the vessel's name where there is one.
  [[nodiscard]] QString told_at(const QPointF& pixel) const;

  [[nodiscard]] QSize sizeHint() const override { return {280, 200}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QTransform to_pixels() const;
  void draw_sides(QPainter& painter) const;
  void draw_vessels(QPainter& painter, const QTransform& to_pixels) const;

  planning::Resectogram map_;
};

// The nearest that the cut comes to a tumour; nothing where none is within reach.
[[nodiscard]] std::optional<double> nearest_mm(const planning::Resectogram& map);

// What the colours mean, as a text with patches of them.
[[nodiscard]] QString resectogram_key();

}  // namespace glisson::widgets
