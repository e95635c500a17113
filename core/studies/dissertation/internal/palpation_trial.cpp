#include "studies/dissertation/internal/palpation_trial.h"

#include <cmath>

#include "base/units.h"

namespace glisson::studies {
namespace {

constexpr double wrong_modulus = 1.5, wrong_stiffening = 1.0, wrong_poisson_ratio = 0.49;

bool is_soft(const PalpationSpecimen& specimen, const geometry::TetMesh& mesh, std::size_t cell) {
  return specimen.youngs_kPa(geometry::cell_centroid_mm(mesh, cell)) == machine_soft_kPa;
}

// The compounds' moduli that somebody stated.
void take_stated(const PalpationSpecimen& specimen, const geometry::TetMesh& mesh, const PalpationOptions& options,
                 std::vector<double>& youngs_kPa) {
  for (std::size_t cell = 0; cell < youngs_kPa.size(); ++cell) {
    const std::optional<double>& stated = is_soft(specimen, mesh, cell) ? options.soft_kPa : options.stiff_kPa;
    if (stated) youngs_kPa[cell] = *stated;
  }
}

std::vector<double> true_moduli(const PalpationSpecimen& specimen, const geometry::TetMesh& mesh) {
  std::vector<double> youngs_kPa;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    youngs_kPa.push_back(specimen.youngs_kPa(geometry::cell_centroid_mm(mesh, cell)));
  }
  return youngs_kPa;
}

// The mean modulus of each compound that the specimen has, by volume.
NamedNumbers compounds_of(const PalpationSpecimen& specimen, const geometry::TetMesh& mesh,
                          const std::vector<double>& youngs_kPa) {
  double sums[2] = {0, 0}, volumes[2] = {0, 0};
  for (std::size_t cell = 0; cell < youngs_kPa.size(); ++cell) {
    const int compound = is_soft(specimen, mesh, cell) ? 0 : 1;
    const double volume_mm3 = geometry::cell_volume_mm3(mesh, cell);
    sums[compound] += volume_mm3 * youngs_kPa[cell];
    volumes[compound] += volume_mm3;
  }
  NamedNumbers found;
  if (volumes[0] > 0) found.emplace_back("soft_kPa", sums[0] / volumes[0]);
  if (volumes[1] > 0) found.emplace_back("stiff_kPa", sums[1] / volumes[1]);
  return found;
}

NamedNumbers begun(const PalpationTrial& trial) {
  NamedNumbers row{{"force_N", trial.force_N}};
  if (trial.reported_mm) row.emplace_back("reported_mm", *trial.reported_mm);
  return row;
}

void append(NamedNumbers& row, const NamedNumbers& more) { row.insert(row.end(), more.begin(), more.end()); }

}  // namespace

Result<PressCurve> truth_of(const PalpationSpecimen& specimen, PalpationFault fault, double ball_radius_mm,
                            const std::vector<double>& forces_N, const PressOptions& options,
                            const Progress& progress) {
  const double poisson_ratio = fault == PalpationFault::poisson ? wrong_poisson_ratio : usual_poisson_ratio;
  const RevolvedBody body{specimen.radius_mm, specimen.height_mm, [&](double r_mm, double z_mm) {
                            const double shear_kPa = units::shear_from_youngs(
                                specimen.youngs_kPa(Eigen::Vector3d(r_mm, 0, z_mm)), usual_poisson_ratio);
                            const double bulk_kPa = 2 * shear_kPa * (1 + poisson_ratio) / (3 * (1 - 2 * poisson_ratio));
                            return Gel{shear_kPa, bulk_kPa, fault == PalpationFault::law ? wrong_stiffening : 0};
                          }};
  std::vector<double> forces_mN;
  for (const double force_N : forces_N) forces_mN.push_back(units::mN_from_N(force_N));
  return press_revolved(body, ball_radius_mm, forces_mN, options, progress);
}

Result<NamedNumbers> judged_trial(const PalpationSpecimen& specimen, const PalpationTrial& trial,
                                  const PalpationFacts& facts, const PalpationOptions& options,
                                  const Progress& progress) {
  const geometry::TetMesh mesh = palpation_mesh(specimen, {options.bricks_across, options.bricks_high});
  std::vector<double> youngs_kPa = facts.found.youngs_kPa;
  take_stated(specimen, mesh, options, youngs_kPa);
  if (trial.fault == PalpationFault::modulus) {
    for (double& modulus : youngs_kPa) modulus *= wrong_modulus;
  }
  const auto model =
      press(mesh, youngs_kPa, options.poisson_ratio, options.ball_radius_mm, trial.force_N, progress.part(0, 0.5));
  if (!model) return failure(model.error());
  const auto surface =
      compare(*model, simulated_scans(facts.rest_profile_mm, facts.pressed, options.ball_radius_mm, facts.scan_seed),
              options.ball_radius_mm);
  if (!surface) return failure(surface.error());

  NamedNumbers row = begun(trial);
  const double true_mm = facts.pressed.depth_mm;
  const auto off_percent = [&](double depth_mm) { return 100 * (depth_mm / true_mm - 1); };
  append(row,
         {{"true_depth_mm", true_mm}, {"depth_mm", model->depth_mm}, {"off_percent", off_percent(model->depth_mm)}});
  if (facts.told_too) {
    const auto told = press(mesh, true_moduli(specimen, mesh), options.poisson_ratio, options.ball_radius_mm,
                            trial.force_N, progress.part(0.5, 1));
    if (!told) return failure(told.error());
    row.emplace_back("told_off_percent", off_percent(told->depth_mm));
  }
  append(row, compounds_of(specimen, mesh, youngs_kPa));
  append(row, {{"measured_percent", 100 * (1 - facts.found.filled_fraction)},
               {"largest_strain", model->largest_strain},
               {"contact_radius_mm", facts.pressed.contact_radius_mm}});
  append(row, *surface);
  return row;
}

Result<NamedNumbers> compared_trial(const PalpationSpecimen& specimen, const PalpationTrial& trial,
                                    const PalpationOptions& options, const PalpationScans& scans,
                                    const Progress& progress) {
  const geometry::TetMesh mesh = palpation_mesh(specimen, {options.bricks_across, options.bricks_high});
  std::vector<double> youngs_kPa(mesh.cells.size());
  take_stated(specimen, mesh, options, youngs_kPa);
  const auto model = press(mesh, youngs_kPa, options.poisson_ratio, options.ball_radius_mm, trial.force_N, progress);
  if (!model) return failure(model.error());
  const auto surface = compare(*model, scans, options.ball_radius_mm);
  if (!surface) return failure(surface.error());
  NamedNumbers row = begun(trial);
  append(row, {{"depth_mm", model->depth_mm}, {"largest_strain", model->largest_strain}});
  append(row, *surface);
  return row;
}

}  // namespace glisson::studies
