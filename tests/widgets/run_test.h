#pragma once
// main() of a widget test: the window system set up as the program itself does.

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "theme.h"
#include "words/language.h"

namespace glisson::widgets {

template <typename Test>
int run_test(int argc, char** argv) {
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  // No choice of this computer's user is read or written; the window speaks English until a test says otherwise.
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  qputenv("XDG_DATA_HOME", settings.path().toUtf8());
  choose_language("en");
  apply_theme(Theme::dark);
  begin_in_kept_language();
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace glisson::widgets
