#include "words.h"

#include <QCoreApplication>

namespace glisson::widgets {

QString told(const std::string& sentence, const std::vector<std::string>& arguments) {
  return QString::fromStdString(
      fill_in(QCoreApplication::translate("errors", sentence.c_str()).toStdString(), arguments));
}

QString told(const Error& error) {
  QString text = told(error.text, error.arguments);
  if (!error.file.empty()) text += " (" + QString::fromStdU16String(error.file.u16string()) + ")";
  if (!error.hint.empty()) text += " " + told(error.hint, error.arguments);
  return text;
}

}  // namespace glisson::widgets
