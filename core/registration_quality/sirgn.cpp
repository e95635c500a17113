#include "registration_quality/sirgn.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>

#include "base/parallel.h"
#include "geometry/delaunay.h"
#include "geometry/nearest.h"
#include "geometry/surface.h"
#include "registration_quality/internal/doubt.h"
#include "registration_quality/internal/frame_motion.h"
#include "registration_quality/internal/warp.h"

namespace glisson::registration_quality {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr double farthest_from_cloud = 0.5;  // of a landmark from a frame's points, as a fraction of their reach

// Landmarks as the registration puts them, and on the model.
struct Landmarks {
  std::vector<int> track;                                       // of the sequence
  std::vector<std::vector<std::optional<Vector3d>>> seen_mm;    // [landmark][frame], in the frame
  std::vector<std::vector<std::optional<Vector3d>>> placed_mm;  // the same in the model's space
  Points on_model_mm;
  int off_the_clouds = 0;  // left out
};

Result<void> check(const RegisteredSequence& sequence, const SirgnOptions& options);
Landmarks place_landmarks(const RegisteredSequence& sequence, const std::vector<FrameMotion>& frames, Quality& quality);
std::vector<std::array<int, 3>> triangulate(const Points& points_mm);
SharedCentreWarps fit_warps(const std::vector<FrameMotion>& frames, const SirgnOptions& options);
void rate_triangles(const Landmarks& landmarks, const SharedCentreWarps& warps,
                    const std::optional<BenchmarkWarps>& benchmark, const std::vector<FrameMotion>& frames,
                    Quality& quality);
void place_mesh(const SharedCentreWarps& warps, std::size_t frames, Quality& quality);
void rate_frames(const RegisteredSequence& sequence, const std::vector<FrameMotion>& frames, const Landmarks& landmarks,
                 Quality& quality);
void label(const SirgnOptions& options, Quality& quality);

}  // namespace

Result<Quality> sirgn(const RegisteredSequence& sequence, const SirgnOptions& options, const Progress& progress) {
  if (auto good = check(sequence, options); !good) return failure(good.error());
  std::vector<FrameMotion> frames;
  for (const RegisteredFrame& frame : sequence.frames) {
    frames.emplace_back(frame, static_cast<std::size_t>(options.maximum_cloud_points));
    if (frames.back().empty()) {
      return failure("sirgn-empty-frame", GLISSON_TEXT("Frame {0} holds no point that is finite."),
                     {std::to_string(frames.size() - 1)});
    }
    if (progress.cancelled()) return cancelled();
    progress.report(0.4 * static_cast<double>(frames.size()) / static_cast<double>(sequence.frames.size()),
                    GLISSON_TEXT("frames"));
  }

  Quality quality;
  quality.against_benchmark = sequence.benchmark.has_value();
  quality.notes = sequence.notes;
  const Landmarks landmarks = place_landmarks(sequence, frames, quality);
  quality.mesh.points_mm = landmarks.on_model_mm;
  quality.mesh.triangles = triangulate(landmarks.on_model_mm);
  if (landmarks.on_model_mm.size() < 4 || quality.mesh.triangles.empty()) {
    if (landmarks.off_the_clouds > 0) {
      return failure(Error{"sirgn-landmarks-off",
                           GLISSON_TEXT("Landmarks that lie far from the points of their frames: {0} of {1}."),
                           {std::to_string(landmarks.off_the_clouds), std::to_string(sequence.landmarks.size())},
                           GLISSON_TEXT("Check that tracks and clouds are both in mm of the left camera."),
                           {}});
    }
    return failure(Error{"sirgn-too-few-landmarks",
                         GLISSON_TEXT("Landmarks seen in three frames or more: {0}; four that do not lie on one line "
                                      "are needed."),
                         {std::to_string(landmarks.on_model_mm.size())},
                         GLISSON_TEXT("Track more features, or mark them by hand."),
                         {}});
  }
  progress.report(0.5, GLISSON_TEXT("warps"));
  const SharedCentreWarps warps = fit_warps(frames, options);
  if (progress.cancelled()) return cancelled();
  progress.report(0.7, GLISSON_TEXT("triangles"));
  rate_triangles(landmarks, warps, benchmark_warps(sequence, options), frames, quality);
  place_mesh(warps, frames.size(), quality);
  quality.doubt_mm = doubt_mm(quality, landmarks.placed_mm);
  rate_frames(sequence, frames, landmarks, quality);
  label(options, quality);
  if (!quality.against_benchmark) {
    quality.notes.push_back({GLISSON_TEXT("judged by its own landmarks, without a benchmark kept with the sequence: a "
                                          "fault that never changes is hardly seen"),
                             {}});
  }
  return quality;
}

