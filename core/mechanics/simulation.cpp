#include "mechanics/simulation.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/stopwatch.h"
#include "mechanics/elements/body.h"
#include "mechanics/internal/simulation_answer.h"
#include "mechanics/meshfree/meshfree_model.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/scenario/mesh_moduli.h"
#include "mechanics/statics/buckling.h"
#include "mechanics/statics/data_driven.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"
#include "mechanics/statics/static_model.h"

namespace glisson::mechanics {
namespace {

bool is_linear(const Scenario& scenario);
bool has_friction(const Scenario& scenario);
Result<void> check_tools(const Scenario& scenario);
Result<void> check_anisotropy(const Scenario& scenario, const SimulationOptions& options);
Result<void> check_walls(const Scenario& scenario, const SimulationOptions& options);
Result<void> check_device(const Scenario& scenario, const SimulationOptions& options);
Result<void> check_relaxation(const Scenario& scenario, const SimulationOptions& options);
std::vector<double> after_long(std::vector<double> youngs_kPa, const Scenario& scenario);
Result<Answer> answer_to(const Question& question, const OpenedBody& body, const SimulationOptions& options,
                         const Progress& progress);
Result<Answer> linear_equilibrium(const Question& question, const Progress& progress);
Result<Answer> equilibrium_from_data(const Question& question, const MaterialData& data, const Progress& progress);
Result<MeshModuli> moduli_for(const geometry::TetMesh& mesh, const Scenario& scenario);
void set_result_fields(const StaticResult& result, const Scenario& scenario, std::vector<double> youngs_kPa,
                       std::vector<double> von_mises_kPa, geometry::TetMesh& mesh);

}  // namespace

Result<Simulation> simulate(const geometry::TetMesh& whole, const Scenario& scenario, const SimulationOptions& options,
                            const Progress& progress) {
  if (auto checked = geometry::check_tetrahedra(whole); !checked) return failure(std::move(checked.error()));
  if (auto available = check_tools(scenario); !available) return failure(std::move(available.error()));
  if (auto available = check_anisotropy(scenario, options); !available) return failure(std::move(available.error()));
  if (auto available = check_walls(scenario, options); !available) return failure(std::move(available.error()));
  if (auto available = check_device(scenario, options); !available) return failure(std::move(available.error()));
  if (auto available = check_relaxation(scenario, options); !available) return failure(std::move(available.error()));
  const bool meshfree = scenario.engine == Engine::meshfree;
  const auto body = open_cuts(whole, scenario.cuts, meshfree ? Along::exactly : Along::nearly);
  if (!body) return failure(body.error());
  const geometry::TetMesh& mesh = body->mesh;
  auto moduli = options.data ? MeshModuli{std::vector<double>(mesh.cells.size(), options.data->slope_kPa()), {}}
                             : moduli_for(mesh, scenario);
  if (!moduli) return failure(std::move(moduli.error()));
  auto places = locate_landmarks(mesh, scenario.landmarks, options.landmark_tolerance_mm);
  if (!places) return failure(std::move(places.error()));

  const std::vector<double> youngs_kPa =
      scenario.motion ? moduli->youngs_kPa : after_long(moduli->youngs_kPa, scenario);
  auto answer = answer_to({mesh, youngs_kPa, scenario, *places, {}, options.device}, *body, options, progress);
  if (!answer) return failure(std::move(answer.error()));
  progress.report(1.0, GLISSON_TEXT("Solved"));

  Simulation simulation;
  simulation.scenario = scenario;
  simulation.landmarks = displaced_landmarks(scenario.landmarks, *places, answer->landmark_displacements_mm);
  simulation.steps = std::move(answer->steps);
  simulation.tools = std::move(answer->tools);
  simulation.contact = answer->contact;
  simulation.share_beyond_data = answer->share_beyond_data;
  simulation.mesh = mesh;
  set_result_fields(answer->result, scenario, std::move(moduli->youngs_kPa), std::move(answer->von_mises_kPa),
                    simulation.mesh);
  simulation.result = std::move(answer->result);
  if (moduli->note) simulation.result.notes.push_back(std::move(*moduli->note));
  if (!scenario.relaxation.empty() && !scenario.motion) {
    simulation.result.notes.push_back(fmt::format(
        "The tissue relaxes: this is its equilibrium after long, with {:.3g} times the stiffness that it has "
        "at once.",
        long_term_share(scenario.relaxation)));
  }
  if (const int inside = cells_in_others(whole); inside > 0) {
    simulation.result.notes.push_back(fmt::format(
        "{} of {} cells lie in others: where the body folds over itself, its tissue counts twice. Mesh it anew.",
        inside, whole.cells.size()));
  }
  if (!scenario.cuts.empty()) {
    simulation.cut = opening_of(*body, simulation.result.displacement_mm);
    if (scenario.cut_walls == Scenario::Walls::apart && simulation.contact)
      simulation.cut->largest_overlap_mm = simulation.contact->overlap_mm;
    if (simulation.cut->largest_overlap_mm > 0.5) {
      simulation.result.notes.push_back(
          fmt::format("The walls of the cuts pass through each other by up to {:.1f} mm. \"cut_walls\": \"apart\" "
                      "keeps them apart, "
                      "in equilibrium by finite elements.",
                      simulation.cut->largest_overlap_mm));
    }
  }
  for (const DisplacedLandmark& landmark : simulation.landmarks) {
    if (landmark.outside_by_mm > 0.5) {
      simulation.result.notes.push_back(
          fmt::format("Landmark {} lies {:.1f} mm outside the body and moves with the nearest part of its surface.",
                      landmark.id, landmark.outside_by_mm));
    }
  }
  return simulation;
}

Validity validity_of(const Simulation& simulation) {
  Validity worst = validity_of(simulation.result, simulation.scenario.material);
  for (const TimeStep& step : simulation.steps) {
    worst.largest_strain = std::max(worst.largest_strain, step.largest_strain);
    worst.inverted_cells = std::max(worst.inverted_cells, step.report.inverted_cells);
  }
  return worst;
}

Result<std::vector<double>> youngs_modulus_of_cells(const geometry::TetMesh& mesh, const Scenario& scenario) {
  return moduli_for(mesh, scenario).map([&](MeshModuli moduli) {
    return after_long(std::move(moduli.youngs_kPa), scenario);
  });
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

bool has_ligaments(const Scenario& scenario) {
  return std::any_of(scenario.supports.begin(), scenario.supports.end(),
                     [](const Support& support) { return std::holds_alternative<Ligament>(support.how); });
}

bool may_be_anisotropic(const Scenario& scenario) {
  return scenario.engine == Engine::fem && !scenario.motion && is_linear(scenario);
}

Result<MaterialBody> material_body(const Question& question) {
  const Scenario& scenario = question.scenario;
  const Stopwatch watch;
  auto body =
      prepare_body(question.mesh, question.youngs_kPa, scenario.supports, options_of(scenario), Holding::required);
  if (!body) return failure(std::move(body.error()));
  std::vector<Material> materials = materials_of(*body, scenario.material, scenario.strain_stiffening);
  return MaterialBody{std::move(*body), std::move(materials), watch.seconds()};
}

Answer answer_of(const MaterialBody& prepared, StaticResult result, const Places& places) {
  const auto& [body, materials, setup_s] = prepared;
  result.setup_s = setup_s;
  auto landmarks_mm = displacement_at(body, result, places);
  auto von_mises_kPa = von_mises_of_cells(body, materials, nodal_displacements(body.layout, result));
  return Answer{std::move(result), std::move(landmarks_mm), std::move(von_mises_kPa), {}, {}, {}};
}

StaticOptions options_of(const Scenario& scenario) {
  StaticOptions options;
  options.poisson_ratio = scenario.poisson_ratio;
  options.density_kg_mm3 = scenario.density_kg_mm3;
  options.capsule = scenario.capsule;
  options.anisotropy = scenario.anisotropy;
  options.prescribed_displacements = scenario.engine == Engine::fem && !scenario.motion && scenario.tools.empty() &&
                                     scenario.cut_walls == Scenario::Walls::free;
  options.parts = scenario.cuts.empty() ? StaticOptions::Parts::one : StaticOptions::Parts::several;
  return options;
}

namespace {

bool is_linear(const Scenario& scenario) {
  return scenario.material == MaterialLaw::linear && !has_ligaments(scenario);
}

bool has_friction(const Scenario& scenario) {
  return std::any_of(scenario.tools.begin(), scenario.tools.end(), [](const ScenarioTool& tool) {
    const auto* rigid = std::get_if<ScenarioRigidTool>(&tool.what);
    return rigid != nullptr && rigid->friction > 0;
  });
}

Result<void> check_tools(const Scenario& scenario) {
  if (scenario.tools.empty()) return {};
  if (scenario.anisotropy && has_friction(scenario)) {
    return failure(Error{"not-available",
                         GLISSON_TEXT("Tools with friction are not there for a body with a grain."),
                         {},
                         GLISSON_TEXT("Leave out the grain or the friction."),
                         {}});
  }
  return {};
}

Result<void> check_anisotropy(const Scenario& scenario, const SimulationOptions& options) {
  if (!scenario.anisotropy || (may_be_anisotropic(scenario) && !options.data)) return {};
  return failure(
      "not-available",
      GLISSON_TEXT("A grain is there for equilibrium by finite elements, with the material \"linear\" and without "
                   "ligaments."));
}

Result<void> check_walls(const Scenario& scenario, const SimulationOptions& options) {
  const bool can_be = scenario.engine == Engine::fem && !scenario.motion && !scenario.anisotropy && !options.data;
  if (scenario.cut_walls == Scenario::Walls::free || can_be) return {};
  return failure(
      "not-available",
      GLISSON_TEXT("The walls of cuts can be kept apart in equilibrium by finite elements, without a grain and "
                   "not straight from data."));
}

Result<void> check_device(const Scenario& scenario, const SimulationOptions& options) {
  const bool can_be =
      scenario.motion && scenario.engine == Engine::fem && !options.data && moves_by_one_solve(scenario);
  if (!options.device || can_be) return {};
  return failure("not-available",
                 GLISSON_TEXT("An OpenCL device solves motions by finite elements with the material \"linear\" or "
                              "\"corotational\", without tools, ligaments, capsule or gas."));
}

Result<void> check_relaxation(const Scenario& scenario, const SimulationOptions& options) {
  if (options.data && !scenario.relaxation.empty()) {
    return failure(Error{"not-available",
                         GLISSON_TEXT("Straight from data nothing relaxes: the measured stresses are what is left."),
                         {},
                         GLISSON_TEXT("Leave out \"relaxation\"."),
                         {}});
  }
  return mechanics::check_relaxation(scenario.relaxation);
}

std::vector<double> after_long(std::vector<double> youngs_kPa, const Scenario& scenario) {
  const double left = long_term_share(scenario.relaxation);
  for (double& modulus_kPa : youngs_kPa) modulus_kPa *= left;
  return youngs_kPa;
}

Result<MeshModuli> moduli_for(const geometry::TetMesh& mesh, const Scenario& scenario) {
  const YoungsModulus modulus = scenario.youngs_modulus.value_or(youngs_modulus_field);
  if (const double* uniform_kPa = std::get_if<double>(&modulus))
    return MeshModuli{std::vector<double>(mesh.cells.size(), *uniform_kPa), {}};
  return moduli_of(mesh, std::get<std::string>(modulus), scenario.poisson_ratio);
}

// A body whose forces answer linearly keeps its factor; all others go to the minimum of their potential energy, or step
// in time.
Result<Answer> answer_to(const Question& question, const OpenedBody& body, const SimulationOptions& options,
                         const Progress& progress) {
  const Scenario& scenario = question.scenario;
  const bool meshfree = scenario.engine == Engine::meshfree;
  if (options.data) return equilibrium_from_data(question, *options.data, progress);
  if (scenario.motion && meshfree) return meshfree_dynamics(question, progress);
  if (scenario.motion) return fem_dynamics(question, progress);
  if (meshfree) return meshfree_equilibrium(question, progress);

  const Question with_walls{question.mesh, question.youngs_kPa, scenario, question.places, body.walls};
  const bool apart = scenario.cut_walls == Scenario::Walls::apart;
  if (is_linear(scenario) && !has_friction(scenario)) {
    if (apart) return linear_contact_equilibrium(with_walls, progress);
    return scenario.tools.empty() ? linear_equilibrium(question, progress)
                                  : linear_contact_equilibrium(question, progress);
  }
  auto answer = nonlinear_equilibrium(question, progress);
  // Walls that nothing presses together need no more than that.
  if (!answer || !apart ||
      opening_of(body, answer->result.displacement_mm).largest_overlap_mm <=
          ContactOptions().penetration_tolerance_mm) {
    return answer;
  }
  return nonlinear_equilibrium(with_walls, progress);
}

Result<Answer> linear_equilibrium(const Question& question, const Progress& progress) {
  const auto model = StaticModel::create(question.mesh, question.youngs_kPa, question.scenario.supports,
                                         options_of(question.scenario), progress.part(0.0, 0.9));
  if (!model) return failure(model.error());
  progress.report(0.9, GLISSON_TEXT("Solving"));
  auto result = model->solve(question.scenario.loads);
  if (!result) return failure(std::move(result.error()));
  if (const double beyond = load_beyond_buckling(*model, *result); beyond > 1) {
    result->notes.push_back(fmt::format(
        "Linear elasticity cannot know it: the body buckles, at a load at least {:.1f} times smaller. Take a "
        "material for large deformation (corotational, neo-hookean).",
        beyond));
  }
  auto landmarks_mm = model->displacement_at(*result, question.places);
  auto von_mises_kPa = model->von_mises_kPa(*result);
  return Answer{std::move(*result), std::move(landmarks_mm), std::move(von_mises_kPa), {}, {}, {}};
}

Result<Answer> equilibrium_from_data(const Question& question, const MaterialData& data, const Progress& progress) {
  const Scenario& scenario = question.scenario;
  if (scenario.engine != Engine::fem || scenario.motion || scenario.capsule || has_ligaments(scenario) ||
      !scenario.tools.empty()) {
    return failure(
        "not-available",
        GLISSON_TEXT("Straight from data there are equilibria by finite elements: without a motion, a capsule, "
                     "ligaments, tools or the meshfree engine."));
  }
  auto found = find_equilibrium_from_data(question.mesh, data, scenario.supports, scenario.loads,
                                          scenario.density_kg_mm3, {}, progress);
  if (!found) return failure(std::move(found.error()));
  StaticOptions options = options_of(scenario);
  options.order = ElementOrder::quadratic;
  const auto body = prepare_body(question.mesh, question.youngs_kPa, scenario.supports, options, Holding::required);
  if (!body) return failure(body.error());
  auto landmarks_mm = displacement_at(*body, found->result, question.places);
  Answer answer{std::move(found->result), std::move(landmarks_mm), std::move(found->von_mises_kPa), {}, {}, {}};
  answer.share_beyond_data = found->share_beyond_data;
  return answer;
}

void set_result_fields(const StaticResult& result, const Scenario& scenario, std::vector<double> youngs_kPa,
                       std::vector<double> von_mises_kPa, geometry::TetMesh& mesh) {
  geometry::Field displacement{displacement_field, 3, {}};
  displacement.values.reserve(3 * result.displacement_mm.size());
  for (const Eigen::Vector3d& u : result.displacement_mm) {
    displacement.values.insert(displacement.values.end(), u.data(), u.data() + 3);
  }
  geometry::set_field(mesh.point_fields, std::move(displacement));
  // Moduli that are the scenario's own were not made of shear moduli.
  const bool from_mesh =
      scenario.youngs_modulus.value_or(youngs_modulus_field) == YoungsModulus(youngs_modulus_field) &&
      poisson_ratio_of(mesh);
  set_moduli(mesh, std::move(youngs_kPa), from_mesh ? std::optional(scenario.poisson_ratio) : std::nullopt);
  geometry::set_field(mesh.cell_fields, {"von_mises_kPa", 1, std::move(von_mises_kPa)});
}

}  // namespace
}  // namespace glisson::mechanics
