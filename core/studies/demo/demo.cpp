#include "studies/demo/demo.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/files.h"
#include "base/json.h"
#include "casefile/import.h"
#include "casefile/model.h"
#include "casefile/result_folder.h"
#include "casefile/structures.h"
#include "geometry/mesh_file.h"
#include "imaging/study.h"
#include "imaging/volume_file.h"
#include "rehearsal/tool_presets.h"
#include "scene/case_scenes.h"
#include "studies/demo/internal/report.h"
#include "studies/demo/patient.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

using casefile::Case;

// Everything that the steps hand on.
struct Run {
  fs::path out;
  DemoRunOptions options;
  DemoPatient demo;
  DemoSummary summary;
};

Result<void> clear_folder(const fs::path& out);
Result<Case> import_and_segment(Run& run, const Progress& progress);
Result<void> build_model(Run& run, Case& patient, const Progress& progress);
Result<void> rehearse(Run& run, Case& patient, const Progress& progress);
Result<void> judge(Run& run, const Case& patient);
Result<void> draw_pictures(Run& run, const Case& patient, const Progress& progress);

}  // namespace

Result<DemoSummary> run_demo(const fs::path& out, const DemoRunOptions& options, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (auto cleared = clear_folder(out); !cleared) return failure(cleared.error());

  Run run{out, options, {}, {}};
  auto demo = write_demo_study(out, {}, progress.part(0.0, 0.35));
  if (!demo) return failure(demo.error());
  run.demo = std::move(*demo);

  auto patient = import_and_segment(run, progress.part(0.35, 0.6));
  if (!patient) return failure(patient.error());
  auto done = build_model(run, *patient, progress.part(0.6, 0.75))
                  .and_then([&] { return rehearse(run, *patient, progress.part(0.75, 0.9)); })
                  .and_then([&] { return judge(run, *patient); })
                  .and_then([&] { return draw_pictures(run, *patient, progress.part(0.9, 1.0)); });
  if (!done) return failure(done.error());

  run.summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.summary.report = out / "report.html";
  done = write_demo_report(run.summary).and_then([&] {
    return write_text_file(out / "summary.json", summary_json(run.summary).dump(2) + "\n");
  });
  if (!done) return failure(done.error());
  return std::move(run.summary);
}

Json summary_json(const DemoSummary& summary) {
  const auto& comparison = summary.reference_against_mre;
  Json document{
      {"simulated", demo_is_simulated},
      {"case", summary.case_folder.string()},
      {"report", summary.report.string()},
      {"liver_ml", summary.liver_ml},
      {"true_liver_ml", summary.true_liver_ml},
      {"liver_dice", summary.liver_dice},
      {"cells", summary.cells},
      {"min_dihedral_deg", summary.min_dihedral_deg},
      {"hausdorff_mm", summary.hausdorff_mm},
      {"stiffness",
       {{"mean_kPa", summary.stiffness.mean_kPa},
        {"sd_kPa", summary.stiffness.sd_kPa},
        {"min_kPa", summary.stiffness.min_kPa},
        {"max_kPa", summary.stiffness.max_kPa},
        {"filled_fraction", summary.stiffness.filled_fraction},
        {"mean_error_kPa", summary.stiffness_error_kPa}}},
      {"tool", summary.tool},
      {"force_N", summary.force_N},
      {"relative_residual", summary.relative_residual},
      {"max_displacement_mm", summary.max_displacement_mm},
      {"state", to_string(summary.validity.state())},
      {"largest_strain", summary.validity.largest_strain},
      {"inverted_cells", summary.validity.inverted_cells},
      {"atlas_against_mre",
       {{"mean_mm", comparison.mean_mm}, {"max_mm", comparison.max_mm}, {"significant", comparison.significant()}}},
      {"landmarks", Json::array()},
      {"seconds", summary.seconds}};
  if (comparison.max_near_tool_mm) document["atlas_against_mre"]["max_near_tool_mm"] = *comparison.max_near_tool_mm;
  for (const auto& landmark : comparison.landmarks) {
    document["landmarks"].push_back({{"id", landmark.id},
                                     {"mre_mm", landmark.displacement_a_mm},
                                     {"atlas_mm", landmark.displacement_b_mm},
                                     {"difference_mm", landmark.difference_mm},
                                     {"significant", landmark.significant()}});
  }
  return null_where_not_finite(std::move(document));
}

