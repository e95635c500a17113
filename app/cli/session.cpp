// glisson-cli session (CASE | --mesh FILE.vtu --scenario S.json) --commands FILE.json [--material M] [--out DIR]: a
// rehearsal with tools in contact, command by command; what was recorded before is compared bit for bit.

#include <fmt/format.h>

#include "base/files.h"
#include "casefile/model.h"
#include "casefile/used_entries.h"
#include "command.h"
#include "elastography/cell_stiffness.h"
#include "evidence_answer.h"
#include "geometry/mesh_file.h"
#include "mechanics/scenario/scenario_file.h"
#include "one_of.h"
#include "rehearsal/session.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

using glisson::json_of;
using mechanics::MaterialLaw;

enum class Settling { each, last, none };

struct Options {
  std::optional<std::string> case_folder, mesh_file, scenario_file;
  std::string commands_file;
  mechanics::Engine engine = mechanics::Engine::fem;
  std::optional<MaterialLaw> material;
  std::optional<double> strain_stiffening;
  Settling settle = Settling::each;
  std::optional<std::string> out;
};

// What is rehearsed, and what is to be said of it.
struct Question {
  rehearsal::RehearsalSetup setup;
  casefile::Evidence evidence;
  std::vector<std::string> remarks;
};

Result<Question> question_of_case(const std::string& folder) {
  const auto patient = casefile::Case::open(folder);
  if (!patient) return failure(patient.error());
  auto model = casefile::read_model(*patient);
  if (!model) return failure(model.error());
  Question question{{}, model->evidence, messages(casefile::model_remarks(*patient))};
  if (model->assumed) question.remarks.push_back(model->assumed->message());
  question.setup = casefile::rehearsal_setup(std::move(*model));
  return question;
}

// Beside a mesh lies the same reference body as beside a case.
Result<Question> question_of_mesh(const std::string& mesh_file, const std::string& scenario_file) {
  const auto scenario = mechanics::read_scenario(scenario_file);
  if (!scenario) return failure(scenario.error());
  auto mesh = geometry::read_tetrahedra(mesh_file);
  if (!mesh) return failure(std::move(mesh.error()));
  auto setup = rehearsal::rehearsal_setup(std::move(*mesh), *scenario);
  if (!setup) return failure(std::move(setup.error()).in_file(scenario_file));
  setup->atlas_youngs_kPa =
      elastography::atlas_youngs_kPa(elastography::Atlas::dissertation_cohort, setup->options.poisson_ratio);
  return Question{std::move(*setup), {}, {}};
}

Result<Question> question_of(const Options& options) {
  if (options.engine == mechanics::Engine::meshfree) {
    return failure("not-available", GLISSON_TEXT("A session knows the engine fem alone; meshfree is for simulate."));
  }
  auto question = options.case_folder ? question_of_case(*options.case_folder)
                                      : question_of_mesh(*options.mesh_file, *options.scenario_file);
  if (!question) return question;
  mechanics::ChosenLaw& law = question->setup.law;
  if (options.material) law.law = *options.material;
  if (options.strain_stiffening) law.strain_stiffening = *options.strain_stiffening;
  if (law.law == MaterialLaw::veronda_westmann && law.strain_stiffening == 0) {
    law.strain_stiffening = 3;
    question->remarks.emplace_back(
        "Nobody said how soon the liver stiffens with strain: strain_stiffening 3 is assumed.");
  }
  return question;
}

Json json_of(const rehearsal::SessionStep& step) {
  Json tools = Json::array();
  for (const auto& tool : step.tools) {
    tools.push_back({{"id", tool.id},
                     {"force_N", json_of(tool.force_mN * 1e-3)},
                     {"contacts", tool.contacts},
                     {"advance_mm", tool.advance_mm},
                     {"penetration_mm", tool.penetration_mm}});
  }
  Json json{{"converged", step.report.converged && step.report.inverted_cells == 0},
            {"relative_residual", step.report.relative_residual},
            {"iterations", step.report.rounds},
            {"energy_uJ", step.report.energy_uJ},
            {"largest_strain", step.report.largest_strain},
            {"inverted_cells", step.report.inverted_cells},
            {"penetration_mm", step.report.penetration_mm},
            {"solve_ms", step.report.solve_ms},
            {"tools", std::move(tools)}};
  if (step.error_bound_mm) {
    json.erase("energy_uJ");  // which is not computed live
    json["error_bound_mm"] = *step.error_bound_mm;
    json["settled"] = step.settled;
  }
  return json;
}

