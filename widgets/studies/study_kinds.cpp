#include "widgets/studies/study_kinds.h"

#include <QCoreApplication>

namespace glisson::widgets {
namespace {

QString words(const char* text) { return QCoreApplication::translate("studies", text); }

StudyKind kind(const char* id, StudyOf of, const char* name, const char* about) {
  return {id, of, [name] { return words(name); }, [about] { return words(about); }};
}

}  // namespace

const std::vector<StudyKind>& study_kinds() {
  static const std::vector<StudyKind> all{
      kind("landmarks", StudyOf::patients, QT_TRANSLATE_NOOP("studies", "Landmarks under an atlas"),
           QT_TRANSLATE_NOOP("studies",
                             "How far a liver of one published stiffness misplaces a retracted liver's places, patient "
                             "by patient (section 4.4).")),
      kind("cohort", StudyOf::patients, QT_TRANSLATE_NOOP("studies", "Stiffness of a cohort"),
           QT_TRANSLATE_NOOP("studies",
                             "How stiffness varies between patients and within one, against the atlas (section 4.3).")),
      kind("beams", StudyOf::one_case, QT_TRANSLATE_NOOP("studies", "Beams of one liver"),
           QT_TRANSLATE_NOOP("studies",
                             "Beams of a case's softest, stiffest and most uneven tissue against one of its mean "
                             "(table 4.1).")),
      kind("shapes", StudyOf::livers, QT_TRANSLATE_NOOP("studies", "Shapes of livers"),
           QT_TRANSLATE_NOOP("studies",
                             "A mean liver and its modes, from a folder of segmented livers, judged on livers left "
                             "out.")),
      kind("palpation", StudyOf::scans, QT_TRANSLATE_NOOP("studies", "Pressed phantoms"),
           QT_TRANSLATE_NOOP("studies",
                             "Silicone pressed by a tool: the simulated surface against the scanned one (section 4.5). "
                             "Without scans, SIMULATED ones.")),
      kind("validate-stiffness", StudyOf::nothing, QT_TRANSLATE_NOOP("studies", "Stiffness against a testing machine"),
           QT_TRANSLATE_NOOP("studies",
                             "Young's modulus by elastography beside a testing machine's, by the dissertation's own "
                             "figures (section 4.6).")),
      kind("data-driven", StudyOf::nothing, QT_TRANSLATE_NOOP("studies", "Data in place of a law"),
           QT_TRANSLATE_NOOP(
               "studies",
               "A SIMULATED liver retracted straight from measured strain and stress, beside lines fitted to "
               "them (chapter 5).")),
      kind("convergence", StudyOf::nothing, QT_TRANSLATE_NOOP("studies", "Error against resolution"),
           QT_TRANSLATE_NOOP(
               "studies",
               "How much of a beam's deflection a coarse model misses (section 6.3.2): what Platform plans "
               "by.")),
      kind("matching", StudyOf::nothing, QT_TRANSLATE_NOOP("studies", "Matching of shapes"),
           QT_TRANSLATE_NOOP(
               "studies", "Energy, bits, memory and time of matching two surfaces (chapter 3), on SIMULATED livers."))};
  return all;
}

QStringList study_arguments(const StudyKind& kind, const StudyChoice& choice) {
  QStringList arguments{"study", kind.id};
  if (kind.of == StudyOf::patients && choice.folder.isEmpty()) {
    arguments << "--simulated" << QString::number(choice.simulated);
  } else if (kind.of == StudyOf::scans) {
    if (!choice.folder.isEmpty()) arguments << "--scans" << choice.folder;
  } else if (kind.of != StudyOf::nothing) {
    arguments << choice.folder;
  }
  return arguments << "--out" << choice.out;
}

}  // namespace glisson::widgets
