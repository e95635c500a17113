#pragma once
// Where widget tests keep what they drew, for a person to look at: build/PRESET/pictures.

#include <QDir>
#include <QString>

#include "support/folders.h"

namespace glisson::test {

inline QString kept_pictures() {
  const QString folder = QString::fromStdString((build_folder() / "pictures").string());
  QDir().mkpath(folder);
  return folder;
}

inline QString kept_picture(const char* name) { return kept_pictures() + "/" + name; }

}  // namespace glisson::test
