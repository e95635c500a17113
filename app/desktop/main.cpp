// glisson [--demo | PATH]: the window.

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>

#include "base/files.h"
#include "main_window.h"
#include "theme.h"

int main(int argc, char** argv) {
  // VTK needs a core profile; set before any window exists.
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);

  QApplication application(argc, argv);
  QApplication::setApplicationName("glisson");
  QApplication::setApplicationDisplayName("Glisson");
  QApplication::setApplicationVersion(QString::fromStdString(glisson::version()));
  glisson::widgets::apply_dark_theme(application);
  QApplication::setWindowIcon(QIcon(":/icons/glisson.svg"));

  QCommandLineParser arguments;
  arguments.setApplicationDescription("Planning and reviewing liver surgery. Not a medical device.");
  arguments.addHelpOption();
  arguments.addVersionOption();
  const QCommandLineOption demo("demo", "Open the demo patient.");
  arguments.addOption(demo);
  arguments.addPositionalArgument("PATH", "A case (NAME.glisson), or a folder or file of images.", "[PATH]");
  arguments.process(application);

  glisson::widgets::MainWindow window;
  window.show();
  if (arguments.isSet(demo)) {
    window.open_demo();
  } else if (!arguments.positionalArguments().isEmpty()) {
    window.open_path(std::filesystem::path(arguments.positionalArguments().front().toStdU16String()));
  }
  return QApplication::exec();
}
