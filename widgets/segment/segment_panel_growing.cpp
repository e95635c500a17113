// Structures that are grown from points; the liver and vessels that are found by their shape.

#include "casefile/found_liver.h"
#include "casefile/structures.h"
#include "widgets/segment/segment_panel.h"
#include "widgets/session/load_patient.h"
#include "widgets/settings/settings.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {

void SegmentPanel::grow() {
  replace_active(tr("Growing: %1"), [within = operations_->within(), seeds_mm = tools_.points().inside_mm](
                                        casefile::Case& patient, const std::string& name, const Progress& progress) {
    const auto inside = within.empty() ? std::nullopt : std::optional(within);
    return casefile::grow_structure(patient, name, seeds_mm, progress, inside);
  });
}

void SegmentPanel::find() {
  const EditedStructure* active = editor_.active_structure();
  if (active != nullptr && active->name == "liver") {
    const std::string shapes = kept_shapes().isEmpty() ? casefile::simulated_shapes : kept_shapes().toStdString();
    replace_active(tr("Finding: %1"), [shapes, points = tools_.points()](casefile::Case& patient, const std::string&,
                                                                         const Progress& progress) {
      return casefile::find_liver(patient, points, shapes, progress);
    });
    return;
  }
  const std::string within = operations_->within();
  replace_active(tr("Finding vessels: %1"),
                 [within = within.empty() ? "liver" : within, seeds_mm = tools_.points().inside_mm](
                     casefile::Case& patient, const std::string& name, const Progress& progress) {
                   return casefile::segment_vessels(patient, name, seeds_mm, within, std::nullopt, progress);
                 });
}

void SegmentPanel::replace_active(const QString& what, Make make) {
  const EditedStructure* active = editor_.active_structure();
  if (active == nullptr) return;
  context_.change(what.arg(structure_label(active->name)),
                  [folder = patient_.folder, name = active->name,
                   make = std::move(make)](const Progress& progress) -> Result<Patient> {
                    auto opened = casefile::Case::open(folder);
                    if (!opened) return failure(opened.error());
                    auto made = make(*opened, name, progress.part(0, 0.9));
                    if (!made) return failure(made.error());
                    return load_patient(folder, progress.part(0.9, 1)).map([&](Patient patient) {
                      patient.remarks = std::move(made->notes);
                      return patient;
                    });
                  });
}

}  // namespace glisson::widgets
