// What another program outlines, taken into the Segment workspace.

#include <QInputDialog>

#include "casefile/label_map.h"
#include "casefile/outlined_by_program.h"
#include "widgets/session/load_patient.h"
#include "widgets/settings/settings.h"

#include "widgets/segment/segment_panel.h"

namespace glisson::widgets {

// Asked once; Settings has it from then on.
void SegmentPanel::outline_with_program() {
  if (kept_program().command.isEmpty()) {
    const QString command =
        QInputDialog::getText(this, tr("Outline with another program"),
                              tr("Its command, as in TotalSegmentator -i {image} -o {folder}\n(kept in Settings):"));
    if (command.trimmed().isEmpty()) return;
    keep_program({command, kept_program().values});
  }
  casefile::OutliningProgram program{kept_program().command.toStdString()};
  for (const QString& text : kept_program().values.split(',', Qt::SkipEmptyParts)) {
    const auto named = casefile::named_value(text.trimmed().toStdString());
    if (!named) {
      context_.tell_error(Error{"settings-value-unclear",
                                GLISSON_TEXT("In Settings, {0} does not say what a value of the outlining program is."),
                                {text.trimmed().toStdString()},
                                GLISSON_TEXT("Write value and name, as in 1=liver, 2=tumour-1."),
                                {}});
      return;
    }
    program.names.insert(*named);
  }
  context_.change(tr("Outlining with another program"),
                  [folder = patient_.folder, program](const Progress& progress) -> Result<Patient> {
                    auto opened = casefile::Case::open(folder);
                    if (!opened) return failure(opened.error());
                    const auto outlined = casefile::outline_by_program(*opened, program, progress.part(0, 0.9));
                    if (!outlined) return failure(outlined.error());
                    return load_patient(folder, progress.part(0.9, 1)).map([&](Patient patient) {
                      for (const auto& structure : *outlined) {
                        for (const Sentence& note : structure.notes) {
                          const auto same = [&](const Sentence& one) { return one.message() == note.message(); };
                          if (std::none_of(patient.remarks.begin(), patient.remarks.end(), same)) {
                            patient.remarks.push_back(note);
                          }
                        }
                      }
                      return patient;
                    });
                  });
}

}  // namespace glisson::widgets
