#include "widgets/words/translated.h"

#include <map>
#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include "base/error_file.h"
#include "segmentation/structures.h"

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

// Entries of a case that are no structures, within a sentence.
const char* entry_words(const std::string& id) {
  static const std::map<std::string, const char*> words = {
      {"volumes/anatomy", QT_TRANSLATE_NOOP("entries", "the image of the anatomy")},
      {"volumes/stiffness", QT_TRANSLATE_NOOP("entries", "the stiffness map")},
      {"volumes/confidence", QT_TRANSLATE_NOOP("entries", "the confidence map")},
      {"meshes/liver", QT_TRANSLATE_NOOP("entries", "the mesh of the liver")},
      {"meshes/model", QT_TRANSLATE_NOOP("entries", "the model")},
      {"evidence/model", QT_TRANSLATE_NOOP("entries", "the accepted evidence")},
      {"vessels/trees", QT_TRANSLATE_NOOP("entries", "the vessel trees")},
      {"territories/couinaud", QT_TRANSLATE_NOOP("entries", "the map of the segments")}};
  const auto found = words.find(id);
  return found == words.end() ? nullptr : found->second;
}

// What the core fills into a sentence, as the window calls it: "tumour-1", "labels/liver", "meshes/model",
// "cyst-2 (label 3)", several of them, or a marked phrase of its own ("it is empty"). Anything else stays.
QString named(const std::string& argument) {
  if (const char* words = entry_words(argument)) return translated("entries", QString::fromUtf8(words));
  static const QRegularExpression labelled("^(.+) \\(label (\\d+)\\)$"), label("^label (\\d+)$");
  const QString text = QString::fromStdString(argument);
  if (const auto match = labelled.match(text); match.hasMatch()) {
    return QCoreApplication::translate("entries", "%1 (label %2)")
        .arg(named(match.captured(1).toStdString()), match.captured(2));
  }
  if (const auto match = label.match(text); match.hasMatch()) {
    return QCoreApplication::translate("entries", "label %1").arg(match.captured(1));
  }
  if (const QString phrase = translated("errors", text); phrase != text) return phrase;
  const QString list = ", ";
  if (text.contains(list)) {
    QStringList parts;
    for (const QString& part : text.split(list)) parts << named(part.toStdString());
    return parts.join(list);
  }
  const auto slash = argument.find('/');
  const bool of_structure =
      slash == std::string::npos || argument.starts_with("labels/") || argument.starts_with("surfaces/");
  const std::string name = argument.substr(slash == std::string::npos ? 0 : slash + 1);
  const bool known = segmentation::known_structure(name).place != segmentation::Place::unknown;
  return of_structure && known ? structure_label(name) : text;
}

}  // namespace

QString translated(const std::string& sentence) { return translated("errors", QString::fromStdString(sentence)); }

QString translated(const Sentence& sentence) {
  std::vector<std::string> arguments;
  for (const std::string& argument : sentence.arguments) arguments.push_back(named(argument).toStdString());
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
  if (colon < 0) return translated("errors", stage);
  return translated("errors", stage.left(colon)) + ": " + named(stage.mid(colon + 2).toStdString());
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
