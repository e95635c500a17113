#pragma once
// How a judgement is read: what the colours show, the tolerance, and the figures.

#include <QComboBox>
#include <QVBoxLayout>
#include <QWidget>

#include "widgets/panels/number_slider.h"
#include "widgets/register/figures_table.h"

namespace glisson::widgets {

class ReadingPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ReadingPanel(QWidget* parent = nullptr);

  [[nodiscard]] HeatValue value() const { return static_cast<HeatValue>(value_->currentData().toInt()); }
  [[nodiscard]] double tolerance_mm() const { return tolerance_->value(); }
  [[nodiscard]] FiguresTable& figures() { return *figures_; }

 Q_SIGNALS:
  void value_chosen();
  void tolerance_changed();

 private:
  void add_tolerance(QVBoxLayout& column);

  QComboBox* value_;
  NumberSlider* tolerance_;
  FiguresTable* figures_;
};

}  // namespace glisson::widgets
