// The stages that put things into a case.

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "case_methods.h"
#include "casefile/found_liver.h"
#include "casefile/import.h"
#include "casefile/model.h"
#include "casefile/outlined_by_program.h"
#include "casefile/structures.h"
#include "choices.h"
#include "image_grid.h"
#include "long_call.h"

namespace py = pybind11;

namespace glisson::python {
namespace {

using namespace casefile;
using namespace py::literals;
using std::filesystem::path;

py::dict dict_of(const SavedStructure& saved) {
  return py::dict("name"_a = saved.name, "id"_a = saved.id, "voxels"_a = saved.voxels, "volume_ml"_a = saved.volume_ml,
                  "notes"_a = messages(saved.notes));
}

py::dict dict_of(const Imported& imported) {
  py::dict volumes;
  for (const ImportedVolume& volume : imported.volumes) volumes[py::str(volume.id)] = volume.notes;
  return volumes;
}

StiffnessChoice stiffness_choice(const std::optional<double>& uniform_kPa, const std::optional<double>& reference_kPa) {
  if (uniform_kPa && reference_kPa) raise("stiffness-invalid", "Give one value or the atlas, not both.");
  if (uniform_kPa) return Uniform{*uniform_kPa};
  if (!reference_kPa) return FromMre{};
  if (*reference_kPa == 2.1) return FromPopulationMean{elastography::PopulationMean::dissertation_cohort};
  if (*reference_kPa == 2.6) return FromPopulationMean{elastography::PopulationMean::published_cohort};
  raise("stiffness-invalid", "No atlas has a mean shear stiffness of {0} kPa.", {py::str(py::float_(*reference_kPa))},
        "There are 2.1 and 2.6.");
}

}  // namespace

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
          "find_liver",
          [](Case& self, const Numbers& seeds_mm, const Numbers& outside_mm, const std::string& shapes,
             const py::object& progress) {
            const segmentation::GivenPoints points{points_or_none(seeds_mm, "seeds_mm"),
                                                   points_or_none(outside_mm, "outside_mm")};
            return dict_of(
                long_call(progress, [&](const Progress& told) { return find_liver(self, points, shapes, told); }));
          },
          py::arg("seeds_mm") = py::list(), py::kw_only(), py::arg("outside_mm") = py::list(),
          py::arg("shapes") = simulated_shapes, py::arg("progress") = py::none(),
          (std::string("Finds the liver of the anatomy by brightness and shape together, from points inside it (n x 3, "
                       "LPS, mm) or from none, and saves it. outside_mm: points in what was wrongly taken for it. "
                       "shapes: the file of a shape model, or \"simulated\", nobody's.") +
           stage_note +
           "\nRaises glisson.Error: shapes-not-a-model, shapes-no-liver-found, shapes-outside, grow-seed-outside.")
              .c_str())
      .def(
          "segment_vessels",
          [](Case& self, const std::string& name, const Numbers& seeds_mm, const std::string& within,
             const std::optional<std::string>& brightness, const py::object& progress) {
            const auto seeds = points_or_none(seeds_mm, "seeds_mm");
            const auto kind = brightness_chosen(brightness);
            return dict_of(long_call(progress, [&](const Progress& told) {
              return segment_vessels(self, name, seeds, within, kind, told);
            }));
          },
          py::arg("name"), py::arg("seeds_mm") = py::list(), py::kw_only(), py::arg("within") = "liver",
          py::arg("brightness") = py::none(), py::arg("progress") = py::none(),
          (std::string(
               "Finds the vessels of the anatomy inside of a structure by their shape and saves them. With "
               "points (n x 3, LPS, mm) only those that hang on one. brightness \"bright\" or \"dark\"; without "
               "it, what more of the tubes are.") +
           stage_note +
           "\nRaises glisson.Error: choice-unknown, structure-unknown, vessels-no-organ, vessels-none, "
           "vessels-seed-off.")
              .c_str())
      .def(
          "outline_by_program",
          [](Case& self, const std::string& command, const std::map<int, std::string>& names,
             const py::object& progress) {
            const OutliningProgram program{command, names};
            py::list outlined;
            for (const ImportedStructure& structure :
                 long_call(progress, [&](const Progress& told) { return outline_by_program(self, program, told); })) {
              outlined.append(py::dict("name"_a = structure.id.substr(structure.id.find('/') + 1),
                                       "id"_a = structure.id, "volume_ml"_a = structure.volume_ml,
                                       "notes"_a = messages(structure.notes)));
            }
            return outlined;
          },
          py::arg("command"), py::kw_only(), py::arg("names") = std::map<int, std::string>(),
          py::arg("progress") = py::none(),
          (std::string(R"(Hands the anatomy to another program, as a segmentation network, and saves what it outlines.

command  its words, as "TotalSegmentator -i {image} -o {folder}": {image} is the anatomy as .nii.gz (float; HU, or as
         measured), {image_folder} the folder in which it lies alone, {folder} an empty one for what the program
         writes, {labels} a file in it for a program that writes one. No shell reads them.
names    value -> name, as {1: "liver"}, where its label maps and their files' names do not say

A list of dicts: name, id, volume_ml, notes. Structures of the same names are replaced; where it fails the case stays
as it was.)") +
           stage_note +
           "\nRaises glisson.Error: command-no-image, command-no-labels, program-no-labels, program-not-found, "
           "program-failed, case-lacks-entry.")
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
          [](Case& self, const std::optional<double>& uniform_kPa, const std::optional<double>& reference_kPa,
             const py::object& progress) {
            const StiffnessChoice choice = stiffness_choice(uniform_kPa, reference_kPa);
            auto stiffness =
                long_call(progress, [&](const Progress& told) { return assign_stiffness(self, choice, {}, told); });
            return handed_over(std::move(stiffness.youngs_kPa));
          },
          py::kw_only(), py::arg("uniform_kPa") = py::none(), py::arg("atlas_kPa") = py::none(),
          py::arg("progress") = py::none(),
          (std::string("Gives each cell its Young's modulus (kPa), from the case's stiffness map, one value, or the "
                       "atlas's mean shear stiffness (2.1 or 2.6), saves the model and returns them: float64, "
                       "(cells,).") +
           stage_note)
              .c_str());
}

}  // namespace glisson::python
