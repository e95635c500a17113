// Pages for people.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "long_call.h"
#include "report/explanation_folder.h"
#include "report/html.h"
#include "report/patient_page.h"
#include "rooms.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using std::filesystem::path;

void write_patient_page(const casefile::Case& patient, const path& file, const std::optional<std::string>& name,
                        const std::vector<std::pair<path, std::string>>& figures, const py::object& progress) {
  report::PatientPageContent content;
  content.name = name;
  for (const auto& [png, caption] : figures) content.figures.push_back({png, caption});
  long_call(progress, [&](const Progress& told) {
    return report::patient_page(patient, content, told).and_then([&](const report::Page& page) {
      return report::write_html(file, page);
    });
  });
}

}  // namespace

void add_report(py::module_& module) {
  module.def("write_patient_page", &write_patient_page, py::arg("case"), py::arg("file"), py::kw_only(),
             py::arg("name") = py::none(), py::arg("figures") = std::vector<std::pair<path, std::string>>(),
             py::arg("progress") = py::none(),
             R"(What was done for the patient of a Case, as one HTML file that needs nothing beside it.

name     the patient's, which the page otherwise withholds
figures  (PNG file, caption) each, as draw_case and write_picture make them; the first large

Raises glisson.Error: case-lacks-entry, file-not-readable, file-not-writable.)");
  module.def(
      "write_explanation",
      [](const path& experiment, const path& folder, const py::object& progress) {
        long_call(progress, [&](const Progress& told) {
          return closedloop::explain(experiment, told).and_then([&](const closedloop::Explained& explained) {
            return report::write_explanation(folder, explained);
          });
        });
      },
      py::arg("experiment"), py::arg("folder"), py::kw_only(), py::arg("progress") = py::none(),
      "Explains an experiment, as explain(), into a folder: report.json, report.html for people, and model.json for "
      "predict() and for rehearsals.\n\nRaises glisson.Error: what is wrong with the experiment, file-not-writable.");
}

}  // namespace glisson::python