namespace {

Result<void> check(const RegisteredSequence& sequence, const SirgnOptions& options) {
  if (sequence.frames.size() < fewest_frames) {
    return failure("sirgn-too-few-frames", GLISSON_TEXT("Too few frames to correlate: {0}; {1} are needed."),
                   {std::to_string(sequence.frames.size()), std::to_string(fewest_frames)});
  }
  for (std::size_t t = 0; t < sequence.frames.size(); ++t) {
    const auto& [cloud_mm, registered_mm] = sequence.frames[t];
    if (cloud_mm.size() != registered_mm.size()) {
      return failure("sirgn-not-point-for-point",
                     GLISSON_TEXT("Frame {0} has {1} points, and {2} after registration: they must match one by one."),
                     {std::to_string(t), std::to_string(cloud_mm.size()), std::to_string(registered_mm.size())});
    }
  }
  for (const LandmarkTrack& track : sequence.landmarks) {
    if (track.positions_mm.size() != sequence.frames.size()) {
      return failure("sirgn-tracks", GLISSON_TEXT("Landmark {0} was followed through {1} of {2} frames."),
                     {track.id, std::to_string(track.positions_mm.size()), std::to_string(sequence.frames.size())});
    }
  }
  if (const auto& benchmark = sequence.benchmark) {
    const auto tracks = sequence.landmarks.size(), frames = sequence.frames.size();
    const bool whole = benchmark->on_model_mm.size() == tracks && benchmark->in_frames_mm.size() == tracks &&
                       std::all_of(benchmark->in_frames_mm.begin(), benchmark->in_frames_mm.end(),
                                   [&](const auto& in_frames) { return in_frames.size() == frames; });
    if (!whole) {
      return failure("sirgn-tracks",
                     GLISSON_TEXT("The benchmark is not of this sequence, with its landmarks ({0}) and frames ({1})."),
                     {std::to_string(tracks), std::to_string(frames)});
    }
  }
  for (const double tolerance_mm : options.tolerances_mm) {
    if (!(tolerance_mm > 0) || !std::isfinite(tolerance_mm)) {
      return failure("sirgn-tolerance", GLISSON_TEXT("A tolerance must be a positive number of mm."));
    }
  }
  return {};
}

Landmarks place_landmarks(const RegisteredSequence& sequence, const std::vector<FrameMotion>& frames,
                          Quality& quality) {
  Landmarks landmarks;
  std::optional<geometry::SurfaceDistance> model;
  if (sequence.model) model.emplace(*sequence.model);
  int too_short = 0, without_place = 0;
  for (std::size_t track = 0; track < sequence.landmarks.size(); ++track) {
    std::vector<std::optional<Vector3d>> seen(frames.size()), placed(frames.size());
    Vector3d sum = Vector3d::Zero();
    int count = 0;
    std::vector<double> distances;
    for (std::size_t t = 0; t < frames.size(); ++t) {
      const auto& position = sequence.landmarks[track].positions_mm[t];
      if (!position || !position->allFinite()) continue;
      seen[t] = *position;
      placed[t] = frames[t].to_model(*position);
      sum += *placed[t];
      distances.push_back(frames[t].distance_from_cloud(*position));
      ++count;
    }
    if (count < fewest_frames) {
      ++too_short;
      continue;
    }
    // The median: a landmark that jumps now and then is judged, one that lies nowhere near the tissue says nothing.
    std::nth_element(distances.begin(), distances.begin() + count / 2, distances.end());
    if (distances[static_cast<std::size_t>(count / 2)] > farthest_from_cloud) {
      ++landmarks.off_the_clouds;
      continue;
    }
    std::optional<Vector3d> on_model;
    if (sequence.benchmark) {
      on_model = sequence.benchmark->on_model_mm[track];
      if (!on_model) {
        ++without_place;
        continue;
      }
    } else {
      on_model = model ? model->closest(sum / count).point_mm : Vector3d(sum / count);
    }
    landmarks.track.push_back(static_cast<int>(track));
    landmarks.seen_mm.push_back(std::move(seen));
    landmarks.placed_mm.push_back(std::move(placed));
    landmarks.on_model_mm.push_back(*on_model);
  }
  if (too_short > 0) {
    quality.notes.push_back({GLISSON_TEXT("Landmarks left out, which were seen in fewer than three frames: {0}"),
                             {std::to_string(too_short)}});
  }
  if (landmarks.off_the_clouds > 0) {
    quality.notes.push_back({GLISSON_TEXT("Landmarks left out, which lie far from the points of their frames: {0}"),
                             {std::to_string(landmarks.off_the_clouds)}});
  }
  if (without_place > 0) {
    quality.notes.push_back({GLISSON_TEXT("landmarks that the benchmark has no place for were left out: {0}"),
                             {std::to_string(without_place)}});
  }
  return landmarks;
}

// In the plane that the points lie along best: what a camera that looks at them squarely would see.
std::vector<std::array<int, 3>> triangulate(const Points& points_mm) {
  if (points_mm.size() < 3) return {};
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& point : points_mm) mean += point / static_cast<double>(points_mm.size());
  Eigen::Matrix3d spread_mm2 = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : points_mm) spread_mm2 += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread_mm2);  // ascending
  if (axes.eigenvalues()[1] <= 1e-9 * axes.eigenvalues()[2]) return {};
  std::vector<Eigen::Vector2d> flat;
  for (const Vector3d& point : points_mm)
    flat.emplace_back(axes.eigenvectors().rightCols<2>().transpose() * (point - mean));
  return geometry::delaunay_triangles(flat);
}

