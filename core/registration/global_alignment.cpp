#include "registration/global_alignment.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>

#include "base/parallel.h"
#include "geometry/nearest.h"
#include "geometry/spread_points.h"
#include "registration/rigid.h"

namespace glisson::registration {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

// One landmark's sighting, as the two steps take it.
struct Pair {
  std::size_t landmark = 0;
  Vector3d seen_mm{0, 0, 0};
  double weight = 1;
};

class Alternation {
 public:
  Alternation(const Sightings& sightings, std::size_t frames, const GlobalAlignmentOptions& options)
      : options_(options), pairs_(frames), rigid_(frames), places_(sightings.size()) {
    for (std::size_t k = 0; k < sightings.size(); ++k) {
      for (std::size_t t = 0; t < frames; ++t) {
        if (sightings[k][t] && sightings[k][t]->allFinite()) pairs_[t].push_back({k, *sightings[k][t], 1});
      }
    }
  }

  // From the reference frame outwards: each time the frame that shares most landmarks with what is placed already.
  Result<void> begin() {
    reference_ =
        static_cast<std::size_t>(std::max_element(pairs_.begin(), pairs_.end(),
                                                  [](const auto& a, const auto& b) { return a.size() < b.size(); }) -
                                 pairs_.begin());
    rigid_[reference_] = Eigen::Isometry3d::Identity();
    place_landmarks();
    for (;;) {
      std::size_t best = pairs_.size(), maximum = 3;
      for (std::size_t t = 0; t < pairs_.size(); ++t) {
        if (rigid_[t]) continue;
        const auto shared = static_cast<std::size_t>(std::count_if(
            pairs_[t].begin(), pairs_[t].end(), [&](const Pair& pair) { return places_[pair.landmark].has_value(); }));
        if (shared <= maximum) continue;
        maximum = shared;
        best = t;
      }
      if (best == pairs_.size()) break;
      if (!align(best)) pairs_[best].clear();  // in line: it cannot be placed
      place_landmarks();
    }
    if (std::count_if(rigid_.begin(), rigid_.end(), [](const auto& rigid) { return rigid.has_value(); }) < 2) {
      return failure(Error{"alignment-too-few-landmarks",
                           GLISSON_TEXT("No two frames share four landmarks."),
                           {},
                           GLISSON_TEXT("Track more features, or leave out fewer frames."),
                           {}});
    }
    return {};
  }

  // Landmarks' places and frames' motions in turn. The answer: how far any place moved.
  double step() {
    const auto before = places_;
    for (std::size_t t = 0; t < pairs_.size(); ++t) {
      if (rigid_[t] && t != reference_) align(t);
    }
    reweight();
    place_landmarks();
    double farthest_mm = 0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (places_[k] && before[k]) farthest_mm = std::max(farthest_mm, (*places_[k] - *before[k]).norm());
    }
    return farthest_mm;
  }

  [[nodiscard]] std::size_t reference() const { return reference_; }
  [[nodiscard]] const std::optional<Eigen::Isometry3d>& rigid(std::size_t t) const { return rigid_[t]; }
  [[nodiscard]] const std::vector<std::optional<Vector3d>>& places() const { return places_; }

  // The sightings of a frame that lie no farther than twice outlier_mm from their landmarks' places.
  [[nodiscard]] std::vector<Pair> good(std::size_t t) const {
    std::vector<Pair> kept;
    for (const Pair& pair : pairs_[t]) {
      if (places_[pair.landmark] && residual_mm(t, pair) <= 2 * options_.outlier_mm) kept.push_back(pair);
    }
    return kept;
  }
  [[nodiscard]] int outliers() const {
    std::size_t count = 0;
    for (std::size_t t = 0; t < pairs_.size(); ++t) {
      if (rigid_[t]) count += pairs_[t].size() - good(t).size();
    }
    return static_cast<int>(count);
  }
  [[nodiscard]] double residual_mm(std::size_t t, const Pair& pair) const {
    return (*rigid_[t] * pair.seen_mm - *places_[pair.landmark]).norm();
  }

 private:
  bool align(std::size_t t) {
    Points from_mm, to_mm;
    std::vector<double> weights;
    for (const Pair& pair : pairs_[t]) {
      if (!places_[pair.landmark]) continue;
      from_mm.push_back(pair.seen_mm);
      to_mm.push_back(*places_[pair.landmark]);
      weights.push_back(pair.weight);
    }
    const auto motion = align_points(from_mm, to_mm, weights);
    if (motion) rigid_[t] = *motion;
    return motion.has_value();
  }

