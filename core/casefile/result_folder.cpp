#include "casefile/result_folder.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/json_value.h"
#include "base/write_file.h"
#include "casefile/internal/case_links.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/scenario_file.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

Failure not_a_result(const fs::path& folder, const std::string& why) {
  return failure(Error{"not-a-result",
                       GLISSON_TEXT("{0} does not hold a simulation's result: {1}."),
                       {folder.string(), why},
                       GLISSON_TEXT("Make one with glisson-cli simulate --out DIR."),
                       folder});
}

Json steps_of(const mechanics::Simulation& simulation);
mechanics::Validity validity_in(const Json& document);

std::string_view engine_name(mechanics::Engine engine) { return engine == mechanics::Engine::fem ? "fem" : "meshfree"; }

}  // namespace

Result<void> write_result(const fs::path& folder, const mechanics::Simulation& simulation) {
  if (auto inside = refuse_links_on_the_way_to(folder); !inside) return inside;
  return write_together([&] {
    return geometry::write_tetrahedra(folder / "result.vtu", simulation.mesh)
        .and_then([&] { return write_file(folder / "scenario.json", mechanics::scenario_text(simulation.scenario)); })
        .and_then([&] { return write_file(folder / "result.json", result_json(simulation).dump(2) + "\n"); });
  });
}

Json result_json(const mechanics::Simulation& simulation) {
  const mechanics::StaticResult& result = simulation.result;
  const mechanics::Validity validity = validity_of(simulation);
  Json document{{"format", "glisson-result/1"},
                {"engine", engine_name(simulation.scenario.engine)},
                {"converged", validity.usable()},
                {"state", to_string(validity.state())},
                {"why_stopped", result.why_stopped},
                {"relative_residual", result.relative_residual},
                {"iterations", result.iterations},
                {"strain_energy_uJ", result.strain_energy_uJ},
                {"largest_strain", validity.largest_strain},
                {"inverted_cells", validity.inverted_cells},
                {"applied_force_N", json_of(result.applied_force_mN * 1e-3)},
                {"held_reaction_N", json_of(result.fixed_reaction_mN * 1e-3)},
                {"support_reaction_N", Json::array()},
                {"foundation_reaction_N", json_of(result.foundation_reaction_mN * 1e-3)},
                {"ligament_reaction_N", json_of(result.ligament_reaction_mN * 1e-3)},
                {"timing", {{"setup_s", result.setup_s}, {"step_ms", result.step_ms}}},
                {"notes", result.notes},
                {"landmarks", Json::array()}};
  if (validity.state() != mechanics::AnswerState::within) document["reason"] = validity.sentence().message();
  if (validity.usable()) document["max_displacement_mm"] = result.max_displacement_mm;
  for (const Eigen::Vector3d& reaction_mN : result.support_reaction_mN) {
    document["support_reaction_N"].push_back(json_of(reaction_mN * 1e-3));
  }
  for (const mechanics::DisplacedLandmark& landmark : simulation.landmarks) {
    Json& told = document["landmarks"].emplace_back(Json{{"id", landmark.id}, {"rest_mm", json_of(landmark.rest_mm)}});
    if (!validity.usable()) continue;
    told["displaced_mm"] = json_of(landmark.displaced_mm);
    told["displacement_mm"] = landmark.displacement_mm;
  }
  if (simulation.contact) {
    document["contact"] = {{"penetration_mm", simulation.contact->penetration_mm},
                           {"rounds", simulation.contact->rounds},
                           {"solve_ms", simulation.contact->solve_ms}};
    document["tools"] = Json::array();
    for (const mechanics::ToolContact& tool : simulation.tools) {
      document["tools"].push_back({{"id", tool.id},
                                   {"force_N", json_of(tool.force_mN * 1e-3)},
                                   {"contacts", tool.contacts},
                                   {"advance_mm", tool.advance_mm},
                                   {"penetration_mm", tool.penetration_mm}});
      if (tool.sticking + tool.slipping == 0) continue;
      document["tools"].back()["friction"] = {{"sticking", tool.sticking}, {"slipping", tool.slipping}};
    }
  }
  if (simulation.cut) {
    document["cut"] = {{"largest_opening_mm", simulation.cut->largest_opening_mm},
                       {"largest_overlap_mm", simulation.cut->largest_overlap_mm}};
  }
  if (!simulation.steps.empty()) document["steps"] = steps_of(simulation);
  return null_where_not_finite(std::move(document));
}

