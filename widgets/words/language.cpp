#include "widgets/words/language.h"
#include "widgets/settings/program_settings.h"

#include <algorithm>
#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

namespace glisson::widgets {
namespace {

constexpr const char* language_key = "language";

bool spoken(const QString& code) {
  return std::any_of(languages().begin(), languages().end(), [&](const Language& each) { return each.code == code; });
}

// The first of the system's languages that the window speaks.
QString system_language() {
  for (const QString& language : QLocale::system().uiLanguages()) {
    const QString code = language.section(QRegularExpression("[-_]"), 0, 0);
    if (spoken(code)) return code;
  }
  return "en";
}

void install(const QString& file, const QString& folder) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  translator->setObjectName("words");
  if (translator->load(file, folder)) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

QString& language_now() {
  static QString code = "en";
  return code;
}

void speak(const QString& code) {
  const QString language = language_now() = spoken(code) ? code : system_language();
  for (auto* before : QCoreApplication::instance()->findChildren<QTranslator*>("words")) delete before;
  // Qt's own dialogs first: what is installed last is asked first.
  install("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install("glisson_" + language, ":/translations");
}

}  // namespace

const std::vector<Language>& languages() {
  // Names by which those who speak them find them: not translated.
  static const std::vector<Language> all{{"en", "English"}, {"de", "Deutsch"}, {"fr", "Français"}, {"es", "Español"}};
  return all;
}

QString kept_language() { return program_settings().value(language_key).toString(); }

QString spoken_language() { return language_now(); }

void choose_language(const QString& code) {
  program_settings().setValue(language_key, code);
  speak(code);
}

void begin_in_kept_language() {
  QLocale numbers = QLocale::c();
  numbers.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  QLocale::setDefault(numbers);
  speak(kept_language());
}

}  // namespace glisson::widgets
