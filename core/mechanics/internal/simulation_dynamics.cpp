// A scenario's motion, by whichever engine moves it.

#include <fmt/format.h>
#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "base/stopwatch.h"
#include "mechanics/contact/internal/augmented_lagrangian.h"
#include "mechanics/dynamics/newton_implicit_euler.h"
#include "mechanics/elements/body.h"
#include "mechanics/internal/simulation_answer.h"
#include "mechanics/meshfree/internal/meshfree_dynamics.h"
#include "mechanics/meshfree/meshfree_contact.h"
#include "mechanics/potentials/elastic.h"
#include "mechanics/statics/displacements.h"
#include "mechanics/statics/equilibrium.h"

namespace glisson::mechanics {
namespace {

// One step solve moves what it can; Newton the rest.
// A body that can be moved on, of either engine.
struct Mover {
  std::function<Result<StepReport>()> step;
  std::function<Eigen::VectorXd()> displacement_mm, velocity_mm_s;
  std::function<const StressHistory*()> history;       // none of a body that does not relax
  std::function<Eigen::Vector3d()> fixed_reaction_mN;  // none: what is left unbalanced at what is fixed
  // Where there are tools: what they push with, of the whole body and each by itself.
  std::function<Eigen::VectorXd()> tools_force_mN;
  std::function<std::pair<std::vector<ToolContact>, ContactReport>()> contacts;
};

// `moving` must outlive it.
template <typename Moving>
Mover mover_of(const Moving& moving, std::function<Result<StepReport>()> step) {
  return {std::move(step),
          [&] { return moving.displacement_mm(); },
          [&] { return moving.velocity_mm_s(); },
          [&] { return moving.history(); },
          {},
          {},
          {}};
}

// Lets the mover tell of what presses on its body.
void press(Mover& mover, const AugmentedLagrangian& lagrangian, const std::vector<ContactTool>& tools,
           const AppliedLoads& loads);

// The tools' way is gone in equal parts, one a step. Failure: "tool-too-fast" (a tool that would pass the surface by).
Result<void> check_speed(const Scenario& scenario);

// `materials` are those of a step: of tissue that relaxes with the share of their moduli that it has then.
Result<Answer> follow(const Mover& mover, const Body& body, const std::vector<Material>& materials,
                      const AppliedLoads& loads, const Scenario& scenario, double setup_s, const Places& places,
                      const Progress& progress);
DynamicsOptions motion_options_of(const Scenario& scenario);
double share_of_step(const Scenario& scenario);

}  // namespace

bool moves_by_one_solve(const Scenario& scenario) {
  const bool gas = std::any_of(scenario.loads.begin(), scenario.loads.end(),
                               [](const Load& load) { return std::holds_alternative<PressureLoad>(load); });
  return scenario.tools.empty() && !has_ligaments(scenario) && !scenario.capsule &&
         (scenario.material == MaterialLaw::linear || (scenario.material == MaterialLaw::corotational && !gas));
}

Result<Answer> fem_dynamics(const Question& question, const Progress& progress) {
  const Scenario& scenario = question.scenario;
  const Stopwatch setting_up;
  StaticOptions options = options_of(scenario);
  options.order = ElementOrder::linear;  // the cells that both movers move
  const auto body = prepare_body(question.mesh, question.youngs_kPa, scenario.supports, options, Holding::optional);
  if (!body) return failure(body.error());
  const std::vector<Material> materials = materials_of(*body, scenario.material, scenario.strain_stiffening);
  const auto loads = applied_loads(*body, scenario.loads, pressure_kind_of(materials));
  if (!loads) return failure(loads.error());
  DynamicsOptions motion_options = motion_options_of(scenario);
  std::optional<ImplicitEuler> moving;
  std::optional<NewtonImplicitEuler> newton;
  std::optional<AugmentedLagrangian> lagrangian;
  std::vector<ContactTool> tools;
  int done = 0;
  Mover mover;
  if (!scenario.tools.empty()) {
    if (auto checked = check_speed(scenario); !checked) return failure(std::move(checked.error()));
    motion_options.max_iterations = 40;
    auto created = NewtonImplicitEuler::create(*body, materials, *loads, motion_options);
    if (!created) return failure(std::move(created.error()));
    newton = std::move(*created);
    auto placed =
        AugmentedLagrangian::create(newton->body(), tools_at(scenario.tools, 0.0), {}, newton->displacement_mm());
    if (!placed) return failure(std::move(placed.error()));
    lagrangian = std::move(*placed);
    mover = mover_of(*newton, [&] {
      tools = tools_at(scenario.tools, double(++done) / scenario.motion->steps);
      return newton->step(
          lagrangian->with_pulls(*loads, tools),
          [&](const BodyProblem& problem) { return lagrangian->equilibrate(tools, problem); }, progress);
    });
    press(mover, *lagrangian, tools, *loads);
  } else if (moves_by_one_solve(scenario)) {
    motion_options.max_iterations = 5000;  // nobody waits for a frame here: stiff bodies get theirs
    motion_options.device = question.device;
    auto created = ImplicitEuler::create(*body, scenario.material, motion_options);
    if (!created) return failure(std::move(created.error()));
    moving = std::move(*created);
    mover = mover_of(*moving, [&] { return moving->step(loads->dead_mN); });
  } else {
    motion_options.max_iterations = 40;  // Newton steps: see NewtonOptions
    auto created = NewtonImplicitEuler::create(*body, materials, *loads, motion_options);
    if (!created) return failure(std::move(created.error()));
    newton = std::move(*created);
    mover = mover_of(*newton, [&] { return newton->step(progress); });
  }
  std::vector<Material> of_step = materials;
  for (Material& material : of_step) material = scaled(material, share_of_step(scenario));
  return follow(mover, *body, of_step, *loads, scenario, setting_up.seconds(), question.places, progress);
}

Result<Answer> meshfree_dynamics(const Question& question, const Progress& progress) {
  const Scenario& scenario = question.scenario;
  const Stopwatch setting_up;
  std::vector<double> youngs_kPa = question.youngs_kPa;
  for (double& modulus_kPa : youngs_kPa) modulus_kPa *= share_of_step(scenario);
  auto handles = prepare_meshfree_body(question.mesh, youngs_kPa, scenario.supports,
                                       {scenario.material, scenario.strain_stiffening}, options_of(scenario),
                                       scenario.meshfree, scenario.cuts, Holding::optional, progress);
  if (!handles) return failure(std::move(handles.error()));
  const std::vector<Material> materials = handles->materials;
  const auto loads = applied_loads(handles->body, scenario.loads, pressure_kind_of(materials));
  if (!loads) return failure(loads.error());
  DynamicsOptions motion_options = motion_options_of(scenario);
  motion_options.max_iterations = 5000;
  auto moving = MeshfreeImplicitEuler::create(std::move(*handles), motion_options);
  if (!moving) return failure(std::move(moving.error()));
  Mover mover = mover_of(*moving, [&] { return moving->step(*loads); });
  mover.fixed_reaction_mN = [&] { return moving->fixed_reaction_mN(); };
  std::optional<AugmentedLagrangian> lagrangian;
  std::vector<ContactTool> tools = tools_at(scenario.tools, 0.0);
  int done = 0;
  if (!tools.empty()) {
    if (auto checked = check_tools_on_meshfree(tools); !checked) return failure(std::move(checked.error()));
    if (auto checked = check_speed(scenario); !checked) return failure(std::move(checked.error()));
    auto placed = AugmentedLagrangian::create(moving->body(), tools, {}, moving->displacement_mm());
    if (!placed) return failure(std::move(placed.error()));
    lagrangian = std::move(*placed);
    mover.step = [&] {
      tools = tools_at(scenario.tools, double(++done) / scenario.motion->steps);
      const auto equilibrate = [&](const BodyProblem& problem) { return lagrangian->equilibrate(tools, problem); };
      return moving->step(lagrangian->with_pulls(*loads, tools), equilibrate, progress);
    };
    press(mover, *lagrangian, tools, *loads);
  }
  return follow(mover, moving->body(), materials, *loads, scenario, setting_up.seconds(), question.places, progress);
}

namespace {

DynamicsOptions motion_options_of(const Scenario& scenario) {
  return {.step_s = scenario.motion->step_s,
          .mass_damping_per_s = scenario.motion->mass_damping_per_s,
          .stiffness_damping_s = scenario.motion->stiffness_damping_s,
          .relaxation = scenario.relaxation};
}

double share_of_step(const Scenario& scenario) { return share_within(scenario.relaxation, scenario.motion->step_s); }

void press(Mover& mover, const AugmentedLagrangian& lagrangian, const std::vector<ContactTool>& tools,
           const AppliedLoads& loads) {
  mover.tools_force_mN = [&] {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(loads.dead_mN.size());
    return (lagrangian.force_mN() + lagrangian.with_pulls({none}, tools).dead_mN).eval();
  };
  mover.contacts = [&] { return std::pair(lagrangian.contacts(tools), lagrangian.report()); };
}

Result<void> check_speed(const Scenario& scenario) {
  const double maximum_mm = 0.5 * thinnest_rod_mm(scenario.tools);
  for (const ScenarioTool& tool : scenario.tools) {
    const auto* rigid = std::get_if<ScenarioRigidTool>(&tool.what);
    if (rigid == nullptr || rigid->push_mN || rigid->advance_mm / scenario.motion->steps <= maximum_mm) continue;
    return failure(Error{"tool-too-fast",
                         GLISSON_TEXT("Tool {0} would move by {1} mm a step, past a surface that it should meet."),
                         {tool.id, fmt::format("{:.1f}", rigid->advance_mm / scenario.motion->steps)},
                         GLISSON_TEXT("Take more steps: at most half the radius of the tool's rods in each."),
                         {}});
  }
  return {};
}

Result<Answer> follow(const Mover& mover, const Body& body, const std::vector<Material>& materials,
                      const AppliedLoads& loads, const Scenario& scenario, double setup_s, const Places& places,
                      const Progress& progress) {
  const Motion& motion = *scenario.motion;
  // What the damping pushes with: its stiffness' part is the slope of the forces along the velocity.
  const auto damping_mN = [&](const Eigen::VectorXd& u_mm, const Eigen::VectorXd& v_mm_s) -> Eigen::VectorXd {
    const double speed = v_mm_s.cwiseAbs().maxCoeff();
    if (motion.stiffness_damping_s == 0 || speed == 0) return Eigen::VectorXd::Zero(u_mm.size());
    const double ahead_s = 1e-6 / speed;
    return motion.stiffness_damping_s / ahead_s *
           (internal_force_mN(body, materials, u_mm) - internal_force_mN(body, materials, u_mm + ahead_s * v_mm_s));
  };

  Answer answer;
  SolveStatus status = SolveStatus::converged;
  double relative_residual = 0;
  int iterations = 0, done = 0;
  StaticResult state;
  const Stopwatch stepping;
  for (; done < motion.steps && status == SolveStatus::converged; ++done) {
    progress.report(double(done) / motion.steps, GLISSON_TEXT("Moving"));
    if (progress.cancelled()) return cancelled();
    auto report = mover.step();
    if (!report) return failure(std::move(report.error()));
    iterations += report->iterations;
    relative_residual = std::max(relative_residual, report->relative_residual);
    if (!report->converged) status = SolveStatus::not_converged;
    const Eigen::VectorXd u_mm = mover.displacement_mm();
    Eigen::VectorXd besides_mN = damping_mN(u_mm, mover.velocity_mm_s());
    if (mover.tools_force_mN) besides_mN += mover.tools_force_mN();
    const StressHistory* history = mover.history();
    if (history != nullptr) {
      besides_mN += internal_force_mN(body, materials, u_mm) - history->resisting_force_mN(body);
    }
    state = state_of(body, materials, u_mm, loads, besides_mN);
    if (history != nullptr) state.strain_energy_uJ = report->strain_energy_uJ;
    if (mover.fixed_reaction_mN) state.fixed_reaction_mN = mover.fixed_reaction_mN();
    TimeStep step{(done + 1) * motion.step_s,   displacement_at(body, state, places), state.fixed_reaction_mN,
                  state.foundation_reaction_mN, state.ligament_reaction_mN,           *report,
                  state.largest_strain};
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
  if (mover.contacts) {
    std::tie(answer.tools, answer.contact.emplace()) = mover.contacts();
    answer.contact->converged = status == SolveStatus::converged;
    answer.contact->energy_uJ = result.strain_energy_uJ;
    answer.contact->largest_strain = result.largest_strain;
    answer.contact->inverted_cells = result.inverted_cells;
  }
  answer.landmark_displacements_mm = displacement_at(body, result, places);
  answer.von_mises_kPa = mover.history() != nullptr ? mover.history()->von_mises_of_cells(body, mover.displacement_mm())
                                                    : von_mises_of_cells(body, materials, mover.displacement_mm());
  return answer;
}

}  // namespace
}  // namespace glisson::mechanics