namespace {

Json steps_of(const mechanics::Simulation& simulation) {
  Json steps = Json::array();
  for (const mechanics::TimeStep& step : simulation.steps) {
    Json landmarks = Json::array();
    const bool usable = step.report.converged && step.report.inverted_cells == 0;
    for (std::size_t l = 0; usable && l < step.landmarks_mm.size(); ++l) {
      landmarks.push_back({{"id", simulation.landmarks[l].id}, {"position_mm", json_of(step.landmarks_mm[l])}});
    }
    steps.push_back({{"time_s", step.time_s},
                     {"landmarks", std::move(landmarks)},
                     {"held_reaction_N", json_of(step.fixed_reaction_mN * 1e-3)},
                     {"foundation_reaction_N", json_of(step.foundation_reaction_mN * 1e-3)},
                     {"ligament_reaction_N", json_of(step.ligament_reaction_mN * 1e-3)},
                     {"converged", usable},
                     {"relative_residual", step.report.relative_residual},
                     {"iterations", step.report.iterations},
                     {"largest_strain", step.largest_strain},
                     {"inverted_cells", step.report.inverted_cells},
                     {"kinetic_energy_uJ", step.report.kinetic_energy_uJ},
                     {"strain_energy_uJ", step.report.strain_energy_uJ},
                     {"step_ms", step.report.step_ms}});
  }
  return steps;
}

// Of results from before there were states, too: a converged one with inverted cells is no better for its age.
mechanics::Validity validity_in(const Json& document) {
  const auto number = [&](const char* key) {
    const Json* value = value_in(document, key);
    return value != nullptr && value->is_number() ? value->get<double>() : 0.0;
  };
  const bool inverted = number("inverted_cells") > 0;
  mechanics::Validity validity{says(document, "converged", true) || inverted, number("largest_strain"),
                               inverted ? static_cast<int>(std::min(number("inverted_cells"), 1e9)) : 0};
  if (says(document, "state", to_string(mechanics::AnswerState::within))) {
    validity.limit = std::numeric_limits<double>::infinity();  // of a law that knows large strain
  }
  return validity;
}

}  // namespace

Result<std::optional<mechanics::Validity>> read_validity(const fs::path& folder) {
  std::error_code problem;
  if (!fs::exists(folder / "result.json", problem)) return std::nullopt;
  return read_json_file(folder / "result.json").map([](const Json& document) {
    return std::optional(validity_in(document));
  });
}

Result<rehearsal::ComparedResult> read_result(const fs::path& folder) {
  std::error_code problem;
  if (!fs::exists(folder / "result.vtu", problem)) return not_a_result(folder, GLISSON_TEXT("result.vtu is missing"));
  const auto document = read_json_file(folder / "result.json");
  if (!document) return failure(document.error());
  if (!says(*document, "format", "glisson-result/1")) {
    return not_a_result(folder, GLISSON_TEXT("result.json does not say \"format\": \"glisson-result/1\""));
  }
  rehearsal::ComparedResult read;
  read.validity = validity_in(*document);
  if (!read.validity.usable()) {
    return failure(Error{"not-a-result",
                         GLISSON_TEXT("The result in {0} is not to be used: {1}."),
                         {folder.string(), read.validity.why_not().message()},
                         GLISSON_TEXT("Simulate it again with less force, or on other supports."),
                         folder});
  }

  auto mesh = geometry::read_tetrahedra(folder / "result.vtu");
  if (!mesh) return failure(mesh.error());
  read.mesh = std::move(*mesh);
  const auto scenario = mechanics::read_scenario(folder / "scenario.json");
  if (!scenario) return failure(scenario.error());
  for (const mechanics::Load& load : scenario->loads) {
    if (const auto* tool = std::get_if<mechanics::ToolLoad>(&load)) read.tools.push_back(*tool);
  }
  try {
    const auto vector = [](const Json& json) {
      return Eigen::Vector3d(json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>());
    };
    for (const Json& landmark : document->at("landmarks")) {
      read.landmarks.push_back({landmark.at("id").get<std::string>(), vector(landmark.at("rest_mm")),
                                vector(landmark.at("displaced_mm")), landmark.at("displacement_mm").get<double>(), 0});
    }
  } catch (const Json::exception& damage) {
    return not_a_result(folder, std::string("result.json is damaged: ") + damage.what());
  }
  return read;
}

}  // namespace glisson::casefile
