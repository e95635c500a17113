// glisson-cli explain: what does a model lack that measurements show?

#include <fmt/format.h>

#include "base/json.h"
#include "closedloop/explanation_file.h"
#include "closedloop/inference/posterior.h"
#include "closedloop/inference/visible.h"
#include "command.h"
#include "report/explanation_folder.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct ExplainCommand {
  std::string experiment;
  std::string out;
};

std::string in_words(const closedloop::Explanation& explanation, const closedloop::Observations& observations);

Result<Outcome> run(const ExplainCommand& command, const Progress& progress) {
  const auto explained = closedloop::explain(command.experiment, progress);
  if (!explained) return failure(explained.error());
  const std::filesystem::path out(command.out);
  if (auto written = report::write_explanation(out, *explained); !written) return failure(std::move(written.error()));

  const auto& observations = explained->model->observations();
  Json document = closedloop::report_json(explained->explanation, observations);
  document["files"] = {(out / "report.json").string(), (out / "report.html").string(), (out / "model.json").string(),
                       (out / "next_trials.json").string()};
  return Outcome{std::move(document), in_words(explained->explanation, observations)};
}

std::string in_words(const closedloop::Explanation& explanation, const closedloop::Observations& observations) {
  const std::string unit = observations.unit == "noise" ? "times the noise" : observations.unit;
  std::string text =
      fmt::format("{}: error {:.3g} {} before, {:.3g} after (noise {:.3g})\n", closedloop::name_of(explanation.verdict),
                  explanation.before.rms, unit, explanation.after.rms, explanation.after.noise);
  if (explanation.held_out)
    text +=
        fmt::format("  on trials left out: {:.3g} {} before, {:.3g} after\n", explanation.held_out_before->rms, unit,
                    explanation.held_out_corrected ? explanation.held_out_corrected->rms : explanation.held_out->rms);
  if (explanation.hidden_targets)
    text += fmt::format("  hidden targets, which nothing was fitted to: {:.3g} mm before, {:.3g} after (mean)\n",
                        explanation.hidden_targets->before.mean, explanation.hidden_targets->after.mean);
  if (const std::string sure = closedloop::posterior_sentence(explanation).message(); !sure.empty())
    text += "  " + sure + "\n";
  if (const std::string seen = closedloop::visible_sentence(explanation); !seen.empty()) text += "  " + seen + "\n";
  for (const auto& effect : explanation.effects) {
    text += "  " + effect.kind + (effect.form.empty() ? "" : " (" + effect.form + ")") + ":";
    for (const auto& found : effect.parameters)
      text += fmt::format(" {} {:.4g} +- {:.2g}", found.parameter.name, found.value, found.std);
    for (const auto& kind : effect.alike) text += "; alike " + kind;
    text += "\n";
  }
  if (explanation.smooth_correction) text += "  smooth-correction, which claims no cause\n";
  for (const auto& next : explanation.next.to_make)
    text += fmt::format("  next: {} ({:.0f} % of the doubt gone)\n", next.sentence.message(), 100 * next.doubt_removed);
  return text + bullet_list(messages(explanation.notes));
}

}  // namespace

void add_explain(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("explain", "Close the loop: find what a model lacks that measurements show");
  auto settings = std::make_shared<ExplainCommand>();
  command->add_option("experiment", settings->experiment, "Experiment (JSON, glisson-experiment/1)")->required();
  command->add_option("--out", settings->out, "Folder for report.json, report.html, model.json and next_trials.json")
      ->required();
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli
