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
#include "registration_quality/internal/warp.h"

namespace glisson::registration_quality {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr double farthest_from_cloud = 0.5;  // of a landmark from a frame's points, as a fraction of their reach

// A frame's finite point pairs, asked which way its points went.
class FrameMotion {
 public:
  FrameMotion(const RegisteredFrame& frame, std::size_t maximum_points);

  [[nodiscard]] bool empty() const { return cloud_mm_.empty(); }
  [[nodiscard]] const Points& registered_mm() const { return registered_mm_; }
  // Where the registration puts a place of the frame, by the pairs around it.
  [[nodiscard]] Vector3d to_model(const Vector3d& place_mm) const {
    return place_mm + mean_displacement(*from_cloud_, place_mm, 1);
  }
  // How a place in the model's space is displaced to lie in the frame.
  [[nodiscard]] Vector3d displacement_to_frame(const Vector3d& place_mm) const {
    return mean_displacement(*from_registered_, place_mm, -1);
  }
  // How far a place lies from the frame's points, as a fraction of how far these reach (diagonal of their box).
  [[nodiscard]] double distance_from_cloud(const Vector3d& place_mm) const {
    return std::sqrt(from_cloud_->nearest(place_mm).squared_distance_mm2) / reach_mm_;
  }
  [[nodiscard]] double distance_to_registered_mm(const Vector3d& place_mm) const {
    return std::sqrt(from_registered_->nearest(place_mm).squared_distance_mm2);
  }

 private:
  [[nodiscard]] Vector3d mean_displacement(const geometry::NearestPoint& tree, const Vector3d& place_mm,
                                           double sign) const;

  Points cloud_mm_, registered_mm_;
  double reach_mm_ = 0;
  std::optional<geometry::NearestPoint> from_cloud_, from_registered_;
};

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
Points spread(const std::vector<FrameMotion>& frames, int count);
SharedCentreWarps fit_warps(const std::vector<FrameMotion>& frames, const SirgnOptions& options);
void rate_triangles(const Landmarks& landmarks, const SharedCentreWarps& warps, std::size_t frames, Quality& quality);
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
  rate_triangles(landmarks, warps, frames.size(), quality);
  place_mesh(warps, frames.size(), quality);
  quality.doubt_mm = doubt_mm(quality, landmarks.placed_mm);
  rate_frames(sequence, frames, landmarks, quality);
  label(options, quality);
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
  for (const double tolerance_mm : options.tolerances_mm) {
    if (!(tolerance_mm > 0) || !std::isfinite(tolerance_mm)) {
      return failure("sirgn-tolerance", GLISSON_TEXT("A tolerance must be a positive number of mm."));
    }
  }
  return {};
}

FrameMotion::FrameMotion(const RegisteredFrame& frame, std::size_t maximum_points) {
  const std::size_t step = std::max<std::size_t>(1, frame.cloud_mm.size() / maximum_points);
  for (std::size_t i = 0; i < frame.cloud_mm.size(); i += step) {
    if (!frame.cloud_mm[i].allFinite() || !frame.registered_mm[i].allFinite()) continue;
    cloud_mm_.push_back(frame.cloud_mm[i]);
    registered_mm_.push_back(frame.registered_mm[i]);
  }
  if (cloud_mm_.empty()) return;
  reach_mm_ = std::max(geometry::bounding_box(cloud_mm_).diagonal_mm(), std::numeric_limits<double>::min());
  from_cloud_.emplace(cloud_mm_);
  from_registered_.emplace(registered_mm_);
}

Vector3d FrameMotion::mean_displacement(const geometry::NearestPoint& tree, const Vector3d& place_mm,
                                        double sign) const {
  constexpr int neighbours = 4;
  constexpr double smallest_mm2 = 1e-6;  // nearer than this is there
  Vector3d sum = Vector3d::Zero();
  double total = 0;
  for (const auto& [point, squared_mm2] : tree.nearest(place_mm, neighbours)) {
    const double weight = 1 / std::max(squared_mm2, smallest_mm2);
    const auto i = static_cast<std::size_t>(point);
    sum += weight * sign * (registered_mm_[i] - cloud_mm_[i]);
    total += weight;
  }
  return sum / total;
}

