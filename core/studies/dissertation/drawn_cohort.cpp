#include "studies/dissertation/drawn_cohort.h"

#include <fmt/format.h>
#include <cmath>
#include <ctime>

#include "base/files.h"
#include "base/json.h"
#include "base/noise.h"
#include "base/write_file.h"
#include "elastography/cell_stiffness.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "shapes/carried_vessels.h"
#include "shapes/drawn_liver.h"
#include "shapes/model_file.h"
#include "studies/dissertation/cohort.h"
#include "vasculature/tree_file.h"

namespace glisson::studies {
namespace fs = std::filesystem;
namespace {

// Processor time of this thread: what a liver costs whatever else runs.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

fs::path mesh_file(const fs::path& out, const std::string& id) { return out / (id + ".vtu"); }
fs::path trees_file(const fs::path& out, const std::string& id) { return out / (id + "_trees.json"); }

// What a liver is drawn from; vessels in the model's mean.
struct Template {
  shapes::ShapeModel model;
  std::optional<shapes::LiverWithVessels> vessels;
};

Result<Template> read_template(const fs::path& model_file, const DrawnCohortOptions& options) {
  auto model = shapes::read_model(model_file);
  if (!model) return failure(model.error());
  Template from{*std::move(model), {}};
  if (options.vessels == DrawnCohortOptions::Vessels::none) return from;
  auto vessels = shapes::reference_vessels(options.reference_spacing_mm);
  if (!vessels) return failure(vessels.error());
  auto in_mean = shapes::carry_vessels(*vessels, from.model.mean);
  if (!in_mean) {
    Error error = in_mean.error();
    return failure(std::move(error).in_file(model_file));
  }
  from.vessels = shapes::LiverWithVessels{from.model.mean, std::move(in_mean->trees), std::move(in_mean->depth_mm)};
  return from;
}

// The drawn liver's trees, written, with what the table says of them.
Result<NamedNumbers> write_vessels(const Template& from, const geometry::Surface& drawn, const fs::path& file) {
  const auto carried = shapes::carry_vessels(*from.vessels, drawn);
  if (!carried) return failure(carried.error());
  Json document = vasculature::trees_json(carried->trees);
  document["simulated"] =
      fmt::format("SIMULATED: vessels of a generated liver, carried into a shape drawn from a model of {} livers",
                  from.model.livers);
  if (auto written = write_json_file(file, document); !written) return failure(written.error());
  double portal_mm = 0, hepatic_mm = 0;
  for (const vasculature::TreeBranch& branch : carried->trees.branches) {
    if (branch.system == vasculature::System::portal_vein) portal_mm += branch.length_mm;
    if (branch.system == vasculature::System::hepatic_vein) hepatic_mm += branch.length_mm;
  }
  return NamedNumbers{{"branches", static_cast<double>(carried->trees.branches.size())},
                      {"portal_veins_mm", portal_mm},
                      {"hepatic_veins_mm", hepatic_mm},
                      {"pulled_in", carried->pulled_in},
                      {"farthest_pulled_mm", carried->farthest_pulled_mm},
                      {"cut_off", carried->cut_off},
                      {"outside", carried->outside}};
}

Result<NamedNumbers> make_liver(const Template& from, int number, const fs::path& out, const std::string& id,
                                const DrawnCohortOptions& options) {
  const double start_s = thread_seconds();
  const auto drawn = shapes::draw_liver(from.model, options.seed, static_cast<std::uint64_t>(number));
  if (!drawn) return failure(drawn.error());
  auto mesh = shapes::mesh_of(*drawn, options.target_cells);
  if (!mesh) return failure(mesh.error());
  geometry::TetMesh& body = mesh->body;
  const imaging::Volume shear_kPa = simulated_liver_map(
      drawn->surface, static_cast<unsigned>(mixed(options.seed, static_cast<std::uint64_t>(number))));
  std::vector<Eigen::Vector3d> centers_mm;
  for (const auto& cell : body.cells) {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const int corner : cell) center += body.points_mm[static_cast<std::size_t>(corner)] / 4;
    centers_mm.push_back(center);
  }
  elastography::StiffnessOptions reading;
  reading.unreliable_border_mm = 0;  // a drawn map has no waves that borders reflect
  auto stiffness = elastography::cell_stiffness(centers_mm, shear_kPa, {}, reading);
  if (!stiffness) return failure(stiffness.error());
  const double volume_ml = geometry::volume_mm3(mesh->surface) / 1000;
  NamedNumbers row{{"volume_ml", volume_ml},
                   {"cells", static_cast<double>(body.cells.size())},
                   {"mean_kPa", stiffness->mean_kPa},
                   {"sd_kPa", stiffness->sd_kPa},
                   {"attempts", drawn->attempts}};
  mechanics::set_moduli(body, std::move(stiffness->youngs_kPa), reading.poisson_ratio);
  const auto written = write_together([&]() -> Result<void> {
    if (from.vessels) {
      const auto vessels = write_vessels(from, drawn->surface, trees_file(out, id));
      if (!vessels) return failure(vessels.error());
      row.insert(row.end(), vessels->begin(), vessels->end());
    }
    return geometry::write_tetrahedra(mesh_file(out, id), body);
  });
  if (!written) return failure(written.error());
  row.emplace_back("cpu_s", thread_seconds() - start_s);
  return row;
}

}  // namespace

