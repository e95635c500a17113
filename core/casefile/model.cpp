#include "casefile/model.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/tissue.h"
#include "casefile/model_upkeep.h"
#include "casefile/placed_landmarks.h"
#include "casefile/structure_landmarks.h"
#include "casefile/structures.h"
#include "casefile/used_entries.h"
#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "meshing/mask_surface.h"
#include "rehearsal/liver_supports.h"
#include "segmentation/lesions.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

using segmentation::Structure;

bool in_liver(const Structure& structure) {
  const auto place = segmentation::known_structure(structure.name).place;
  return place == segmentation::Place::liver || place == segmentation::Place::inside;
}

Result<void> save_structure_surfaces(Case& patient, const std::vector<Structure>& structures);
Result<elastography::CellStiffness> stiffness_from_mre(const Case& patient, const geometry::TetMesh& mesh,
                                                       const elastography::StiffnessOptions& options, Provenance& made);
std::vector<Eigen::Vector3d> centroids_mm(const geometry::TetMesh& mesh);

}  // namespace

Result<meshing::LiverMesh> mesh_liver(Case& patient, const meshing::MeshOptions& options, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Reading the structures"));
  auto structures = read_structures(patient);
  if (!structures) return failure(structures.error());
  std::erase_if(*structures, [](const Structure& structure) { return !in_liver(structure); });
  if (structures->empty() || structures->front().name != "liver")
    return failure(patient.file_of("labels/liver").error());

  auto whole = segmentation::with_lesions(std::move(structures->front().mask), *structures);
  structures->front().mask = std::move(whole.liver);

  const auto composed = segmentation::compose_labels(*structures, segmentation::Extent::liver);
  if (!composed) return failure(composed.error());
  meshing::MeshOptions named = options;
  std::vector<std::string> outside;  // a portal vein as some programs outline it: its stem alone
  for (std::size_t i = 0; i < composed->names.size(); ++i) {
    const auto label = static_cast<std::uint16_t>(i + 1);
    const auto& voxels = composed->labels.values;
    if (std::find(voxels.begin(), voxels.end(), label) == voxels.end()) {
      outside.push_back(composed->names[i]);
    } else {
      named.names.push_back({label, composed->names[i]});
    }
  }
  auto meshed = meshing::mesh_labels(composed->labels, named, progress.part(0.05, 0.85));
  if (!meshed) return failure(meshed.error());

  Provenance made{"mesh", {{"target-cells", std::to_string(options.target_cells)}}, {}, {}, meshed->notes};
  for (const Structure& structure : *structures) made.from.push_back("labels/" + structure.name);
  for (const std::string& lesion : whole.added) {
    made.notes.push_back({GLISSON_TEXT("{0} was not wholly inside the liver; it was meshed as part of it."), {lesion}});
  }
  for (const std::string& name : outside) {
    made.notes.push_back({GLISSON_TEXT("{0} lies outside of the liver and has no cells of its own."), {name}});
  }
  for (const meshing::LabelName& region : named.names) {
    made.options[fmt::format("region-{}", region.label)] = region.name;
  }
  // A liver that is cut by the image may lack its upper rear; then the scenario must say what holds it.
  if (auto marked = rehearsal::mark_attachments(meshed->body); !marked) {
    made.notes.push_back({marked.error().text, marked.error().arguments});
  }

  progress.report(0.9, GLISSON_TEXT("Saving the mesh"));
  auto saved = patient.together([&] {
    return patient
        .add("meshes/liver", ".vtu", made,
             [&](const fs::path& file) { return geometry::write_tetrahedra(file, meshed->body); })
        .and_then([&] { return save_structure_surfaces(patient, *structures); });
  });
  if (!saved) return failure(saved.error());
  meshed->notes = made.notes;
  return meshed;
}

