// The case folder: what it holds, and the stages that put things into it.

#include "casefile/case.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "casefile/import.h"
#include "casefile/model.h"
#include "casefile/structures.h"
#include "casefile/used_entries.h"
#include "documents.h"
#include "geometry/mesh_file.h"
#include "image_grid.h"
#include "imaging/volume_file.h"
#include "long_call.h"
#include "mechanics/scenario/scenario_file.h"
#include "rooms.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace casefile;
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
  py::dict dict;
  dict["id"] = entry.id;
  dict["file"] = entry.file.string();
  dict["sha256"] = entry.sha256;
  dict["by"] = entry.made.by;
  dict["options"] = entry.made.options;
  dict["from"] = entry.made.from;
  dict["notes"] = messages(entry.made.notes);
  dict["version"] = entry.version;
  dict["when_utc"] = entry.when_utc;
  return dict;
}

py::dict dict_of(const SavedStructure& saved) {
  py::dict dict;
  dict["name"] = saved.name;
  dict["id"] = saved.id;
  dict["voxels"] = saved.voxels;
  dict["volume_ml"] = saved.volume_ml;
  dict["notes"] = messages(saved.notes);
  return dict;
}

py::dict dict_of(const Imported& imported) {
  py::dict volumes;
  for (const ImportedVolume& volume : imported.volumes) volumes[py::str(volume.id)] = volume.notes;
  return volumes;
}

// What a simulation or a rehearsal of this patient is asked.
py::dict question(const Case& self, const py::object& scenario) {
  mechanics::Scenario asked;
  if (!scenario.is_none()) asked = or_raise(mechanics::parse_scenario(text_of(scenario)));
  PatientModel model = short_call([&] { return read_model(self); });
  std::vector<std::string> remarks = messages(model_remarks(self));
  if (model.assumed && !asked.youngs_modulus) remarks.push_back(model.assumed->message());
  for (const Sentence& said : put_into(asked, model)) remarks.push_back(said.message());
  py::dict dict;
  dict["mesh"] = std::make_shared<geometry::TetMesh>(std::move(model.mesh));
  dict["scenario"] = python_of_text(mechanics::scenario_text(asked));
  dict["atlas_youngs_kPa"] = model.atlas_youngs_kPa;
  dict["remarks"] = remarks;
  return dict;
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

constexpr const char* stage_note = "\n\nprogress(fraction, stage) is told how far it is; KeyboardInterrupt cancels.";

void add_stages(py::class_<Case>& bound) {
  bound
      .def(
          "import_study",
          [](Case& self, const path& from, const std::optional<std::string>& anatomy_uid,
             const std::optional<std::string>& stiffness_uid, const py::object& progress) {
            return dict_of(long_call(progress, [&](const Progress& told) -> Result<Imported> {
              const auto study = imaging::scan(from, told.part(0, 0.3));
              if (!study) return failure(study.error());
              ImportChoice choice;
              choice.anatomy_uid = anatomy_uid;
              choice.stiffness_uid = stiffness_uid;
              return import_study(self, *study, choice, told.part(0.3, 1));
            }));
          },
          py::arg("path"), py::kw_only(), py::arg("anatomy_uid") = py::none(), py::arg("stiffness_uid") = py::none(),
          py::arg("progress") = py::none(),
          (std::string("Takes the series of a folder or file into the case: id -> notes of each volume.") + stage_note +
           "\nRaises glisson.Error: import-no-anatomy, import-ambiguous, import-unknown-uid, import-would-replace.")
              .c_str())
      .def(
          "grow_structure",
          [](Case& self, const std::string& name, const Numbers& seeds_mm, const std::optional<std::string>& within,
             const py::object& progress) {
            const auto seeds = points_from(seeds_mm, "seeds_mm");
            return dict_of(long_call(
                progress, [&](const Progress& told) { return grow_structure(self, name, seeds, told, within); }));
          },
          py::arg("name"), py::arg("seeds_mm"), py::kw_only(), py::arg("within") = py::none(),
          py::arg("progress") = py::none(),
          (std::string("Grows a structure from points inside it (n x 3, LPS, mm) on the anatomy and saves it. How "
                       "follows from the name: vessels and lesions by contrast, organs as the liver.") +
           stage_note)
              .c_str())
      .def(
          "mesh_liver",
          [](Case& self, int target_cells, const py::object& progress) {
            auto mesh = long_call(progress, [&](const Progress& told) {
              meshing::MeshOptions options;
              options.target_cells = target_cells;
              return mesh_liver(self, options, told);
            });
            return std::make_shared<geometry::TetMesh>(std::move(mesh.body));
          },
          py::kw_only(), py::arg("target_cells") = 20000, py::arg("progress") = py::none(),
          (std::string("Meshes the liver with the structures inside it, saves the mesh and the surfaces, and returns "
                       "the TetMesh.") +
           stage_note)
              .c_str())
      .def(
          "assign_stiffness",
          [](Case& self, const std::optional<double>& uniform_kPa, const py::object& progress) {
            const StiffnessChoice choice =
                uniform_kPa ? StiffnessChoice(Uniform{*uniform_kPa}) : StiffnessChoice(FromMre{});
            auto stiffness =
                long_call(progress, [&](const Progress& told) { return assign_stiffness(self, choice, {}, told); });
            return handed_over(std::move(stiffness.youngs_kPa));
          },
          py::kw_only(), py::arg("uniform_kPa") = py::none(), py::arg("progress") = py::none(),
          (std::string("Gives each cell its Young's modulus (kPa), from the case's stiffness map or one value, saves "
                       "the model and returns them: float64, (cells,).") +
           stage_note)
              .c_str());
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
}

}  // namespace glisson::python
