#include "widgets/words/number_box.h"

#include <algorithm>
#include <QLocale>
#include <QRegularExpression>
#include <QTimer>
#include <QToolTip>

namespace glisson::widgets {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) { setKeyboardTracking(false); }

QValidator::State NumberBox::validate(QString& text, int& /*position*/) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return QValidator::Acceptable;
  text.replace(',', '.');
  static const QRegularExpression number_begun("^[+-]?[0-9]*\\.?[0-9]*([eE][+-]?[0-9]*)?$");
  if (!number_begun.match(bare(text)).hasMatch()) return QValidator::Invalid;
  const std::optional<double> number = number_in(text);
  return number && *number >= minimum() && *number <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

double NumberBox::valueFromText(const QString& text) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return minimum();
  return QString::number(number_in(text).value_or(value()), 'f', decimals()).toDouble();
}

// What is no number at all stays, and Qt goes back to the value before.
void NumberBox::fixup(QString& text) const {
  const std::optional<double> number = number_in(text);
  if (!number) return;
  text = in_full(std::clamp(*number, minimum(), maximum()));
  if (*number > maximum()) say(tr("At most %1.").arg(in_full(maximum())));
  if (*number < minimum()) say(tr("At least %1.").arg(in_full(minimum())));
}

std::optional<double> NumberBox::number_in(const QString& text) const {
  bool is_number = false;
  const double number = QLocale::c().toDouble(bare(text), &is_number);
  return is_number ? std::optional(number) : std::nullopt;
}

QString NumberBox::bare(QString text) const {
  if (!prefix().isEmpty() && text.startsWith(prefix())) text.remove(0, prefix().size());
  for (const QString& unit : {suffix(), suffix().trimmed()}) {
    if (!unit.isEmpty() && text.endsWith(unit)) text.chop(unit.size());
  }
  return text.trimmed();
}

QString NumberBox::in_full(double value) const { return prefix() + textFromValue(value) + suffix(); }

// After the focus has moved on, which would close the note.
void NumberBox::say(const QString& what) const {
  constexpr int long_enough_to_read_ms = 4000;
  QTimer::singleShot(0, this, [this, what] {
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), what, const_cast<NumberBox*>(this), rect(),
                       long_enough_to_read_ms);
  });
}

NumberBox* whole_number(const char* name, int minimum, int maximum, int value, QWidget* parent) {
  auto* box = new NumberBox(parent);
  box->setObjectName(name);
  box->setDecimals(0);
  box->setRange(minimum, maximum);
  box->setValue(value);
  return box;
}

}  // namespace glisson::widgets