// What the body pushes back with on all tools, and its moment about their own places.
void add_reaction(Json& json, const rehearsal::SessionStep& step) {
  Eigen::Vector3d force_mN = Eigen::Vector3d::Zero();
  for (const auto& tool : step.tools) force_mN -= tool.force_mN;
  json["reaction_N"] = json_of(force_mN * 1e-3);
  json["torque_Nmm"] = json_of(-step.torque_mNmm * 1e-3);
}

Json json_of(const rehearsal::SessionState& state) {
  Json json{{"number", state.number},
            {"patient", json_of(state.patient_step)},
            {"state", to_string(state.validity.state())},
            {"largest_strain", state.validity.largest_strain},
            {"relative_residual", state.patient_step.report.relative_residual},
            {"inverted_cells", state.validity.inverted_cells},
            {"usable", state.validity.usable()},
            {"settled", state.settled},
            {"error_bound_mm", state.error_bound_mm.value_or(0.0)},
            {"step_ms", state.step_ms},
            {"digest", state.digest},
            {"landmarks", Json::array()}};
  add_reaction(json, state.patient_step);
  if (!state.refused.empty()) json["refused"] = state.refused;
  if (state.atlas_step) json["atlas"] = json_of(*state.atlas_step);
  if (state.cut) {
    json["cut"] = {{"open_mm2", state.cut->open_mm2},
                   {"bridge_mm2", state.cut->bridge_mm2},
                   {"largest_opening_mm", state.cut->largest_opening_mm}};
  }
  if (state.validity.state() != mechanics::AnswerState::within) json["reason"] = state.validity.sentence().message();
  if (!state.validity.usable()) return json;
  json["max_displacement_mm"] = state.patient.max_displacement_mm;
  if (state.atlas) json["max_difference_mm"] = state.max_difference_mm;
  for (std::size_t l = 0; l < state.patient.landmarks.size(); ++l) {
    const auto& landmark = state.patient.landmarks[l];
    Json entry{{"id", landmark.id},
               {"displaced_mm", json_of(landmark.displaced_mm)},
               {"displacement_mm", landmark.displacement_mm}};
    if (state.atlas) entry["atlas_displaced_mm"] = json_of(state.atlas->landmarks[l].displaced_mm);
    if (l < state.differences.size()) {
      entry["difference_mm"] = state.differences[l].difference_mm;
      entry["significant"] = state.differences[l].significant();
    }
    json["landmarks"].push_back(std::move(entry));
  }
  return json;
}

std::string in_words(const rehearsal::SessionState& state) {
  std::string moved = "-";
  if (state.validity.usable()) {
    moved = fmt::format("moved by {:6.2f} mm", state.patient.max_displacement_mm);
    if (state.atlas) moved += fmt::format(", atlas apart by {:5.2f} mm", state.max_difference_mm);
  }
  if (state.error_bound_mm) {
    moved += fmt::format(", landmarks within {:.2f} mm{}", *state.error_bound_mm,
                         *state.error_bound_mm > rehearsal::SessionEngine::shown_mm ? " (still settling)" : "");
  }
  return fmt::format("{:3}  {}, in {:6.1f} ms. {}{}\n", state.number, moved, state.step_ms,
                     state.validity.sentence().message(), state.refused.empty() ? "" : "  REFUSED: " + state.refused);
}

// A file where it is called one, and else a folder with the recording and the answer.
Result<void> write_out(const std::string& out, const rehearsal::Recording& recording, const Json& answer) {
  const std::filesystem::path path(out);
  if (path.extension() == ".json") return write_text_file(path, rehearsal::recording_text(recording));
  return write_text_file(path / "session.json", rehearsal::recording_text(recording)).and_then([&] {
    return write_text_file(path / "frames.json", answer.dump(1) + "\n");
  });
}

