// Two studies of one patient compared.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "base/json.h"
#include "casefile/growth.h"
#include "documents.h"
#include "long_call.h"
#include "report/growth.h"
#include "report/growth_page.h"
#include "rooms.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using casefile::Case;
using std::filesystem::path;

py::object compare(const Case& before, const Case& after, const std::optional<std::string>& plan,
                   const std::optional<double>& days, const std::optional<double>& standard_liver_ml, bool same_patient,
                   const std::optional<path>& folder, const py::object& progress) {
  casefile::GrowthQuestion question;
  question.plan = plan;
  question.options.days = days;
  question.options.standard_liver_ml = standard_liver_ml;
  if (same_patient) question.patients = casefile::GrowthQuestion::Patients::one;
  const casefile::ComparedStudies compared = long_call(
      progress, [&](const Progress& told) { return casefile::compare_studies(before, after, question, told); });
  if (folder) {
    const std::string origin = before.origin().empty() ? after.origin() : before.origin();
    short_call([&] { return report::write_growth(*folder, compared, origin); });
  }
  return python_of(report::growth_json(compared));
}

}  // namespace

void add_growth(py::module_& module) {
  module.def(
      "compare_studies", &compare, py::arg("before"), py::arg("after"), py::kw_only(), py::arg("plan") = py::none(),
      py::arg("days") = py::none(), py::arg("standard_liver_ml") = py::none(), py::arg("same_patient") = false,
      py::arg("folder") = py::none(), py::arg("progress") = py::none(),
      R"(What grew between two studies of one patient, as before and after an embolisation: two Cases with segments.

plan               whose remnant is followed: each case's own of that name
days               between the studies, where their images have no dates
standard_liver_ml  of which the per cent are in both; None: of each study's own liver
same_patient       the images name two patients, and they are of one all the same
folder             where given, growth.json, growth.csv and growth.html are written there

A dict as growth.json ("glisson-growth/1"): liver, segments, remnant (before_ml, after_ml, change_percent, ...), days,
sentences. Neither case is changed.
Raises glisson.Error: growth-same-case, growth-not-one-patient, growth-order, growth-days, growth-days-differ,
growth-segments-missing, growth-segments-stale, growth-standard-volume, growth-plan-in-one-study, plan-unknown.)");
}

}  // namespace glisson::python
