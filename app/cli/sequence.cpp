// glisson-cli sequence LEFT RIGHT: a stereo video to clouds, tracked landmarks and the model, for sirgn.

#include <fmt/format.h>

#include "command.h"
#include "eyes.h"
#include "registration_quality/video_sequence.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

struct SequenceCommand {
  std::string left, right, calibration, out, model, landmarks;
  vision::Shared shared = vision::Shared::left_then_right;
  registration_quality::VideoSequenceOptions options;
};

Result<Outcome> run(SequenceCommand command, const Progress& progress) {
  const auto calibration = vision::read_stereo_calibration(command.calibration);
  if (!calibration) return failure(calibration.error());
  auto video = vision::StereoSource::open({command.left, command.right, command.shared});
  if (!video) return failure(video.error());
  if (!command.model.empty()) command.options.model = command.model;
  if (!command.landmarks.empty()) command.options.landmarks = command.landmarks;
  command.options.tracks.nearest_mm = command.options.stereo.nearest_mm;
  command.options.tracks.farthest_mm = command.options.stereo.farthest_mm;
  const auto sequence =
      registration_quality::make_sequence(*video, *calibration, command.out, command.options, progress);
  if (!sequence) return failure(sequence.error());
  std::vector<std::string> notes = calibration->notes;
  notes.insert(notes.end(), sequence->notes.begin(), sequence->notes.end());
  Outcome outcome{{{"frames", sequence->frames},
                   {"landmarks", sequence->landmarks},
                   {"mean_points", sequence->mean_points},
                   {"valid_fraction", sequence->mean_valid_fraction},
                   {"epipolar_px", sequence->epipolar_px},
                   {"notes", notes},
                   {"file", sequence->file.string()}},
                  fmt::format("{} frames, {} landmarks, {:.0f} points a frame\n", sequence->frames, sequence->landmarks,
                              sequence->mean_points)};
  if (const auto& rms_mm = sequence->alignment_rms_mm) {
    outcome.document["alignment"] = {
        {"before_rms_mm", (*rms_mm)[0]}, {"rigid_rms_mm", (*rms_mm)[1]}, {"rms_mm", (*rms_mm)[2]}};
    outcome.text +=
        fmt::format("landmarks agree within {:.2f} mm once aligned; {:.2f} mm before\n", (*rms_mm)[2], (*rms_mm)[0]);
  }
  outcome.text += bullet_list(notes);
  return outcome;
}

}  // namespace

void add_sequence(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("sequence", "Turn a stereo video into clouds and tracked landmarks for sirgn");
  auto settings = std::make_shared<SequenceCommand>();
  command->add_option("left", settings->left, "The left eye's video, or a folder of pictures")->required();
  CLI::Option* right = command->add_option("right", settings->right, "The right eye's; none with --eyes");
  CLI::Option* eyes = add_eyes(*command, right, settings->shared);
  command->add_option("--calibration", settings->calibration, "Stereo calibration, as for stereo")->required();
  command->add_option("--skip", settings->options.skip, "Leave out so many frames at the beginning")
      ->check(CLI::Range(0, 10'000'000));
  command->add_option("--every", settings->options.every, "Take one frame of so many")->check(CLI::Range(1, 10000));
  command->add_option("--frames", settings->options.maximum_frames, "At most so many frames")
      ->check(CLI::Range(3, 100000))
      ->capture_default_str();
  command->add_option("--step", settings->options.stereo.step_px, "A point every so many pixels")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--nearest-mm", settings->options.stereo.nearest_mm, "Nearest depth")->capture_default_str();
  command->add_option("--farthest-mm", settings->options.stereo.farthest_mm, "Farthest depth")->capture_default_str();
  command->add_option("--model", settings->model, "Surface to register to; absent: the frames' own, aligned globally");
  command->add_option("--landmarks", settings->landmarks, "tracks.csv made by an expert; absent: tracked features");
  command->add_option("--out", settings->out, "New folder for sequence.json, clouds and pictures")->required();
  command->callback([&chosen, settings, right, eyes] {
    check_eyes(*right, *eyes);
    chosen = [settings](const Progress& progress) { return run(*settings, progress); };
  });
}

}  // namespace glisson::cli
