// The case folder: what it holds, and what was done to it in the window.

#include "casefile/case.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "base/json.h"
#include "case_methods.h"
#include "casefile/macro.h"
#include "casefile/model.h"
#include "casefile/redo_step.h"
#include "casefile/used_entries.h"
#include "choices.h"
#include "documents.h"
#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"
#include "long_call.h"
#include "mechanics/scenario/scenario_file.h"
#include "rooms.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace casefile;
using namespace py::literals;
using std::filesystem::path;

std::string name_of(Freshness freshness) {
  switch (freshness) {
    case Freshness::current: return "current";
    case Freshness::stale: return "stale";
    case Freshness::changed_outside: return "changed-outside";
    case Freshness::missing: break;
  }
  return "missing";
}

py::dict entry_dict(const Entry& entry) {
  return py::dict("id"_a = entry.id, "file"_a = entry.file.string(), "sha256"_a = entry.sha256, "by"_a = entry.made.by,
                  "options"_a = entry.made.options, "from"_a = entry.made.from, "notes"_a = messages(entry.made.notes),
                  "version"_a = entry.version, "when_utc"_a = entry.when_utc);
}

// What a simulation or a rehearsal of this patient is asked.
py::dict question(const Case& self, const py::object& scenario) {
  mechanics::Scenario asked;
  if (!scenario.is_none()) asked = or_raise(mechanics::parse_scenario(text_of(scenario)));
  PatientModel model = short_call([&] { return read_model(self); });
  std::vector<std::string> remarks = messages(model_remarks(self));
  if (model.assumed && !asked.youngs_modulus) remarks.push_back(model.assumed->message());
  for (const Sentence& said : put_into(asked, model)) remarks.push_back(said.message());
  return py::dict("mesh"_a = std::make_shared<geometry::TetMesh>(std::move(model.mesh)),
                  "scenario"_a = python_of_text(mechanics::scenario_text(asked)),
                  "atlas_youngs_kPa"_a = model.reference_youngs_kPa, "remarks"_a = remarks);
}

void add_reading(py::class_<Case>& bound) {
  bound
      .def(py::init([](const path& folder) { return short_call([&] { return Case::open(folder); }); }),
           py::arg("folder"))
      .def_static(
          "create", [](const path& folder) { return short_call([&] { return Case::create(folder); }); },
          py::arg("folder"), "A new case; the folder must not exist or be empty, and should end in \".glisson\".")
      .def_property_readonly(
          "folder", [](const Case& self) { return self.folder(); }, "Where it lies.")
      .def_property_readonly("origin", &Case::origin,
                             "\"SIMULATED ...\", or empty for a real patient: to be shown beside anything of it.")
      .def_property_readonly(
          "entries",
          [](const Case& self) {
            py::list entries;
            for (const Entry& entry : self.entries()) entries.append(entry_dict(entry));
            return entries;
          },
          "What the case holds and how each was made: a list of dicts with id, file, sha256, by, options, from, notes, "
          "version, when_utc.")
      .def(
          "file_of", [](const Case& self, const std::string& id) { return or_raise(self.file_of(id)); }, py::arg("id"),
          "The full path of an entry's file.\n\nRaises glisson.Error: case-lacks-entry.")
      .def(
          "freshness",
          [](const Case& self, const std::string& id) {
            or_raise(self.file_of(id));
            const py::gil_scoped_release released;
            return name_of(self.freshness(id));
          },
          py::arg("id"),
          "\"current\", \"stale\" (what it was made from has changed), \"changed-outside\" or \"missing\".")
      .def(
          "volume", [](const Case& self, const std::string& id) { return short_call([&] { return self.volume(id); }); },
          py::arg("id") = "volumes/anatomy",
          "A measured quantity of the case: \"volumes/anatomy\", \"volumes/stiffness\" (kPa).")
      .def(
          "mask",
          [](const Case& self, const std::string& name) {
            const path file = or_raise(self.file_of("labels/" + name));
            return short_call([&] { return imaging::read_mask_file(file); }).mask;
          },
          py::arg("structure") = "liver", "A structure's mask: \"liver\", \"tumour-1\", ...")
      .def_property_readonly(
          "structures",
          [](const Case& self) {
            std::vector<std::string> names;
            for (const Entry& entry : self.entries())
              if (entry.id.starts_with("labels/")) names.push_back(entry.id.substr(7));
            return names;
          },
          "Names of its structures.")
      .def(
          "mesh",
          [](const Case& self, const std::string& id) {
            const path file = or_raise(self.file_of(id));
            return std::make_shared<geometry::TetMesh>(short_call([&] { return geometry::read_tetrahedra(file); }));
          },
          py::arg("id") = "meshes/liver",
          "The liver's tetrahedra; \"meshes/model\" has the cell field \"youngs_modulus_kPa\".")
      .def(
          "surface",
          [](const Case& self, const std::string& name) {
            const path file = or_raise(self.file_of("surfaces/" + name));
            return std::make_shared<geometry::Surface>(short_call([&] { return geometry::read_surface(file); }));
          },
          py::arg("structure") = "liver", "A structure's smooth surface.")
      .def("question", &question, py::arg("scenario") = py::none(),
           R"(What simulate(), StaticRehearsal or Session are asked of this patient: a dict.

mesh              the TetMesh with the patient's own stiffness
scenario          as given, with what the case brings where it says nothing: supports, landmarks, accepted evidence
atlas_youngs_kPa  of the reference body that it is compared with
remarks           what was assumed, left out, or is stale

Raises glisson.Error: case-lacks-entry before there is a model; scenario-invalid.)")
      .def("__repr__", [](const Case& self) { return "<glisson.Case " + self.folder().string() + ">"; });
}

// What was done in the window: taken over, and as a program.
void add_recordings(py::class_<Case>& bound) {
  bound
      .def(
          "redo",
          [](Case& self, const path& recorded, int step) {
            short_call([&] { return redo_step(self, recorded, step); });
          },
          py::arg("recorded"), py::arg("step"),
          R"(Does a step again that was done by hand in the window, from the history of the case folder `recorded`. This case
must be as that one was before the step; its files come out the same, byte for byte.

Raises glisson.Error: step-unknown, step-does-not-fit, step-content-gone, step-changes-nothing.)")
      .def(
          "macro",
          [](const Case& self, const std::string& language) {
            using Written = std::string (*)(const Macro&);
            const auto written =
                chosen<Written>("language", language, {{"python", as_python}, {"command-line", as_command_line}});
            return written(short_call([&] { return macro_of(self.folder()); }));
          },
          py::arg("language") = "python",
          "What was done to this case in the window, as a program that does it again: \"python\", or "
          "\"command-line\" for a shell.");
}

}  // namespace

void add_casefile(py::module_& module) {
  py::class_<Case> bound(
      module, "Case",
      R"(A case: the folder NAME.glisson with everything known of one patient, and where it came from.

Case(folder) opens one. The folder is the state, a Case a view of it; each change is one transaction.

Raises glisson.Error: what is wrong with the folder or its case.json.)");
  add_reading(bound);
  add_stages(bound);
  add_maps(bound);
  add_plans(bound);
  add_rehearsals(bound);
  add_recordings(bound);
}

}  // namespace glisson::python