Result<elastography::CellStiffness> assign_stiffness(Case& patient, const StiffnessChoice& choice,
                                                     const elastography::StiffnessOptions& options,
                                                     const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Reading the mesh"));
  auto mesh =
      patient.file_of("meshes/liver").and_then([](const fs::path& file) { return geometry::read_tetrahedra(file); });
  if (!mesh) return failure(mesh.error());

  Provenance made{"stiffness", {{"poisson-ratio", fmt::format("{}", options.poisson_ratio)}}, {"meshes/liver"}, {}, {}};
  Result<elastography::CellStiffness> stiffness = tl::unexpected(Error{});
  if (std::holds_alternative<FromMre>(choice)) {
    progress.report(0.2, GLISSON_TEXT("Stiffness of each cell from the MRE map"));
    stiffness = stiffness_from_mre(patient, *mesh, options, made);
  } else {
    const auto* uniform = std::get_if<Uniform>(&choice);
    const double youngs_kPa =
        uniform ? uniform->youngs_kPa
                : elastography::reference_youngs_kPa(std::get<FromPopulationMean>(choice).mean, options.poisson_ratio);
    if (!(youngs_kPa > 0) || !std::isfinite(youngs_kPa)) {
      return failure("stiffness-invalid", GLISSON_TEXT("A Young's modulus of {0} kPa is not possible."),
                     {fmt::format("{}", youngs_kPa)});
    }
    stiffness = elastography::uniform_stiffness(mesh->cells.size(), youngs_kPa);
    made.options[uniform ? "uniform_kPa" : "atlas_kPa"] =
        uniform ? fmt::format("{}", youngs_kPa) : fmt::format("{:g}", youngs_kPa);
  }
  if (!stiffness) return stiffness;

  const bool stated = std::holds_alternative<Uniform>(choice);
  mechanics::set_moduli(*mesh, stiffness->youngs_kPa, stated ? std::nullopt : std::optional(options.poisson_ratio));
  geometry::Field source{"stiffness_source", 1, {}};
  for (const auto s : stiffness->source) source.values.push_back(static_cast<double>(s));
  geometry::set_field(mesh->cell_fields, std::move(source));
  progress.report(0.9, GLISSON_TEXT("Saving the model"));
  auto saved = patient.add("meshes/model", ".vtu", std::move(made),
                           [&](const fs::path& file) { return geometry::write_tetrahedra(file, *mesh); });
  if (!saved) return failure(saved.error());
  return stiffness;
}

Result<std::optional<imaging::Mask>> confident_voxels(const Case& patient) {
  if (!patient.find("volumes/confidence")) return std::nullopt;
  const auto confidence = patient.volume("volumes/confidence");
  if (!confidence) return failure(confidence.error());
  imaging::Mask confident{confidence->grid, {}};
  // Scanners store the mask as 0 and something, or as a percentage; half of the largest value counts as confident.
  const float half = 0.5f * *std::max_element(confidence->values.begin(), confidence->values.end());
  for (const float value : confidence->values) confident.values.push_back(value > half ? 1 : 0);
  return confident;
}

Result<elastography::Reliability> reliability_of(const Case& patient) {
  elastography::Reliability reliability;
  auto confident = confident_voxels(patient);
  if (!confident) return failure(std::move(confident.error()));
  reliability.confident = std::move(*confident);
  if (patient.find("labels/liver")) {
    auto liver =
        patient.file_of("labels/liver").and_then([](const fs::path& file) { return imaging::read_mask_file(file); });
    if (!liver) return failure(liver.error());
    reliability.organ = std::move(liver->mask);
  }
  return reliability;
}

Result<PatientModel> read_model(const Case& patient) {
  auto model = read_model_before_evidence(patient);
  if (!model) return model;
  auto learnt = with_evidence(patient, organ_of(*model), model->mesh);
  if (!learnt) return failure(std::move(learnt.error()));
  if (learnt->evidence.effects.empty()) return model;
  mechanics::set_moduli(model->mesh, std::move(learnt->organ.youngs_kPa), mechanics::poisson_ratio_of(model->mesh));
  model->supports = std::move(learnt->organ.supports);
  model->capsule = learnt->organ.capsule;
  model->anisotropy = learnt->organ.anisotropy;
  model->strain_stiffening = learnt->organ.strain_stiffening;
  model->relaxation = std::move(learnt->organ.relaxation);
  model->standing_loads = std::move(learnt->organ.standing_loads);
  model->evidence = std::move(learnt->evidence);
  const auto& effects = model->evidence.effects;
  const bool scaled = std::any_of(effects.begin(), effects.end(), [](const closedloop::LearntEffect& effect) {
    return effect.carried && effect.kind == "stiffness-scale";
  });
  if (scaled) model->assumed.reset();
  return model;
}

Result<PatientModel> read_model_before_evidence(const Case& patient) {
  auto mesh =
      patient.file_of("meshes/model").and_then([](const fs::path& file) { return geometry::read_tetrahedra(file); });
  if (!mesh) {
    return failure(patient.find("meshes/liver") && !patient.find("meshes/model")
                       ? std::move(mesh.error())
                             .with_hint(GLISSON_TEXT("Give the mesh its stiffness first (glisson-cli stiffness)."))
                       : mesh.error());
  }
  if (auto own = check_own_mesh(patient, *mesh); !own) return failure(std::move(own.error()));
  PatientModel model;
  model.mesh = std::move(*mesh);
  const double ratio = mechanics::poisson_ratio_of(model.mesh).value_or(usual_poisson_ratio);
  const auto moduli = mechanics::moduli_of(model.mesh, mechanics::youngs_modulus_field, ratio);
  if (!moduli && moduli.error().code != "modulus-missing") return failure(moduli.error());
  if (!moduli) {
    return failure(Error{"model-no-stiffness",
                         GLISSON_TEXT("The model of {0} has no stiffness."),
                         {patient.folder().string()},
                         GLISSON_TEXT("Run glisson-cli stiffness again."),
                         patient.folder()});
  }
  model.assumed = assumed_stiffness(patient);
  model.reference_youngs_kPa =
      elastography::reference_youngs_kPa(elastography::PopulationMean::dissertation_cohort, ratio);
  model.supports = rehearsal::usual_supports();

  const auto structures = read_structures(patient);
  if (!structures) return failure(structures.error());
  model.landmarks = landmarks_of(*structures);
  const auto placed = placed_landmarks(patient);
  if (!placed) return failure(placed.error());
  model.landmarks.insert(model.landmarks.end(), placed->begin(), placed->end());
  for (const Structure& structure : *structures) {
    if (!in_liver(structure) || !patient.find("surfaces/" + structure.name)) continue;
    auto surface = patient.file_of("surfaces/" + structure.name).and_then([](const fs::path& file) {
      return geometry::read_surface(file);
    });
    if (!surface) return failure(surface.error());
    StructureSurface shown{structure.name, structure.color_rgb, std::move(*surface),
                           segmentation::volume_ml(structure.mask)};
    if (structure.name == "liver") {
      model.liver = std::move(shown);
    } else {
      model.structures.push_back(std::move(shown));
    }
  }
  return model;
}

Result<geometry::Surface> smooth_outline(const Structure& structure) {
  return meshing::mask_surface(structure.mask,
                               structure.name == "liver" ? meshing::organ_smoothing : meshing::MaskSurfaceOptions{});
}

namespace {

Result<void> save_structure_surfaces(Case& patient, const std::vector<Structure>& structures) {
  for (const Structure& structure : structures) {
    if (segmentation::voxel_count(structure.mask) == 0) continue;
    const auto surface = smooth_outline(structure);
    if (!surface) return failure(surface.error());
    auto saved =
        patient.add("surfaces/" + structure.name, ".vtp", Provenance{"mesh", {}, {"labels/" + structure.name}, {}, {}},
                    [&](const fs::path& file) { return geometry::write_surface(file, *surface); });
    if (!saved) return saved;
  }
  return {};
}

Result<elastography::CellStiffness> stiffness_from_mre(const Case& patient, const geometry::TetMesh& mesh,
                                                       const elastography::StiffnessOptions& options,
                                                       Provenance& made) {
  const auto map = patient.volume("volumes/stiffness");
  if (!map) {
    return failure(Error{map.error()}.with_hint(
        GLISSON_TEXT("Import a study with MR elastography, or choose --uniform-kPa or --atlas.")));
  }
  made.from.push_back("volumes/stiffness");

  const auto reliability = reliability_of(patient);
  if (!reliability) return failure(reliability.error());
  if (reliability->confident) made.from.push_back("volumes/confidence");
  if (reliability->organ) made.from.push_back("labels/liver");
  return elastography::cell_stiffness(centroids_mm(mesh), *map, *reliability, options);
}

std::vector<Eigen::Vector3d> centroids_mm(const geometry::TetMesh& mesh) {
  std::vector<Eigen::Vector3d> centroids(mesh.cells.size());
  for (std::size_t cell = 0; cell < centroids.size(); ++cell) centroids[cell] = geometry::cell_centroid_mm(mesh, cell);
  return centroids;
}

}  // namespace
}  // namespace glisson::casefile
