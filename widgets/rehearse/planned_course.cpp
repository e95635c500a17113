#include "widgets/rehearse/planned_course.h"

#include "casefile/resection_folder.h"

namespace glisson::widgets {

PlannedCourse planned_course(const Patient& patient) {
  if (patient.folder.empty() || !patient.rehearsal_setup) return {};
  const auto plan = casefile::read_planned_cut(patient.folder / "results" / "resection");
  if (!plan) return {};
  if (plan->liver == casefile::PlannedCut::Liver::held_aside) {
    return {{},
            Sentence{GLISSON_TEXT(
                         "The plan was set on the liver as it was held aside: set it at rest to cut along it here."),
                     {}}};
  }
  auto course = casefile::surface_of(*plan).and_then([&](const geometry::CutSurface& surface) {
    return rehearsal::course_of(patient.rehearsal_setup->mesh, surface);
  });
  if (!course) return {{}, Sentence{course.error().text, course.error().arguments}};
  return {std::move(*course), {}};
}

}  // namespace glisson::widgets