  void place_landmarks() {
    std::vector<Vector3d> sum(places_.size(), Vector3d::Zero());
    std::vector<double> total(places_.size(), 0);
    for (std::size_t t = 0; t < pairs_.size(); ++t) {
      if (!rigid_[t]) continue;
      for (const Pair& pair : pairs_[t]) {
        sum[pair.landmark] += pair.weight * (*rigid_[t] * pair.seen_mm);
        total[pair.landmark] += pair.weight;
      }
    }
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (total[k] > 0) places_[k] = sum[k] / total[k];
    }
  }

  void reweight() {
    for (std::size_t t = 0; t < pairs_.size(); ++t) {
      if (!rigid_[t]) continue;
      for (Pair& pair : pairs_[t]) {
        if (!places_[pair.landmark]) continue;
        const double relative = residual_mm(t, pair) / options_.outlier_mm;
        pair.weight = 1 / ((1 + relative * relative) * (1 + relative * relative));
      }
    }
  }

  const GlobalAlignmentOptions& options_;
  std::vector<std::vector<Pair>> pairs_;  // of each frame
  std::vector<std::optional<Eigen::Isometry3d>> rigid_;
  std::vector<std::optional<Vector3d>> places_;
  std::size_t reference_ = 0;
};

double mean_square_before(const Sightings& sightings, const std::vector<std::vector<Pair>>& good);
std::optional<FrameAlignment> fit_warp(const std::vector<Pair>& pairs, const Alternation& state, std::size_t t,
                                       const GlobalAlignmentOptions& options);

}  // namespace

Result<GlobalAlignment> align_globally(const Sightings& sightings, const GlobalAlignmentOptions& options,
                                       const Progress& progress) {
  const std::size_t frames = sightings.empty() ? 0 : sightings.front().size();
  if (frames < 2) return failure("alignment-too-few-frames", GLISSON_TEXT("Two frames or more can be aligned."));
  for (const auto& landmark : sightings) {
    if (landmark.size() == frames) continue;
    return failure("alignment-sizes", GLISSON_TEXT("A landmark was followed through {0} of {1} frames."),
                   {std::to_string(landmark.size()), std::to_string(frames)});
  }
  Alternation state(sightings, frames, options);
  if (auto begun = state.begin(); !begun) return failure(begun.error());
  GlobalAlignment alignment;
  alignment.reference = static_cast<int>(state.reference());
  while (alignment.iterations < options.iterations) {
    if (progress.cancelled()) return cancelled();
    ++alignment.iterations;
    progress.report(0.5 * alignment.iterations / options.iterations, GLISSON_TEXT("aligning frames"));
    if (state.step() < options.smallest_step_mm) break;
  }

  std::vector<std::vector<Pair>> good(frames);
  std::vector<int> sightings_of(sightings.size(), 0);
  for (std::size_t t = 0; t < frames; ++t) {
    if (!state.rigid(t)) continue;
    good[t] = state.good(t);
    for (const Pair& pair : good[t]) ++sightings_of[pair.landmark];
  }
  for (std::size_t k = 0; k < sightings.size(); ++k) {
    alignment.landmarks_mm.push_back(sightings_of[k] >= 2 ? state.places()[k] : std::nullopt);
  }
  for (auto& pairs : good) {
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                               [&](const Pair& pair) { return !alignment.landmarks_mm[pair.landmark]; }),
                pairs.end());
  }
  alignment.outliers = state.outliers();
  alignment.frames.resize(frames);
  parallel_for(frames, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (state.rigid(t) && !progress.cancelled()) alignment.frames[t] = fit_warp(good[t], state, t, options);
    }
  });
  if (progress.cancelled()) return cancelled();

  double rigid_mm2 = 0, warped_mm2 = 0, count = 0;
  for (std::size_t t = 0; t < frames; ++t) {
    if (!alignment.frames[t]) {
      alignment.notes.push_back(fmt::format("frame {} shares too few landmarks with the others: left out", t));
      good[t].clear();
      continue;
    }
    for (const Pair& pair : good[t]) {
      rigid_mm2 += std::pow(state.residual_mm(t, pair), 2);
      warped_mm2 += (alignment.frames[t]->warp(pair.seen_mm) - *alignment.landmarks_mm[pair.landmark]).squaredNorm();
      ++count;
    }
  }
  if (count > 0) {
    alignment.before_rms_mm = std::sqrt(mean_square_before(sightings, good));
    alignment.rigid_rms_mm = std::sqrt(rigid_mm2 / count);
    alignment.rms_mm = std::sqrt(warped_mm2 / count);
  }
  return alignment;
}