// Some of all that any frame was registered to.
Points registered_places(const std::vector<FrameMotion>& frames) {
  constexpr std::size_t maximum_places = 20000;
  std::size_t total = 0;
  for (const FrameMotion& frame : frames) total += frame.registered_mm().size();
  const std::size_t step = std::max<std::size_t>(1, total / maximum_places);
  Points places;
  for (const FrameMotion& frame : frames) {
    for (std::size_t i = 0; i < frame.registered_mm().size(); i += step) places.push_back(frame.registered_mm()[i]);
  }
  return places;
}

SharedCentreWarps fit_warps(const std::vector<FrameMotion>& frames, const SirgnOptions& options) {
  const Points places = registered_places(frames);
  Points centres;
  for (const std::size_t place : spread(places, options.control_points)) centres.push_back(places[place]);
  Eigen::MatrixXd displacements(static_cast<Eigen::Index>(centres.size()),
                                static_cast<Eigen::Index>(3 * frames.size()));
  parallel_for(frames.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (std::size_t centre = 0; centre < centres.size(); ++centre) {
        displacements.block<1, 3>(static_cast<Eigen::Index>(centre), static_cast<Eigen::Index>(3 * t)) =
            frames[t].displacement_to_frame(centres[centre]).transpose();
      }
    }
  });
  return SharedCentreWarps(std::move(centres), displacements, options.stiffness_mm);
}

constexpr int lattice_steps = 4;  // along each side: 15 places in a triangle

std::vector<Vector3d> lattice(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  std::vector<Vector3d> places;
  for (int i = 0; i <= lattice_steps; ++i) {
    for (int j = 0; i + j <= lattice_steps; ++j) {
      places.push_back((i * a + j * b + (lattice_steps - i - j) * c) / lattice_steps);
    }
  }
  return places;
}

// Normalised covariance of two series; where nothing moves they agree if neither does.
double correlation_of(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  constexpr double still_mm2 = 1e-12;
  const Eigen::VectorXd from_mean_a = a.array() - a.mean();
  const Eigen::VectorXd from_mean_b = b.array() - b.mean();
  const double variance_a = from_mean_a.squaredNorm(), variance_b = from_mean_b.squaredNorm();
  if (variance_a < still_mm2 || variance_b < still_mm2) return variance_a < still_mm2 && variance_b < still_mm2 ? 1 : 0;
  return from_mean_a.dot(from_mean_b) / std::sqrt(variance_a * variance_b);
}

// How far the registration displaces places on the model in some frames: a row a place, a column a frame; and of each
// frame the place that is warped most (2.3).
struct Displaced {
  Eigen::MatrixXd mm;
  std::vector<Eigen::Index> most;
};

