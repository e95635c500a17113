// glisson-cli demo --out DIR: the main job, end to end, on the simulated patient that ships inside.

#include <fmt/format.h>

#include "command.h"
#include "studies/demo/demo.h"

namespace glisson::cli {
namespace {

Outcome describe(const studies::DemoSummary& summary) {
  const auto& comparison = summary.atlas_against_mre;
  std::string text = fmt::format(
      "SIMULATED: a generated patient; not a medical device.\n"
      "Liver {:.0f} ml (true {:.0f} ml, Dice {:.3f}); {} cells; Young's modulus {:.2f} kPa on average (sd {:.2f})\n"
      "{} with {:.1f} N: the liver moves by up to {:.1f} mm; atlas against MRE: mean {:.1f} mm, largest {:.1f} mm\n",
      summary.liver_ml, summary.true_liver_ml, summary.liver_dice, summary.cells, summary.stiffness.mean_kPa,
      summary.stiffness.sd_kPa, summary.tool, summary.force_N, summary.max_displacement_mm, comparison.mean_mm,
      comparison.max_mm);
  text += summary.validity.sentence().message() + "\n";
  text += fmt::format("  {:24} {:>8} {:>8} {:>8}\n", "landmark (mm)", "MRE", "atlas", "apart");
  for (const auto& landmark : comparison.landmarks) {
    text += fmt::format("  {:24} {:8.1f} {:8.1f} {:8.1f}{}\n", landmark.id, landmark.displacement_a_mm,
                        landmark.displacement_b_mm, landmark.difference_mm,
                        landmark.displacement_a_mm >= rehearsal::significant_mm ? "  moves by 5 mm or more" : "");
  }
  return {studies::summary_json(summary),
          text + fmt::format("{:.0f} s; report: {}\n", summary.seconds, summary.report.string())};
}

}  // namespace

void add_demo(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("demo", "The main job, end to end, on the simulated patient that ships inside");
  auto out = std::make_shared<std::string>();
  auto options = std::make_shared<studies::DemoRunOptions>();
  command->add_option("--out", *out, "Folder for the study, the case and the report")->required();
  command->add_option("--force-N", options->force_N, "Force of the retractor (default: its usual force)")
      ->check(CLI::Range(0.01, 100.0));
  command->callback([&chosen, out, options] {
    chosen = [out, options](const Progress& progress) {
      return studies::run_demo(*out, *options, progress).map(describe);
    };
  });
}

}  // namespace glisson::cli
