#pragma once
// The plan that Resect kept, as a course that the rehearsal's cut can take.

#include <optional>

#include "base/sentence.h"
#include "rehearsal/cut_course.h"
#include "widgets/session/patient.h"

namespace glisson::widgets {

struct PlannedCourse {
  std::optional<rehearsal::CutCourse> course;
  std::optional<Sentence> why_not;  // nothing where there is no plan
};
[[nodiscard]] PlannedCourse planned_course(const Patient& patient);

}  // namespace glisson::widgets