Landmarks place_landmarks(const RegisteredSequence& sequence, const std::vector<FrameMotion>& frames,
                          Quality& quality) {
  Landmarks landmarks;
  std::optional<geometry::SurfaceDistance> model;
  if (sequence.model) model.emplace(*sequence.model);
  int too_short = 0;
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
    const Vector3d mean = sum / count;
    landmarks.track.push_back(static_cast<int>(track));
    landmarks.seen_mm.push_back(std::move(seen));
    landmarks.placed_mm.push_back(std::move(placed));
    landmarks.on_model_mm.push_back(model ? model->closest(mean).point_mm : mean);
  }
  if (too_short > 0) {
    quality.notes.push_back({GLISSON_TEXT("Landmarks left out, which were seen in fewer than three frames: {0}"),
                             {std::to_string(too_short)}});
  }
  if (landmarks.off_the_clouds > 0) {
    quality.notes.push_back({GLISSON_TEXT("Landmarks left out, which lie far from the points of their frames: {0}"),
                             {std::to_string(landmarks.off_the_clouds)}});
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

// Farthest points among all that any frame was registered to.
Points spread(const std::vector<FrameMotion>& frames, int count) {
  constexpr std::size_t maximum_candidates = 20000;
  std::size_t total = 0;
  for (const FrameMotion& frame : frames) total += frame.registered_mm().size();
  const std::size_t step = std::max<std::size_t>(1, total / maximum_candidates);
  Points candidates;
  for (const FrameMotion& frame : frames) {
    for (std::size_t i = 0; i < frame.registered_mm().size(); i += step) candidates.push_back(frame.registered_mm()[i]);
  }
  std::vector<double> squared_mm2(candidates.size(), std::numeric_limits<double>::infinity());
  Points chosen;
  std::size_t next = 0;
  while (static_cast<int>(chosen.size()) < count && squared_mm2[next] > 0) {
    chosen.push_back(candidates[next]);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      squared_mm2[i] = std::min(squared_mm2[i], (candidates[i] - chosen.back()).squaredNorm());
    }
    next = static_cast<std::size_t>(std::max_element(squared_mm2.begin(), squared_mm2.end()) - squared_mm2.begin());
  }
  return chosen;
}

SharedCentreWarps fit_warps(const std::vector<FrameMotion>& frames, const SirgnOptions& options) {
  Points centres = spread(frames, options.control_points);
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

void rate_triangles(const Landmarks& landmarks, const SharedCentreWarps& warps, std::size_t frames, Quality& quality) {
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

      // The inside: how far S^-1 displaces each place in each frame; the farthest of each frame speaks (2.3).
      const auto places = lattice(landmarks.on_model_mm[corners[0]], landmarks.on_model_mm[corners[1]],
                                  landmarks.on_model_mm[corners[2]]);
      const Eigen::MatrixXd displacements = warps.displacements_mm(places);
      Eigen::MatrixXd warped_mm(displacements.rows(), count);
      for (Eigen::Index place = 0; place < displacements.rows(); ++place) {
        for (Eigen::Index n = 0; n < count; ++n) {
          warped_mm(place, n) = displacements.block<1, 3>(place, 3 * seen[static_cast<std::size_t>(n)]).norm();
        }
      }
      Eigen::VectorXd correlations(displacements.rows());
      for (Eigen::Index place = 0; place < displacements.rows(); ++place) {
        correlations[place] = correlation_of(warped_mm.row(place).transpose(), landmark_mm);
      }
      double sum = 0;
      for (Eigen::Index n = 0; n < count; ++n) {
        Eigen::Index worst = 0;
        course.warp_mm[static_cast<std::size_t>(seen[static_cast<std::size_t>(n)])] = warped_mm.col(n).maxCoeff(&worst);
        sum += correlations[worst];
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
