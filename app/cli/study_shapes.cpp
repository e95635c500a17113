// glisson-cli study shapes FOLDER --out DIR: a shape model of real livers, and what it is worth on livers left out.

#include <fmt/format.h>
#include <filesystem>

#include "one_of.h"
#include "studies/dissertation/shapes_study.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyShapesCommand {
  std::string folder, out;
  std::string only;
  studies::ShapesOptions study;
};

Result<Outcome> run(const StudyShapesCommand& options, const Progress& progress) {
  studies::ShapesOptions asked = options.study;
  if (!options.only.empty()) asked.only = options.only;
  const auto study = studies::run_shapes(options.folder, options.out, asked, progress);
  if (!study) return failure(study.error());
  if (asked.only) return Outcome{Json{{"liver", *asked.only}}, fmt::format("{} is done\n", *asked.only)};
  auto document = read_json_file(std::filesystem::path(options.out) / "summary.json");
  if (!document) return failure(document.error());
  Outcome outcome{std::move(*document), {}};
  outcome.text = fmt::format(
      "{} livers, {} refused; {} modes hold {:.0f} % of the variance\n"
      "Livers lie {:.1f} mm from their mean; one drawn lies {:.1f} mm from the nearest real one (specificity)\n",
      study->used, study->refused, study->ranks.rank,
      100 * study->ranks.by_modes[static_cast<std::size_t>(study->ranks.rank - 1)].compactness, study->spread_mm,
      study->specificity_mm);
  for (const studies::ShapesScore& score : study->scores) {
    outcome.text += fmt::format("{:22} mean {:6.2f}, median {:6.2f}, worst {:6.2f}  {}\n", score.column, score.mean,
                                score.median, score.worst, score.says);
  }
  for (const auto* rows : {&study->livers, &study->judged}) {
    for (const studies::BatchRow& row : *rows) {
      if (!row.error.empty()) outcome.text += fmt::format("Refused: {}: {}\n", row.id, row.error);
    }
  }
  return outcome;
}

}  // namespace

void add_study_shapes(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "shapes", "A shape model of a folder's livers, judged on livers left out; run again, it goes on");
  auto options = std::make_shared<StudyShapesCommand>();
  command->add_option("folder", options->folder, "Label maps, one a liver: ID_liver.nii.gz or ID_couinaud.nii.gz")
      ->required();
  command->add_option("--out", options->out, "Folder for the model, the livers' surfaces and the tables")->required();
  command
      ->add_option("--judge", options->study.judged,
                   "judging: every other liver, by models of all others; tuning: the rest, alone; all; none")
      ->transform(one_of(Words<studies::ShapesJudged>{{"judging", studies::ShapesJudged::judging},
                                                      {"tuning", studies::ShapesJudged::tuning},
                                                      {"all", studies::ShapesJudged::all},
                                                      {"none", studies::ShapesJudged::none}}));
  command->add_option("--only", options->only, "This liver's correspondence alone: one job of many");
  command->add_flag("--spacing-is-true", options->study.believe_unit_spacing,
                    "Believe labels of 1 x 1 x 1 mm, which are refused as having lost their spacing");
  command
      ->add_option("--reference-spacing-mm", options->study.reference_spacing_mm,
                   "Of the points of the surface that every liver is described by")
      ->capture_default_str()
      ->check(CLI::Range(4.0, 20.0));
  shapes::FitOptions& fit = options->study.fit;
  command->add_option("--noise-mm", fit.noise_mm, "Of seen places, across the surface")->capture_default_str();
  command->add_option("--along-mm", fit.along_mm, "Of seen places, along it")->capture_default_str();
  command->add_option("--independent", fit.independent, "Seen points of a whole liver count as so many")
      ->capture_default_str();
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
