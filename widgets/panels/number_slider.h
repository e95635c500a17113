#pragma once
// A slider and the number it stands for, kept together.

#include <QSlider>
#include <QWidget>

#include "widgets/words/number_box.h"

namespace glisson::widgets {

class NumberSlider : public QWidget {
  Q_OBJECT

 public:
  NumberSlider(double minimum, double maximum, double step, int decimals, QWidget* parent = nullptr);

  void set_suffix(const QString& suffix);
  [[nodiscard]] double value() const { return number_->value(); }
  void set_value(double value);
  // Keeps the value where it still fits.
  void set_range(double minimum, double maximum);

 protected:
  // What is said of the pair holds for both.
  bool event(QEvent* event) override;

 Q_SIGNALS:
  void changed(double value);

 private:
  void show_on_slider();

  double step_;
  QSlider* slider_;
  NumberBox* number_;
};

}  // namespace glisson::widgets
