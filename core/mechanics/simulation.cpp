#include "mechanics/simulation.h"

#include <fmt/format.h>
#include <cmath>

#include "mechanics/static_model.h"

namespace glisson::mechanics {
namespace {

Result<void> refuse_what_is_not_available(const Scenario& scenario);
std::string names_of(const geometry::Fields& fields);
geometry::TetMesh mesh_with_result(const StaticModel& model, const StaticResult& result);

}  // namespace

Result<Simulation> simulate(const geometry::TetMesh& mesh, const Scenario& scenario, const SimulationOptions& options,
                            const Progress& progress) {
  if (auto available = refuse_what_is_not_available(scenario); !available) return failure(std::move(available.error()));
  auto youngs_kPa = youngs_modulus_of_cells(mesh, scenario);
  if (!youngs_kPa) return failure(std::move(youngs_kPa.error()));

  StaticOptions static_options;
  static_options.poisson_ratio = scenario.poisson_ratio;
  static_options.density_kg_mm3 = scenario.density_kg_mm3;
  auto model =
      StaticModel::create(mesh, std::move(*youngs_kPa), scenario.supports, static_options, progress.part(0.0, 0.9));
  if (!model) return failure(std::move(model.error()));
  auto places = locate_landmarks(mesh, scenario.landmarks, options.landmark_tolerance_mm);
  if (!places) return failure(std::move(places.error()));

  progress.report(0.9, "Solving");
  auto result = model->solve(scenario.loads);
  if (!result) return failure(std::move(result.error()));
  progress.report(1.0, "Solved");

  Simulation simulation;
  simulation.scenario = scenario;
  simulation.landmarks = displaced_landmarks(scenario.landmarks, *places, model->displacement_at(*result, *places));
  simulation.mesh = mesh_with_result(*model, *result);
  simulation.result = std::move(*result);
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
  if (scenario.material != MaterialLaw::linear) {
    return failure("not-available", GLISSON_TEXT("Only the material \"linear\" is available yet, at small strain."));
  }
  if (scenario.motion) {
    return failure("not-available", GLISSON_TEXT("Motion is not available yet: leave it out to get equilibrium."));
  }
  return {};
}

std::string names_of(const geometry::Fields& fields) {
  std::string names;
  for (const geometry::Field& field : fields) names += (names.empty() ? "" : ", ") + field.name;
  return names.empty() ? "none" : names;
}

geometry::TetMesh mesh_with_result(const StaticModel& model, const StaticResult& result) {
  geometry::TetMesh mesh = model.mesh();
  geometry::Field displacement{displacement_field, 3, {}};
  displacement.values.reserve(3 * result.displacement_mm.size());
  for (const Eigen::Vector3d& u : result.displacement_mm) {
    displacement.values.insert(displacement.values.end(), u.data(), u.data() + 3);
  }
  geometry::set_field(mesh.point_fields, std::move(displacement));
  geometry::set_field(mesh.cell_fields, {youngs_modulus_field, 1, model.youngs_kPa()});
  geometry::set_field(mesh.cell_fields, {"von_mises_kPa", 1, model.von_mises_kPa(result)});
  return mesh;
}

}  // namespace
}  // namespace glisson::mechanics
