#pragma once
// main() of a widget test: the window system set up as the program itself does.

#include <QApplication>
#include <QSurfaceFormat>
#include <QtTest>

#include "theme.h"

namespace glisson::widgets {

template <typename Test>
int run_test(int argc, char** argv) {
  QSurfaceFormat format;  // VTK needs a core profile
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  apply_dark_theme(application);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace glisson::widgets
