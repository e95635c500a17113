// glisson [--demo | PATH]: the window.

#include <algorithm>
#include <iterator>
#include <QApplication>
#include <QCommandLineParser>

#include "base/files.h"
#include "base/parallel.h"
#include "widgets/main_window.h"
#include "widgets/settings/settings.h"
#include "widgets/theme.h"
#include "widgets/words/language.h"

namespace {

const QCommandLineOption demo_option("demo", "Open the demo patient.");

void name_application() {
  QCoreApplication::setApplicationName("glisson");
  QCoreApplication::setApplicationVersion(QString::fromStdString(glisson::version()));
}

// Answers --help and --version, and ends the program, itself.
QStringList positional_arguments(QCommandLineParser& parser, const QCoreApplication& application) {
  parser.setApplicationDescription("Planning and reviewing liver surgery. Not a medical device.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addOption(demo_option);
  parser.addPositionalArgument("PATH", "A case (NAME.glisson), or a folder or file of images.", "[PATH]");
  parser.process(application);
  return parser.positionalArguments();
}

bool asks_for_text_only(int argc, char** argv) {
  static constexpr std::string_view text_only[] = {"-h", "--help", "--help-all", "-v", "--version"};
  return std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
    return std::find(std::begin(text_only), std::end(text_only), argument) != std::end(text_only);
  });
}

}  // namespace

int main(int argc, char** argv) {
  QCommandLineParser arguments;
  if (asks_for_text_only(argc, argv)) {  // needs no display
    const QCoreApplication application(argc, argv);
    name_application();
    positional_arguments(arguments, application);
    return 0;
  }

  QApplication application(argc, argv);
  name_application();
  QApplication::setApplicationDisplayName("Glisson");
  glisson::widgets::apply_theme(glisson::widgets::kept_theme());
  glisson::widgets::begin_in_kept_language();
  glisson::set_thread_count(glisson::widgets::kept_threads());
  QApplication::setWindowIcon(QIcon(":/icons/glisson.svg"));

  const QStringList paths = positional_arguments(arguments, application);
  glisson::widgets::MainWindow window;
  window.show();
  if (arguments.isSet(demo_option)) {
    window.open_demo();
  } else if (!paths.isEmpty()) {
    window.open_path(std::filesystem::path(paths.front().toStdU16String()));
  }
  return QApplication::exec();
}
