#pragma once
// The dissertation's studies as a person starts them: what each is about, what it needs, and the command line that it
// is.

#include <functional>
#include <QString>
#include <QStringList>
#include <vector>

namespace glisson::widgets {

// What a study is made of. It may be patients (simulated, or a folder of cases or stiffness maps), one case, or a
// folder of segmented livers. It may be scans if there are any, or nothing that somebody has to bring.
enum class StudyOf { patients, one_case, livers, scans, nothing };
[[nodiscard]] inline bool needs_folder(StudyOf of) { return of == StudyOf::one_case || of == StudyOf::livers; }

struct StudyKind {
  QString id;  // as glisson-cli study has it
  StudyOf of = StudyOf::nothing;
  std::function<QString()> name;   // in the language of now
  std::function<QString()> about;  // what is asked, and where the dissertation asks it
};
[[nodiscard]] const std::vector<StudyKind>& study_kinds();

struct StudyChoice {
  int simulated = 0;  // how many patients, where no folder is given
  QString folder;     // of cases or maps, a case, scans; empty for none
  QString out;
};
// Of glisson-cli. Run again with the same choice, a study goes on where it was stopped.
[[nodiscard]] QStringList study_arguments(const StudyKind& kind, const StudyChoice& choice);

}  // namespace glisson::widgets
