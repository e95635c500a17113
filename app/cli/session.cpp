// glisson-cli session (CASE | --mesh FILE.vtu --scenario S.json) --commands FILE.json [--material M] [--out DIR]: a
// rehearsal with tools in contact, command by command; what was recorded before is compared bit for bit. Of several
// recordings, what each asks of the liver, side by side.

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/write_file.h"
#include "casefile/orders.h"
#include "command.h"
#include "evidence_answer.h"
#include "one_of.h"
#include "rehearsal/orders.h"
#include "report/html.h"
#include "report/orders_page.h"
#include "session_question.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

using glisson::json_of;
using mechanics::MaterialLaw;

enum class Settling { each, last, none };

struct SessionCommand {
  SessionSource source;
  std::vector<std::string> commands_files;
  Settling settle = Settling::each;
  std::optional<std::string> out;
  bool keep = false;
};

Result<rehearsal::Recording> recording_in(const std::string& file) {
  return read_text_file(file, std::uint64_t{64} << 20).and_then([&](const std::string& text) {
    return rehearsal::parse_recording(text, file);
  });
}

Json json_of(const rehearsal::SessionStep& step) {
  Json tools = Json::array();
  for (const auto& tool : step.tools) {
    tools.push_back({{"id", tool.id},
                     {"force_N", json_of(tool.force_mN * 1e-3)},
                     {"contacts", tool.contacts},
                     {"advance_mm", tool.advance_mm},
                     {"penetration_mm", tool.penetration_mm}});
    if (tool.sticking + tool.slipping > 0) {
      tools.back()["friction"] = {{"sticking", tool.sticking}, {"slipping", tool.slipping}};
    }
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
  if (state.reference_step) json["atlas"] = json_of(*state.reference_step);
  if (const auto& motion = state.motion) {
    json["motion"] = {
        {"time_s", motion->time_s}, {"largest_speed_mm_s", motion->largest_speed_mm_s}, {"moves", motion->moves}};
    json["patient"].erase("energy_uJ");  // which is not computed live
    if (state.reference_step) json["atlas"].erase("energy_uJ");
  }
  if (const auto& beside = state.beside_elements) {
    json["finite_elements"] = {{"landmarks_mm", beside->landmarks_mm},
                               {"surface_mm", beside->surface_mm},
                               {"meshfree_ms", beside->meshfree_ms},
                               {"ms", beside->elements_ms}};
    if (beside->largest_opening_mm) json["finite_elements"]["largest_opening_mm"] = *beside->largest_opening_mm;
  }
  if (state.cut) {
    json["cut"] = {{"open_mm2", state.cut->open_mm2},
                   {"bridge_mm2", state.cut->bridge_mm2},
                   {"largest_opening_mm", state.cut->largest_opening_mm}};
  }
  if (state.validity.state() != mechanics::AnswerState::within) json["reason"] = state.validity.sentence().message();
  if (!state.validity.usable()) return json;
  json["max_displacement_mm"] = state.patient.max_displacement_mm;
  if (state.reference) json["max_difference_mm"] = state.max_difference_mm;
  for (std::size_t l = 0; l < state.patient.landmarks.size(); ++l) {
    const auto& landmark = state.patient.landmarks[l];
    Json entry{{"id", landmark.id},
               {"displaced_mm", json_of(landmark.displaced_mm)},
               {"displacement_mm", landmark.displacement_mm}};
    if (state.reference) entry["atlas_displaced_mm"] = json_of(state.reference->landmarks[l].displaced_mm);
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
    if (state.reference) moved += fmt::format(", atlas apart by {:5.2f} mm", state.max_difference_mm);
  }
  if (const auto& beside = state.beside_elements) {
    moved += fmt::format(", finite elements apart by {:.2f} mm (landmarks {:.2f})", beside->surface_mm,
                         beside->landmarks_mm);
  }
  if (state.cut) {
    moved += fmt::format(", open by {:.2f} mm", state.cut->largest_opening_mm);
    if (state.beside_elements && state.beside_elements->largest_opening_mm) {
      moved += fmt::format(" (by finite elements {:.2f})", *state.beside_elements->largest_opening_mm);
    }
  }
  if (state.error_bound_mm) {
    moved += fmt::format(", landmarks within {:.2f} mm{}", *state.error_bound_mm,
                         *state.error_bound_mm > rehearsal::SessionEngine::shown_mm ? " (still settling)" : "");
  }
  if (const auto& motion = state.motion) {
    moved += fmt::format(", after {:.2f} s at {:.1f} mm/s", motion->time_s, motion->largest_speed_mm_s);
  }
  return fmt::format("{:3}  {}, in {:6.1f} ms. {}{}\n", state.number, moved, state.step_ms,
                     state.validity.sentence().message(), state.refused.empty() ? "" : "  REFUSED: " + state.refused);
}

bool has_friction(const rehearsal::Recording& recording) {
  return std::any_of(recording.begin(), recording.end(), [](const auto& one) {
    const auto* hold = std::get_if<rehearsal::HoldTool>(&one.first);
    const auto* touching = hold == nullptr ? nullptr : std::get_if<mechanics::TouchingTool>(&hold->tool.what);
    return touching != nullptr && touching->friction > 0;
  });
}

// A file where it is called one, and else a folder with the recording and the answer.
Result<void> write_out(const std::string& out, const rehearsal::Recording& recording, const Json& answer) {
  const std::filesystem::path path(out);
  if (path.extension() == ".json") return write_text_file(path, rehearsal::recording_text(recording));
  return write_together([&] {
    return write_file(path / "session.json", rehearsal::recording_text(recording)).and_then([&] {
      return write_file(path / "frames.json", answer.dump(1) + "\n");
    });
  });
}

// The files' names without folder and ending; with the folder's name where two are alike.
std::vector<std::string> names_of(const std::vector<std::string>& files) {
  const auto stem = [](const std::string& file) { return std::filesystem::path(file).stem().string(); };
  std::vector<std::string> names;
  for (const std::string& file : files) {
    const auto alike =
        std::count_if(files.begin(), files.end(), [&](const auto& one) { return stem(one) == stem(file); });
    const std::string folder = std::filesystem::path(file).parent_path().filename().string();
    names.push_back(alike > 1 && !folder.empty() ? folder + " " + stem(file) : stem(file));
  }
  return names;
}

// As orders of steps of the case, named as their files; with the comparison, where they were compared.
Result<void> keep_in_case(const SessionCommand& options, const std::vector<rehearsal::NamedRecording>& recordings,
                          mechanics::MaterialLaw law, const std::vector<rehearsal::OrderOfSteps>& compared) {
  auto patient = casefile::Case::open(*options.source.case_folder);
  if (!patient) return failure(std::move(patient.error()));
  return patient->together([&]() -> Result<void> {
    for (const auto& [name, recording] : recordings) {
      if (auto kept = casefile::keep_order(*patient, {name, recording, law}); !kept) return kept;
    }
    if (compared.empty()) return {};
    return casefile::keep_comparison(*patient, {compared, law, casefile::orders_remarks(*patient)});
  });
}

Result<Outcome> run(const SessionCommand& options, const Progress& progress) {
  const std::string& file = options.commands_files.front();
  const auto commands = recording_in(file);
  if (!commands) return failure(commands.error());
  progress.report(0.0, GLISSON_TEXT("Reading the model"));
  auto question = question_of(options.source);
  if (!question) return failure(std::move(question.error()));
  if (question->setup.law.law == MaterialLaw::linear && has_friction(*commands)) {
    question->remarks.emplace_back("At small strain every tool is smooth: friction is computed at large strain alone.");
  }
  if (question->setup.motion && question->setup.law.law != MaterialLaw::linear && !question->setup.relaxation.empty()) {
    question->remarks.emplace_back("At large strain tissue does not creep in motion: its moduli are those after long.");
  }
  const MaterialLaw law = question->setup.law.law;
  const std::optional<mechanics::Motion> motion = question->setup.motion;
  const auto reference =
      options.source.live ? rehearsal::WithReference::when_asked : rehearsal::reference_in(*commands);
  auto engine = rehearsal::SessionEngine::create(std::move(question->setup), progress.part(0.0, 0.5), reference);
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
  double all_ms = 0, time_s = 0;
  long steps_of_time = 0;
  for (std::size_t i = 0; i < commands->size(); ++i) {
    progress.report(0.5 + 0.5 * double(i) / double(commands->size()), GLISSON_TEXT("Moving the tools"));
    if (progress.cancelled()) return cancelled();
    const auto& [command, recorded] = (*commands)[i];
    const rehearsal::SessionState& state = engine->step(command);
    if (!recorded.empty() && recorded != state.digest && !first_other) first_other = i;
    recording.emplace_back(command, state.digest);
    all_ms += state.step_ms;
    if (state.motion) {
      steps_of_time += std::max(0L, std::lround((state.motion->time_s - time_s) / motion->step_s));
      time_s = state.motion->time_s;  // which undo sets back
    }
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
  if (motion) {
    outcome.document["motion"] = {{"step_s", motion->step_s}, {"steps", steps_of_time}};
    if (all_ms > 0) outcome.document["motion"]["steps_per_s"] = 1e3 * double(steps_of_time) / all_ms;
  }
  if (first_other) {
    return failure(Error{"replay-differs",
                         GLISSON_TEXT("Command {0} led to another state than was recorded."),
                         {std::to_string(*first_other + 1)},
                         GLISSON_TEXT("Replay with the case and the version that it was recorded with."),
                         file});
  }
  if (options.keep) {
    if (auto kept = keep_in_case(options, {{names_of(options.commands_files).front(), recording}}, law, {}); !kept)
      return failure(std::move(kept.error()));
  }
  if (options.out) {
    outcome.document["out"] = *options.out;
    if (auto written = write_out(*options.out, recording, outcome.document); !written) {
      return failure(std::move(written.error()));
    }
  }
  return outcome;
}

// Several recordings: what each asks of the liver.
Result<Outcome> compare_orders(const SessionCommand& options, const Progress& progress) {
  const std::vector<std::string> names = names_of(options.commands_files);
  std::vector<rehearsal::NamedRecording> recordings;
  for (std::size_t r = 0; r < names.size(); ++r) {
    auto recording = recording_in(options.commands_files[r]);
    if (!recording) return failure(std::move(recording.error()));
    recordings.push_back({names[r], *std::move(recording)});
  }
  progress.report(0.0, GLISSON_TEXT("Reading the model"));
  auto question = question_of(options.source, true);
  if (!question) return failure(std::move(question.error()));
  const MaterialLaw law = question->setup.law.law;
  const auto orders = rehearsal::run_orders(std::move(question->setup), question->vessels, recordings, progress);
  if (!orders) return failure(orders.error());

  Outcome outcome{{{"orders", Json::array()}}, bullet_list(question->remarks)};
  if (!question->remarks.empty()) outcome.document["notes"] = question->remarks;
  for (const rehearsal::OrderOfSteps& order : *orders) {
    outcome.document["orders"].push_back(rehearsal::json_of(order));
    outcome.text += fmt::format("{}: {:.2f} N at most, strain {:.0f} % at most{}\n", order.name,
                                order.largest_force_N.value, 100 * order.largest_strain.value,
                                order.unusable.empty() ? "" : ", with steps that may not be used");
    for (const rehearsal::LandmarkMove& landmark : order.landmarks)
      outcome.text += fmt::format("  {} moves by {:.1f} mm at most\n", landmark.id, landmark.largest_mm.value);
  }
  if (options.keep) {
    if (auto kept = keep_in_case(options, recordings, law, *orders); !kept) return failure(std::move(kept.error()));
  }
  if (!options.out) return outcome;
  const std::filesystem::path out(*options.out);
  outcome.document["files"] = {(out / "orders.json").string(), (out / "orders.html").string()};
  auto written = write_together([&] {
    return write_file(out / "orders.json", outcome.document.dump(1) + "\n").and_then([&] {
      return report::write_html(out / "orders.html", report::orders_page(*orders, question->origin, question->remarks));
    });
  });
  if (!written) return failure(std::move(written.error()));
  return outcome;
}

}  // namespace

void add_session(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "session", "Rehearse with tools in contact, command by command; replay a recording to the bit");
  auto options = std::make_shared<SessionCommand>();
  CLI::Option* case_folder = command->add_option("case", options->source.case_folder, "The case");
  CLI::Option* mesh = command->add_option("--mesh", options->source.mesh_file, "Tetrahedra (.vtu), instead of a case");
  CLI::Option* scenario = command->add_option("--scenario", options->source.scenario_file,
                                              "Of the mesh: supports, loads, moduli, landmarks (JSON)");
  mesh->needs(scenario)->excludes(case_folder);
  scenario->needs(mesh);
  command
      ->add_option("--commands", options->commands_files,
                   "\"glisson-session/1\" (JSON): hold, release, cut, undo, settle and wait_steps; a digest that "
                   "stands there must come out again. Several files are orders of steps, which are compared")
      ->required();
  CLI::Option* engine =
      command
          ->add_option(
              "--engine", options->source.engine,
              "fem, or meshfree: of small strain, with finite elements beside it to be held against; default: what "
              "the scenario says, of a case fem")
          ->transform(
              one_of<mechanics::Engine>({{"fem", mechanics::Engine::fem}, {"meshfree", mechanics::Engine::meshfree}}));
  command
      ->add_option("--nodes", options->source.nodes, "Of the meshfree engine; default: one for 12 points of the mesh")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--material", options->source.material,
                   "linear is small strain, the others large strain with a bound of each first picture; default: what "
                   "the scenario says, of a case linear")
      ->transform(one_of<MaterialLaw>({{"linear", MaterialLaw::linear},
                                       {"corotational", MaterialLaw::corotational},
                                       {"neo-hookean", MaterialLaw::neo_hookean},
                                       {"veronda-westmann", MaterialLaw::veronda_westmann}}));
  command
      ->add_option("--strain-stiffening", options->source.strain_stiffening,
                   "Of veronda-westmann: how soon it stiffens (its c2)")
      ->check(CLI::PositiveNumber);
  CLI::Option* step =
      command
          ->add_option("--motion", options->source.step_s,
                       "In motion by steps of so many seconds: each small move of a tool passes one, wait_steps more; "
                       "tissue that creeps does so at small strain. Default: what the scenario says, of a case at rest")
          ->check(CLI::PositiveNumber);
  command
      ->add_option("--mass-damping", options->source.mass_damping_per_s,
                   "In motion, Rayleigh damping: times the mass (1/s); default 0")
      ->check(CLI::NonNegativeNumber)
      ->needs(step);
  command
      ->add_option("--stiffness-damping", options->source.stiffness_damping_s,
                   "In motion, Rayleigh damping: times the tissue's stiffness (s); default 0")
      ->check(CLI::NonNegativeNumber)
      ->needs(step);
  command
      ->add_option("--settle", options->settle,
                   "At large strain, bring frames to rest beside the run: each (default), the last one, none")
      ->transform(one_of<Settling>({{"each", Settling::each}, {"last", Settling::last}, {"none", Settling::none}}));
  command
      ->add_flag("--live", options->source.live,
                 "As the window rehearses the case, to the bit; the reference body comes where a command asks for it")
      ->excludes(mesh);
  command->add_option(
      "--out", options->out,
      "Folder for the commands with each frame's digest (session.json) and the frames (frames.json); or "
      "a file.json for the commands alone; of several orders, for orders.json and orders.html");
  command
      ->add_flag("--keep", options->keep,
                 "Keeps the commands in the case as orders of steps, named as their files; of several also the "
                 "comparison, which the report then shows")
      ->needs(case_folder)
      ->excludes(engine);
  command->callback([&chosen, options] {
    if (!options->source.case_folder && !options->source.mesh_file) throw CLI::RequiredError("a case or --mesh");
    chosen = [options](const Progress& progress) {
      return options->commands_files.size() == 1 ? run(*options, progress) : compare_orders(*options, progress);
    };
  });
}

}  // namespace glisson::cli
