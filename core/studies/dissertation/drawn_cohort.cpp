#include "studies/dissertation/drawn_cohort.h"

#include <fmt/format.h>
#include <cmath>
#include <ctime>

#include "base/files.h"
#include "base/noise.h"
#include "elastography/cell_stiffness.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "shapes/drawn_liver.h"
#include "shapes/model_file.h"
#include "studies/dissertation/cohort.h"

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

Result<NamedNumbers> make_liver(const shapes::ShapeModel& model, int number, const fs::path& file,
                                const DrawnCohortOptions& options) {
  const double start_s = thread_seconds();
  const auto drawn = shapes::draw_liver(model, options.seed, static_cast<std::uint64_t>(number));
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
  const NamedNumbers row{{"volume_ml", volume_ml},
                         {"cells", static_cast<double>(body.cells.size())},
                         {"mean_kPa", stiffness->mean_kPa},
                         {"sd_kPa", stiffness->sd_kPa},
                         {"attempts", drawn->attempts}};
  mechanics::set_moduli(body, std::move(stiffness->youngs_kPa), reading.poisson_ratio);
  if (auto written = geometry::write_tetrahedra(file, body); !written) return failure(written.error());
  NamedNumbers timed = row;
  timed.emplace_back("cpu_s", thread_seconds() - start_s);
  return timed;
}

}  // namespace

Result<DrawnCohort> draw_cohort(const fs::path& model_file, const fs::path& out, const DrawnCohortOptions& options,
                                const Progress& progress) {
  const auto model = shapes::read_model(model_file);
  if (!model) return failure(model.error());
  const auto content = sha256_of_file(model_file);
  if (!content) return failure(content.error());
  std::error_code problem;
  fs::create_directories(out, problem);
  const auto noted = write_text_file(
      out / "SIMULATED.txt",
      fmt::format(
          "SIMULATED livers, drawn from a model of {} livers with seed {}: nobody's anatomy, nobody's stiffness\n",
          model->livers, options.seed));
  if (!noted) return failure(noted.error());
  std::vector<BatchPatient> patients;
  for (int number = 1; number <= options.count; ++number) {
    const std::string id = fmt::format("simulated-{:05}", number);
    if (!fs::exists(mesh_file(out, id), problem)) fs::remove(out / "patients" / (id + ".json"), problem);
    patients.push_back({id, fmt::format("drawn/1 {} {} {} {}", *content, options.seed, number, options.target_cells)});
  }
  auto rows = run_batch(
      out, patients,
      [&](std::size_t p) {
        return make_liver(*model, static_cast<int>(p) + 1, mesh_file(out, patients[p].id), options);
      },
      {}, progress);
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
