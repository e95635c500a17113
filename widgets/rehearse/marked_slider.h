#pragma once
// A slider whose track changes its colour from some value on: what lies beyond can be chosen, and is seen to be beyond.

#include <optional>
#include <QSlider>

namespace glisson::widgets {

class MarkedSlider : public QSlider {
  Q_OBJECT

 public:
  using QSlider::QSlider;

  void set_mark(std::optional<double> value);  // nothing: no mark
  [[nodiscard]] std::optional<double> mark() const { return mark_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<double> mark_;
};

}  // namespace glisson::widgets