Displaced displaced_by_benchmark(const std::vector<Vector3d>& places, const std::vector<Eigen::Index>& seen,
                                 const BenchmarkWarps& benchmark, const std::vector<FrameMotion>& frames) {
  const Eigen::MatrixXd to_frames = benchmark.warps.displacements_mm(places);
  Displaced displaced{Eigen::MatrixXd(to_frames.rows(), static_cast<Eigen::Index>(seen.size())), {}};
  for (Eigen::Index n = 0; n < displaced.mm.cols(); ++n) {
    const Eigen::Index t = seen[static_cast<std::size_t>(n)];
    double farthest_mm = -1;
    displaced.most.push_back(0);
    for (Eigen::Index place = 0; place < to_frames.rows(); ++place) {
      const Vector3d displacement = to_frames.block<1, 3>(place, 3 * t).transpose();
      const Vector3d in_frame = places[static_cast<std::size_t>(place)] + displacement;
      displaced.mm(place, n) = (in_frame - frames[static_cast<std::size_t>(t)].to_model(in_frame)).norm();
      if (displacement.norm() <= farthest_mm) continue;
      farthest_mm = displacement.norm();
      displaced.most.back() = place;
    }
  }
  return displaced;
}

Displaced displaced_by_itself(const std::vector<Vector3d>& places, const std::vector<Eigen::Index>& seen,
                              const SharedCentreWarps& warps) {
  const Eigen::MatrixXd to_frames = warps.displacements_mm(places);
  Displaced displaced{Eigen::MatrixXd(to_frames.rows(), static_cast<Eigen::Index>(seen.size())), {}};
  for (Eigen::Index n = 0; n < displaced.mm.cols(); ++n) {
    for (Eigen::Index place = 0; place < to_frames.rows(); ++place) {
      displaced.mm(place, n) = to_frames.block<1, 3>(place, 3 * seen[static_cast<std::size_t>(n)]).norm();
    }
    displaced.mm.col(n).maxCoeff(&displaced.most.emplace_back());
  }
  return displaced;
}

void rate_triangles(const Landmarks& landmarks, const SharedCentreWarps& warps,
                    const std::optional<BenchmarkWarps>& benchmark, const std::vector<FrameMotion>& motions,
                    Quality& quality) {
  const std::size_t frames = motions.size();
  const auto& triangles = quality.mesh.triangles;
  quality.correlation.assign(triangles.size(), 0);
  quality.error_mm.assign(triangles.size(), 0);
  quality.frames_seen.assign(triangles.size(), 0);
  const std::vector<double> unseen_mm(frames, std::numeric_limits<double>::quiet_NaN());
  quality.courses.assign(triangles.size(), {unseen_mm, unseen_mm, unseen_mm});
  parallel_for(triangles.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      std::array<std::size_t, 3> corners{};
      for (std::size_t c = 0; c < 3; ++c) corners[c] = static_cast<std::size_t>(triangles[k][c]);
      std::vector<Eigen::Index> seen;  // frames that hold all corners
      for (std::size_t t = 0; t < frames; ++t) {
        if (benchmark && !benchmark->holds[t]) continue;
        if (std::all_of(corners.begin(), corners.end(),
                        [&](std::size_t c) { return landmarks.seen_mm[c][t].has_value(); }))
          seen.push_back(static_cast<Eigen::Index>(t));
      }
      quality.frames_seen[k] = static_cast<int>(seen.size());
      const auto count = static_cast<Eigen::Index>(seen.size());

      // The corners: mean landmark distance vector (2.2), and how well they were registered.
      TriangleCourse& course = quality.courses[k];
      Eigen::VectorXd landmark_mm = Eigen::VectorXd::Zero(count);
      for (Eigen::Index n = 0; n < count; ++n) {
        const auto t = static_cast<std::size_t>(seen[static_cast<std::size_t>(n)]);
        double error_mm = 0;
        for (const std::size_t corner : corners) {
          const Vector3d& on_model = landmarks.on_model_mm[corner];
          landmark_mm[n] += (*landmarks.seen_mm[corner][t] - on_model).norm() / 3;
          error_mm += (*landmarks.placed_mm[corner][t] - on_model).norm() / 3;
        }
        quality.error_mm[k] += error_mm / static_cast<double>(count);
        course.landmarks_mm[t] = landmark_mm[n];
        course.error_mm[t] = error_mm;
      }
      if (count < fewest_frames) continue;

      // The inside: how far each place is displaced in each frame; the most heavily warped one speaks for it (2.3).
      const auto places = lattice(landmarks.on_model_mm[corners[0]], landmarks.on_model_mm[corners[1]],
                                  landmarks.on_model_mm[corners[2]]);
      const Displaced displaced = benchmark ? displaced_by_benchmark(places, seen, *benchmark, motions)
                                            : displaced_by_itself(places, seen, warps);
      Eigen::VectorXd correlations(displaced.mm.rows());
      for (Eigen::Index place = 0; place < displaced.mm.rows(); ++place) {
        correlations[place] = correlation_of(displaced.mm.row(place).transpose(), landmark_mm);
      }
      double sum = 0;
      for (Eigen::Index n = 0; n < count; ++n) {
        const auto frame = static_cast<std::size_t>(n);
        course.warp_mm[static_cast<std::size_t>(seen[frame])] = displaced.mm(displaced.most[frame], n);
        sum += correlations[displaced.most[frame]];
      }
      quality.correlation[k] = sum / static_cast<double>(count);
    }
  });
  double sum = 0;
  for (const double correlation : quality.correlation) sum += correlation;
  quality.mean_correlation = sum / static_cast<double>(triangles.size());
  const auto unseen = std::count_if(quality.frames_seen.begin(), quality.frames_seen.end(),
                                    [](int seen) { return seen < fewest_frames; });
  if (unseen > 0) {
    quality.notes.push_back(
        {GLISSON_TEXT("Triangles with all corners in fewer than three frames, whose correlation is 0: {0}"),
         {std::to_string(unseen)}});
  }
}

