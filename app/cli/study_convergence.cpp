// glisson-cli study convergence --out DIR: what is missing of a beam's deflection at which resolution.

#include <fmt/format.h>
#include <filesystem>

#include "studies/dissertation/convergence_study.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyConvergenceCommand {
  std::string out;
  studies::ConvergenceOptions study;
};

Result<Outcome> run(const StudyConvergenceCommand& options, const Progress& progress) {
  const auto study = studies::run_convergence(options.study, progress);
  if (!study) return failure(study.error());
  if (auto written = studies::write_convergence(options.out, *study); !written) return failure(written.error());
  auto document = read_json_file(std::filesystem::path(options.out) / "summary.json");
  if (!document) return failure(document.error());
  Outcome outcome{std::move(*document), {}};
  outcome.text = fmt::format("Theory puts the tip {:.2f} mm lower ({:.2f} mm by eq. 6.6 without shear)\n",
                             study->theory_tip_mm, study->eq_6_6_tip_mm);
  for (const studies::ConvergenceRow& row : study->rows) {
    outcome.text += fmt::format("  {:7.2f} mm3 {:5} nodes: {:6.2f} mm missing at the tip, {:.2f} s set-up\n",
                                row.resolution_mm3, row.nodes, row.error_mm, row.setup_s);
  }
  outcome.document["convergence"] = (std::filesystem::path(options.out) / "convergence.json").string();
  return outcome;
}

}  // namespace

void add_study_convergence(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "convergence",
      "A beam's error against its resolution (section 6.3.2); writes a curve for platform --convergence");
  auto options = std::make_shared<StudyConvergenceCommand>();
  command->add_option("--out", options->out, "Folder for the table, the summary, the curve and the report")->required();
  command->add_option("--finest-mm3", options->study.finest_mm3, "Volume of a node")->capture_default_str();
  command->add_option("--coarsest-mm3", options->study.coarsest_mm3, "Volume of a node")->capture_default_str();
  command->add_option("--resolutions", options->study.resolutions, "How many in between, the ends included")
      ->capture_default_str();
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
