#include "shapes/completion.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/nearest.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using geometry::Surface;

constexpr double largest_residual_mm = 6, largest_mean_square = 4;

// Points at an edge of one triangle alone.
std::set<int> border_points(const Surface& surface) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& [a, b, c] : surface.triangles) {
    for (const std::pair<int, int> edge : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)}) ++uses[edge];
  }
  std::set<int> border;
  for (const auto& [edge, count] : uses) {
    if (count == 1) border.insert({edge.first, edge.second});
  }
  return border;
}

}  // namespace

Result<void> check_inside(const ShapeModel& model, const ShapeFit& fit) {
  if (fit.residual_mm > largest_residual_mm || fit.mean_square > largest_mean_square) {
    return failure(Error{"shapes-outside",
                         GLISSON_TEXT("This is no liver as the model's {0}: {1} mm are left between both, and its "
                                      "modes are {2} standard deviations out on average."),
                         {std::to_string(model.livers), fmt::format("{:.1f}", fit.residual_mm),
                          fmt::format("{:.1f}", std::sqrt(fit.mean_square))},
                         GLISSON_TEXT("Look at spacing and affine; a resected or transplanted liver cannot be "
                                      "completed by a model of whole ones."),
                         {}});
  }
  return {};
}

Result<double> mirrored_ratio(const ShapeModel& model, const Surface& seen, const ShapeFit& fit) {
  Surface mirror = seen;
  for (Vector3d& point : mirror.points_mm) point.x() = -point.x();
  for (auto& triangle : mirror.triangles) std::swap(triangle[1], triangle[2]);
  // A shape that the modes reach only by going far out fits less well.
  const auto badness = [](const ShapeFit& of) { return std::hypot(of.residual_mm, 3 * std::sqrt(of.mean_square)); };
  return fit_model(model, mirror).map([&](const ShapeFit& other) { return badness(other) / badness(fit); });
}

Result<void> check_not_mirrored(const ShapeModel& model, const Surface& seen, const ShapeFit& fit) {
  const auto ratio = mirrored_ratio(model, seen, fit);
  if (!ratio || *ratio >= 1) return {};  // a mirror image that finds no place is no rival
  return failure(Error{"shapes-mirrored",
                       GLISSON_TEXT("The model's livers come nearer to this one's mirror image: left and right are "
                                    "exchanged, or the patient is a rare one."),
                       {},
                       GLISSON_TEXT("Look at the file's affine: which way its first axis runs."),
                       {}});
}

Result<Completion> complete(const ShapeModel& model, const Surface& seen, const FitOptions& options,
                            const Progress& progress) {
  auto fit = fit_model(model, seen, options, progress);
  if (!fit) return failure(fit.error());
  Completion completion{fit->surface, *std::move(fit), 0};
  const geometry::SurfaceDistance distance(seen);
  const std::set<int> border = border_points(seen);
  const std::vector<Vector3d> normals = geometry::point_normals(completion.surface),
                              seen_normals = geometry::point_normals(seen);
  const std::size_t points = completion.surface.points_mm.size();
  std::vector<double> sd_mm(points), is_seen(points, 0);
  for (std::size_t p = 0; p < points; ++p) {
    const Vector3d& normal = normals[p];
    sd_mm[p] = std::sqrt(normal.dot(completion.fit.covariance_mm2[p] * normal));
    const auto closest = distance.closest(completion.surface.points_mm[p]);
    const auto& triangle = seen.triangles[static_cast<std::size_t>(closest.triangle)];
    if (closest.distance_mm > 3 * largest_residual_mm) continue;
    if (std::any_of(triangle.begin(), triangle.end(), [&](int corner) { return border.contains(corner); })) continue;
    if (seen_normals[static_cast<std::size_t>(triangle[0])].dot(normal) < 0.3) continue;
    is_seen[p] = 1;
    sd_mm[p] = options.noise_mm;
    completion.surface.points_mm[p] = closest.point_mm;
  }
  double seen_mm2 = 0, all_mm2 = 0;
  for (const auto& [a, b, c] : completion.surface.triangles) {
    const auto at = [&](int point) { return completion.surface.points_mm[static_cast<std::size_t>(point)]; };
    const double area = 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).norm();
    all_mm2 += area;
    for (const int corner : {a, b, c}) seen_mm2 += area / 3 * is_seen[static_cast<std::size_t>(corner)];
  }
  completion.seen_fraction = seen_mm2 / all_mm2;
  geometry::set_field(completion.surface.point_fields, {"sd_mm", 1, std::move(sd_mm)});
  geometry::set_field(completion.surface.point_fields, {"seen", 1, std::move(is_seen)});
  return completion;
}

}  // namespace glisson::shapes
