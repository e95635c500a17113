#pragma once
// A box for a number. All that may become a number can be typed, beyond the limits too. When it is done (Enter, or on
// to another control) the box holds back at its limit and says which. A comma is taken for a dot, as it is typed in
// most of Europe: 2,5 is 2.5 there and never 25.

#include <optional>
#include <QDoubleSpinBox>

namespace glisson::widgets {

class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  // The value changes when the number is done, not with each key.
  explicit NumberBox(QWidget* parent = nullptr);

  QValidator::State validate(QString& text, int& position) const override;
  [[nodiscard]] double valueFromText(const QString& text) const override;
  void fixup(QString& text) const override;

 private:
  [[nodiscard]] std::optional<double> number_in(const QString& text) const;
  [[nodiscard]] QString bare(QString text) const;  // without prefix and unit
  [[nodiscard]] QString in_full(double value) const;
  void say(const QString& what) const;
};

// A box for whole numbers.
[[nodiscard]] NumberBox* whole_number(const char* name, int minimum, int maximum, int value, QWidget* parent = nullptr);

}  // namespace glisson::widgets