Result<DrawnCohort> draw_cohort(const fs::path& model_file, const fs::path& out, const DrawnCohortOptions& options,
                                const Progress& progress) {
  const auto from = read_template(model_file, options);
  if (!from) return failure(from.error());
  const auto content = sha256_of_file(model_file);
  if (!content) return failure(content.error());
  std::error_code problem;
  fs::create_directories(out, problem);
  const auto noted = write_text_file(
      out / "SIMULATED.txt",
      fmt::format(
          "SIMULATED livers, drawn from a model of {} livers with seed {}: nobody's anatomy, nobody's stiffness{}\n",
          from->model.livers, options.seed, from->vessels ? ", nobody's vessels" : ""));
  if (!noted) return failure(noted.error());
  std::vector<BatchPatient> patients;
  for (int number = 1; number <= options.count; ++number) {
    const std::string id = fmt::format("simulated-{:05}", number);
    const bool whole =
        fs::exists(mesh_file(out, id), problem) && (!from->vessels || fs::exists(trees_file(out, id), problem));
    if (!whole) fs::remove(out / "patients" / (id + ".json"), problem);
    patients.push_back({id, fmt::format("drawn/{} {} {} {} {}", from->vessels ? 2 : 1, *content, options.seed, number,
                                        options.target_cells)});
  }
  auto rows = run_batch(
      out, patients,
      [&](std::size_t p) { return make_liver(*from, static_cast<int>(p) + 1, out, patients[p].id, options); }, {},
      progress);
  if (!rows) return failure(rows.error());
  DrawnCohort cohort;
  cohort.rows = std::move(*rows);
  double cpu_s = 0, made = 0;
  for (const BatchRow& row : cohort.rows) {
    if (!row.error.empty()) {
      ++cohort.failed;
      continue;
    }
    ++cohort.livers;
    cohort.reused += row.reused ? 1 : 0;
    for (const auto& [name, value] : row.values) {
      if (name == "cpu_s" && !row.reused) cpu_s += value, made += 1;
    }
  }
  cohort.cpu_seconds_a_liver = made > 0 ? cpu_s / made : 0;
  const std::vector<double> ml = column_of(cohort.rows, "volume_ml");
  const auto n = static_cast<double>(ml.size());
  for (const double volume : ml) cohort.mean_volume_ml += volume / n;
  for (const double volume : ml)
    cohort.sd_volume_ml += (volume - cohort.mean_volume_ml) * (volume - cohort.mean_volume_ml);
  cohort.sd_volume_ml = n > 1 ? std::sqrt(cohort.sd_volume_ml / (n - 1)) : 0;
  if (auto written = write_batch_csv(out / "livers.csv", cohort.rows); !written) return failure(written.error());
  return cohort;
}

}  // namespace glisson::studies
