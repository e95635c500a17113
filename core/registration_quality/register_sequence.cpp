#include "registration_quality/register_sequence.h"

#include "geometry/mesh_file.h"
#include "registration/global_alignment.h"
#include "registration/register.h"

namespace glisson::registration_quality {
namespace {

Result<void> check(const SequenceFiles& files, SequenceMethod method);
Result<std::vector<Eigen::Vector3d>> moved_to_model(const geometry::Surface& cloud, const geometry::Surface& model,
                                                    SequenceMethod method, const Progress& progress);
Result<void> align_all(RegisteredSequence& sequence, const Progress& progress);

}  // namespace

std::string_view name_of(SequenceMethod method) {
  switch (method) {
    case SequenceMethod::given: return "given";
    case SequenceMethod::icp: return "icp";
    case SequenceMethod::geo: return "geo";
    case SequenceMethod::gnra: return "gnra";
  }
  return {};
}

Result<RegisteredSequence> register_sequence(const SequenceFiles& files, SequenceMethod method,
                                             const Progress& progress) {
  if (auto possible = check(files, method); !possible) return failure(possible.error());
  RegisteredSequence sequence;
  sequence.landmarks = files.landmarks;
  if (files.model) {
    auto model = geometry::read_surface(*files.model);
    if (!model) return failure(model.error());
    sequence.model = std::move(*model);
  }
  const auto frames = static_cast<double>(files.clouds.size());
  for (std::size_t t = 0; t < files.clouds.size(); ++t) {
    if (progress.cancelled()) return cancelled();
    auto cloud = read_cloud(files.clouds[t]);
    if (!cloud) return failure(cloud.error());
    RegisteredFrame frame;
    if (method == SequenceMethod::given) {
      auto moved = read_cloud(files.registered[t]);
      if (!moved) return failure(moved.error());
      frame.registered_mm = std::move(moved->points_mm);
    } else if (method != SequenceMethod::gnra) {
      const auto part = progress.part(static_cast<double>(t) / frames, static_cast<double>(t + 1) / frames);
      auto moved = moved_to_model(*cloud, *sequence.model, method, part);
      if (!moved) return failure(std::move(moved.error()).in_file(files.clouds[t]));
      frame.registered_mm = std::move(*moved);
    }
    frame.cloud_mm = std::move(cloud->points_mm);
    sequence.frames.push_back(std::move(frame));
  }
  if (progress.cancelled()) return cancelled();
  if (method == SequenceMethod::gnra) {
    if (auto aligned = align_all(sequence, progress); !aligned) return failure(aligned.error());
  }
  return sequence;
}

namespace {

Result<void> check(const SequenceFiles& files, SequenceMethod method) {
  if (method == SequenceMethod::given && files.registered.empty()) {
    return failure(Error{"sequence-not-registered",
                         GLISSON_TEXT("The sequence names no registered clouds."),
                         {},
                         GLISSON_TEXT("Add \"registered\", or choose --method icp or geo."),
                         {}});
  }
  if ((method == SequenceMethod::icp || method == SequenceMethod::geo) && !files.model) {
    return failure(Error{"sequence-no-model",
                         GLISSON_TEXT("The sequence names no model to register its clouds to."),
                         {},
                         GLISSON_TEXT("Add \"model\": a surface file."),
                         {}});
  }
  return {};
}

Result<std::vector<Eigen::Vector3d>> moved_to_model(const geometry::Surface& cloud, const geometry::Surface& model,
                                                    SequenceMethod method, const Progress& progress) {
  registration::RegisterOptions options;
  options.method = method == SequenceMethod::geo ? registration::Method::geo : registration::Method::icp;
  options.geo.prior = registration::Prior::positions;  // model and frames lie in the camera's space
  auto moved = registration::register_surfaces(cloud, model, options, progress);
  if (!moved) return failure(std::move(moved.error()));
  return std::move(moved->surface.points_mm);
}

Result<void> align_all(RegisteredSequence& sequence, const Progress& progress) {
  registration::Sightings sightings;
  for (const LandmarkTrack& track : sequence.landmarks) sightings.push_back(track.positions_mm);
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

}  // namespace
}  // namespace glisson::registration_quality
