// glisson-cli gate-cases HISTORY --budget MINUTES: which cases a gate runs in so many minutes.

#include <fmt/format.h>
#include <cmath>

#include "base/files.h"
#include "recording_commands.h"
#include "studies/gate/choose_cases.h"

namespace glisson::cli {
namespace {

struct GateCasesCommand {
  std::string history, out;
  double budget_minutes = 0;
};

Json json_of_worths(const std::vector<studies::CaseWorth>& cases) {
  Json list = Json::array();
  for (const studies::CaseWorth& one : cases) {
    list.push_back({{"case", one.id},
                    {"minutes", one.minutes},
                    {"scatter_percent", one.scatter_percent},
                    {"got_worse", one.got_worse}});
    const bool never_run = one.worth_per_minute >= 1e300;
    if (!never_run) list.back()["worth_per_minute"] = one.worth_per_minute;
  }
  return list;
}

Result<Outcome> run(const GateCasesCommand& command) {
  const auto histories = studies::read_gate_history(command.history);
  if (!histories) return failure(histories.error());
  const auto choice = studies::choose_cases(*histories, command.budget_minutes);
  if (!choice) return failure(choice.error());
  std::string names;
  for (const studies::CaseWorth& one : choice->chosen) names += one.id + "\n";
  if (!command.out.empty()) {
    if (auto written = write_text_file(command.out, names); !written) return failure(written.error());
  }
  return Outcome{{{"minutes", choice->minutes},
                  {"chosen", json_of_worths(choice->chosen)},
                  {"left_out", json_of_worths(choice->left_out)}},
                 command.out.empty() ? names
                                     : fmt::format("{} of {} cases, {:.1f} minutes: {}\n", choice->chosen.size(),
                                                   histories->size(), choice->minutes, command.out)};
}

}  // namespace

void add_gate_cases(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "gate-cases", "Choose the cases that a gate runs in so many minutes: those that told the most a minute before");
  auto settings = std::make_shared<GateCasesCommand>();
  command
      ->add_option("history", settings->history, "Earlier runs: case,seconds,METRIC,...; a row a case a run, in order")
      ->required();
  command->add_option("--budget", settings->budget_minutes, "Minutes")->required()->check(CLI::Range(1e-6, 1e6));
  command->add_option("--out", settings->out, "The chosen cases, a line each, for your program and gate --cases");
  command->callback([&chosen, settings] { chosen = [settings](const Progress&) { return run(*settings); }; });
}

}  // namespace glisson::cli
