// glisson-cli simulate (CASE | --mesh FILE.vtu) --scenario S.json [--data D] --out DIR: equilibrium or motion under
// supports, tools and loads.

#include <fmt/format.h>

#include "casefile/model.h"
#include "casefile/result_folder.h"
#include "casefile/used_entries.h"
#include "closedloop/material/stress_strain_file.h"
#include "command.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/scenario_file.h"
#include "mechanics/simulation.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct SimulateCommand {
  std::optional<std::string> case_folder;
  std::optional<std::string> mesh_file;
  std::string scenario_file;
  std::optional<std::string> data_file;
  std::string out;
  std::optional<std::string> device;  // of OpenCL
};

struct Question {
  geometry::TetMesh mesh;
  mechanics::Scenario scenario;
  std::vector<Sentence> evidence;  // what of it is in, and what is left out
  std::vector<Sentence> remarks;   // on the case's files
};

// A case brings its mesh, and what the scenario leaves out: the usual supports, landmarks on tumours and vessels, and
// accepted evidence.
Result<Question> question(const SimulateCommand& options, mechanics::Scenario scenario) {
  if (options.mesh_file) {
    return geometry::read_tetrahedra(*options.mesh_file).map([&](geometry::TetMesh mesh) {
      return Question{std::move(mesh), std::move(scenario), {}, {}};
    });
  }
  const auto patient = casefile::Case::open(*options.case_folder);
  if (!patient) return failure(patient.error());
  auto model = casefile::read_model(*patient);
  if (!model) return failure(model.error());
  if (options.data_file) leave_stiffness_to_data(*model);
  std::vector<Sentence> remarks = casefile::model_remarks(*patient);
  if (model->assumed && !scenario.youngs_modulus && !options.data_file) remarks.push_back(*model->assumed);
  std::vector<Sentence> evidence = casefile::put_into(scenario, *model);
  return Question{std::move(model->mesh), std::move(scenario), std::move(evidence), std::move(remarks)};
}

std::string describe(const mechanics::Simulation& simulation) {
  const mechanics::StaticResult& result = simulation.result;
  const mechanics::Validity validity = validity_of(simulation);
  const auto length = [&](double length_mm) {
    return validity.usable() ? fmt::format("{:.2f} mm", length_mm) : std::string("-");
  };
  std::vector<std::string> notes = result.notes;
  std::erase(notes, validity.sentence().message());  // which stands at the top
  std::string text =
      fmt::format("{}\nLargest displacement {}; relative residual {:.1e}; set-up {:.2f} s, solve {:.0f} ms\n",
                  validity.sentence().message(), length(result.max_displacement_mm), result.relative_residual,
                  result.setup_s, result.step_ms);
  for (const auto& landmark : simulation.landmarks) {
    const bool far = validity.usable() && landmark.displacement_mm >= rehearsal::significant_mm;
    text += fmt::format("  {:24} {:>10}{}\n", landmark.id, length(landmark.displacement_mm), far ? "  >= 5 mm" : "");
  }
  return text + bullet_list(notes);
}

// Measured strain and stress, where the person gave some, in place of the scenario's material.
Result<mechanics::SimulationOptions> simulation_options(const SimulateCommand& options,
                                                        const mechanics::Scenario& scenario) {
  mechanics::SimulationOptions simulation;
  simulation.device = options.device;
  if (!options.data_file) return simulation;
  return closedloop::read_stress_strain(*options.data_file)
      .and_then([&](const std::vector<mechanics::StressStrain>& measured) {
        return mechanics::MaterialData::create(measured, {.poisson_ratio = scenario.poisson_ratio});
      })
      .map([&](mechanics::MaterialData data) {
        simulation.data = std::move(data);
        return simulation;
      })
      .map_error(
          [&](const Error& error) { return error.file.empty() ? Error(error).in_file(*options.data_file) : error; });
}

Result<Outcome> simulate(const SimulateCommand& options, const Progress& progress) {
  auto scenario = mechanics::read_scenario(options.scenario_file);
  if (!scenario) return failure(scenario.error());
  progress.report(0.0, GLISSON_TEXT("Reading the mesh"));
  const auto asked = question(options, std::move(*scenario));
  if (!asked) return failure(asked.error());
  const auto settings = simulation_options(options, asked->scenario);
  if (!settings) return failure(settings.error());
  auto simulation = mechanics::simulate(asked->mesh, asked->scenario, *settings, progress);
  if (!simulation) return failure(simulation.error());
  for (const Sentence& said : asked->evidence) simulation->result.notes.push_back(said.message());
  for (const Sentence& said : asked->remarks) simulation->result.notes.push_back(said.message());
  if (!simulation->result.converged()) {
    return failure(Error{"not-converged",
                         GLISSON_TEXT("The computation did not converge: {0}"),
                         {simulation->result.why_stopped},
                         {},
                         options.scenario_file});
  }
  if (auto written = casefile::write_result(options.out, *simulation); !written) return failure(written.error());
  Outcome outcome{casefile::result_json(*simulation), describe(*simulation)};
  outcome.document["out"] = options.out;
  if (!asked->evidence.empty()) outcome.document["evidence"] = messages(asked->evidence);
  return outcome;
}

}  // namespace

void add_simulate(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("simulate", "Move the liver: equilibrium or motion under supports, tools and loads");
  auto options = std::make_shared<SimulateCommand>();
  CLI::Option* case_folder = command->add_option("case", options->case_folder, "The case");
  CLI::Option* mesh = command->add_option("--mesh", options->mesh_file, "Tetrahedra (.vtu), instead of a case");
  command->add_option("--scenario", options->scenario_file, "Supports, loads and landmarks (JSON)")->required();
  command->add_option("--data", options->data_file,
                      "Measured strain and stress in place of the material: a CSV (strain, stress_kPa) or a material "
                      "experiment (JSON)");
  add_opencl(*command, options->device);
  command->add_option("--out", options->out, "Folder for the result")->required();
  case_folder->excludes(mesh);
  command->callback([&chosen, options] {
    if (!options->case_folder && !options->mesh_file) throw CLI::RequiredError("a case or --mesh");
    chosen = [options](const Progress& progress) { return simulate(*options, progress); };
  });
}

}  // namespace glisson::cli
