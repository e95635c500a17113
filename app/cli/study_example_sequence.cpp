// glisson-cli study example-sequence --out DIR: a simulated sequence whose truth is known, for sirgn.

#include <fmt/format.h>

#include "studies/review/example_sequence.h"
#include "study_commands.h"

namespace glisson::cli {
namespace {

struct StudyExampleSequenceCommand {
  std::string out;
  studies::ExampleSequenceOptions sequence;
};

Result<Outcome> run(const StudyExampleSequenceCommand& options, const Progress& progress) {
  const auto file = studies::write_example_sequence(options.out, options.sequence, progress);
  if (!file) return failure(file.error());
  return Outcome{{{"frames", options.sequence.frames}, {"file", file->string()}},
                 fmt::format("{} simulated frames: {}\n", options.sequence.frames, file->string())};
}

}  // namespace

void add_study_example_sequence(CLI::App& study, Action& chosen) {
  CLI::App* command = study.add_subcommand(
      "example-sequence", "A simulated sequence for sirgn: a generated liver, breathing and pressed by a tool");
  auto options = std::make_shared<StudyExampleSequenceCommand>();
  command->add_option("--frames", options->sequence.frames, "How many")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
  command->add_option("--landmarks", options->sequence.landmarks, "How many are tracked")
      ->check(CLI::Range(4, 2000))
      ->capture_default_str();
  command->add_option("--fault-mm", options->sequence.fault_mm, "Of the given registration, at its worst")
      ->check(CLI::Range(0.0, 50.0))
      ->capture_default_str();
  command->add_option("--patient", options->sequence.patient, "Seed of the generated liver (see study anatomy)")
      ->capture_default_str();
  command->add_option("--seed", options->sequence.seed, "Of noise")->capture_default_str();
  command->add_flag("--stereo", options->sequence.stereo, "Both eyes' pictures and their calibration too, in video/");
  command->add_option("--out", options->out, "New folder for sequence.json, clouds, pictures and truth.json")
      ->required();
  command->callback(
      [&chosen, options] { chosen = [options](const Progress& progress) { return run(*options, progress); }; });
}

}  // namespace glisson::cli
