// glisson-cli study palpation --out DIR: simulated against scanned surfaces of a pressed phantom.

#include <fmt/format.h>

#include "studies/dissertation/palpation.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyPalpationCommand {
  std::string out;
  std::string scans;
  studies::PalpationOptions palpation;
};

Outcome describe_palpation(const studies::PalpationSummary& summary) {
  Outcome outcome{{{"trials", Json::array()},
                   {"mean_mm", summary.mean_mm},
                   {"worst_mm", summary.worst_mm},
                   {"dissertation_text_mm", studies::reported_mean_in_text_mm},
                   {"dissertation_table_mm", summary.reported_mean_mm},
                   {"scans", summary.simulated_scans ? "simulated" : "given"}},
                  {}};
  if (summary.simulated_scans) outcome.text = "The scans are SIMULATED: no phantom was measured here.\n";
  for (const studies::BatchRow& row : summary.rows) {
    Json json{{"trial", row.id}};
    for (const auto& [name, value] : row.values) json[name] = value;
    if (!row.error.empty()) json["error"] = row.error;
    outcome.text += row.error.empty()
                        ? fmt::format("{:10} {:6.2f} mm, near the tool {:6.2f} mm, pressed in by {:6.2f} mm\n", row.id,
                                      studies::column_of({row}, "mean_mm").front(),
                                      studies::column_of({row}, "near_tool_mm").front(),
                                      studies::column_of({row}, "depth_mm").front())
                        : fmt::format("{:10} {}\n", row.id, row.error);
    outcome.document["trials"].push_back(std::move(json));
  }
  outcome.text += fmt::format("Mean {:.2f} mm; the dissertation says {:.2f} mm, and its table averages {:.2f} mm\n",
                              summary.mean_mm, studies::reported_mean_in_text_mm, summary.reported_mean_mm);
  return outcome;
}

}  // namespace

void add_study_palpation(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "palpation", "A pressed phantom: simulated against scanned surface (section 4.5); run again, it goes on");
  auto options = std::make_shared<StudyPalpationCommand>();
  command->add_option("--out", options->out, "Folder for the rows, the table, the summary and the report")->required();
  command->add_option("--scans", options->scans,
                      "Folder with A-rest.ply, A-1.69N.ply, ... in mm; without it scans are SIMULATED");
  command->add_option("--tool-radius-mm", options->palpation.tool_radius_mm, "Of the disc that the tool presses on")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 100.0));
  command->add_option("--soft-kPa", options->palpation.soft_kPa, "Young's modulus of compound A")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e4));
  command->add_option("--stiff-kPa", options->palpation.stiff_kPa, "Young's modulus of compound B")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e4));
  command->callback([&chosen, options] {
    chosen = [options](const Progress& progress) {
      if (!options->scans.empty()) options->palpation.scans = options->scans;
      return studies::run_palpation(options->out, options->palpation, progress).map(describe_palpation);
    };
  });
}

}  // namespace glisson::cli
