// glisson-cli demo --out DIR [--guide]: the main job, end to end, on the simulated patient that ships inside; and its
// tumour on a laparoscope's frames.

#include <fmt/format.h>

#include "base/json.h"
#include "command.h"
#include "studies/demo/demo.h"
#include "studies/review/guided_example.h"

namespace glisson::cli {
namespace {

Outcome describe(const studies::DemoSummary& summary) {
  const auto& comparison = summary.reference_against_mre;
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

// What the liver was placed like on the frames of its own video.
Outcome with_guided(Outcome outcome, const studies::GuidedExample& example) {
  outcome.document["guided"] = studies::guided_example_json(example);
  for (const studies::GuidedExampleFrame& frame : example.frames) {
    outcome.text += frame.placed ? fmt::format("  {}: {} is off by {:.1f} mm (stated: 90 % within {:.1f} mm)\n",
                                               frame.id, example.structure, frame.error_mm, frame.within_mm)
                                 : fmt::format("  {}: not placed\n", frame.id);
  }
  outcome.text += fmt::format("On the video {} is off by {:.1f} mm on average (SIMULATED): {}\n", example.structure,
                              example.mean_error_mm(), example.picture.string());
  return outcome;
}

Result<Outcome> run(const std::string& out, const studies::DemoRunOptions& options, bool guide,
                    const Progress& progress) {
  const auto summary = studies::run_demo(out, options, guide ? progress.part(0, 0.6) : progress);
  if (!summary) return failure(summary.error());
  Outcome outcome = describe(*summary);
  if (!guide) return outcome;
  const auto example =
      studies::guide_example(summary->case_folder, std::filesystem::path(out) / "guided", 12, progress.part(0.6, 1));
  if (!example) return failure(example.error());
  return with_guided(std::move(outcome), *example);
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
  auto guide = std::make_shared<bool>(false);
  command->add_flag("--guide", *guide, "Then place the liver on a simulated laparoscopy: the tumour beside its truth");
  command->callback([&chosen, out, options, guide] {
    chosen = [out, options, guide](const Progress& progress) { return run(*out, *options, *guide, progress); };
  });
}

}  // namespace glisson::cli
