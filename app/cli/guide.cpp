// glisson-cli guide GUIDANCE.json --out DIR: where the organ and its hidden targets are in each frame.

#include <fmt/format.h>

#include "command.h"
#include "guidance/guidance_answer.h"
#include "guidance/guidance_file.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

std::string describe(const guidance::GuidanceAnswer& answer) {
  std::string text;
  for (const guidance::FrameAnswer& frame : answer.frames) {
    const guidance::ElasticPlacement& placed = frame.placement;
    if (!placed.converged) {
      text += fmt::format("{}: not answered. {}\n", frame.id, placed.why_not);
      continue;
    }
    double sd_mm = 0;
    for (const double each : placed.target_sd_mm) sd_mm = std::max(sd_mm, each);
    text += fmt::format(
        "{}: {:.0f} % of the surface seen, residual {:.2f} mm, deformed by {:.1f} mm (rms), targets to {:.1f} mm "
        "(largest sd), {:.1f} s\n",
        frame.id, 100 * placed.visible_share, placed.residual_rms_mm, placed.elastic_rms_mm, sd_mm, frame.seconds);
    for (const guidance::FoundTool& tool : placed.tools) {
      text += fmt::format("  {}: {:.2f} N (sd {:.2f})\n", tool.id, 1e-3 * tool.force_mN.norm(), 1e-3 * tool.sd_mN);
    }
  }
  return text + bullet_list(answer.notes);
}

Result<Outcome> guide(const std::string& file, const std::string& out, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Reading the guidance case"));
  const auto guidance = guidance::read_guidance(file);
  if (!guidance) return failure(guidance.error());
  const auto answer = guidance::answer(*guidance, progress);
  if (!answer) return failure(Error(answer.error()).in_file(file));
  if (auto written = guidance::write_answer(out, *guidance, *answer); !written) return failure(written.error());
  Outcome outcome{guidance::answer_json(*guidance, *answer), describe(*answer)};
  outcome.document["out"] = out;
  return outcome;
}

}  // namespace

void add_guide(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("guide", "Place the organ and its hidden targets in each frame of a camera");
  auto file = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  command->add_option("guidance", *file, "The guidance case (glisson-guidance/1)")->required();
  command->add_option("--out", *out, "Folder for guidance.json and a mesh a frame")->required();
  command->callback([&chosen, file, out] {
    chosen = [file, out](const Progress& progress) { return guide(*file, *out, progress); };
  });
}

}  // namespace glisson::cli
