#pragma once
// Numbers as the chosen language writes them, for tables and sentences.

#include <QLocale>
#include <QString>

namespace glisson::widgets {

[[nodiscard]] inline QString number(double value, int decimals = 1) { return QLocale().toString(value, 'f', decimals); }

// So many digits that mean something: 1234.5 is 1.23e+03.
[[nodiscard]] inline QString significant(double value, int digits = 3) {
  return QLocale().toString(value, 'g', digits);
}

// What stands in a table where there is no number.
[[nodiscard]] inline QString no_figure() { return QString::fromUtf8("\u2013"); }

}  // namespace glisson::widgets