geometry::Surface merged_model(const std::vector<geometry::Surface>& surfaces, const GlobalAlignment& alignment,
                               double reach_mm) {
  const auto reference = static_cast<std::size_t>(alignment.reference);
  geometry::Surface model;
  model.triangles = surfaces[reference].triangles;
  model.points_mm = surfaces[reference].points_mm;
  if (!alignment.frames[reference]) return model;
  const auto to_model = [&](std::size_t t, Points points_mm) {
    parallel_for(points_mm.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) points_mm[i] = alignment.frames[t]->warp(points_mm[i]);
    });
    return points_mm;
  };
  model.points_mm = to_model(reference, std::move(model.points_mm));
  Points sum = model.points_mm;
  std::vector<double> count(model.points_mm.size(), 1);
  for (std::size_t t = 0; t < surfaces.size(); ++t) {
    if (t == reference || !alignment.frames[t] || surfaces[t].triangles.empty()) continue;
    geometry::Surface warped;
    warped.triangles = surfaces[t].triangles;
    warped.points_mm = to_model(t, surfaces[t].points_mm);
    const geometry::SurfaceDistance near(warped);
    parallel_for(sum.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto closest = near.closest(model.points_mm[i]);
        if (closest.distance_mm > reach_mm) continue;
        sum[i] += closest.point_mm;
        ++count[i];
      }
    });
  }
  for (std::size_t i = 0; i < sum.size(); ++i) model.points_mm[i] = sum[i] / count[i];
  return model;
}

namespace {

double mean_square_before(const Sightings& sightings, const std::vector<std::vector<Pair>>& good) {
  std::vector<Points> seen(sightings.size());
  for (const auto& pairs : good) {
    for (const Pair& pair : pairs) seen[pair.landmark].push_back(pair.seen_mm);
  }
  double sum = 0, count = 0;
  for (const Points& points : seen) {
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& point : points) mean += point / static_cast<double>(points.size());
    for (const Vector3d& point : points) sum += (point - mean).squaredNorm();
    count += static_cast<double>(points.size());
  }
  return count > 0 ? sum / count : 0;
}

// The farthest from one another, so that a few stand for all.
std::vector<Pair> spread(const std::vector<Pair>& pairs, std::size_t count) {
  if (pairs.size() <= count) return pairs;
  std::vector<Vector3d> seen_mm;
  for (const Pair& pair : pairs) seen_mm.push_back(pair.seen_mm);
  std::vector<Pair> chosen;
  for (const std::size_t p : geometry::spread_points(seen_mm, count)) chosen.push_back(pairs[p]);
  return chosen;
}

// Landmarks on tissue lie nearly in one plane, and noise would decide what becomes of space across it: two points
// before and behind, as far as the landmarks reach, move as the frame does rigidly.
void hold_across(Points& from_mm, Points& to_mm, const Eigen::Isometry3d& rigid) {
  if (from_mm.size() < 3) return;
  Vector3d center = Vector3d::Zero();
  for (const Vector3d& point : from_mm) center += point / static_cast<double>(from_mm.size());
  Eigen::Matrix3d spread_mm2 = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : from_mm) spread_mm2 += (point - center) * (point - center).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread_mm2 / static_cast<double>(from_mm.size()));
  const double reach_mm = 2 * std::sqrt(axes.eigenvalues()[2]);
  for (const double side : {-1.0, 1.0}) {
    const Vector3d point = center + side * reach_mm * axes.eigenvectors().col(0);
    from_mm.push_back(point);
    to_mm.push_back(rigid * point);
  }
}

std::optional<FrameAlignment> fit_warp(const std::vector<Pair>& pairs, const Alternation& state, std::size_t t,
                                       const GlobalAlignmentOptions& options) {
  constexpr double minimum_determinant = 0.1;  // of dS/dp: volumes there may shrink to a tenth, and never turn over
  constexpr int stiffenings = 8;
  if (pairs.size() < 4) return std::nullopt;
  Points from_mm, to_mm;
  for (const Pair& pair : spread(pairs, static_cast<std::size_t>(options.maximum_centers))) {
    from_mm.push_back(pair.seen_mm);
    to_mm.push_back(*state.places()[pair.landmark]);
  }
  hold_across(from_mm, to_mm, *state.rigid(t));
  double stiffness_mm = options.stiffness_mm;
  for (int i = 0; i < stiffenings; ++i, stiffness_mm = 2 * stiffness_mm + 1) {
    const auto warp = ThinPlateSpline::fit(from_mm, to_mm, stiffness_mm);
    if (!warp) return std::nullopt;
    // Looked at where it bends most: at its own points, and between each and the next.
    bool folds = false;
    for (std::size_t k = 0; k < from_mm.size() && !folds; ++k) {
      const Vector3d between = 0.5 * (from_mm[k] + from_mm[(k + 1) % from_mm.size()]);
      folds = warp->jacobian(from_mm[k]).determinant() < minimum_determinant ||
              warp->jacobian(between).determinant() < minimum_determinant;
    }
    if (!folds) return FrameAlignment{*state.rigid(t), *warp, stiffness_mm};
  }
  return std::nullopt;
}

}  // namespace
}  // namespace glisson::registration
