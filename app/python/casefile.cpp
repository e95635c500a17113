// The case folder: what it holds, and the stages that put things into it.

#include "casefile/case.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "base/json.h"
#include "casefile/import.h"
#include "casefile/macro.h"
#include "casefile/model.h"
#include "casefile/plans.h"
#include "casefile/redo_step.h"
#include "casefile/structures.h"
#include "casefile/used_entries.h"
#include "casefile/vascular.h"
#include "casefile/waves.h"
#include "choices.h"
#include "documents.h"
#include "geometry/mesh_file.h"
#include "image_grid.h"
#include "imaging/volume_file.h"
#include "long_call.h"
#include "mechanics/scenario/scenario_file.h"
#include "plan_cuts.h"
#include "planning/plan_file.h"
#include "rooms.h"
#include "segment_dict.h"

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

py::dict dict_of(const SavedStructure& saved) {
  return py::dict("name"_a = saved.name, "id"_a = saved.id, "voxels"_a = saved.voxels, "volume_ml"_a = saved.volume_ml,
                  "notes"_a = messages(saved.notes));
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
  return py::dict("mesh"_a = std::make_shared<geometry::TetMesh>(std::move(model.mesh)),
                  "scenario"_a = python_of_text(mechanics::scenario_text(asked)),
                  "atlas_youngs_kPa"_a = model.atlas_youngs_kPa, "remarks"_a = remarks);
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

StiffnessChoice stiffness_choice(const std::optional<double>& uniform_kPa, const std::optional<double>& atlas_kPa) {
  if (uniform_kPa && atlas_kPa) raise("stiffness-invalid", "Give one value or the atlas, not both.");
  if (uniform_kPa) return Uniform{*uniform_kPa};
  if (!atlas_kPa) return FromMre{};
  if (*atlas_kPa == 2.1) return FromAtlas{elastography::Atlas::dissertation_cohort};
  if (*atlas_kPa == 2.6) return FromAtlas{elastography::Atlas::published_cohort};
  raise("stiffness-invalid", "No atlas has a mean shear stiffness of {0} kPa.", {py::str(py::float_(*atlas_kPa))},
        "There are 2.1 and 2.6.");
}

elastography::InversionOptions inversion_options(const std::string& method, const std::string& long_waves,
                                                 bool directional) {
  using elastography::InversionMethod;
  using elastography::LongWaves;
  elastography::InversionOptions options;
  options.method = chosen<InversionMethod>(
      "method", method, {{"direct", InversionMethod::direct}, {"lfe", InversionMethod::local_frequency}});
  options.long_waves =
      chosen<LongWaves>("long_waves", long_waves,
                        {{"high-pass", LongWaves::high_pass}, {"curl", LongWaves::curl}, {"keep", LongWaves::keep}});
  if (directional) options.directions = elastography::Directions::apart;
  return options;
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

// Waves, vessels and territories.
void add_maps(py::class_<Case>& bound) {
  bound
      .def(
          "invert_waves",
          [](Case& self, const std::string& method, const std::string& long_waves, bool directional,
             const std::optional<double>& frequency_Hz, const std::optional<int>& directions,
             const py::object& progress) {
            const auto options = inversion_options(method, long_waves, directional);
            const elastography::AskedFor asked{frequency_Hz, directions};
            const auto map =
                long_call(progress, [&](const Progress& told) { return invert_waves(self, asked, options, told); });
            return py::dict("mean_kPa"_a = map.mean_kPa, "confident_fraction"_a = map.confident_fraction,
                            "frequencies_Hz"_a = map.frequencies_Hz, "notes"_a = messages(map.notes));
          },
          py::kw_only(), py::arg("method") = "direct", py::arg("long_waves") = "high-pass",
          py::arg("directional") = false, py::arg("frequency_Hz") = py::none(), py::arg("directions") = py::none(),
          py::arg("progress") = py::none(),
          R"(Computes the shear stiffness from the case's waves; the maps take their places in it.

method        "direct" or "lfe"; long_waves: "high-pass", "curl" or "keep"; directional: waves of each direction by
              themselves
frequency_Hz, directions   where the headers say nothing

A dict: mean_kPa, confident_fraction, frequencies_Hz, notes.
Raises glisson.Error: waves-none, choice-unknown.)")
      .def(
          "find_vessels",
          [](Case& self, const std::optional<std::string>& structure, const std::optional<Numbers>& portal_mm,
             const std::optional<Numbers>& hepatic_mm, const py::object& progress) {
            vasculature::Clicks clicks;
            if (portal_mm) clicks.portal_mm = vector_from(*portal_mm, "portal_mm");
            if (hepatic_mm) clicks.hepatic_mm = vector_from(*hepatic_mm, "hepatic_mm");
            return std::make_shared<vasculature::VesselTrees>(
                long_call(progress, [&](const Progress& told) { return find_vessels(self, structure, clicks, told); }));
          },
          py::kw_only(), py::arg("structure") = py::none(), py::arg("portal_mm") = py::none(),
          py::arg("hepatic_mm") = py::none(), py::arg("progress") = py::none(),
          (std::string(
               "The VesselTrees of the case, saved in it: of the structures portal-vein and hepatic-vein, or of "
               "one that holds both. portal_mm, hepatic_mm: a place (LPS, mm) on each main stem, where the "
               "first guess is wrong.") +
           stage_note + "\nRaises glisson.Error: vessels-missing, labels-grids-differ.")
              .c_str())
      .def(
          "find_territories",
          [](Case& self, const std::string& by, const py::object& progress) {
            const auto from = chosen<SegmentsBy>("by", by, {{"tree", SegmentsBy::trees}, {"prior", SegmentsBy::shape}});
            auto found = long_call(progress, [&](const Progress& told) { return find_territories(self, from, told); });
            py::dict dict = segment_dict(std::move(found.couinaud));
            for (const auto system : {vasculature::System::portal_vein, vasculature::System::hepatic_vein}) {
              auto& territory = found.territory.at(static_cast<std::size_t>(system));
              dict[vasculature::system_name(system)] =
                  territory ? py::cast(std::make_shared<imaging::LabelMap>(*std::move(territory))) : py::none();
            }
            return dict;
          },
          py::kw_only(), py::arg("by") = "tree", py::arg("progress") = py::none(),
          (std::string("Which tissue belongs to which branch, and Couinaud's segments, saved in the case: what "
                       "couinaud_segments answers, with \"portal-vein\" and \"hepatic-vein\" (LabelMaps of the number "
                       "of the branch + 1, or None). by: \"tree\", or \"prior\" for the liver's shape alone.") +
           stage_note + "\nRaises glisson.Error: vessels-missing, choice-unknown.")
              .c_str());
}

// Resection plans.
void add_plans(py::class_<Case>& bound) {
  bound
      .def(
          "planner",
          [](const Case& self, const py::object& progress) {
            return long_call(progress, [&](const Progress& told) {
              return open_planner(self, told).map([](OpenedPlanner opened) { return std::move(opened.planner); });
            });
          },
          py::kw_only(), py::arg("progress") = py::none(),
          "A Planner for this patient: with its trees and territories where it has them.")
      .def_property_readonly(
          "plans",
          [](const Case& self) {
            py::list plans;
            for (const KeptPlan& kept : short_call([&] { return kept_plans(self); })) {
              const Json answer = or_raise(kept_answer(self, kept.id));
              plans.append(py::dict("id"_a = kept.id, "name"_a = kept.plan.name,
                                    "cuts"_a = python_of(planning::plan_json(kept.plan).at("cuts")),
                                    "answer"_a = python_of(answer), "remarks"_a = messages(kept.remarks)));
            }
            return plans;
          },
          "The resection plans that it keeps: a list of dicts with id, name, cuts, answer (as it was then), remarks.")
      .def(
          "keep_plan",
          [](Case& self, const std::string& name, const py::object& cuts, const py::object& progress) {
            const planning::Plan plan{name, cuts_from(cuts)};
            return long_call(progress, [&](const Progress& told) -> Result<std::string> {
              const auto opened = open_planner(self, told);
              if (!opened) return failure(opened.error());
              const auto answer = opened->planner.answer(plan.cuts);
              if (!answer) return failure(answer.error());
              return keep_plan(self, plan, *answer, opened->planner.trees());
            });
          },
          py::arg("name"), py::arg("cuts"), py::kw_only(), py::arg("progress") = py::none(),
          "Answers a plan (cuts as Planner.answer takes them) and keeps it in the case: the id of its entry.")
      .def(
          "drop_plan", [](Case& self, const std::string& name) { short_call([&] { return drop_plan(self, name); }); },
          py::arg("name"), "Takes a plan out of the case.\n\nRaises glisson.Error: plan-unknown.");
}

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
          [](Case& self, const std::optional<double>& uniform_kPa, const std::optional<double>& atlas_kPa,
             const py::object& progress) {
            const StiffnessChoice choice = stiffness_choice(uniform_kPa, atlas_kPa);
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
  add_recordings(bound);
}

}  // namespace glisson::python
