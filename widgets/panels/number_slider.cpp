#include "widgets/panels/number_slider.h"

#include <cmath>
#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>

namespace glisson::widgets {

NumberSlider::NumberSlider(double minimum, double maximum, double step, int decimals, QWidget* parent)
    : QWidget(parent), step_(step) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  slider_ = new QSlider(Qt::Horizontal, this);
  number_ = new NumberBox(this);
  number_->setDecimals(decimals);
  number_->setSingleStep(step);
  number_->setFixedWidth(112);
  row->addWidget(slider_, 1);
  row->addWidget(number_);
  setFocusProxy(slider_);
  set_range(minimum, maximum);
  connect(slider_, &QSlider::valueChanged, this, [this](int steps) { number_->setValue(steps * step_); });
  connect(number_, &NumberBox::valueChanged, this, [this](double value) {
    show_on_slider();
    Q_EMIT changed(value);
  });
}

void NumberSlider::set_suffix(const QString& suffix) { number_->setSuffix(suffix); }

void NumberSlider::set_value(double value) { number_->setValue(value); }

void NumberSlider::set_range(double minimum, double maximum) {
  {
    const QSignalBlocker quiet(slider_);
    slider_->setRange(static_cast<int>(std::ceil(minimum / step_ - 1e-9)),
                      static_cast<int>(std::floor(maximum / step_ + 1e-9)));
  }
  number_->setRange(minimum, maximum);
  show_on_slider();
}

bool NumberSlider::event(QEvent* event) {
  if (event->type() == QEvent::ToolTipChange) {
    for (QWidget* each : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(number_)}) {
      each->setAccessibleName(accessibleName());
      each->setToolTip(toolTip());
    }
  }
  return QWidget::event(event);
}

void NumberSlider::show_on_slider() {
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(number_->value() / step_)));
}

}  // namespace glisson::widgets
