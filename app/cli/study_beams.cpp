// glisson-cli study beams CASE ... --out DIR: beams of soft, stiff and uneven tissue against the liver's mean.

#include <fmt/format.h>
#include <filesystem>

#include "casefile/model.h"
#include "studies/dissertation/beam_regions.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyBeamsCommand {
  std::vector<std::string> cases;
  std::string out;
  studies::BeamOptions beams;
};

Result<Outcome> run(const StudyBeamsCommand& options, const Progress& progress) {
  std::vector<studies::BeamRow> rows;
  for (std::size_t i = 0; i < options.cases.size(); ++i) {
    const double share = 1.0 / double(options.cases.size());
    const auto model = casefile::Case::open(options.cases[i]).and_then([](const casefile::Case& patient) {
      return casefile::read_model(patient);
    });
    if (!model) return failure(model.error());
    auto row = studies::compare_beams(std::filesystem::path(options.cases[i]).stem().string(), model->mesh,
                                      casefile::youngs_kPa(*model), options.beams,
                                      progress.part(share * double(i), share * double(i + 1)));
    if (!row) return failure(std::move(row.error()));
    rows.push_back(std::move(*row));
  }
  if (auto written = studies::write_beams(options.out, rows, options.beams); !written) return failure(written.error());
  auto document = read_json_file(std::filesystem::path(options.out) / "summary.json");
  if (!document) return failure(document.error());
  Outcome outcome{std::move(*document), {}};
  for (const studies::BeamRow& row : rows) {
    outcome.text += fmt::format("{}: liver {:.1f} kPa, control lifted by {:.1f} mm\n", row.patient, row.mean_kPa,
                                row.control_displacement_mm);
    for (std::size_t r = 0; r < row.regions.size(); ++r) {
      const studies::BeamComparison& region = row.regions[r];
      outcome.text += fmt::format("  {:18} {:5.1f} kPa (sd {:.1f}): {:.1f} mm apart on average, {:.1f} mm at most{}\n",
                                  studies::region_names[r], region.place.mean_kPa, region.place.sd_kPa, region.mean_mm,
                                  region.max_mm, region.max_mm >= options.beams.significant_mm ? "  >= 5 mm" : "");
    }
  }
  return outcome;
}

}  // namespace

void add_study_beams(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "beams", "Beams of soft, stiff and uneven tissue against one of the liver's mean (section 4.4, table 4.1)");
  auto options = std::make_shared<StudyBeamsCommand>();
  command->add_option("cases", options->cases, "The cases, one or more")->required()->expected(1, 100000);
  command->add_option("--out", options->out, "Folder for the table, the summary and the report")->required();
  command->add_option("--force-N", options->beams.force_N, "That lifts a beam at its middle")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 100.0));
  command->add_option("--foundation-kPa-per-mm", options->beams.foundation_kPa_per_mm, "Under both ends of a beam")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1e6));
  command->add_option("--nodes", options->beams.nodes, "Of the meshfree engine, a beam")
      ->capture_default_str()
      ->check(CLI::Range(4, 2000));
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
