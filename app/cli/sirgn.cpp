// glisson-cli sirgn SEQUENCE.json: how good a registration of a video is, triangle by triangle.

#include "quality/sirgn.h"

#include <fmt/format.h>
#include <chrono>
#include <numeric>

#include "command.h"
#include "geometry/mesh_file.h"
#include "one_of.h"
#include "quality/quality_file.h"
#include "quality/sequence_file.h"
#include "registration/global_alignment.h"
#include "registration/register.h"
#include "shared_options.h"
#include "study/review.h"

namespace glisson::cli {
namespace {

enum class Method { given, icp, geo, gnra };
constexpr const char* method_names[] = {"given", "icp", "geo", "gnra"};

struct SirgnCommand {
  std::string sequence, out;
  Method method = Method::given;
  quality::SirgnOptions options;
  bool pictures = false;
};

Result<quality::RegisteredSequence> registered(const quality::SequenceFiles& files, Method method,
                                               const Progress& progress);
Result<void> align_all(quality::RegisteredSequence& sequence, const Progress& progress);
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

  const quality::StoredQuality stored{command.sequence, method_names[static_cast<int>(command.method)],
                                      command.options.tolerances_mm, *quality};
  if (auto written = quality::write_quality(command.out, stored); !written) return failure(written.error());
  if (command.pictures) {
    const auto drawn = study::write_heat_pictures(stored, std::filesystem::path(command.out) / "frames");
    if (!drawn) return failure(drawn.error());
  }
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
  if ((method == Method::icp || method == Method::geo) && !sequence.model) {
    return failure(Error{"sequence-no-model",
                         GLISSON_TEXT("The sequence names no model to register its clouds to."),
                         {},
                         GLISSON_TEXT("Add \"model\": a surface file."),
                         {}});
  }
  registration::RegisterOptions options;
  options.method = method == Method::geo ? registration::Method::geo : registration::Method::icp;
  options.geo.prior = registration::Prior::positions;  // model and frames lie in the camera's space
  const auto frames = static_cast<double>(files.clouds.size());
  for (std::size_t t = 0; t < files.clouds.size(); ++t) {
    auto cloud = quality::read_cloud(files.clouds[t]);
    if (!cloud) return failure(cloud.error());
    quality::RegisteredFrame frame;
    if (method == Method::given) {
      auto moved = quality::read_cloud(files.registered[t]);
      if (!moved) return failure(moved.error());
      frame.registered_mm = std::move(moved->points_mm);
    } else if (method != Method::gnra) {
      const auto part = progress.part(static_cast<double>(t) / frames, static_cast<double>(t + 1) / frames);
      auto moved = registration::register_surfaces(*cloud, *sequence.model, options, part);
      if (!moved) return failure(std::move(moved.error()).in_file(files.clouds[t]));
      frame.registered_mm = std::move(moved->surface.points_mm);
    }
    frame.cloud_mm = std::move(cloud->points_mm);
    sequence.frames.push_back(std::move(frame));
    if (progress.cancelled()) return cancelled();
  }
  if (method == Method::gnra) {
    if (auto aligned = align_all(sequence, progress); !aligned) return failure(aligned.error());
  }
  return sequence;
}

// Registered by the benchmark itself: all frames to one model by the landmarks.
Result<void> align_all(quality::RegisteredSequence& sequence, const Progress& progress) {
  registration::Sightings sightings;
  for (const quality::LandmarkTrack& track : sequence.landmarks) sightings.push_back(track.positions_mm);
  const auto alignment = registration::align_globally(sightings, {}, progress);
  if (!alignment) return failure(alignment.error());
  for (std::size_t t = 0; t < sequence.frames.size(); ++t) {
    if (!alignment->frames[t]) {
      return failure("sequence-frame-not-aligned", GLISSON_TEXT("Frame {0} shares too few landmarks with the others."),
                     {std::to_string(t)});
    }
    for (const Eigen::Vector3d& point : sequence.frames[t].cloud_mm) {
      sequence.frames[t].registered_mm.push_back(alignment->frames[t]->warp(point));
    }
  }
  return {};
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
          "given: the clouds that the sequence names as registered; icp, geo: register them to the model first; gnra: "
          "all frames at once, by the landmarks")
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
