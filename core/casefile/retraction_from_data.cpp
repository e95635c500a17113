#include "casefile/retraction_from_data.h"

#include <algorithm>

#include "closedloop/material/stress_strain_file.h"
#include "geometry/field.h"
#include "mechanics/simulation.h"
#include "rehearsal/tool_presets.h"

namespace glisson::casefile {
namespace {

using mechanics::Scenario;
using mechanics::Simulation;

// One tool at segment VI; the rest is the model's.
Result<Scenario> retraction(const PatientModel& model, double force_N);

Result<Simulation> converged(PatientModel model, const Scenario& scenario, const mechanics::SimulationOptions& options,
                             const Progress& progress);

void compare(const Simulation& from_data, const Simulation& by_model, RetractionFromData& answer);

}  // namespace

Result<RetractionFromData> retract_from_data(const Case& patient, const std::filesystem::path& file, double force_N,
                                             const Progress& progress) {
  auto model = read_model(patient);
  if (!model) return failure(std::move(model.error()));
  auto scenario = retraction(*model, force_N);
  if (!scenario) return failure(std::move(scenario.error()));
  auto measured = closedloop::read_stress_strain(file);
  if (!measured) return failure(std::move(measured.error()));
  auto data = mechanics::MaterialData::create(*measured, {.poisson_ratio = scenario->poisson_ratio});
  if (!data) return failure(std::move(data.error()).in_file(file));

  RetractionFromData answer;
  answer.measured = *std::move(measured);
  answer.slope_kPa = data->slope_kPa();
  auto by_model = converged(*model, *scenario, {}, progress.part(0, 0.3));
  if (!by_model) return failure(std::move(by_model.error()));
  leave_stiffness_to_data(*model);
  mechanics::SimulationOptions options;
  options.data = *std::move(data);
  auto from_data = converged(*model, *scenario, options, progress.part(0.3, 1));
  if (!from_data) return failure(std::move(from_data.error()));
  compare(*from_data, *by_model, answer);
  return answer;
}

namespace {

Result<Scenario> retraction(const PatientModel& model, double force_N) {
  return rehearsal::hoist_segment_vi(model.mesh).map([&](const rehearsal::ToolPlacement& placement) {
    Scenario scenario;
    scenario.loads = {rehearsal::tool_load(placement, force_N)};
    return scenario;
  });
}

Result<Simulation> converged(PatientModel model, const Scenario& scenario, const mechanics::SimulationOptions& options,
                             const Progress& progress) {
  Scenario asked = scenario;
  static_cast<void>(put_into(asked, model));
  auto simulation = mechanics::simulate(model.mesh, asked, options, progress);
  if (simulation && !simulation->result.converged()) {
    return failure("not-converged", GLISSON_TEXT("The computation did not converge: {0}"),
                   {simulation->result.why_stopped});
  }
  return simulation;
}

void compare(const Simulation& from_data, const Simulation& by_model, RetractionFromData& answer) {
  answer.from_data_mm = from_data.result.max_displacement_mm;
  answer.by_model_mm = by_model.result.max_displacement_mm;
  answer.beyond_data = from_data.share_beyond_data;
  answer.validity = std::max(validity_of(from_data), validity_of(by_model),
                             [](const auto& a, const auto& b) { return a.state() < b.state(); });
  geometry::TetMesh liver = from_data.mesh;
  std::vector<double> apart_mm;
  for (std::size_t p = 0; p < liver.points_mm.size(); ++p) {
    const Eigen::Vector3d& displaced_mm = from_data.result.displacement_mm[p];
    apart_mm.push_back((displaced_mm - by_model.result.displacement_mm[p]).norm());
    answer.apart_mean_mm += apart_mm.back() / static_cast<double>(liver.points_mm.size());
    answer.apart_largest_mm = std::max(answer.apart_largest_mm, apart_mm.back());
    liver.points_mm[p] += displaced_mm;
  }
  answer.surface = geometry::boundary_surface(liver);
  geometry::Field apart{apart_field, 1, {}};
  for (const double point : geometry::find_field(answer.surface.point_fields, "mesh_point")->values) {
    apart.values.push_back(apart_mm[static_cast<std::size_t>(point)]);
  }
  geometry::set_field(answer.surface.point_fields, std::move(apart));
  for (std::size_t l = 0; l < from_data.landmarks.size(); ++l) {
    const mechanics::DisplacedLandmark &one = from_data.landmarks[l], &other = by_model.landmarks[l];
    answer.landmarks.push_back(
        {one.id, one.displacement_mm, other.displacement_mm, (one.displaced_mm - other.displaced_mm).norm()});
  }
}

}  // namespace
}  // namespace glisson::casefile
