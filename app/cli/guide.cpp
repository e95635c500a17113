// glisson-cli guide (CASE --sequence SEQUENCE.json | GUIDANCE.json | CONTOURS.json) --out DIR: where the organ and its
// hidden targets are in each frame.

#include <fmt/format.h>
#include <cmath>

#include "base/csv.h"
#include "base/json.h"
#include "casefile/guide_case.h"
#include "command.h"
#include "guidance/contour_file.h"
#include "guidance/guidance_file.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

std::string describe(const guidance::GuidanceAnswer& answer) {
  std::string text;
  for (const guidance::FrameAnswer& frame : answer.frames) {
    const guidance::ElasticPlacement& placed = frame.placement;
    if (!placed.converged) {
      text += fmt::format("{}: not answered. {}\n", frame.id, placed.why_not.message());
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

struct Asked {
  std::string input, sequence, sequence_sha256, pose, lines, out;
  std::optional<std::size_t> frame;
  double noise_mm = 0.5;
};

Outcome outcome_of(const guidance::GuidanceCase& guidance, const guidance::GuidanceAnswer& answer,
                   const std::string& out) {
  Outcome outcome{guidance::answer_json(guidance, answer), describe(answer)};
  outcome.document["out"] = out;
  return outcome;
}

Result<Outcome> guide_file(const Asked& asked, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Reading the guidance case"));
  const auto guidance = guidance::read_guidance(asked.input);
  if (!guidance) return failure(guidance.error());
  const auto answer = guidance::answer(*guidance, progress);
  if (!answer) return failure(Error(answer.error()).in_file(asked.input));
  if (auto written = guidance::write_answer(asked.out, *guidance, *answer); !written) return failure(written.error());
  return outcome_of(*guidance, *answer, asked.out);
}

std::string describe(const guidance::ContourCase& asked, const std::vector<guidance::ContourAnswer>& answers) {
  std::string text;
  for (std::size_t f = 0; f < answers.size(); ++f) {
    const guidance::ContourAnswer& answer = answers[f];
    if (!answer.found) {
      text += fmt::format("{}: not answered. {}\n", answer.id, answer.found.error().message());
      continue;
    }
    text += fmt::format("{}: pose from one picture\n", answer.id);
    for (std::size_t c = 0; c < answer.left_out.size(); ++c) {
      const std::string& id = asked.frames[f].contours[c].id;
      const auto& off = answer.found->off[c];
      if (!off) {
        text += fmt::format("  {}: not used, the lens's distortion tells no direction there\n", id);
        continue;
      }
      text += fmt::format("  {}: {:.0f} px off, {:.1f} mm", id, off->px, off->mm);
      if (const auto& left = answer.left_out[c]) {
        text += fmt::format("; left out {:.0f} px, {:.1f} mm", left->px, left->mm);
      }
      text += "\n";
    }
  }
  return text + "A picture tells no depth: how far the organ is from the camera is known by its size alone.\n";
}

Result<Outcome> guide_contours(const Asked& asked, const Progress& progress) {
  progress.report(0.0, GLISSON_TEXT("Reading the guidance case"));
  const auto contours = guidance::read_contours(asked.input);
  if (!contours) return failure(contours.error());
  const auto answers = guidance::answer(*contours, progress);
  if (!answers) return failure(answers.error());
  Outcome outcome{guidance::answer_json(*contours, *answers), describe(*contours, *answers)};
  const auto written = write_json_file(std::filesystem::path(asked.out) / "guidance.json", outcome.document);
  if (!written) return failure(written.error());
  outcome.document["out"] = asked.out;
  return outcome;
}

// "16 numbers, comma, row by row": scan to camera.
Result<std::optional<Eigen::Isometry3d>> parse_pose(const std::string& text) {
  if (text.empty()) return std::nullopt;
  std::vector<double> numbers;
  for (const CsvRow& row : csv_rows(text)) {
    for (std::size_t n = 0; n < row.cells.size(); ++n) numbers.push_back(row.number(n));
  }
  const auto pose = guidance::rigid_pose(numbers);
  if (pose) return pose;
  return failure(Error{"usage",
                       GLISSON_TEXT("--pose {0} is no rigid motion: 16 numbers with commas, row by row."),
                       {text},
                       GLISSON_TEXT("The pose takes a point of the scan (mm) to the camera's frame."),
                       {}});
}

Result<Outcome> guide_case(const Asked& asked, const Progress& progress) {
  const auto pose = parse_pose(asked.pose);
  if (!pose) return failure(pose.error());
  const auto patient = casefile::Case::open(asked.input);
  if (!patient) return failure(patient.error());
  casefile::MarkedLines lines;
  if (!asked.lines.empty()) {
    auto read = casefile::read_marked_lines(asked.lines);
    if (!read) return failure(std::move(read.error()));
    lines = *std::move(read);
  }
  const std::size_t frame = asked.frame.value_or(casefile::first_marked_frame(lines).value_or(0));
  const casefile::GuidedFrom from{frame, *pose, asked.noise_mm, asked.sequence_sha256, lines};
  const auto guided = casefile::guide_case(*patient, asked.sequence, from, progress);
  if (!guided) return failure(guided.error());
  const auto pictures = casefile::write_guided_case(asked.out, *guided);
  if (!pictures) return failure(pictures.error());
  Outcome outcome = outcome_of(guided->guided.guidance, guided->answer, asked.out);
  outcome.document["pictures"] = *pictures;
  return outcome;
}

}  // namespace

void add_guide(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("guide", "Place the organ and its hidden targets in each frame of a camera");
  auto asked = std::make_shared<Asked>();
  command
      ->add_option("input", asked->input,
                   "A guidance case (glisson-guidance/1), contours of pictures (glisson-contours/1), or a case folder "
                   "with --sequence")
      ->required();
  auto* sequence = command->add_option("--sequence", asked->sequence, "The laparoscope's sequence.json");
  command->add_option("--sequence-sha256", asked->sequence_sha256, "Refuses another sequence.json than the one of this")
      ->needs(sequence);
  command->add_option("--pose", asked->pose, "Scan to camera in that frame, about: 16 numbers, row by row")
      ->needs(sequence);
  command
      ->add_option(
          "--lines", asked->lines,
          "Lines that are marked on model and frames (glisson-marked-lines/1), as the workspace Guide keeps them")
      ->needs(sequence);
  command
      ->add_option("--frame", asked->frame,
                   "The frame that it begins with, from 0 (default: the first with lines, else 0); the others follow")
      ->needs(sequence);
  command->add_option("--noise-mm", asked->noise_mm, "Standard deviation of the clouds' coordinates")
      ->check(CLI::Range(0.01, 20.0))
      ->needs(sequence)
      ->capture_default_str();
  command->add_option("--out", asked->out, "Folder for guidance.json, a mesh and a picture a frame")->required();
  command->callback([&chosen, asked] {
    chosen = [asked](const Progress& progress) {
      if (!asked->sequence.empty()) return guide_case(*asked, progress);
      return guidance::holds_contours(asked->input) ? guide_contours(*asked, progress) : guide_file(*asked, progress);
    };
  });
}

}  // namespace glisson::cli
