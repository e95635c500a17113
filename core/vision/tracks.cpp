#include "vision/tracks.h"

#include <algorithm>
#include <numeric>
#include <opencv2/core.hpp>

#include "vision/internal/stereo_features.h"

namespace glisson::vision {
namespace {

using Eigen::Vector3d;

// What both eyes show of one frame.
struct SeenPoint {
  std::vector<Vector3d> positions_mm;
  Descriptors left, right;

  [[nodiscard]] int count() const { return static_cast<int>(positions_mm.size()); }
};

// A landmark that is followed, with what it looked like when it was seen last.
struct Followed {
  std::vector<std::pair<int, Vector3d>> sightings;  // frame and place, the latest last
  Eigen::Matrix<float, 1, 128> left, right;

  [[nodiscard]] int last_frame() const { return sightings.back().first; }
  [[nodiscard]] const Vector3d& last_mm() const { return sightings.back().second; }
};

SeenPoint see(const Frame& left, const Frame& right, const Triangulator& triangulate, const TrackOptions& options);
std::vector<RowPair> closed_rounds(const std::vector<const Followed*>& followed, const SeenPoint& seen,
                                   const TrackOptions& options);
std::vector<RowPair> like_their_neighbours(const std::vector<const Followed*>& followed, const SeenPoint& seen,
                                           const std::vector<RowPair>& pairs, double unlike_mm);

}  // namespace

struct LandmarkTracker::Inside {
  TrackOptions options;
  Triangulator triangulate;
  std::vector<Followed> followed;
  int frames = 0;
  int seen_again = 0;  // in the latest
};

LandmarkTracker::LandmarkTracker(const StereoCalibration& calibration, const TrackOptions& options)
    : inside_(std::make_unique<Inside>(Inside{options, Triangulator(calibration), {}, 0, 0})) {}
LandmarkTracker::LandmarkTracker(LandmarkTracker&&) noexcept = default;
LandmarkTracker& LandmarkTracker::operator=(LandmarkTracker&&) noexcept = default;
LandmarkTracker::~LandmarkTracker() = default;

Result<void> LandmarkTracker::add(const Frame& left, const Frame& right) {
  if (left.width != right.width || left.height != right.height) {
    return failure("stereo-image-sizes", GLISSON_TEXT("The left image is {0} x {1} pixels, the right one {2} x {3}."),
                   {std::to_string(left.width), std::to_string(left.height), std::to_string(right.width),
                    std::to_string(right.height)});
  }
  auto& [options, triangulate, followed, frames, seen_again] = *inside_;
  SeenPoint seen;
  try {
    seen = see(left, right, triangulate, options);
  } catch (const cv::Exception& problem) {
    return failure("stereo-failed", GLISSON_TEXT("The pair could not be matched: {0}."), {problem.err});
  }
  const int frame = frames++;
  std::vector<const Followed*> awaited;
  for (const Followed& landmark : followed) {
    if (frame - landmark.last_frame() <= options.longest_gap + 1) awaited.push_back(&landmark);
  }
  std::vector<bool> is_known(static_cast<std::size_t>(seen.count()), false);
  const auto note = [&](Followed& landmark, int row) {
    const auto at = static_cast<std::size_t>(row);
    landmark.sightings.emplace_back(frame, seen.positions_mm[at]);
    landmark.left = seen.left.row(row);
    landmark.right = seen.right.row(row);
    is_known[at] = true;
  };
  const auto rounds = closed_rounds(awaited, seen, options);
  const auto kept = like_their_neighbours(awaited, seen, rounds, options.unlike_neighbours_mm);
  seen_again = static_cast<int>(kept.size());
  for (const auto& [old, row] : kept) {
    note(followed[static_cast<std::size_t>(awaited[static_cast<std::size_t>(old)] - followed.data())], row);
  }
  for (int row = 0; row < seen.count(); ++row) {
    if (!is_known[static_cast<std::size_t>(row)]) note(followed.emplace_back(), row);
  }
  return {};
}

int LandmarkTracker::followed() const { return inside_->seen_again; }

std::vector<Track> LandmarkTracker::tracks() const {
  const double fewest =
      std::max<double>(inside_->options.shortest_track, inside_->options.minimum_share * inside_->frames);
  std::vector<const Followed*> kept;
  for (const Followed& landmark : inside_->followed) {
    if (static_cast<double>(landmark.sightings.size()) >= fewest) kept.push_back(&landmark);
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [](const Followed* a, const Followed* b) { return a->sightings.size() > b->sightings.size(); });
  std::vector<Track> tracks;
  for (const Followed* landmark : kept) {
    Track track{"g" + std::to_string(tracks.size()), {}};
    track.positions_mm.resize(static_cast<std::size_t>(inside_->frames));
    for (const auto& [frame, position_mm] : landmark->sightings) {
      track.positions_mm[static_cast<std::size_t>(frame)] = position_mm;
    }
    tracks.push_back(std::move(track));
  }
  return tracks;
}

namespace {

SeenPoint see(const Frame& left, const Frame& right, const Triangulator& triangulate, const TrackOptions& options) {
  const Features in_left = find_features(left, options.features), in_right = find_features(right, options.features);
  const auto pairs =
      mutual_pairs(in_left.descriptors, in_right.descriptors, options.ratio, [](int, int) { return true; });
  std::vector<Eigen::Vector2d> left_px, right_px;
  for (const auto& [a, b] : pairs) {
    left_px.push_back(in_left.pixels[static_cast<std::size_t>(a)]);
    right_px.push_back(in_right.pixels[static_cast<std::size_t>(b)]);
  }
  const auto sightings = triangulate(left_px, right_px);
  std::vector<std::size_t> good;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const double depth_mm = sightings[i].position_mm.z();
    if (sightings[i].epipolar_px <= options.epipolar_px && depth_mm >= options.nearest_mm &&
        depth_mm <= options.farthest_mm) {
      good.push_back(i);
    }
  }
  SeenPoint seen;
  seen.left.resize(static_cast<Eigen::Index>(good.size()), 128);
  seen.right.resize(static_cast<Eigen::Index>(good.size()), 128);
  for (const std::size_t i : good) {
    const auto row = static_cast<Eigen::Index>(seen.positions_mm.size());
    seen.left.row(row) = in_left.descriptors.row(pairs[i].a);
    seen.right.row(row) = in_right.descriptors.row(pairs[i].b);
    seen.positions_mm.push_back(sightings[i].position_mm);
  }
  return seen;
}

std::vector<RowPair> closed_rounds(const std::vector<const Followed*>& followed, const SeenPoint& seen,
                                   const TrackOptions& options) {
  Descriptors left(static_cast<Eigen::Index>(followed.size()), 128), right(left.rows(), 128);
  for (std::size_t i = 0; i < followed.size(); ++i) {
    left.row(static_cast<Eigen::Index>(i)) = followed[i]->left;
    right.row(static_cast<Eigen::Index>(i)) = followed[i]->right;
  }
  const auto near = [&](int old, int row) {
    return (followed[static_cast<std::size_t>(old)]->last_mm() - seen.positions_mm[static_cast<std::size_t>(row)])
               .squaredNorm() <= options.fastest_mm * options.fastest_mm;
  };
  const auto by_left = mutual_pairs(left, seen.left, options.ratio, near);
  const auto by_right = mutual_pairs(right, seen.right, options.ratio, near);
  std::vector<int> row_by_right(followed.size(), -1);
  for (const auto& [old, row] : by_right) row_by_right[static_cast<std::size_t>(old)] = row;
  std::vector<RowPair> closed;
  for (const RowPair& pair : by_left) {
    if (row_by_right[static_cast<std::size_t>(pair.a)] == pair.b) closed.push_back(pair);
  }
  return closed;
}

std::vector<RowPair> like_their_neighbours(const std::vector<const Followed*>& followed, const SeenPoint& seen,
                                           const std::vector<RowPair>& pairs, double unlike_mm) {
  constexpr std::size_t neighbours = 8, fewest = 5;
  if (pairs.size() < fewest) return pairs;
  std::vector<Vector3d> from_mm, motion_mm;
  for (const auto& [old, row] : pairs) {
    from_mm.push_back(followed[static_cast<std::size_t>(old)]->last_mm());
    motion_mm.push_back(seen.positions_mm[static_cast<std::size_t>(row)] - from_mm.back());
  }
  std::vector<RowPair> kept;
  std::vector<std::size_t> nearest(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::iota(nearest.begin(), nearest.end(), std::size_t{0});
    const std::size_t count = std::min(neighbours + 1, nearest.size());  // itself among them
    std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearest.end(),
                      [&](std::size_t a, std::size_t b) {
                        return (from_mm[a] - from_mm[i]).squaredNorm() < (from_mm[b] - from_mm[i]).squaredNorm();
                      });
    Vector3d median_mm;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> along;
      for (std::size_t n = 0; n < count; ++n) along.push_back(motion_mm[nearest[n]][axis]);
      std::nth_element(along.begin(), along.begin() + static_cast<std::ptrdiff_t>(count / 2), along.end());
      median_mm[axis] = along[count / 2];
    }
    if ((motion_mm[i] - median_mm).norm() <= unlike_mm) kept.push_back(pairs[i]);
  }
  return kept;
}

}  // namespace
}  // namespace glisson::vision
