// glisson-cli sirgn SEQUENCE.json: how good a registration of a video is, triangle by triangle.

#include "quality/sirgn.h"

#include <fmt/format.h>
#include <chrono>
#include <numeric>

#include "command.h"
#include "geometry/mesh_file.h"
#include "quality/sequence_file.h"
#include "registration/register.h"
#include "shared_options.h"

namespace glisson::cli {
namespace {

enum class Method { given, icp, geo };

struct SirgnCommand {
  std::string sequence, out;
  Method method = Method::given;
  quality::SirgnOptions options;
};

Result<quality::RegisteredSequence> registered(const quality::SequenceFiles& files, Method method,
                                               const Progress& progress);
Outcome describe(const quality::Quality& quality, const SirgnCommand& command, std::size_t frames, double time_s,
                 double judging_s);

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Result<Outcome> run(const SirgnCommand& command, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto files = quality::read_sequence(command.sequence);
  if (!files) return failure(files.error());
  const auto sequence = registered(*files, command.method, progress.part(0, 0.7));
  if (!sequence) return failure(sequence.error());
  const auto judging_start = std::chrono::steady_clock::now();
  const auto quality = quality::sirgn(*sequence, command.options, progress.part(0.7, 1));
  if (!quality) return failure(quality.error());
  const double judging_s = seconds_since(judging_start);

  std::error_code problem;
  std::filesystem::create_directories(command.out, problem);
  if (problem) {
    return failure("folder-not-made", GLISSON_TEXT("The folder {0} cannot be made: {1}."),
                   {command.out, problem.message()});
  }
  const auto mesh_file = std::filesystem::path(command.out) / "quality.vtp";
  if (auto written = geometry::write_surface(mesh_file, quality->mesh); !written) return failure(written.error());
  return describe(*quality, command, sequence->frames.size(), seconds_since(start), judging_s);
}

Result<quality::RegisteredSequence> registered(const quality::SequenceFiles& files, Method method,
                                               const Progress& progress) {
  quality::RegisteredSequence sequence;
  sequence.landmarks = files.landmarks;
  if (files.model) {
    auto model = geometry::read_surface(*files.model);
    if (!model) return failure(model.error());
    sequence.model = std::move(*model);
  }
  if (method == Method::given && files.registered.empty()) {
    return failure(Error{"sequence-not-registered",
                         GLISSON_TEXT("The sequence names no registered clouds."),
                         {},
                         GLISSON_TEXT("Add \"registered\", or choose --method icp or geo."),
                         {}});
  }
  if (method != Method::given && !sequence.model) {
    return failure(Error{"sequence-no-model",
                         GLISSON_TEXT("The sequence names no model to register its clouds to."),
                         {},
                         GLISSON_TEXT("Add \"model\": a surface file."),
                         {}});
  }
  registration::RegisterOptions options;
  options.method = method == Method::geo ? registration::Method::geo : registration::Method::icp;
  const auto frames = static_cast<double>(files.clouds.size());
  for (std::size_t t = 0; t < files.clouds.size(); ++t) {
    auto cloud = quality::read_cloud(files.clouds[t]);
    if (!cloud) return failure(cloud.error());
    quality::RegisteredFrame frame;
    if (method == Method::given) {
      auto moved = quality::read_cloud(files.registered[t]);
      if (!moved) return failure(moved.error());
      frame.registered_mm = std::move(moved->points_mm);
    } else {
      const auto part = progress.part(static_cast<double>(t) / frames, static_cast<double>(t + 1) / frames);
      auto moved = registration::register_surfaces(*cloud, *sequence.model, options, part);
      if (!moved) return failure(std::move(moved.error()).in_file(files.clouds[t]));
      frame.registered_mm = std::move(moved->surface.points_mm);
    }
    frame.cloud_mm = std::move(cloud->points_mm);
    sequence.frames.push_back(std::move(frame));
    if (progress.cancelled()) return cancelled();
  }
  return sequence;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Outcome describe(const quality::Quality& quality, const SirgnCommand& command, std::size_t frames, double time_s,
                 double judging_s) {
  Outcome outcome{
      {{"landmarks", quality.mesh.points_mm.size()},
       {"frames", frames},
       {"triangles", quality.mesh.triangles.size()},
       {"mean_correlation", quality.mean_correlation},
       {"rejected", Json::object()},
       {"tre_mm", mean(quality.tre_mm)},
       {"tre_per_frame_mm", quality.tre_mm},
       {"rmse_per_frame_mm", quality.rmse_mm},
       {"notes", quality.notes},
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
  outcome.text += bullet_list(quality.notes);
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
          "given: the clouds that the sequence names as registered; icp, geo: register them to the model first")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Method>{{"given", Method::given}, {"icp", Method::icp}, {"geo", Method::geo}}))
      ->required();
  command->add_option("--tolerance-mm", settings->options.tolerances_mm, "Errors from which a triangle is rejected")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--out", settings->out, "Folder for quality.vtp")->required();
  command->callback(
      [&chosen, settings] { chosen = [settings](const Progress& progress) { return run(*settings, progress); }; });
}

}  // namespace glisson::cli
