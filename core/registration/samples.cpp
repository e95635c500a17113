#include "registration/samples.h"

#include <algorithm>

#include "geometry/geodesic.h"

namespace glisson::registration {
namespace {

// Distances from points that may become samples, asked for together.
struct Asked {
  std::vector<int> points;
  Eigen::MatrixXd distances_mm;  // a row each

  [[nodiscard]] Eigen::Index row_of(int point) const {
    return std::find(points.begin(), points.end(), point) - points.begin();
  }
  [[nodiscard]] bool has(int point) const { return row_of(point) < distances_mm.rows(); }
};

// The farthest point, and others as far from their nearest sample as from each other: most are among the next samples.
std::vector<int> likely_samples(const geometry::Surface& surface, const Eigen::VectorXd& to_nearest_mm);
int farthest_point(const Eigen::VectorXd& distances_mm);

}  // namespace

Result<GeodesicSamples> sample_surface(const geometry::Surface& surface, int count, int start,
                                       const Progress& progress) {
  if (count < 1 || static_cast<std::size_t>(count) > surface.points_mm.size()) {
    return failure("too-few-points", GLISSON_TEXT("A surface of {0} points cannot give {1} samples."),
                   {std::to_string(surface.points_mm.size()), std::to_string(count)});
  }
  const auto geodesics = geometry::HeatGeodesics::prepare(surface);
  if (!geodesics) return failure(geodesics.error());

  GeodesicSamples samples;
  samples.to_surface_mm.resize(count, static_cast<Eigen::Index>(surface.points_mm.size()));
  Eigen::VectorXd to_nearest_mm = geodesics->distances_mm(start);
  Asked asked;
  for (int sample = 0; sample < count; ++sample) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(sample) / count, GLISSON_TEXT("geodesic distances"));
    const int next = farthest_point(to_nearest_mm);
    if (!asked.has(next)) {
      asked.points = sample == 0 ? std::vector<int>{next} : likely_samples(surface, to_nearest_mm);
      asked.distances_mm = geodesics->distances_mm(asked.points);
    }
    samples.points.push_back(next);
    samples.to_surface_mm.row(sample) = asked.distances_mm.row(asked.row_of(next));
    const Eigen::VectorXd from_next_mm = samples.to_surface_mm.row(sample).transpose();
    if (sample == 0) to_nearest_mm = from_next_mm;  // the start is no sample
    to_nearest_mm = to_nearest_mm.cwiseMin(from_next_mm);
  }
  samples.covering_radius_mm = to_nearest_mm.maxCoeff();

  // The heat method's distance there and back differ a little; a metric's do not.
  const Eigen::MatrixXd one_way = samples.to_surface_mm(Eigen::all, samples.points).cwiseMax(0.0);
  samples.between_mm = 0.5 * (one_way + one_way.transpose());
  samples.between_mm.diagonal().setZero();
  return samples;
}

namespace {

std::vector<int> likely_samples(const geometry::Surface& surface, const Eigen::VectorXd& to_nearest_mm) {
  constexpr std::size_t maximum = 16;
  std::vector<int> likely;
  Eigen::VectorXd left_mm = to_nearest_mm;
  while (likely.size() < maximum) {
    const int next = farthest_point(left_mm);
    if (!likely.empty() && !(left_mm[next] > 0)) break;
    likely.push_back(next);
    const Eigen::Vector3d& here_mm = surface.points_mm[static_cast<std::size_t>(next)];
    for (Eigen::Index point = 0; point < left_mm.size(); ++point) {
      const Eigen::Vector3d& there_mm = surface.points_mm[static_cast<std::size_t>(point)];
      left_mm[point] = std::min(left_mm[point], (there_mm - here_mm).norm());
    }
  }
  return likely;
}

int farthest_point(const Eigen::VectorXd& distances_mm) {
  Eigen::Index point = 0;
  distances_mm.maxCoeff(&point);
  return static_cast<int>(point);
}

}  // namespace
}  // namespace glisson::registration