Result<Outcome> run(const Options& options, const Progress& progress) {
  const auto text = read_text_file(options.commands_file, std::uint64_t{64} << 20);
  if (!text) return failure(text.error());
  auto commands = rehearsal::parse_recording(*text, options.commands_file);
  if (!commands) return failure(std::move(commands.error()));
  progress.report(0.0, GLISSON_TEXT("Reading the model"));
  auto question = question_of(options);
  if (!question) return failure(std::move(question.error()));
  auto engine = rehearsal::SessionEngine::create(std::move(question->setup), progress.part(0.0, 0.5));
  if (!engine) return failure(std::move(engine.error()));

  Outcome outcome{{{"frames", Json::array()}}, ""};
  if (!question->evidence.effects.empty()) {
    outcome.document["evidence"] = evidence_json(question->evidence);
    outcome.text = evidence_text(question->evidence);
  }
  if (!question->remarks.empty()) outcome.document["notes"] = question->remarks;
  outcome.text += bullet_list(question->remarks);
  rehearsal::Recording recording;
  std::optional<std::size_t> first_other;
  double all_ms = 0;
  for (std::size_t i = 0; i < commands->size(); ++i) {
    progress.report(0.5 + 0.5 * double(i) / double(commands->size()), GLISSON_TEXT("Moving the tools"));
    if (progress.cancelled()) return cancelled();
    const auto& [command, recorded] = (*commands)[i];
    const rehearsal::SessionState& state = engine->step(command);
    if (!recorded.empty() && recorded != state.digest && !first_other) first_other = i;
    recording.emplace_back(command, state.digest);
    all_ms += state.step_ms;
    Json json = json_of(state);
    json["settled_ms"] = state.step_ms;
    const bool is_last = i + 1 == commands->size();
    if (!state.settled && (options.settle == Settling::each || (options.settle == Settling::last && is_last))) {
      const rehearsal::SessionState rest = engine->settled_state();
      json["settled_ms"] = rest.settled ? Json(state.step_ms + rest.step_ms) : Json();  // null: it found no rest
      json["at_rest"] = json_of(rest);
    } else if (!state.settled) {
      json.erase("settled_ms");
    }
    outcome.document["frames"].push_back(std::move(json));
    outcome.text += in_words(state);
  }
  if (all_ms > 0) outcome.document["frames_per_s"] = 1e3 * double(commands->size()) / all_ms;
  if (first_other) {
    return failure(Error{"replay-differs",
                         GLISSON_TEXT("Command {0} led to another state than was recorded."),
                         {std::to_string(*first_other + 1)},
                         GLISSON_TEXT("Replay with the case and the version that it was recorded with."),
                         options.commands_file});
  }
  if (options.out) {
    outcome.document["out"] = *options.out;
    if (auto written = write_out(*options.out, recording, outcome.document); !written) {
      return failure(std::move(written.error()));
    }
  }
  return outcome;
}

}  // namespace

void add_session(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "session", "Rehearse with tools in contact, command by command; replay a recording to the bit");
  auto options = std::make_shared<Options>();
  CLI::Option* case_folder = command->add_option("case", options->case_folder, "The case");
  CLI::Option* mesh = command->add_option("--mesh", options->mesh_file, "Tetrahedra (.vtu), instead of a case");
  CLI::Option* scenario = command->add_option("--scenario", options->scenario_file,
                                              "Of the mesh: supports, loads, moduli, landmarks (JSON)");
  mesh->needs(scenario)->excludes(case_folder);
  scenario->needs(mesh);
  command
      ->add_option("--commands", options->commands_file,
                   "\"glisson-session/1\" (JSON): hold, release, cut, undo and settle; a digest that stands there must "
                   "come out again")
      ->required();
  command->add_option("--engine", options->engine, "How it is computed")
      ->transform(
          one_of<mechanics::Engine>({{"fem", mechanics::Engine::fem}, {"meshfree", mechanics::Engine::meshfree}}));
  command
      ->add_option("--material", options->material,
                   "linear is small strain, the others large strain with a bound of each first picture; default: what "
                   "the scenario says, of a case linear")
      ->transform(one_of<MaterialLaw>({{"linear", MaterialLaw::linear},
                                       {"corotational", MaterialLaw::corotational},
                                       {"neo-hookean", MaterialLaw::neo_hookean},
                                       {"veronda-westmann", MaterialLaw::veronda_westmann}}));
  command
      ->add_option("--strain-stiffening", options->strain_stiffening,
                   "Of veronda-westmann: how soon it stiffens (its c2)")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--settle", options->settle,
                   "At large strain, bring frames to rest beside the run: each (default), the last one, none")
      ->transform(one_of<Settling>({{"each", Settling::each}, {"last", Settling::last}, {"none", Settling::none}}));
  command->add_option(
      "--out", options->out,
      "Folder for the commands with each frame's digest (session.json) and the frames (frames.json); or "
      "a file.json for the commands alone");
  command->callback([&chosen, options] {
    if (!options->case_folder && !options->mesh_file) throw CLI::RequiredError("a case or --mesh");
    chosen = [options](const Progress& progress) { return run(*options, progress); };
  });
}

}  // namespace glisson::cli
