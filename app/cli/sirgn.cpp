// glisson-cli sirgn SEQUENCE.json: how good a registration of a video is, triangle by triangle.

#include "registration_quality/sirgn.h"

#include <fmt/format.h>
#include <chrono>
#include <numeric>

#include "base/write_file.h"
#include "command.h"
#include "one_of.h"
#include "registration_quality/quality_file.h"
#include "registration_quality/register_sequence.h"
#include "registration_quality/sequence_file.h"
#include "shared_options.h"
#include "studies/review/review.h"

namespace glisson::cli {
namespace {

using Method = registration_quality::SequenceMethod;

struct SirgnCommand {
  std::string sequence, out;
  Method method = Method::given;
  registration_quality::SirgnOptions options;
  bool pictures = false;
};

Outcome describe(const registration_quality::Quality& quality, const SirgnCommand& command, std::size_t frames,
                 const std::string& simulated, double time_s, double judging_s);

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Result<Outcome> run(const SirgnCommand& command, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto files = registration_quality::read_sequence(command.sequence);
  if (!files) return failure(files.error());
  const auto sequence = registration_quality::register_sequence(*files, command.method, progress.part(0, 0.7));
  if (!sequence) return failure(sequence.error());
  const auto judging_start = std::chrono::steady_clock::now();
  const auto quality = registration_quality::sirgn(*sequence, command.options, progress.part(0.7, 1));
  if (!quality) return failure(quality.error());
  const double judging_s = seconds_since(judging_start);

  const registration_quality::StoredQuality stored{command.sequence, std::string(name_of(command.method)),
                                                   command.options.tolerances_mm, *quality};
  const auto written = write_together([&] {
    return registration_quality::write_quality(command.out, stored).and_then([&]() -> Result<void> {
      if (!command.pictures) return {};
      const auto drawn = studies::write_heat_pictures(stored, std::filesystem::path(command.out) / "frames");
      return drawn ? Result<void>() : Result<void>(failure(drawn.error()));
    });
  });
  if (!written) return failure(written.error());
  return describe(*quality, command, sequence->frames.size(), files->simulated, seconds_since(start), judging_s);
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Outcome describe(const registration_quality::Quality& quality, const SirgnCommand& command, std::size_t frames,
                 const std::string& simulated, double time_s, double judging_s) {
  Outcome outcome{
      {{"landmarks", quality.mesh.points_mm.size()},
       {"frames", frames},
       {"triangles", quality.mesh.triangles.size()},
       {"judged_against", judged_against(quality)},
       {"mean_correlation", quality.mean_correlation},
       {"rejected", Json::object()},
       {"tre_mm", mean(quality.tre_mm)},
       {"tre_per_frame_mm", quality.tre_mm},
       {"rmse_per_frame_mm", quality.rmse_mm},
       {"notes", messages(quality.notes)},
       {"time_s", time_s},
       {"judging_s", judging_s},
       {"file", (std::filesystem::path(command.out) / "quality.vtp").string()}},
      fmt::format("{} landmarks, {} frames, {} triangles: mean correlation {:.3f}\n", quality.mesh.points_mm.size(),
                  frames, quality.mesh.triangles.size(), quality.mean_correlation)};
  if (!quality.rmse_mm.empty()) outcome.document["rmse_mm"] = mean(quality.rmse_mm);
  for (std::size_t i = 0; i < command.options.tolerances_mm.size(); ++i) {
    const std::string tolerance = fmt::format("{}", command.options.tolerances_mm[i]);
    outcome.document["rejected"][tolerance] = quality.rejected_fraction[i];
    outcome.text += fmt::format("  {:3.0f} % of the triangles are off by {} mm or more\n",
                                100 * quality.rejected_fraction[i], tolerance);
  }
  if (!simulated.empty()) {
    outcome.document["simulated"] = simulated;
    outcome.text += simulated + "\n";
  }
  outcome.text += bullet_list(messages(quality.notes));
  return outcome;
}

}  // namespace

void add_sirgn(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("sirgn", "Judge the registration of a video, triangle by triangle");
  auto settings = std::make_shared<SirgnCommand>();
  command->add_option("sequence", settings->sequence, "Sequence (JSON): frames, landmarks, model")->required();
  command
      ->add_option(
          "--method", settings->method,
          "given: the clouds that the sequence names as registered; icp, geo: register them to the model first; gnra: "
          "all frames at once, by the landmarks that are not the ones that judge")
      ->transform(one_of(
          Words<Method>{{"given", Method::given}, {"icp", Method::icp}, {"geo", Method::geo}, {"gnra", Method::gnra}}))
      ->required();
  command->add_option("--tolerance-mm", settings->options.tolerances_mm, "Errors from which a triangle is rejected")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--pictures", settings->pictures, "Draw the heat mesh over each frame, into frames/");
  command->add_option("--out", settings->out, "Folder for quality.vtp and sirgn.json")->required();
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli
