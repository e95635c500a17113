#include "widgets/session/load_patient.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "casefile/case.h"
#include "casefile/import.h"
#include "casefile/model.h"
#include "casefile/structures.h"
#include "casefile/waves.h"
#include "mechanics/simulation.h"
#include "studies/demo/demo.h"

namespace glisson::widgets {
namespace fs = std::filesystem;
namespace {

Result<std::shared_ptr<const imaging::Volume>> read_volume(const casefile::Case& patient, const std::string& id) {
  if (patient.find(id) == nullptr) return std::shared_ptr<const imaging::Volume>();
  return patient.volume(id).map([](imaging::Volume volume) {
    return std::shared_ptr<const imaging::Volume>(std::make_shared<imaging::Volume>(std::move(volume)));
  });
}

PatientStructure structure_of(const casefile::StructureSurface& read) {
  return {read.name, std::make_shared<geometry::Surface>(read.surface), read.volume_ml};
}

// Landmarks are those of the structures as they are outlined now, the mesh is that of the model: after an edit some may
// lie outside of it.
void say_lost_landmarks(std::size_t lost, Patient& patient) {
  if (lost == 0) return;
  patient.remarks.push_back(
      {GLISSON_TEXT("The structures have changed since the model was built. Landmarks that now lie outside "
                    "of it are left out ({0}). Build the model anew."),
       {std::to_string(lost)}});
}

// Whatever is outlined and no part of the model: the gall bladder, vessels outside, a landmark for the eye.
Result<void> show_around(const casefile::Case& from, Patient& patient) {
  auto outlined = casefile::read_structures(from);
  if (!outlined) return failure(outlined.error());
  std::erase_if(*outlined, [&](const segmentation::Structure& structure) {
    const auto same = [&](const PatientStructure& known) { return known.name == structure.name; };
    return segmentation::voxel_count(structure.mask) == 0 ||
           std::any_of(patient.structures.begin(), patient.structures.end(), same);
  });
  std::vector<Result<geometry::Surface>> outlines(outlined->size(), failure("cancelled", {}));
  parallel_for(outlines.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) outlines[k] = casefile::smooth_outline((*outlined)[k]);
  });
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    if (!outlines[k]) return failure(outlines[k].error());
    const segmentation::Structure& structure = (*outlined)[k];
    patient.around.push_back({structure.name, std::make_shared<geometry::Surface>(*std::move(outlines[k])),
                              segmentation::volume_ml(structure.mask), true});
  }
  return {};
}

// The smooth surfaces, the liver's among them, ride in the model.
Result<void> prepare_rehearsal(const casefile::Case& from, Patient& patient, const Progress& progress,
                               const FirstLook& first_look) {
  auto model = casefile::read_model(from);
  if (!model) return failure(model.error());
  patient.structures.push_back(structure_of(model->liver));
  for (const auto& structure : model->structures) patient.structures.push_back(structure_of(structure));
  const std::vector<double>& youngs_kPa = casefile::youngs_kPa(*model);
  patient.mean_youngs_kPa = std::accumulate(youngs_kPa.begin(), youngs_kPa.end(), 0.0) /
                            static_cast<double>(std::max<std::size_t>(1, youngs_kPa.size()));
  patient.assumed_stiffness = model->assumed;
  patient.evidence = model->evidence;
  if (auto shown = show_around(from, patient); !shown) return shown;
  if (first_look) {
    Patient shown = patient;
    shown.preparing = true;
    first_look(shown);
  }
  auto [setup, lost_landmarks] = casefile::live_rehearsal_setup(*std::move(model));
  say_lost_landmarks(lost_landmarks, patient);
  auto rehearsal = rehearsal::StaticRehearsal::create(setup, progress);
  if (!rehearsal) return failure(rehearsal.error());
  setup.models = rehearsal->models();
  patient.rehearsal_setup = std::make_shared<rehearsal::RehearsalSetup>(std::move(setup));
  patient.rehearsal = std::make_shared<rehearsal::StaticRehearsal>(*std::move(rehearsal));
  return {};
}

// Of many structures of one file the same is said once.
void add_new(std::vector<Sentence>& remarks, const std::vector<Sentence>& notes) {
  for (const Sentence& note : notes) {
    const auto same = [&](const Sentence& one) { return one.message() == note.message(); };
    if (std::none_of(remarks.begin(), remarks.end(), same)) remarks.push_back(note);
  }
}

// Before there is a model: what has been outlined so far.
Result<void> show_outlines(const casefile::Case& from, Patient& patient) {
  const auto structures = casefile::read_structures(from);
  if (!structures) return failure(structures.error());
  for (const segmentation::Structure& structure : *structures) {
    if (segmentation::voxel_count(structure.mask) == 0) continue;  // begun, and nothing drawn yet
    auto outline = casefile::smooth_outline(structure);
    if (!outline) return failure(outline.error());
    patient.structures.push_back({structure.name, std::make_shared<geometry::Surface>(*std::move(outline)),
                                  segmentation::volume_ml(structure.mask)});
  }
  return {};
}

}  // namespace

OpenedThing kind_of(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path / "case.json", ignored) ? OpenedThing::case_folder : OpenedThing::study;
}

Result<Patient> load_patient(const fs::path& case_folder, const Progress& progress, const FirstLook& first_look) {
  progress.report(0, GLISSON_TEXT("Reading the case"));
  const auto opened = casefile::Case::open(case_folder);
  if (!opened) return failure(opened.error());
  Patient patient;
  patient.name = opened->folder().stem().string();
  patient.origin = opened->origin();
  patient.folder = opened->folder();
  auto anatomy = read_volume(*opened, "volumes/anatomy");
  if (!anatomy) return failure(anatomy.error());
  patient.anatomy = *anatomy;
  auto stiffness = read_volume(*opened, "volumes/stiffness");
  if (!stiffness) return failure(stiffness.error());
  patient.stiffness = *stiffness;
  if (progress.cancelled()) return cancelled();
  progress.report(0.05, GLISSON_TEXT("Preparing the model"));
  if (opened->find("meshes/model") != nullptr) {
    const Patient before = patient;
    const auto prepared = prepare_rehearsal(*opened, patient, progress.part(0.05, 1), first_look);
    if (prepared) return patient;
    if (prepared.error().code == "cancelled") return failure(prepared.error());
    // A model that cannot be used any more keeps nobody from the case.
    patient = before;
    patient.remarks.push_back({prepared.error().text, prepared.error().arguments});
    patient.remarks.push_back({GLISSON_TEXT("The model cannot be used. Build it anew."), {}});
  }
  if (auto shown = show_outlines(*opened, patient); !shown) return failure(shown.error());
  return patient;
}

Result<Patient> import_patient(const imaging::Study& study, const std::vector<casefile::SeriesRole>& roles,
                               const fs::path& case_folder, const Progress& progress, casefile::Replacing replacing) {
  std::error_code ignored;
  const bool there = fs::exists(case_folder / "case.json", ignored);
  auto patient = there ? casefile::Case::open(case_folder) : casefile::Case::create(case_folder);
  if (!patient) return failure(patient.error());
  const auto imported = casefile::import_series_as(*patient, study, roles, progress.part(0, 0.8), replacing);
  if (!imported) {
    if (!there) fs::remove_all(case_folder, ignored);  // nothing was there before: Case::create saw to it
    return failure(imported.error());
  }
  return load_patient(case_folder, progress.part(0.8, 1)).map([&](Patient loaded) {
    for (const casefile::ImportedStructure& structure : imported->structures) add_new(loaded.remarks, structure.notes);
    return loaded;
  });
}

NextStep next_step(const fs::path& case_folder) {
  const auto opened = casefile::Case::open(case_folder);
  if (!opened || opened->find("meshes/model") != nullptr) return NextStep::none;
  if (opened->find("volumes/anatomy") == nullptr) return NextStep::none;
  return opened->find("labels/liver") != nullptr ? NextStep::build_model : NextStep::outline_liver;
}

bool has_waves_to_invert(const fs::path& case_folder) {
  const auto opened = casefile::Case::open(case_folder);
  return opened && opened->find("volumes/stiffness") == nullptr && casefile::has_waves(*opened);
}

Result<Patient> outline_liver(const fs::path& case_folder, const Eigen::Vector3d& inside_mm, const Progress& progress) {
  auto opened = casefile::Case::open(case_folder);
  if (!opened) return failure(opened.error());
  auto grown = casefile::grow_structure(*opened, "liver", {inside_mm}, progress.part(0, 0.9));
  if (!grown) return failure(grown.error());
  return load_patient(case_folder, progress.part(0.9, 1)).map([&](Patient patient) {
    patient.remarks = std::move(grown->notes);
    return patient;
  });
}

Result<Patient> build_model(const fs::path& case_folder, const Progress& progress) {
  auto opened = casefile::Case::open(case_folder);
  if (!opened) return failure(opened.error());
  // Shares of the time that 20,000 cells take: the factorisation, at loading, is most of it.
  if (auto meshed = casefile::mesh_liver(*opened, {}, progress.part(0, 0.2)); !meshed) return failure(meshed.error());
  const bool measured = opened->find("volumes/stiffness") != nullptr;
  const casefile::StiffnessChoice choice = measured ? casefile::StiffnessChoice(casefile::FromMre{})
                                                    : casefile::StiffnessChoice(casefile::FromPopulationMean{});
  if (auto given = casefile::assign_stiffness(*opened, choice, {}, progress.part(0.2, 0.22)); !given) {
    return failure(given.error());
  }
  // The stiffness that nobody chose here.
  return load_patient(case_folder, progress.part(0.22, 1)).map([](Patient patient) {
    if (patient.assumed_stiffness) patient.remarks.push_back(*patient.assumed_stiffness);
    return patient;
  });
}

Result<Patient> load_demo(const fs::path& folder, const Progress& progress, const FirstLook& first_look) {
  const fs::path made_before = folder / "demo.glisson";
  std::error_code ignored;
  if (fs::exists(made_before / "case.json", ignored)) return load_patient(made_before, progress, first_look);
  const auto summary = studies::run_demo(folder, {}, progress.part(0, 0.9));
  if (!summary) return failure(summary.error());
  return load_patient(summary->case_folder, progress.part(0.9, 1), first_look);
}

}  // namespace glisson::widgets