void place_mesh(const SharedCentreWarps& warps, std::size_t frames, Quality& quality) {
  const Eigen::MatrixXd displacements = warps.displacements_mm(quality.mesh.points_mm);
  quality.mesh_in_frames_mm.assign(frames, quality.mesh.points_mm);
  for (std::size_t t = 0; t < frames; ++t) {
    for (std::size_t i = 0; i < quality.mesh.points_mm.size(); ++i) {
      quality.mesh_in_frames_mm[t][i] +=
          displacements.block<1, 3>(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(3 * t)).transpose();
    }
  }
}

void rate_frames(const RegisteredSequence& sequence, const std::vector<FrameMotion>& frames, const Landmarks& landmarks,
                 Quality& quality) {
  for (std::size_t t = 0; t < frames.size(); ++t) {
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < landmarks.on_model_mm.size(); ++k) {
      if (!landmarks.placed_mm[k][t]) continue;
      sum += (*landmarks.placed_mm[k][t] - landmarks.on_model_mm[k]).norm();
      ++count;
    }
    quality.tre_mm.push_back(count > 0 ? sum / count : 0);
  }
  if (!sequence.model) {
    quality.notes.push_back({GLISSON_TEXT("no model was given, so there is no distance from it (RMSE)"), {}});
    return;
  }
  const geometry::SurfaceDistance model(*sequence.model);
  quality.rmse_mm.resize(frames.size());
  parallel_for(frames.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      double sum_mm2 = 0;
      for (const Vector3d& point : frames[t].registered_mm()) {
        const double distance_mm = model.closest(point).distance_mm;
        sum_mm2 += distance_mm * distance_mm;
      }
      quality.rmse_mm[t] = std::sqrt(sum_mm2 / static_cast<double>(frames[t].registered_mm().size()));
    }
  });
}

void label(const SirgnOptions& options, Quality& quality) {
  geometry::set_field(quality.mesh.cell_fields, {"correlation", 1, quality.correlation});
  geometry::set_field(quality.mesh.cell_fields, {"error_mm", 1, quality.error_mm});
  geometry::set_field(quality.mesh.cell_fields, {"doubt_mm", 1, quality.doubt_mm});
  geometry::set_field(quality.mesh.cell_fields,
                      {"frames", 1, {quality.frames_seen.begin(), quality.frames_seen.end()}});
  for (const double tolerance_mm : options.tolerances_mm) {
    std::vector<double> accepted;
    for (const double error_mm : quality.error_mm) accepted.push_back(error_mm < tolerance_mm ? 1 : 0);
    const auto rejected = static_cast<double>(std::count(accepted.begin(), accepted.end(), 0.0));
    quality.rejected_fraction.push_back(rejected / static_cast<double>(accepted.size()));
    geometry::set_field(quality.mesh.cell_fields, {fmt::format("accepted_{}", tolerance_mm), 1, std::move(accepted)});
  }
}

}  // namespace
}  // namespace glisson::registration_quality
