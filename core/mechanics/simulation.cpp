#include "mechanics/simulation.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>

#include "mechanics/body.h"
#include "mechanics/equilibrium.h"
#include "mechanics/large_deformation.h"
#include "mechanics/newton_motion.h"
#include "mechanics/static_model.h"
#include "mechanics/stopwatch.h"

namespace glisson::mechanics {
namespace {

// What an engine answers, whichever it was.
struct Answer {
  StaticResult result;
  std::vector<Eigen::Vector3d> landmark_displacements_mm;
  std::vector<double> von_mises_kPa;  // one a cell
  std::vector<MotionStep> steps;
};
using Places = std::vector<PointInMesh>;

Result<void> refuse_what_is_not_available(const Scenario& scenario);
bool is_linear(const Scenario& scenario);
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

  const auto compute = scenario.motion ? end_of_motion : is_linear(scenario) ? small_equilibrium : large_equilibrium;
  auto answer = compute(mesh, *youngs_kPa, scenario, *places, progress);
  if (!answer) return failure(std::move(answer.error()));
  progress.report(1.0, "Solved");

  Simulation simulation;
  simulation.scenario = scenario;
  simulation.landmarks = displaced_landmarks(scenario.landmarks, *places, answer->landmark_displacements_mm);
  simulation.steps = std::move(answer->steps);
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
  return {};
}

bool has_ligaments(const Scenario& scenario) {
  return std::any_of(scenario.supports.begin(), scenario.supports.end(),
                     [](const Support& support) { return std::holds_alternative<Ligament>(support.how); });
}

bool is_linear(const Scenario& scenario) {
  return scenario.material == MaterialLaw::linear && !has_ligaments(scenario);
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
  options.capsule = scenario.capsule;
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
  return Answer{std::move(*result), std::move(landmarks_mm), std::move(von_mises_kPa), {}};
}

Result<Answer> large_equilibrium(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa,
                                 const Scenario& scenario, const Places& places, const Progress& progress) {
  const Stopwatch watch;
  const auto body =
      prepare_body(mesh, std::move(youngs_kPa), scenario.supports, options_of(scenario), Holding::required);
  if (!body) return failure(body.error());
  const std::vector<Material> materials = materials_of(*body, scenario.material, scenario.strain_stiffening);
  const double setup_s = watch.seconds();
  auto result = find_equilibrium(*body, materials, scenario.loads, {}, progress);
  if (!result) return failure(std::move(result.error()));
  result->setup_s = setup_s;
  auto landmarks_mm = displacement_at(*body, *result, places);
  auto von_mises_kPa = von_mises_of_cells(*body, materials, nodal_displacements(*body, *result));
  return Answer{std::move(*result), std::move(landmarks_mm), std::move(von_mises_kPa), {}};
}

// One step solve moves what it can; Newton the rest.
bool moves_by_one_solve(const Scenario& scenario) {
  const bool gas = std::any_of(scenario.loads.begin(), scenario.loads.end(),
                               [](const Load& load) { return std::holds_alternative<PressureLoad>(load); });
  return !has_ligaments(scenario) && !scenario.capsule &&
         (scenario.material == MaterialLaw::linear || (scenario.material == MaterialLaw::corotational && !gas));
}

// From rest, under loads that are there from the first moment.
struct Mover {
  std::function<Result<StepReport>()> step;
  std::function<Eigen::VectorXd()> displacement_mm, velocity_mm_s;
};

Result<Answer> end_of_motion(const geometry::TetMesh& mesh, std::vector<double> youngs_kPa, const Scenario& scenario,
                             const Places& places, const Progress& progress) {
  const Stopwatch setting_up;
  StaticOptions options = options_of(scenario);
  options.order = ElementOrder::linear;  // the cells that both movers move
  const auto body = prepare_body(mesh, std::move(youngs_kPa), scenario.supports, options, Holding::optional);
  if (!body) return failure(body.error());
  const std::vector<Material> materials = materials_of(*body, scenario.material, scenario.strain_stiffening);
  const auto loads = applied_loads(*body, scenario.loads, gas_on(materials));
  if (!loads) return failure(loads.error());
  const Motion& motion = *scenario.motion;
  MotionOptions motion_options{.step_s = motion.step_s,
                               .mass_damping_per_s = motion.mass_damping_per_s,
                               .stiffness_damping_s = motion.stiffness_damping_s};

  std::optional<MovingBody> moving;
  std::optional<NewtonMotion> newton;
  Mover mover;
  if (moves_by_one_solve(scenario)) {
    motion_options.max_iterations = 5000;  // nobody waits for a frame here: stiff bodies get theirs
    auto created = MovingBody::create(*body, scenario.material, motion_options);
    if (!created) return failure(std::move(created.error()));
    moving = std::move(*created);
    mover = {[&]() -> Result<StepReport> { return moving->step(loads->dead_mN); },
             [&] { return moving->displacement_mm(); }, [&] { return moving->velocity_mm_s(); }};
  } else {
    motion_options.max_iterations = 40;  // Newton steps: see NewtonOptions
    auto created = NewtonMotion::create(*body, materials, *loads, motion_options);
    if (!created) return failure(std::move(created.error()));
    newton = std::move(*created);
    mover = {[&] { return newton->step(progress); }, [&] { return newton->displacement_mm(); },
             [&] { return newton->velocity_mm_s(); }};
  }
  const double setup_s = setting_up.seconds();

  // What the damping pushes with: its stiffness' part is the slope of the forces along the velocity.
  const auto damping_mN = [&](const Eigen::VectorXd& u_mm, const Eigen::VectorXd& v_mm_s) -> Eigen::VectorXd {
    const double speed = v_mm_s.cwiseAbs().maxCoeff();
    if (motion.stiffness_damping_s == 0 || speed == 0) return Eigen::VectorXd::Zero(u_mm.size());
    const double ahead_s = 1e-6 / speed;
    return motion.stiffness_damping_s / ahead_s *
           (internal_force_mN(*body, materials, u_mm) - internal_force_mN(*body, materials, u_mm + ahead_s * v_mm_s));
  };

  Answer answer;
  SolveStatus status = SolveStatus::converged;
  double relative_residual = 0;
  int iterations = 0, done = 0;
  StaticResult state;
  const Stopwatch stepping;
  for (; done < motion.steps && status == SolveStatus::converged; ++done) {
    progress.report(double(done) / motion.steps, "Moving");
    if (progress.cancelled()) return cancelled();
    auto report = mover.step();
    if (!report) return failure(std::move(report.error()));
    iterations += report->iterations;
    relative_residual = std::max(relative_residual, report->relative_residual);
    if (!report->converged) status = SolveStatus::not_converged;
    const Eigen::VectorXd u_mm = mover.displacement_mm();
    state = state_of(*body, materials, u_mm, *loads, damping_mN(u_mm, mover.velocity_mm_s()));
    MotionStep step{(done + 1) * motion.step_s, displacement_at(*body, state, places),
                    state.held_reaction_mN,     state.foundation_reaction_mN,
                    state.ligament_reaction_mN, *report};
    for (std::size_t l = 0; l < places.size(); ++l) step.landmarks_mm[l] += scenario.landmarks[l].position_mm;
    answer.steps.push_back(std::move(step));
  }

  StaticResult& result = answer.result;
  result = std::move(state);
  result.status = status;
  result.relative_residual = relative_residual;
  result.iterations = iterations;
  result.setup_s = setup_s;
  result.step_ms = 1e3 * stepping.seconds() / done;
  result.why_stopped = result.status == SolveStatus::converged
                           ? fmt::format("All {} steps converged, the worst to a relative residual of {:.1e}.", done,
                                         result.relative_residual)
                           : fmt::format("Step {} of {} stayed at a relative residual of {:.1e}.", done, motion.steps,
                                         result.relative_residual);
  answer.landmark_displacements_mm = displacement_at(*body, result, places);
  answer.von_mises_kPa = von_mises_of_cells(*body, materials, mover.displacement_mm());
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
