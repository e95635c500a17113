// glisson-cli study data-driven --out DIR: a liver retracted straight from measured strain and stress.

#include <fmt/format.h>
#include <filesystem>

#include "closedloop/material/stress_strain_file.h"
#include "studies/dissertation/data_driven_study.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyDataDrivenCommand {
  std::string out;
  std::optional<std::string> measured_file;
  std::vector<double> noise_percent{0, 2, 5};
  studies::DataDrivenStudyOptions study;
};

std::string words_of(const studies::DataDrivenRow& row) {
  return fmt::format(
      "  {:5} measurements, noise {:4.1f} %: {}by a line through all {:.2f} mm, by the line up to 5 % strain {}; "
      "{} on that line{}\n",
      row.measurements, 100 * row.noise,
      row.from_data ? fmt::format("from data {:.2f} mm off on average, ", row.from_data->mean_mm)
                    : fmt::format("lifted by {:.1f} mm from data; ", row.retraction_mm),
      row.by_line.mean_mm, row.by_region_line ? fmt::format("{:.2f} mm", row.by_region_line->mean_mm) : "none",
      row.on_the_line, row.converged ? "" : fmt::format("; states still wandered after {} rounds", row.rounds));
}

Result<Outcome> run(const StudyDataDrivenCommand& options, const Progress& progress) {
  studies::DataDrivenStudyOptions asked = options.study;
  asked.noises.clear();
  for (const double percent : options.noise_percent) asked.noises.push_back(percent / 100);
  if (options.measured_file) {
    auto measured = closedloop::read_stress_strain(*options.measured_file);
    if (!measured) return failure(std::move(measured.error()));
    asked.measured = std::move(*measured);
  }
  const auto study = studies::run_data_driven(asked, progress);
  if (!study && options.measured_file && study.error().code == "data-invalid") {
    return failure(Error(study.error()).in_file(*options.measured_file));
  }
  if (!study) return failure(study.error());
  if (auto written = studies::write_data_driven(options.out, *study); !written) return failure(written.error());
  auto document = read_json_file(std::filesystem::path(options.out) / "summary.json");
  if (!document) return failure(document.error());
  Outcome outcome{std::move(*document), {}};
  outcome.text = study->true_retraction_mm
                     ? fmt::format("SIMULATED: the tissue's own law lifts the liver by up to {:.1f} mm\n",
                                   *study->true_retraction_mm)
                     : std::string("No truth: lines are told by how far they are from the answer from data\n");
  for (const studies::DataDrivenRow& row : study->rows) outcome.text += words_of(row);
  outcome.document["report"] = (std::filesystem::path(options.out) / "report.html").string();
  return outcome;
}

}  // namespace

void add_study_data_driven(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "data-driven", "A liver retracted straight from measured strain and stress, beside a fitted line (chapter 5)");
  auto options = std::make_shared<StudyDataDrivenCommand>();
  command->add_option("--out", options->out, "Folder for the table, the summary and the report")->required();
  command->add_option("--measured", options->measured_file,
                      "Somebody's measurements: CSV with strain,stress_kPa, or an experiment of kind material; without "
                      "them SIMULATED ones");
  command->add_option("--measurements", options->study.counts, "How many simulated ones, 3 and more; several are tried")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--noise-percent", options->noise_percent, "Of the largest stress; several are tried")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--outliers-one-in", options->study.outliers_one_in, "0: none")->capture_default_str();
  command->add_option("--force-N", options->study.force_N, "That lifts segment VI")->capture_default_str();
  command->add_option("--target-cells", options->study.target_cells, "Of the liver")->capture_default_str();
  command->add_option("--seed", options->study.seed, "Of the noise")->capture_default_str();
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