namespace {

// An earlier demo is told by its truth folder.
Result<void> clear_folder(const fs::path& out) {
  std::error_code problem;
  if (!fs::exists(out, problem) || fs::is_empty(out, problem)) return {};
  if (!fs::exists(out / "truth" / "truth.json", problem)) {
    return failure(Error{"demo-folder-taken",
                         GLISSON_TEXT("{0} holds files that are not an earlier demo's."),
                         {out.string()},
                         GLISSON_TEXT("Choose an empty or a new folder."),
                         out});
  }
  for (const char* part : {"demo.glisson", "pictures", "report.html", "summary.json", "guided"})
    fs::remove_all(out / part, problem);
  return {};
}

Result<Case> import_and_segment(Run& run, const Progress& progress) {
  const auto study = imaging::scan(run.demo.dicom_folder, progress.part(0.0, 0.1));
  if (!study) return failure(study.error());
  run.summary.case_folder = run.out / "demo.glisson";
  auto patient = Case::create(run.summary.case_folder);
  if (!patient) return patient;
  const auto imported = casefile::import_study(*patient, *study, {}, progress.part(0.1, 0.4));
  if (!imported) return failure(imported.error());

  for (const DemoSeeds& seeds : run.demo.seeds) {
    if (seeds.structure != "liver") continue;
    const auto liver = casefile::grow_structure(*patient, "liver", seeds.positions_mm, progress.part(0.4, 1.0));
    if (!liver) return failure(liver.error());
    run.summary.liver_ml = liver->volume_ml;
  }
  return patient;
}

Result<void> build_model(Run& run, Case& patient, const Progress& progress) {
  meshing::MeshOptions options;
  options.target_cells = run.options.target_cells;
  const auto mesh = casefile::mesh_liver(patient, options, progress.part(0.0, 0.8));
  if (!mesh) return failure(mesh.error());
  run.summary.cells = mesh->body.cells.size();
  run.summary.min_dihedral_deg = mesh->quality.min_dihedral_deg;
  run.summary.hausdorff_mm = mesh->hausdorff_mm;

  auto stiffness = casefile::assign_stiffness(patient, casefile::FromMre{}, {}, progress.part(0.8, 1.0));
  if (!stiffness) return failure(stiffness.error());
  run.summary.stiffness = std::move(*stiffness);
  return {};
}

// The same retraction on the patient's own stiffness and on the atlas's one value: results/mre and results/atlas.
Result<void> rehearse(Run& run, Case& patient, const Progress& progress) {
  const auto model = casefile::read_model(patient);
  if (!model) return failure(model.error());
  const auto placement = rehearsal::hoist_segment_vi(model->mesh);
  if (!placement) return failure(placement.error());
  run.summary.tool = placement->preset.name;
  run.summary.force_N = run.options.force_N > 0 ? run.options.force_N : placement->preset.usual_force_N;

  mechanics::Scenario scenario;
  scenario.supports = model->supports;
  scenario.landmarks = model->landmarks;
  scenario.loads = {rehearsal::tool_load(*placement, run.summary.force_N)};
  const auto mre = mechanics::simulate(model->mesh, scenario, {}, progress.part(0.0, 0.5));
  if (!mre) return failure(mre.error());
  scenario.youngs_modulus = model->reference_youngs_kPa;
  const auto reference = mechanics::simulate(model->mesh, scenario, {}, progress.part(0.5, 1.0));
  if (!reference) return failure(reference.error());
  run.summary.validity = validity_of(*mre);
  for (const mechanics::Validity& validity : {run.summary.validity, validity_of(*reference)}) {
    if (validity.usable()) continue;
    return failure(Error{"answer-unusable",
                         GLISSON_TEXT("The retraction's answer is not to be used: {0}."),
                         {validity.why_not().message()},
                         GLISSON_TEXT("Use less force."),
                         {}});
  }
  auto comparison = rehearsal::compare(*mre, *reference);
  if (!comparison) return failure(comparison.error());

  run.summary.relative_residual = std::max(mre->result.relative_residual, reference->result.relative_residual);
  run.summary.max_displacement_mm = mre->result.max_displacement_mm;
  run.summary.reference_against_mre = std::move(*comparison);
  return casefile::write_result(patient.folder() / "results" / "mre", *mre).and_then([&] {
    return casefile::write_result(patient.folder() / "results" / "atlas", *reference);
  });
}

// What nobody has for a real patient: the truth, to hold the chain's outcome against.
Result<void> judge(Run& run, const Case& patient) {
  const auto liver =
      patient.file_of("labels/liver").and_then([](const fs::path& file) { return imaging::read_mask_file(file); });
  if (!liver) return failure(liver.error());
  const auto true_liver = imaging::read_mask_file(run.demo.truth_folder / "liver.nrrd");
  if (!true_liver) return failure(true_liver.error());
  const auto dice = segmentation::dice(liver->mask, true_liver->mask);
  if (!dice) return failure(dice.error());
  run.summary.liver_dice = *dice;
  run.summary.true_liver_ml = segmentation::volume_ml(true_liver->mask);

  const auto mesh = geometry::read_tetrahedra(patient.folder() / "meshes" / "model.vtu");
  if (!mesh) return failure(mesh.error());
  const auto true_shear = imaging::read_volume_file(run.demo.truth_folder / "shear_kPa.nrrd");
  if (!true_shear) return failure(true_shear.error());
  double error = 0;
  std::size_t judged = 0;
  for (std::size_t cell = 0; cell < mesh->cells.size(); ++cell) {
    const Eigen::Vector3d index = true_shear->grid.index_of(geometry::cell_centroid_mm(*mesh, cell));
    const Eigen::Vector3i voxel = (index.array() + 0.5).floor().cast<int>();
    if (!true_shear->grid.contains(voxel.x(), voxel.y(), voxel.z())) continue;
    const double shear_kPa = true_shear->at(voxel.x(), voxel.y(), voxel.z());
    if (shear_kPa <= 0) continue;
    error += std::abs(run.summary.stiffness.youngs_kPa[cell] -
                      units::youngs_from_shear(shear_kPa, elastography::StiffnessOptions{}.poisson_ratio));
    ++judged;
  }
  run.summary.stiffness_error_kPa = judged > 0 ? error / static_cast<double>(judged) : 0;
  return {};
}

Result<void> draw_pictures(Run& run, const Case& patient, const Progress& progress) {
  constexpr int width = 1200;
  constexpr int height = 900;
  const fs::path folder = run.out / "pictures";
  const auto save = [&](const Result<scene::Picture>& picture, const std::string& name) -> Result<void> {
    if (!picture) return failure(picture.error());
    run.summary.pictures.push_back(folder / (name + ".png"));
    return scene::write_png(*picture, run.summary.pictures.back());
  };
  const auto draw = [&](const Result<scene::Scene>& scene) -> Result<scene::Picture> {
    if (!scene) return failure(scene.error());
    return scene::draw(*scene, width, height);
  };

  progress.report(0.0, GLISSON_TEXT("Drawing"));
  for (const std::string& name : scene::case_scene_names()) {
    if (auto saved = save(draw(scene::case_scene(patient, name)), name); !saved) return saved;
  }
  const fs::path mre = patient.folder() / "results" / "mre";
  const fs::path reference = patient.folder() / "results" / "atlas";
  if (auto saved = save(draw(scene::result_scene(mre)), "displacement"); !saved) return saved;
  const auto comparison = scene::comparison_scene(reference, "Atlas stiffness", mre, "MRE stiffness");
  if (!comparison) return failure(comparison.error());
  return save(scene::draw_red_blue(*comparison, width, height), "comparison");
}

}  // namespace
}  // namespace glisson::studies
