#pragma once
// A box for a number that takes a comma for a dot, as it is typed in most of Europe: 2,5 is 2.5 there and never 25.

#include <QDoubleSpinBox>

namespace glisson::widgets {

class NumberBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  QValidator::State validate(QString& text, int& position) const override {
    text.replace(',', '.');
    return QDoubleSpinBox::validate(text, position);
  }
};

}  // namespace glisson::widgets
