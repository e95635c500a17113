// glisson-cli study palpation --out DIR: a model on elastography against a phantom that is pressed.

#include <fmt/format.h>

#include "studies/dissertation/palpation.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyPalpationCommand {
  std::string out;
  std::string scans;
  double soft_kPa = 0, stiff_kPa = 0;
  studies::PalpationOptions palpation;
};

std::string said_of(const studies::BatchRow& row, bool judged) {
  if (!row.error.empty()) return fmt::format("{:16} {}\n", row.id, row.error);
  const auto value = [&](const char* name) { return studies::column_of({row}, name).front(); };
  const auto if_any = [&](const char* name, const char* format) {
    const auto values = studies::column_of({row}, name);
    return values.empty() ? std::string() : fmt::format(fmt::runtime(format), values.front());
  };
  if (!judged) {
    return fmt::format("{:16} {:5.2f} mm, near the tool {:5.2f} mm, pressed in by {:5.2f} mm\n", row.id,
                       value("mean_mm"), value("near_tool_mm"), value("depth_mm"));
  }
  return fmt::format("{:14} {:5.2f} mm deep, true {:5.2f}: {:+5.1f} %{}; surface {:.2f} mm off{};{}{}\n", row.id,
                     value("depth_mm"), value("true_depth_mm"), value("off_percent"),
                     if_any("told_off_percent", " ({:+.1f} with the true moduli)"), value("mean_mm"),
                     if_any("reported_mm", ", in table 4.4 {:.2f}"), if_any("soft_kPa", " A {:.1f} kPa"),
                     if_any("stiff_kPa", " B {:.1f} kPa"));
}

Outcome describe_palpation(const studies::PalpationSummary& summary) {
  Outcome outcome{{{"trials", Json::array()},
                   {"mean_mm", summary.mean_mm},
                   {"worst_mm", summary.worst_mm},
                   {"dissertation_text_mm", studies::reported_mean_in_text_mm},
                   {"dissertation_table_mm", summary.reported_mean_mm},
                   {"scans", summary.simulated_scans ? "simulated" : "given"}},
                  {},
                  summary.passed()};
  if (summary.simulated_scans) {
    outcome.text = "Phantoms, elastography and scans are SIMULATED: nothing was measured here.\n";
  }
  for (const studies::BatchRow& row : summary.rows) {
    Json json{{"trial", row.id}};
    for (const auto& [name, value] : row.values) json[name] = value;
    if (!row.error.empty()) json["error"] = row.error;
    outcome.text += said_of(row, summary.simulated_scans);
    outcome.document["trials"].push_back(std::move(json));
  }
  outcome.text += fmt::format("Mean {:.2f} mm; the dissertation says {:.2f} mm, and its table averages {:.2f} mm\n",
                              summary.mean_mm, studies::reported_mean_in_text_mm, summary.reported_mean_mm);
  if (!summary.simulated_scans) return outcome;
  outcome.document["passed"] = summary.passed();
  outcome.document["held"] = {{"trials", summary.honest}, {"within_limit", summary.held}};
  outcome.document["faults"] = {{"trials", summary.faults}, {"beyond_limit", summary.caught}};
  outcome.text += fmt::format(
      "{}: the ball as deep as in truth to within {:.0f} % in {} of {} trials; {} of {} faults on purpose beyond that, "
      "of "
      "which the surface's {:.0f} mm alone would have let {} pass\n",
      summary.passed() ? "The study holds" : "The study does NOT hold", 100 * studies::palpation_limit, summary.held,
      summary.honest, summary.caught, summary.faults, studies::clinical_limit_mm, summary.faults_within_clinical_limit);
  return outcome;
}

}  // namespace

void add_study_palpation(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "palpation",
      "A pressed phantom: a model on elastography against another solver's truth, or scans (section 4.5); exit code 1 "
      "where it does not hold; run again, it goes on");
  auto options = std::make_shared<StudyPalpationCommand>();
  command->add_option("--out", options->out, "Folder for the rows, the table, the summary and the report")->required();
  command->add_option("--scans", options->scans,
                      "Folder with A-rest.ply, A-1.69N.ply, ... in mm; without it phantom and scans are SIMULATED");
  command->add_option("--only", options->palpation.only, "Only these trials, such as A-1.69N or A-7.81N-law");
  command->add_option("--tool-radius-mm", options->palpation.ball_radius_mm, "Of the ball that presses")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 100.0));
  command
      ->add_option("--soft-kPa", options->soft_kPa,
                   "Young's modulus of compound A in the model, in place of what elastography finds")
      ->check(CLI::Range(0.01, 1e4));
  command
      ->add_option("--stiff-kPa", options->stiff_kPa,
                   "Young's modulus of compound B in the model, in place of what elastography finds")
      ->check(CLI::Range(0.01, 1e4));
  command->callback([&chosen, options] {
    chosen = [options](const Progress& progress) {
      studies::PalpationOptions& palpation = options->palpation;
      if (!options->scans.empty()) palpation.scans = options->scans;
      if (options->soft_kPa > 0) palpation.soft_kPa = options->soft_kPa;
      if (options->stiff_kPa > 0) palpation.stiff_kPa = options->stiff_kPa;
      return studies::run_palpation(options->out, palpation, progress).map(describe_palpation);
    };
  });
}

}  // namespace glisson::cli
