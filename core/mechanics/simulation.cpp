#include "mechanics/simulation.h"

#include <fmt/format.h>
#include <cmath>

#include "mechanics/body.h"
#include "mechanics/equilibrium.h"
#include "mechanics/large_deformation.h"
#include "mechanics/motion.h"
#include "mechanics/static_model.h"
#include "mechanics/stopwatch.h"
#include "mechanics/strain.h"

namespace glisson::mechanics {
namespace {

// What an engine answers, whichever it was.
struct Answer {
  StaticResult result;
  std::vector<Eigen::Vector3d> landmark_displacements_mm;
  std::vector<double> von_mises_kPa;  // one a cell
};
using Places = std::vector<PointInMesh>;

Result<void> refuse_what_is_not_available(const Scenario& scenario);
Result<Answer> small_equilibrium(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                 const Scenario& scenario, const Places& places, const Progress& progress);
Result<Answer> large_equilibrium(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                 const Scenario& scenario, const Places& places, const Progress& progress);
Result<Answer> end_of_motion(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa, const Scenario& scenario,
                             const Places& places, const Progress& progress);
std::string names_of(const geometry::Fields& fields);
void set_result_fields(const StaticResult& result, std::vector<double> youngs_kPa, std::vector<double> von_mises_kPa,
                       geometry::TetMesh& mesh);

}  // namespace

Result<Simulation> simulate(const geometry::TetMesh& mesh, const Scenario& scenario, const SimulationOptions& options,
                            const Progress& progress) {
  if (auto available = refuse_what_is_not_available(scenario); !available) return failure(std::move(available.error()));
  if (auto checked = geometry::check_tetrahedra(mesh); !checked) return failure(std::move(checked.error()));
  auto youngs_kPa = youngs_modulus_of_cells(mesh, scenario);
  if (!youngs_kPa) return failure(std::move(youngs_kPa.error()));
  auto places = locate_landmarks(mesh, scenario.landmarks, options.landmark_tolerance_mm);
  if (!places) return failure(std::move(places.error()));

  const auto compute = scenario.motion                            ? end_of_motion
                       : scenario.material == MaterialLaw::linear ? small_equilibrium
                                                                  : large_equilibrium;
  auto answer = compute(mesh, *youngs_kPa, scenario, *places, progress);
  if (!answer) return failure(std::move(answer.error()));
  progress.report(1.0, "Solved");

  Simulation simulation;
  simulation.scenario = scenario;
  simulation.landmarks = displaced_landmarks(scenario.landmarks, *places, answer->landmark_displacements_mm);
  simulation.mesh = mesh;
  set_result_fields(answer->result, std::move(*youngs_kPa), std::move(answer->von_mises_kPa), simulation.mesh);
  simulation.result = std::move(answer->result);
  for (const DisplacedLandmark& landmark : simulation.landmarks) {
    if (landmark.outside_by_mm > 0.5) {
      simulation.result.notes.push_back(
          fmt::format("Landmark {} lies {:.1f} mm outside the body and moves with the nearest part of its surface.",
                      landmark.id, landmark.outside_by_mm));
    }
  }
  return simulation;
}

Result<std::vector<double>> youngs_modulus_of_cells(const geometry::TetMesh& mesh, const Scenario& scenario) {
  const YoungsModulus modulus = scenario.youngs_modulus.value_or(youngs_modulus_field);
  if (const double* uniform_kPa = std::get_if<double>(&modulus)) {
    return std::vector<double>(mesh.cells.size(), *uniform_kPa);
  }
  const std::string& name = std::get<std::string>(modulus);
  const geometry::Field* field = geometry::find_field(mesh.cell_fields, name);
  if (field == nullptr || field->components != 1 || field->values.size() != mesh.cells.size()) {
    return failure(Error{"modulus-missing",
                         GLISSON_TEXT("The mesh has no cell array {0} with one value a cell."),
                         {name, names_of(mesh.cell_fields)},
                         GLISSON_TEXT("Give the scenario \"youngs_modulus_kPa\", a number or the name of a cell array; "
                                      "the mesh's cell arrays are: {1}."),
                         {}});
  }
  return field->values;
}

Result<std::vector<PointInMesh>> locate_landmarks(const geometry::TetMesh& mesh, const std::vector<Landmark>& landmarks,
                                                  double tolerance_mm) {
  std::vector<Eigen::Vector3d> positions_mm;
  for (const Landmark& landmark : landmarks) {
    if (!landmark.position_mm.allFinite()) {
      return failure("landmark-invalid", GLISSON_TEXT("The position of landmark {0} is not a finite point."),
                     {landmark.id});
    }
    positions_mm.push_back(landmark.position_mm);
  }
  std::vector<PointInMesh> places = locate_points(mesh, positions_mm);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].outside_by_mm <= tolerance_mm) continue;
    return failure(Error{"landmark-outside",
                         GLISSON_TEXT("Landmark {0} lies {1} mm outside the body."),
                         {landmarks[i].id, fmt::format("{:.1f}", places[i].outside_by_mm)},
                         GLISSON_TEXT("Check that landmarks and mesh are in the same coordinates (LPS, mm)."),
                         {}});
  }
  return places;
}

std::vector<DisplacedLandmark> displaced_landmarks(const std::vector<Landmark>& landmarks,
                                                   const std::vector<PointInMesh>& places,
                                                   const std::vector<Eigen::Vector3d>& displacements_mm) {
  std::vector<DisplacedLandmark> displaced;
  displaced.reserve(landmarks.size());
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    displaced.push_back({landmarks[i].id, landmarks[i].position_mm, landmarks[i].position_mm + displacements_mm[i],
                         displacements_mm[i].norm(), places[i].outside_by_mm});
  }
  return displaced;
}

namespace {

Result<void> refuse_what_is_not_available(const Scenario& scenario) {
  if (scenario.engine != Engine::fem) {
    return failure("not-available", GLISSON_TEXT("The meshfree engine is not available yet: take engine \"fem\"."));
  }
  if (scenario.motion && scenario.material == MaterialLaw::neo_hookean) {
    return failure("not-available", GLISSON_TEXT("Motion is available for the materials \"linear\" and "
                                                 "\"corotational\"; leave it out to get equilibrium."));
  }
  return {};
}

std::string names_of(const geometry::Fields& fields) {
  std::string names;
  for (const geometry::Field& field : fields) names += (names.empty() ? "" : ", ") + field.name;
  return names.empty() ? "none" : names;
}

StaticOptions options_of(const Scenario& scenario) {
  StaticOptions options;
  options.poisson_ratio = scenario.poisson_ratio;
  options.density_kg_mm3 = scenario.density_kg_mm3;
  return options;
}

Result<Answer> small_equilibrium(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                 const Scenario& scenario, const Places& places, const Progress& progress) {
  const auto model = StaticModel::create(mesh, std::move(youngs_kPa), scenario.supports, options_of(scenario),
                                         progress.part(0.0, 0.9));
  if (!model) return failure(model.error());
  progress.report(0.9, "Solving");
  auto result = model->solve(scenario.loads);
  if (!result) return failure(std::move(result.error()));
  auto landmarks_mm = model->displacement_at(*result, places);
  auto von_mises_kPa = model->von_mises_kPa(*result);
  return Answer{std::move(*result), std::move(landmarks_mm), std::move(von_mises_kPa)};
}

Result<Answer> large_equilibrium(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                 const Scenario& scenario, const Places& places, const Progress& progress) {
  const Stopwatch watch;
  const auto body =
      prepare_body(mesh, std::move(youngs_kPa), scenario.supports, options_of(scenario), Holding::required);
  if (!body) return failure(body.error());
  const std::vector<Material> materials = materials_of(*body, scenario.material);
  const double setup_s = watch.seconds();
  auto result = find_equilibrium(*body, materials, scenario.loads, {}, progress);
  if (!result) return failure(std::move(result.error()));
  result->setup_s = setup_s;
  auto landmarks_mm = displacement_at(*body, *result, places);
  auto von_mises_kPa = von_mises_of_cells(*body, materials, nodal_displacements(*body, *result));
  return Answer{std::move(*result), std::move(landmarks_mm), std::move(von_mises_kPa)};
}

// From rest, under loads that are there from the first moment.
Result<Answer> end_of_motion(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa, const Scenario& scenario,
                             const Places& places, const Progress& progress) {
  const Stopwatch setting_up;
  StaticOptions options = options_of(scenario);
  options.order = ElementOrder::linear;  // the cells that MovingBody moves
  auto body = prepare_body(mesh, std::move(youngs_kPa), scenario.supports, options, Holding::optional);
  if (!body) return failure(std::move(body.error()));
  const std::vector<Material> materials = materials_of(*body, scenario.material);
  const Motion& motion = *scenario.motion;
  auto moving = MovingBody::create(std::move(*body), scenario.material,
                                   {.step_s = motion.step_s,
                                    .mass_damping_per_s = motion.mass_damping_per_s,
                                    .stiffness_damping_s = motion.stiffness_damping_s,
                                    .max_iterations = 5000});  // nobody waits for a frame here: stiff bodies get theirs
  if (!moving) return failure(std::move(moving.error()));
  const auto force_mN = moving->force_of(scenario.loads);
  if (!force_mN) return failure(force_mN.error());

  Answer answer;
  StaticResult& result = answer.result;
  result.setup_s = setting_up.seconds();
  result.status = SolveStatus::converged;
  const Stopwatch stepping;
  int done = 0;
  for (; done < motion.steps && result.status == SolveStatus::converged; ++done) {
    progress.report(double(done) / motion.steps, "Moving");
    if (progress.cancelled()) return cancelled();
    const StepReport step = moving->step(*force_mN);
    result.iterations += step.iterations;
    result.relative_residual = std::max(result.relative_residual, step.relative_residual);
    result.inverted_cells = step.inverted_cells;
    result.strain_energy_uJ = step.strain_energy_uJ;
    if (!step.converged) result.status = SolveStatus::not_converged;
  }
  result.step_ms = 1e3 * stepping.seconds() / done;
  result.why_stopped = result.status == SolveStatus::converged
                           ? fmt::format("All {} steps converged, the worst to a relative residual of {:.1e}.", done,
                                         result.relative_residual)
                           : fmt::format("Step {} of {} stayed at a relative residual of {:.1e}.", done, motion.steps,
                                         result.relative_residual);

  const Eigen::VectorXd u_mm = moving->displacement_mm();
  set_displacements(moving->body(), u_mm, result);
  result.applied_force_mN = sum_of(*force_mN);
  result.external_work_uJ = u_mm.dot(*force_mN);
  const StrainMeasure measure =
      scenario.material == MaterialLaw::linear ? StrainMeasure::small : StrainMeasure::stretch;
  result.largest_strain = strain_range(mesh, moving->body().layout, u_mm, measure).largest_strain;
  if (result.inverted_cells > 0) {
    result.notes.push_back(fmt::format("{} cells are turned inside out at the end.", result.inverted_cells));
  }
  answer.landmark_displacements_mm = displacement_at(moving->body(), result, places);
  answer.von_mises_kPa = von_mises_of_cells(moving->body(), materials, u_mm);
  return answer;
}

void set_result_fields(const StaticResult& result, std::vector<double> youngs_kPa, std::vector<double> von_mises_kPa,
                       geometry::TetMesh& mesh) {
  geometry::Field displacement{displacement_field, 3, {}};
  displacement.values.reserve(3 * result.displacement_mm.size());
  for (const Eigen::Vector3d& u : result.displacement_mm) {
    displacement.values.insert(displacement.values.end(), u.data(), u.data() + 3);
  }
  geometry::set_field(mesh.point_fields, std::move(displacement));
  geometry::set_field(mesh.cell_fields, {youngs_modulus_field, 1, std::move(youngs_kPa)});
  geometry::set_field(mesh.cell_fields, {"von_mises_kPa", 1, std::move(von_mises_kPa)});
}

}  // namespace
}  // namespace glisson::mechanics
