#pragma once
// Numbers as the chosen language writes them, for tables and sentences.

#include <QLocale>
#include <QString>

namespace glisson::widgets {

[[nodiscard]] inline QString number(double value, int decimals = 1) { return QLocale().toString(value, 'f', decimals); }

}  // namespace glisson::widgets
