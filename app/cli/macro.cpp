// glisson-cli macro CASE [--as command-line|python]: what was done to a case in the window, as a program that does it
// again.

#include "casefile/macro.h"

#include "recording_commands.h"

namespace glisson::cli {
namespace {

Outcome describe(const casefile::Macro& macro, const std::string& language) {
  Outcome outcome{{{"as", language}, {"earlier_forgotten", macro.earlier_forgotten}, {"steps", Json::array()}}, {}};
  outcome.text = language == "python" ? casefile::as_python(macro) : casefile::as_command_line(macro);
  outcome.document["text"] = outcome.text;
  for (const casefile::MacroStep& step : macro.steps) {
    Json commands = Json::array();
    for (const casefile::Command& command : step.commands) commands.push_back(command.words);
    outcome.document["steps"].push_back(
        {{"number", step.number}, {"name", step.name.message()}, {"commands", std::move(commands)}});
  }
  return outcome;
}

}  // namespace

void add_macro(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "macro", "Write what was done to a case in the window as a program: commands for a shell, or Python");
  auto case_folder = std::make_shared<std::string>();
  auto language = std::make_shared<std::string>("command-line");
  command->add_option("case", *case_folder, "The case")->required();
  command->add_option("--as", *language, "In which language")
      ->capture_default_str()
      ->check(CLI::IsMember({"command-line", "python"}));
  command->callback([&chosen, case_folder, language] {
    chosen = [case_folder, language](const Progress&) -> Result<Outcome> {
      return casefile::macro_of(*case_folder).map([&](const casefile::Macro& macro) {
        return describe(macro, *language);
      });
    };
  });
}

}  // namespace glisson::cli
