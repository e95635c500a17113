#include "widgets/words/translated.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "base/error_file.h"

namespace glisson::widgets {
namespace {

// The structures of segmentation/structures.h and what the demo marks, for the translation tools to find.
[[maybe_unused]] constexpr const char* known_structures[] = {
    QT_TRANSLATE_NOOP("structures", "Liver"),
    QT_TRANSLATE_NOOP("structures", "Planned cut"),
    QT_TRANSLATE_NOOP("structures", "Segments"),
    QT_TRANSLATE_NOOP("structures", "Tumour"),
    QT_TRANSLATE_NOOP("structures", "Cyst"),
    QT_TRANSLATE_NOOP("structures", "Portal vein"),
    QT_TRANSLATE_NOOP("structures", "Hepatic vein"),
    QT_TRANSLATE_NOOP("structures", "Artery"),
    QT_TRANSLATE_NOOP("structures", "Biliary tract"),
    QT_TRANSLATE_NOOP("structures", "Necrosis"),
    QT_TRANSLATE_NOOP("structures", "Gallbladder"),
    QT_TRANSLATE_NOOP("structures", "Gastric vein"),
    QT_TRANSLATE_NOOP("structures", "Aorta"),
    QT_TRANSLATE_NOOP("structures", "Heart"),
    QT_TRANSLATE_NOOP("structures", "Stomach"),
    QT_TRANSLATE_NOOP("structures", "Kidney"),
    QT_TRANSLATE_NOOP("structures", "Spleen"),
    QT_TRANSLATE_NOOP("structures", "Pancreas"),
    QT_TRANSLATE_NOOP("structures", "Bone"),
    QT_TRANSLATE_NOOP("structures", "Hilum"),
    QT_TRANSLATE_NOOP("structures", "Vena cava"),
    QT_TRANSLATE_NOOP("structures", "Duodenum"),
    QT_TRANSLATE_NOOP("structures", "Small bowel"),
    QT_TRANSLATE_NOOP("structures", "Colon"),
    QT_TRANSLATE_NOOP("structures", "Esophagus"),
    QT_TRANSLATE_NOOP("structures", "Adrenal gland"),
    QT_TRANSLATE_NOOP("structures", "Kidney left"),
    QT_TRANSLATE_NOOP("structures", "Kidney right"),
    QT_TRANSLATE_NOOP("structures", "Adrenal gland left"),
    QT_TRANSLATE_NOOP("structures", "Adrenal gland right"),
};

QString translated(const char* context, const QString& text) {
  return QCoreApplication::translate(context, text.toUtf8().constData());
}

}  // namespace

QString translated(const std::string& sentence) { return translated("errors", QString::fromStdString(sentence)); }

QString translated(const Sentence& sentence) {
  // An argument may be a marked phrase of its own ("it is empty").
  std::vector<std::string> arguments;
  for (const std::string& argument : sentence.arguments) arguments.push_back(translated(argument).toStdString());
  return QString::fromStdString(fill_in(translated(sentence.text).toStdString(), arguments));
}

QString translated(const Error& error) {
  QString text = translated(Sentence{error.text, error.arguments});
  text += QString::fromStdString(file_behind(text.toStdString(), error));
  if (!error.hint.empty()) text += " " + translated(Sentence{error.hint, error.arguments});
  return text;
}

QString translated_stage(const QString& stage) {
  const qsizetype colon = stage.indexOf(": ");
  return colon < 0 ? translated("errors", stage) : translated("errors", stage.left(colon)) + stage.mid(colon);
}

QString structure_label(const std::string& name) {
  QString label = QString::fromStdString(name);
  label.replace('-', ' ');
  if (!label.isEmpty()) label[0] = label[0].toUpper();
  // "Portal vein" is translated, the 2 behind it stays.
  static const QRegularExpression number(" \\d+$");
  const qsizetype end = label.indexOf(number);
  return end < 0 ? translated("structures", label) : translated("structures", label.left(end)) + label.mid(end);
}

QString patient_label(const std::string& name) { return translated("patients", QString::fromStdString(name)); }

}  // namespace glisson::widgets
