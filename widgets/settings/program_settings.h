#pragma once
// Where the program keeps what a person chose: one place of QSettings, whoever writes there.

#include <QSettings>

namespace glisson::widgets {

// Where the last file was chosen, which may be called after a patient.
inline constexpr const char* last_folder_key = "last_folder";

[[nodiscard]] inline QSettings program_settings() { return QSettings("glisson", "glisson"); }

}  // namespace glisson::widgets
