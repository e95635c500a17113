#include "registration/samples.h"

#include <algorithm>

#include "geometry/geodesic.h"

namespace glisson::registration {
namespace {

using Distances = Eigen::Map<const Eigen::VectorXd>;

int farthest_point(const Eigen::VectorXd& distances_mm) {
  Eigen::Index point = 0;
  distances_mm.maxCoeff(&point);
  return static_cast<int>(point);
}

}  // namespace

Result<GeodesicSamples> sample_surface(const geometry::Surface& surface, int count, int start,
                                       const Progress& progress) {
  if (count < 1 || static_cast<std::size_t>(count) > surface.points_mm.size()) {
    return failure("too-few-points", GLISSON_TEXT("A surface of {0} points cannot give {1} samples."),
                   {std::to_string(surface.points_mm.size()), std::to_string(count)});
  }
  auto geodesics = geometry::HeatGeodesics::prepare(surface);
  if (!geodesics) return failure(geodesics.error());

  const auto points = static_cast<Eigen::Index>(surface.points_mm.size());
  const auto distances_from = [&](int point) { return geodesics->distances_mm(point); };
  GeodesicSamples samples;
  samples.to_surface_mm.resize(count, points);
  const std::vector<double> from_start = distances_from(start);
  int next = farthest_point(Distances(from_start.data(), points));
  Eigen::VectorXd to_nearest_mm;
  for (int sample = 0; sample < count; ++sample) {
    if (progress.cancelled()) return cancelled();
    progress.report(static_cast<double>(sample) / count, GLISSON_TEXT("geodesic distances"));
    samples.points.push_back(next);
    const std::vector<double> distances = distances_from(next);
    samples.to_surface_mm.row(sample) = Distances(distances.data(), points);
    if (sample == 0) {
      to_nearest_mm = Distances(distances.data(), points);
    } else {
      to_nearest_mm = to_nearest_mm.cwiseMin(Distances(distances.data(), points));
    }
    next = farthest_point(to_nearest_mm);
  }
  samples.covering_radius_mm = to_nearest_mm.maxCoeff();

  // The heat method's distance there and back differ a little; a metric's do not.
  const Eigen::MatrixXd one_way = samples.to_surface_mm(Eigen::all, samples.points).cwiseMax(0.0);
  samples.between_mm = 0.5 * (one_way + one_way.transpose());
  samples.between_mm.diagonal().setZero();
  return samples;
}

}  // namespace glisson::registration
