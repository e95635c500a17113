#pragma once
// main() of a widget test: the window system set up as the program itself does.

#include <cstdio>
#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "widgets/theme.h"
#include "widgets/views/render_widget.h"
#include "widgets/words/language.h"

namespace glisson::widgets {

template <typename Test>
int run_test_in_application(int argc, char** argv) {
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

template <typename Test>
int run_test(int argc, char** argv) {
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  const int failures = run_test_in_application<Test>(argc, argv);
  // A frame drawn while the program's static objects go would take the program down with it, now and then.
  if (!RenderWidget::drawing_thread_runs()) return failures;
  std::fputs("FAIL!  : the views are still being drawn after the application has ended\n", stderr);
  return failures + 1;
}

}  // namespace glisson::widgets
