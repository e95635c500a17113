// glisson-cli gate BASE NEW: two versions' results case by case, for CI: exit code 1 where something got worse.

#include "studies/gate/gate.h"

#include <fmt/format.h>

#include "command.h"
#include "shared_options.h"
#include "studies/gate/choose_cases.h"

namespace glisson::cli {
namespace {

struct GateCommand {
  std::string base, now, out, tolerances, cases;
};

Result<Outcome> run(const GateCommand& command, const Progress& progress) {
  auto base = studies::read_results(command.base);
  if (!base) return failure(base.error());
  auto now = studies::read_results(command.now);
  if (!now) return failure(now.error());
  if (!command.cases.empty()) {
    const auto chosen = studies::read_chosen_cases(command.cases);
    if (!chosen) return failure(chosen.error());
    base = studies::only(*base, *chosen);
    now = studies::only(*now, *chosen);
  }
  studies::GateOptions options;
  if (!command.tolerances.empty()) {
    auto read = studies::read_tolerances(command.tolerances);
    if (!read) return failure(read.error());
    options = *std::move(read);
  }
  const auto gate = studies::compare_results(*base, *now, options, progress);
  if (!gate) return failure(gate.error());
  if (auto written = studies::write_gate(*gate, *base, *now, options, command.out); !written)
    return failure(written.error());

  std::string text;
  for (const studies::MetricChange& change : gate->metrics) text += sentence_of(change) + "\n";
  for (const studies::PictureChange& change : gate->pictures) {
    if (change.verdict != studies::GateVerdict::worse) continue;
    text += change.problem.empty() ? fmt::format("{}: similarity {:.3f}: worse\n", change.name, change.similarity)
                                   : fmt::format("{}: {}: worse\n", change.name, change.problem);
  }
  if (!gate->only_base.empty()) text += fmt::format("{} cases are missing now: worse\n", gate->only_base.size());
  if (!gate->only_now.empty()) text += fmt::format("{} cases are new, not compared\n", gate->only_now.size());
  text += bullet_list(gate->notes);
  text += fmt::format("{}: {}\n", name_of(gate->verdict), (std::filesystem::path(command.out) / "gate.html").string());
  return Outcome{json_of(*gate), std::move(text), gate->verdict != studies::GateVerdict::worse};
}

}  // namespace

void add_gate(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("gate", "Compare two versions' results case by case; exit code 1 where something got worse");
  auto settings = std::make_shared<GateCommand>();
  command->add_option("base", settings->base, "Folder with metrics.csv, and pictures/CASE/NAME.png where it has any")
      ->required();
  command->add_option("new", settings->now, "The same of the new version")->required();
  command->add_option("--tolerances", settings->tolerances,
                      "Which way each metric is better, and how much worse may pass (JSON)");
  command->add_option("--cases", settings->cases, "Only these, as gate-cases chose them (a case a line)");
  command->add_option("--out", settings->out, "Folder for gate.html, gate.json, junit.xml and pictures")->required();
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli
