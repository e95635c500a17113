#include <algorithm>
#include <cmath>
#include <set>

#include "base/parallel.h"
#include "base/upper_median.h"
#include "registration/rigid.h"
#include "registration_quality/internal/doubt.h"

namespace glisson::registration_quality {
namespace {

using Eigen::Vector3d;
using Sightings = std::vector<std::optional<Vector3d>>;

// How far a landmark wanders on the model: the mean distance of where it was put from the median of that.
double wandering_mm(const Sightings& placed) {
  Vector3d usual_mm = Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> along;
    for (const auto& place : placed) {
      if (place) along.push_back((*place)[axis]);
    }
    usual_mm[axis] = upper_median(std::move(along));
  }
  double sum_mm = 0, count = 0;
  for (const auto& place : placed) {
    if (!place) continue;
    sum_mm += (*place - usual_mm).norm();
    ++count;
  }
  return count > 0 ? sum_mm / count : 0;
}

// How far the points are from having moved as one rigid body: root mean square after the best fit.
double bending_mm(const std::set<int>& around, const std::vector<Vector3d>& in_frame_mm,
                  const std::vector<Vector3d>& on_model_mm) {
  std::vector<Vector3d> from_mm, to_mm;
  for (const int point : around) {
    from_mm.push_back(in_frame_mm[static_cast<std::size_t>(point)]);
    to_mm.push_back(on_model_mm[static_cast<std::size_t>(point)]);
  }
  const auto motion = registration::align_points(from_mm, to_mm);
  if (!motion) return 0;  // three points or fewer, or all in line, fit any motion
  double sum_mm2 = 0;
  for (std::size_t i = 0; i < from_mm.size(); ++i) sum_mm2 += (*motion * from_mm[i] - to_mm[i]).squaredNorm();
  return std::sqrt(sum_mm2 / static_cast<double>(from_mm.size()));
}

}  // namespace

std::vector<double> doubt_mm(const Quality& quality, const std::vector<Sightings>& placed_mm) {
  constexpr std::size_t maximum_frames = 16;  // that bending is looked at in, evenly chosen
  const auto& points_mm = quality.mesh.points_mm;
  const auto& triangles = quality.mesh.triangles;
  const std::size_t points = points_mm.size();
  std::vector<std::set<int>> neighbours(points);  // with the point itself
  for (const auto& triangle : triangles) {
    for (const int corner : triangle) {
      neighbours[static_cast<std::size_t>(corner)].insert(triangle.begin(), triangle.end());
    }
  }
  const std::size_t step = std::max<std::size_t>(1, quality.mesh_in_frames_mm.size() / maximum_frames);
  std::vector<double> wandering(points), bending(points);
  parallel_for(points, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      wandering[i] = wandering_mm(placed_mm[i]);
      std::set<int> around;
      for (const int neighbour : neighbours[i]) {
        const auto& its = neighbours[static_cast<std::size_t>(neighbour)];
        around.insert(its.begin(), its.end());
      }
      double sum_mm = 0, count = 0;
      for (std::size_t t = 0; t < quality.mesh_in_frames_mm.size(); t += step) {
        sum_mm += bending_mm(around, quality.mesh_in_frames_mm[t], points_mm);
        ++count;
      }
      bending[i] = count > 0 ? sum_mm / count : 0;
    }
  });

  std::vector<double> doubt;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    std::set<int> around;
    double bent_mm = 0;
    for (const int corner : triangles[k]) {
      const auto at = static_cast<std::size_t>(corner);
      around.insert(neighbours[at].begin(), neighbours[at].end());
      bent_mm += bending[at] / 3;
    }
    std::vector<double> wander_mm;
    for (const int point : around) wander_mm.push_back(wandering[static_cast<std::size_t>(point)]);
    doubt.push_back((1 - quality.correlation[k]) * std::hypot(upper_median(std::move(wander_mm)), bent_mm));
  }
  return doubt;
}

}  // namespace glisson::registration_quality
