// glisson-cli session CASE --commands FILE.json [--out FILE.json]: a rehearsal with tools in contact, step by step;
// what was recorded before is compared bit for bit.

#include <fmt/format.h>

#include "base/files.h"
#include "casefile/model.h"
#include "casefile/used_entries.h"
#include "command.h"
#include "evidence_answer.h"
#include "geometry/mesh_file.h"
#include "rehearsal/session.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

using glisson::json_of;

struct Options {
  std::string case_folder;
  std::string commands_file;
  std::optional<std::string> out;
};

Json json_of(const rehearsal::SessionStep& step) {
  Json tools = Json::array();
  for (const auto& tool : step.tools) {
    tools.push_back({{"id", tool.id},
                     {"force_N", json_of(tool.force_mN * 1e-3)},
                     {"contacts", tool.contacts},
                     {"advance_mm", tool.advance_mm},
                     {"penetration_mm", tool.penetration_mm}});
  }
  return {{"converged", step.report.converged && step.report.inverted_cells == 0},
          {"relative_residual", step.report.relative_residual},
          {"iterations", step.report.rounds},
          {"energy_uJ", step.report.energy_uJ},
          {"largest_strain", step.report.largest_strain},
          {"inverted_cells", step.report.inverted_cells},
          {"penetration_mm", step.report.penetration_mm},
          {"solve_ms", step.report.solve_ms},
          {"tools", std::move(tools)}};
}

Json json_of(const rehearsal::SessionFrame& frame) {
  Json json{{"number", frame.number},
            {"patient", json_of(frame.patient_step)},
            {"state", to_string(frame.validity.state())},
            {"largest_strain", frame.validity.largest_strain},
            {"inverted_cells", frame.validity.inverted_cells},
            {"usable", frame.validity.usable()},
            {"step_ms", frame.step_ms},
            {"digest", frame.digest},
            {"landmarks", Json::array()}};
  if (!frame.refused.empty()) json["refused"] = frame.refused;
  if (frame.atlas_step) json["atlas"] = json_of(*frame.atlas_step);
  if (frame.cut) {
    json["cut"] = {{"open_mm2", frame.cut->open_mm2},
                   {"bridge_mm2", frame.cut->bridge_mm2},
                   {"largest_opening_mm", frame.cut->largest_opening_mm}};
  }
  if (frame.validity.state() != mechanics::AnswerState::within) json["reason"] = frame.validity.sentence().message();
  if (!frame.validity.usable()) return json;
  json["max_displacement_mm"] = frame.patient.max_displacement_mm;
  if (frame.atlas) json["max_difference_mm"] = frame.max_difference_mm;
  for (std::size_t l = 0; l < frame.patient.landmarks.size(); ++l) {
    const auto& landmark = frame.patient.landmarks[l];
    Json entry{{"id", landmark.id},
               {"position_mm", json_of(landmark.displaced_mm)},
               {"displacement_mm", landmark.displacement_mm}};
    if (l < frame.differences.size()) {
      entry["difference_mm"] = frame.differences[l].difference_mm;
      entry["significant"] = frame.differences[l].significant();
    }
    json["landmarks"].push_back(std::move(entry));
  }
  return json;
}

std::string in_words(const rehearsal::SessionFrame& frame) {
  std::string moved = "-";
  if (frame.validity.usable()) {
    moved = fmt::format("moved by {:6.2f} mm", frame.patient.max_displacement_mm);
    if (frame.atlas) moved += fmt::format(", atlas apart by {:5.2f} mm", frame.max_difference_mm);
  }
  return fmt::format("{:3}  {}, in {:6.1f} ms. {}{}\n", frame.number, moved, frame.step_ms,
                     frame.validity.sentence().message(), frame.refused.empty() ? "" : "  REFUSED: " + frame.refused);
}

Result<Outcome> run(const Options& options, const Progress& progress) {
  const auto text = read_text_file(options.commands_file, std::uint64_t{64} << 20);
  if (!text) return failure(text.error());
  auto commands = rehearsal::parse_recording(*text, options.commands_file);
  if (!commands) return failure(std::move(commands.error()));
  progress.report(0.0, GLISSON_TEXT("Reading the model"));
  const auto patient = casefile::Case::open(options.case_folder);
  if (!patient) return failure(patient.error());
  auto model = casefile::read_model(*patient);
  if (!model) return failure(model.error());
  const casefile::Evidence evidence = model->evidence;
  std::vector<std::string> remarks = messages(casefile::model_remarks(*patient));
  if (model->assumed) remarks.push_back(model->assumed->message());
  auto engine = rehearsal::SessionEngine::create(casefile::rehearsal_setup(std::move(*model)), progress.part(0.0, 0.7));
  if (!engine) return failure(std::move(engine.error()));

  Outcome outcome{{{"steps", Json::array()}}, ""};
  if (!evidence.effects.empty()) {
    outcome.document["evidence"] = evidence_json(evidence);
    outcome.text = evidence_text(evidence);
  }
  if (!remarks.empty()) outcome.document["notes"] = remarks;
  outcome.text += bullet_list(remarks);
  rehearsal::Recording recording;
  std::optional<std::size_t> first_other;
  for (std::size_t i = 0; i < commands->size(); ++i) {
    progress.report(0.7 + 0.3 * double(i) / double(commands->size()), GLISSON_TEXT("Moving the tools"));
    if (progress.cancelled()) return cancelled();
    const auto& [command, recorded] = (*commands)[i];
    const rehearsal::SessionFrame& frame = engine->step(command);
    if (!recorded.empty() && recorded != frame.digest && !first_other) first_other = i;
    recording.emplace_back(command, frame.digest);
    outcome.document["steps"].push_back(json_of(frame));
    outcome.text += in_words(frame);
  }
  if (first_other) {
    return failure(Error{"replay-differs",
                         GLISSON_TEXT("Command {0} led to another state than was recorded."),
                         {std::to_string(*first_other + 1)},
                         GLISSON_TEXT("Replay with the case and the version that it was recorded with."),
                         options.commands_file});
  }
  if (options.out) {
    if (auto written = write_text_file(*options.out, rehearsal::recording_text(recording)); !written) {
      return failure(std::move(written.error()));
    }
    outcome.document["out"] = *options.out;
  }
  return outcome;
}

}  // namespace

void add_session(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "session", "Rehearse with tools in contact, command by command; replay a recording to the bit");
  auto options = std::make_shared<Options>();
  command->add_option("case", options->case_folder, "The case")->required();
  command
      ->add_option(
          "--commands", options->commands_file,
          "\"glisson-session/1\" (JSON): hold, release, cut and undo; a digest that stands there must come out again")
      ->required();
  command->add_option("--out", options->out, "The same commands with each frame's digest");
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
