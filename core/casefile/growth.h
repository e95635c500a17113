#pragma once
// Two cases of one patient, as before and after an embolisation, compared (planning/growth.h). The segments, the
// stiffness and the plans that each case keeps are compared. The answer says too whether both are of one patient, and
// how many days lie between.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "casefile/case.h"
#include "casefile/vascular.h"
#include "planning/growth.h"

namespace glisson::casefile {

struct GrowthQuestion {
  // By its name: each case's own plan of that name. One that a single case has goes over to the other if it is made of
  // segments and territories. Any other cut has its place in its own study.
  std::optional<std::string> plan;
  // days: where the images' dates do not tell. Errors: where absent, what was measured of segments found this way
  // (docs/territories.md).
  planning::GrowthOptions options;
  // Of images that name two patients: refused, or a person said that they are of one.
  enum class Patients { as_images_say, one } patients = Patients::as_images_say;
};

enum class DaysFrom { unknown, dates, person };

struct ComparedStudies {
  planning::Growth growth;
  std::string plan;  // empty: none
  std::optional<double> days, standard_liver_ml;
  DaysFrom days_from = DaysFrom::unknown;
  // By which changes are within_error; none of a remnant whose cut is not by segments or territories.
  std::optional<double> segment_error_percent, remnant_error_percent;
  std::array<SegmentsBy, 2> segments_by{};  // before, after
  std::vector<Sentence> remarks;
};

// Segments are those that the cases keep; nothing is found anew, and neither case is changed. Fails with
// "growth-same-case", "growth-not-one-patient", "growth-order" (the second is the earlier one) or "growth-days-differ"
// (from what the dates say). Fails with "growth-segments-missing", "growth-segments-stale", "plan-unknown" or
// "growth-plan-in-one-study". Fails as planning::growth_between and open_planner do.
Result<ComparedStudies> compare_studies(const Case& before, const Case& after, const GrowthQuestion& question,
                                        const Progress& progress = {});

}  // namespace glisson::casefile
