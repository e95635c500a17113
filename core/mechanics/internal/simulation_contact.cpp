// A scenario's equilibrium: with tools in contact by the kept factor, and at large deformation with and without them.

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/stopwatch.h"
#include "mechanics/contact/contact.h"
#include "mechanics/contact/large_contact.h"
#include "mechanics/internal/simulation_answer.h"
#include "mechanics/meshfree/internal/meshfree_body.h"
#include "mechanics/meshfree/meshfree_contact.h"
#include "mechanics/potentials/elastic.h"

namespace glisson::mechanics {
namespace {

int steps_for(const std::vector<ScenarioTool>& tools, double largest_move_mm);
std::vector<std::vector<ContactTool>> stations_of(const std::vector<ScenarioTool>& tools, int fewest = 1);

}  // namespace

Result<Answer> linear_contact_equilibrium(const Question& question, const Progress& progress) {
  const Scenario& scenario = question.scenario;
  const std::vector<OpenedBody::Wall>& walls = question.walls;
  auto model = StaticModel::create(question.mesh, question.youngs_kPa, scenario.supports, options_of(scenario),
                                   progress.part(0.0, 0.5), points_on(walls));
  if (!model) return failure(std::move(model.error()));
  const Stopwatch watch;
  const auto body = ContactBody::create(std::move(*model), scenario.loads, question.places);
  if (!body) return failure(body.error());
  const ContactOptions options;
  const int steps = scenario.tools.empty() ? 0 : steps_for(scenario.tools, options.largest_move_mm);
  ContactState state = body->untouched();
  int rounds = state.report.rounds;
  for (int step = 1; step <= steps && state.report.converged; ++step) {
    progress.report(0.5 + 0.5 * (step - 1) / steps, GLISSON_TEXT("Moving the tools"));
    if (progress.cancelled()) return cancelled();
    auto next = body->solve(state, tools_at(scenario.tools, double(step) / steps), options);
    if (!next) return failure(std::move(next.error()));
    state = std::move(*next);
    rounds += state.report.rounds;
  }
  auto result = body->whole_result(state);
  if (!result) return failure(std::move(result.error()));
  result->iterations = rounds;
  result->step_ms = 1e3 * watch.seconds();
  if (!state.report.converged) {
    result->status = SolveStatus::not_converged;
    result->why_stopped = fmt::format(
        "After {} rounds the tools, or the walls of cuts, still reach {:.2f} mm into the surface (tolerance {:.2f}), "
        "which still moves by {:.2f} mm.",
        rounds, state.report.penetration_mm, options.penetration_tolerance_mm, state.report.movement_mm);
  }
  auto landmarks_mm = body->model().displacement_at(*result, question.places);
  auto von_mises_kPa = body->model().von_mises_kPa(*result);
  return Answer{std::move(*result), std::move(landmarks_mm), std::move(von_mises_kPa), {}, std::move(state.tools),
                state.report};
}

Result<Answer> nonlinear_equilibrium(const Question& question, const Progress& progress) {
  const Scenario& scenario = question.scenario;
  const auto prepared = material_body(question);
  if (!prepared) return failure(prepared.error());
  const Body& body = prepared->body;
  const std::vector<Material>& materials = prepared->materials;
  const auto loads = applied_loads(body, scenario.loads, pressure_kind_of(materials));
  if (!loads) return failure(loads.error());
  if (scenario.tools.empty() && question.walls.empty()) {
    auto result = find_equilibrium(body, materials, *loads, {}, progress);
    if (!result) return failure(std::move(result.error()));
    return answer_of(*prepared, std::move(*result), question.places);
  }
  constexpr int fewest_stations_of_walls = 4;
  const auto stations = stations_of(scenario.tools, question.walls.empty() ? 1 : fewest_stations_of_walls);
  auto contact = find_equilibrium_in_contact(body, materials, *loads, stations, {}, progress, question.walls);
  if (!contact) return failure(std::move(contact.error()));
  Answer answer = answer_of(*prepared, std::move(contact->result), question.places);
  answer.tools = std::move(contact->tools);
  answer.contact = contact->report;
  return answer;
}

Result<Answer> meshfree_equilibrium(const Question& question, const Progress& progress) {
  const Scenario& scenario = question.scenario;
  const auto model = MeshfreeModel::create(question.mesh, question.youngs_kPa, scenario.supports,
                                           {scenario.material, scenario.strain_stiffening}, options_of(scenario),
                                           scenario.meshfree, scenario.cuts, progress.part(0.0, 0.7));
  if (!model) return failure(model.error());
  Answer answer;
  if (scenario.tools.empty()) {
    auto result = model->solve(scenario.loads, {}, progress.part(0.7, 1.0));
    if (!result) return failure(std::move(result.error()));
    answer.result = std::move(*result);
  } else {
    const MeshfreeBody& handles = model->body();
    const auto loads = applied_loads(handles.body, scenario.loads, pressure_kind_of(handles.materials));
    if (!loads) return failure(loads.error());
    auto contact =
        find_equilibrium_in_contact(*model, *loads, stations_of(scenario.tools), {}, progress.part(0.7, 1.0));
    if (!contact) return failure(std::move(contact.error()));
    answer.result = std::move(contact->result);
    answer.result.setup_s = model->cost().setup_s;
    answer.tools = std::move(contact->tools);
    answer.contact = contact->report;
  }
  answer.landmark_displacements_mm = model->displacement_at(answer.result, question.places);
  answer.von_mises_kPa = model->von_mises_kPa(answer.result);
  return answer;
}

// All tools go together, in steps in which none passes the surface by.
std::vector<ContactTool> tools_at(const std::vector<ScenarioTool>& tools, double part) {
  std::vector<ContactTool> hands;
  for (const ScenarioTool& tool : tools) {
    if (const auto* jaws = std::get_if<ScenarioGrasp>(&tool.what)) {
      Grasp grasp{jaws->center_mm, jaws->radius_mm, Eigen::Vector3d(part * jaws->displacement_mm), {0, 0, 1}};
      if (jaws->pull_mN) {
        grasp.drawn = part * jaws->pull_mN->norm();
        grasp.direction = *jaws->pull_mN;
      }
      hands.push_back({tool.id, std::move(grasp)});
      continue;
    }
    const auto& rigid = std::get<ScenarioRigidTool>(tool.what);
    TouchingTool touching{rigid.shape, pose_towards(rigid.position_mm, rigid.direction), {}};
    touching.pose = touching.pose.advanced(part * rigid.advance_mm);
    if (rigid.push_mN) touching.push_mN = part * *rigid.push_mN;
    touching.friction = rigid.friction;
    hands.push_back({tool.id, std::move(touching)});
  }
  return hands;
}

double thinnest_rod_mm(const std::vector<ScenarioTool>& tools) {
  double radius_mm = 10;
  for (const ScenarioTool& tool : tools) {
    if (const auto* rigid = std::get_if<ScenarioRigidTool>(&tool.what)) {
      for (const Rod& rod : rigid->shape) radius_mm = std::min(radius_mm, rod.radius_mm);
    }
  }
  return radius_mm;
}

namespace {

int steps_for(const std::vector<ScenarioTool>& tools, double largest_move_mm) {
  double farthest_mm = 0;
  for (const ScenarioTool& tool : tools) {
    if (const auto* rigid = std::get_if<ScenarioRigidTool>(&tool.what)) {
      farthest_mm = std::max(farthest_mm, rigid->push_mN ? 4 * largest_move_mm : rigid->advance_mm);
    } else {
      farthest_mm = std::max(farthest_mm, std::get<ScenarioGrasp>(tool.what).displacement_mm.norm());
    }
  }
  return std::max(1, static_cast<int>(std::ceil(farthest_mm / largest_move_mm)));
}

std::vector<std::vector<ContactTool>> stations_of(const std::vector<ScenarioTool>& tools, int fewest) {
  const int steps = std::max(fewest, steps_for(tools, 0.5 * thinnest_rod_mm(tools)));
  std::vector<std::vector<ContactTool>> stations;
  for (int step = 1; step <= steps; ++step) stations.push_back(tools_at(tools, double(step) / steps));
  return stations;
}

}  // namespace
}  // namespace glisson::mechanics
