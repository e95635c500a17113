#pragma once
// Where the program keeps what a person chose: one place of QSettings, whoever writes there.

#include <QSettings>

namespace glisson::widgets {

[[nodiscard]] inline QSettings program_settings() { return QSettings("glisson", "glisson"); }

}  // namespace glisson::widgets
