#include "registration_quality/register_sequence.h"

#include "geometry/mesh_file.h"
#include "geometry/nearest.h"
#include "registration/global_alignment.h"
#include "registration/register.h"
#include "registration/rigid.h"

namespace glisson::registration_quality {
namespace {

Result<void> check(const SequenceFiles& files, SequenceMethod method);
// Moves frame after frame to the model.
class ToModel {
 public:
  static Result<ToModel> create(const geometry::Surface& model, SequenceMethod method, const Progress& progress);
  Result<std::vector<Eigen::Vector3d>> operator()(const geometry::Surface& cloud, const Progress& progress);

 private:
  explicit ToModel(const geometry::Surface& model) : model_(&model) {}
  const geometry::Surface* model_;
  std::optional<registration::FrameMatcher> by_geo_;
};

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
  if (method != SequenceMethod::gnra) sequence.benchmark = files.benchmark;
  if (files.model) {
    auto model = geometry::read_surface(*files.model);
    if (!model) return failure(model.error());
    sequence.model = std::move(*model);
  }
  std::optional<ToModel> to_model;
  if (method == SequenceMethod::icp || method == SequenceMethod::geo) {
    auto made = ToModel::create(*sequence.model, method, progress.part(0, 0));
    if (!made) return failure(std::move(made.error()).in_file(*files.model));
    to_model = std::move(*made);
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
    } else if (to_model) {
      const auto part = progress.part(static_cast<double>(t) / frames, static_cast<double>(t + 1) / frames);
      auto moved = (*to_model)(*cloud, part);
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

Result<ToModel> ToModel::create(const geometry::Surface& model, SequenceMethod method, const Progress& progress) {
  ToModel to_model(model);
  if (method == SequenceMethod::geo) {
    registration::GeoOptions options;
    options.prior = registration::Prior::positions;  // model and frames lie in the camera's space
    auto matcher = registration::FrameMatcher::create(model, options, progress);
    if (!matcher) return failure(std::move(matcher.error()));
    to_model.by_geo_ = std::move(*matcher);
  }
  return to_model;
}

Result<std::vector<Eigen::Vector3d>> ToModel::operator()(const geometry::Surface& cloud, const Progress& progress) {
  auto moved =
      by_geo_ ? by_geo_->match(cloud, progress.part(0, 0.3)).and_then([&](const registration::SurfaceMatch& match) {
        return registration::register_by_matches(cloud, *model_, match, {}, progress.part(0.3, 1));
      })
              : registration::register_surfaces(cloud, *model_, {}, progress);
  if (!moved) return failure(std::move(moved.error()));
  return std::move(moved->surface.points_mm);
}

constexpr std::size_t folds = 5;

// Alignments that each leave out the landmarks of one fold, all in the space of the one of all landmarks.
struct HeldOut {
  registration::GlobalAlignment alignment;
  Eigen::Isometry3d to_common = Eigen::Isometry3d::Identity();

  [[nodiscard]] std::optional<Eigen::Vector3d> moved(std::size_t frame, const Eigen::Vector3d& point_mm) const {
    const auto& its = alignment.frames[frame];
    return its ? std::optional<Eigen::Vector3d>(to_common * its->warp(point_mm)) : std::nullopt;
  }
};

Result<HeldOut> align_without(std::size_t fold, registration::Sightings sightings,
                              const registration::GlobalAlignment& all, const Progress& progress) {
  for (std::size_t k = fold; k < sightings.size(); k += folds) {
    sightings[k].assign(sightings[k].size(), std::nullopt);
  }
  auto alignment = registration::align_globally(sightings, {}, progress);
  if (!alignment) return failure(alignment.error());
  std::vector<Eigen::Vector3d> from_mm, to_mm;
  for (std::size_t k = 0; k < sightings.size(); ++k) {
    if (!alignment->landmarks_mm[k] || !all.landmarks_mm[k]) continue;
    from_mm.push_back(*alignment->landmarks_mm[k]);
    to_mm.push_back(*all.landmarks_mm[k]);
  }
  const auto to_common = registration::align_points(from_mm, to_mm);
  if (!to_common) return failure(to_common.error());
  return HeldOut{std::move(*alignment), *to_common};
}

// Every point of a frame by the alignment that leaves out the landmark seen next to it.
Result<void> align_all(RegisteredSequence& sequence, const Progress& progress) {
  registration::Sightings sightings;
  for (const LandmarkTrack& track : sequence.landmarks) sightings.push_back(track.positions_mm);
  const auto all = registration::align_globally(sightings, {}, progress.part(0, 0.2));
  if (!all) return failure(all.error());
  std::vector<HeldOut> held_out;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    const double begin = 0.2 + 0.16 * static_cast<double>(fold);
    auto without = align_without(fold, sightings, *all, progress.part(begin, begin + 0.16));
    if (!without) return failure(without.error());
    held_out.push_back(std::move(*without));
  }
  for (std::size_t t = 0; t < sequence.frames.size(); ++t) {
    std::vector<Eigen::Vector3d> seen_mm;
    std::vector<std::size_t> fold_of;
    for (std::size_t k = 0; k < sightings.size(); ++k) {
      if (!sightings[k][t] || !sightings[k][t]->allFinite()) continue;
      seen_mm.push_back(*sightings[k][t]);
      fold_of.push_back(k % folds);
    }
    const auto unaligned = [&] {
      return failure("sequence-frame-not-aligned", GLISSON_TEXT("Frame {0} shares too few landmarks with the others."),
                     {std::to_string(t)});
    };
    if (seen_mm.empty()) return unaligned();
    const geometry::NearestPoint nearest(seen_mm);
    for (const Eigen::Vector3d& point : sequence.frames[t].cloud_mm) {
      const std::size_t fold = point.allFinite() ? fold_of[static_cast<std::size_t>(nearest.nearest(point).point)] : 0;
      const auto moved = held_out[fold].moved(t, point);
      if (!moved) return unaligned();
      sequence.frames[t].registered_mm.push_back(*moved);
    }
  }
  sequence.notes.push_back(
      {GLISSON_TEXT("each point was aligned without a fifth of the landmarks, the one nearest to it "
                    "among them"),
       {}});
  return {};
}

}  // namespace
}  // namespace glisson::registration_quality
