#include "registration_quality/video_sequence.h"

#include <fmt/format.h>

#include "base/files.h"
#include "base/json.h"
#include "geometry/manifold.h"
#include "geometry/mesh_file.h"
#include "registration/global_alignment.h"
#include "registration_quality/benchmark.h"
#include "registration_quality/sequence_file.h"
#include "registration_quality/sirgn.h"
#include "vision/picture_check.h"

namespace glisson::registration_quality {
namespace {

namespace fs = std::filesystem;

constexpr auto benchmark_name = "benchmark.csv";

// The frames as they come, written one by one.
class Recording {
 public:
  Recording(const vision::StereoCalibration& calibration, const fs::path& folder, const VideoSequenceOptions& options,
            const FrameMatched& matched)
      : calibration_(calibration),
        folder_(folder),
        options_(options),
        matched_(matched),
        tracker_(calibration, options.tracks) {}

  Result<void> add(const vision::StereoPair& pair, int number);
  Result<VideoSequence> finish(const Progress& progress);

 private:
  Result<void> begin(const vision::StereoPair& first);
  Result<void> write_landmarks(const std::vector<vision::Track>& tracks);
  Result<geometry::Surface> aligned_model(const std::vector<vision::Track>& tracks, const Progress& progress);

  const vision::StereoCalibration& calibration_;
  const fs::path& folder_;
  const VideoSequenceOptions& options_;
  const FrameMatched& matched_;
  std::optional<vision::StereoMatcher> matcher_;
  vision::LandmarkTracker tracker_;
  std::vector<geometry::Surface> surfaces_;
  Json frames_ = Json::array();
  bool has_benchmark_ = false;
  VideoSequence sequence_;
};

Result<VideoSequence> record(vision::StereoSource& video, Recording recording, const VideoSequenceOptions& options,
                             const Progress& progress);

}  // namespace

Result<VideoSequence> make_sequence(vision::StereoSource& video, const vision::StereoCalibration& calibration,
                                    const fs::path& folder, const VideoSequenceOptions& options,
                                    const Progress& progress, const FrameMatched& matched) {
  auto made = NewSequenceFolder::make(folder);
  if (!made) return failure(made.error());
  auto sequence = record(video, Recording(calibration, made->beside(), options, matched), options, progress);
  if (!sequence) return sequence;
  if (progress.cancelled()) return cancelled();
  if (auto kept = made->keep(); !kept) return failure(kept.error());
  sequence->file = folder / sequence->file.filename();
  return sequence;
}

namespace {

Result<VideoSequence> record(vision::StereoSource& video, Recording recording, const VideoSequenceOptions& options,
                             const Progress& progress) {
  if (auto enough = video.has(options.needed()); !enough) return failure(enough.error());
  const int to_come = std::max(1, video.count().value_or(1 << 30) - options.skip);
  const double expected = std::min(options.maximum_frames, (to_come - 1) / options.every + 1);
  for (int number = 0, taken = 0; taken < options.maximum_frames; ++number) {
    if (progress.cancelled()) return cancelled();
    const auto pair = video.next();
    if (!pair) return failure(pair.error());
    if (!*pair) break;
    if (number < options.skip || (number - options.skip) % options.every != 0) continue;
    if (auto added = recording.add(**pair, number); !added) return failure(added.error());
    progress.report(std::min(0.8, 0.8 * ++taken / expected), GLISSON_TEXT("frames"));
  }
  return recording.finish(progress.part(0.8, 1));
}

Result<void> Recording::begin(const vision::StereoPair& first) {
  const int width = first.left.width, height = first.left.height;
  auto matcher = vision::StereoMatcher::prepare(calibration_, width, height, options_.stereo);
  if (!matcher) return failure(matcher.error());
  matcher_ = std::move(*matcher);
  const auto check = vision::check_against_pictures(calibration_, first.left, first.right);
  if (!check) return failure(check.error());
  sequence_.epipolar_px = check->epipolar_px;
  if (!vision::may_be_of_size(calibration_, width, height)) {
    sequence_.notes.push_back(
        fmt::format("the calibration's principal point lies far from the middle of {} x {} pixels: is it of this size?",
                    width, height));
  }
  return {};
}

Result<void> Recording::add(const vision::StereoPair& pair, int number) {
  const auto& [left, right] = pair;
  if (!matcher_) {
    if (auto begun = begin(pair); !begun) return begun;
  }
  auto cloud = matcher_->cloud(left, right);
  if (!cloud) return failure(cloud.error());
  geometry::Surface seen;
  seen.points_mm = cloud->points_mm;
  seen.triangles = cloud->triangles;
  seen = geometry::largest_manifold_piece(seen);
  constexpr std::size_t fewest_triangles = 200;
  if (seen.triangles.size() < fewest_triangles) {
    sequence_.notes.push_back(fmt::format("frame {} of the video shows hardly anything in depth: left out", number));
    ++sequence_.left_out;
    return {};
  }
  if (auto added = tracker_.add(left, right); !added) return failure(added.error());
  if (matched_) matched_({number, *cloud, tracker_.followed()});
  const std::string name = fmt::format("f{:03}", frames_.size());
  if (auto written = vision::write_frame(left, folder_ / (name + ".png")); !written) return failure(written.error());
  if (auto written = geometry::write_surface(folder_ / (name + ".ply"), seen); !written) {
    return failure(written.error());
  }
  frames_.push_back({{"image", name + ".png"}, {"cloud", name + ".ply"}});
  sequence_.mean_points += static_cast<double>(seen.points_mm.size());
  sequence_.mean_valid_fraction += cloud->valid_fraction;
  surfaces_.push_back(std::move(seen));
  return {};
}

Result<VideoSequence> Recording::finish(const Progress& progress) {
  if (sequence_.frames = static_cast<int>(frames_.size()); sequence_.frames < fewest_frames) {
    return failure("sequence-too-few-frames", GLISSON_TEXT("Frames that show something: {0}; {1} are needed."),
                   {std::to_string(sequence_.frames), std::to_string(fewest_frames)});
  }
  const auto frames = static_cast<double>(frames_.size());
  sequence_.mean_points /= frames;
  sequence_.mean_valid_fraction /= frames;
  const auto tracks = tracker_.tracks();
  if (auto written = write_landmarks(tracks); !written) return failure(written.error());
  geometry::Surface model;
  if (options_.model) {
    auto given = geometry::read_surface(*options_.model);
    if (!given) return failure(given.error());
    model = std::move(*given);
    sequence_.notes.push_back("the model was given: registrations are judged without a benchmark");
  } else {
    auto aligned = aligned_model(tracks, progress);
    if (!aligned) return failure(aligned.error());
    model = std::move(*aligned);
  }
  if (auto written = geometry::write_surface(folder_ / "model.ply", model); !written) return failure(written.error());

  Json matrix = Json::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    matrix.push_back(
        std::vector<double>(calibration_.left.matrix.row(row).begin(), calibration_.left.matrix.row(row).end()));
  }
  Json document{{"frames", frames_},
                {"landmarks", "tracks.csv"},
                {"model", "model.ply"},
                {"camera", {{"matrix", matrix}, {"distortion", calibration_.left.distortion}}}};
  if (has_benchmark_) document["benchmark"] = benchmark_name;
  if (!calibration_.simulated.empty()) document["simulated"] = calibration_.simulated;
  if (auto written = vision::write_stereo_calibration(folder_ / "camera.json", calibration_); !written) {
    return failure(written.error());
  }
  sequence_.file = folder_ / "sequence.json";
  if (auto written = write_json_file(sequence_.file, document); !written) return failure(written.error());
  return std::move(sequence_);
}

Result<void> Recording::write_landmarks(const std::vector<vision::Track>& tracks) {
  if (options_.landmarks) {
    const auto text = read_text_file(*options_.landmarks);
    if (!text) return failure(text.error());
    sequence_.notes.push_back("landmarks: " + options_.landmarks->string());
    return write_text_file(folder_ / "tracks.csv", *text);
  }
  std::string csv = "landmark,frame,x_mm,y_mm,z_mm\n";
  for (const vision::Track& track : tracks) {
    for (std::size_t t = 0; t < track.positions_mm.size(); ++t) {
      if (const auto& at = track.positions_mm[t]) {
        csv += fmt::format("{},{},{:.4f},{:.4f},{:.4f}\n", track.id, t, at->x(), at->y(), at->z());
      }
    }
  }
  sequence_.landmarks = static_cast<int>(tracks.size());
  return write_text_file(folder_ / "tracks.csv", csv);
}

Result<geometry::Surface> Recording::aligned_model(const std::vector<vision::Track>& tracks, const Progress& progress) {
  if (tracks.empty()) {
    return failure(Error{"sequence-no-landmarks",
                         GLISSON_TEXT("No feature could be followed through {0} frames."),
                         {std::to_string(options_.tracks.shortest_track)},
                         GLISSON_TEXT("Take more frames, or give landmarks and a model of your own."),
                         {}});
  }
  registration::Sightings sightings;
  for (const vision::Track& track : tracks) sightings.push_back(track.positions_mm);
  const auto alignment = registration::align_globally(sightings, {}, progress);
  if (!alignment) return failure(alignment.error());
  sequence_.alignment_rms_mm = {alignment->before_rms_mm, alignment->rigid_rms_mm, alignment->rms_mm};
  sequence_.notes.insert(sequence_.notes.end(), alignment->notes.begin(), alignment->notes.end());
  if (options_.landmarks) {
    sequence_.notes.push_back("the expert's landmarks were not aligned: registrations are judged without a benchmark");
  } else {
    std::vector<LandmarkTrack> landmarks;
    for (const vision::Track& track : tracks) landmarks.push_back({track.id, track.positions_mm});
    if (auto written = write_benchmark(folder_ / benchmark_name, landmarks, benchmark_of(*alignment)); !written) {
      return failure(written.error());
    }
    has_benchmark_ = true;
  }
  return registration::merged_model(surfaces_, *alignment);
}

}  // namespace
}  // namespace glisson::registration_quality
