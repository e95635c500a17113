#include "shapes/completion.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <map>
#include <set>

#include "geometry/nearest.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using geometry::Surface;

constexpr double largest_residual_mm = 8, largest_mean_square = 4;  // 6.5 and 1.3 were the largest of 41 real livers
constexpr double farthest_seen_mm = 18;                             // from the model's place for a point
// Of a correlation that falls off as a Gaussian: how far along the liver what no mode explains goes on.
constexpr double rest_length_mm = 25;

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

// What no mode explains goes on from where it is seen to what lies near: a Gaussian process (kriging, Matheron 1963) of
// the model's residual over places.
class RestBeyond {
 public:
  RestBeyond(const ShapeModel& model, const std::vector<Vector3d>& places_mm, const std::vector<double>& is_seen,
             const std::vector<Vector3d>& rest_mm, double noise_mm) {
    constexpr std::size_t most = 500;  // known places, evenly by their numbers
    const auto seen = static_cast<std::size_t>(std::count(is_seen.begin(), is_seen.end(), 1.0));
    const std::size_t step = seen / most + 1;
    std::size_t count = 0;
    std::vector<Vector3d> known_rest_mm;
    for (std::size_t p = 0; p < places_mm.size(); ++p) {
      if (is_seen[p] == 0 || count++ % step != 0) continue;
      known_mm_.push_back(places_mm[p]);
      known_rest_mm.push_back(rest_mm[p]);
    }
    const auto n = static_cast<Eigen::Index>(known_mm_.size());
    const double variance =
        std::max(1e-6, model.residual_sd_mm.squaredNorm() / static_cast<double>(model.residual_sd_mm.size()));
    Eigen::MatrixXd among(n, n);
    Eigen::MatrixX3d right(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
      among.col(i) = alike(known_mm_[static_cast<std::size_t>(i)]);
      right.row(i) = known_rest_mm[static_cast<std::size_t>(i)].transpose();
    }
    among.diagonal().array() += noise_mm * noise_mm / variance + 1e-6;
    factor_.compute(among);
    weights_ = factor_.solve(right);
  }

  struct There {
    Vector3d expected_mm{0, 0, 0};
    double share = 0;  // of the residual's variance that is no longer unknown
  };
  [[nodiscard]] There at(const Vector3d& place_mm) const {
    if (known_mm_.empty()) return {};
    const Eigen::VectorXd to_known = alike(place_mm);
    return {weights_.transpose() * to_known, std::clamp(to_known.dot(factor_.solve(to_known)), 0.0, 1.0)};
  }

 private:
  [[nodiscard]] Eigen::VectorXd alike(const Vector3d& place_mm) const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(known_mm_.size()));
    for (std::size_t i = 0; i < known_mm_.size(); ++i) {
      values[static_cast<Eigen::Index>(i)] =
          std::exp(-(known_mm_[i] - place_mm).squaredNorm() / (2 * rest_length_mm * rest_length_mm));
    }
    return values;
  }

  std::vector<Vector3d> known_mm_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::MatrixX3d weights_;
};

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
  constexpr double clearly = 0.9;              // 1.3 was the minimum on 41 real livers
  if (!ratio || *ratio >= clearly) return {};  // a mirror image that finds no place is no rival
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
  std::vector<double> sd_mm(points, options.noise_mm), is_seen(points, 0);
  std::vector<Vector3d> to_seen_mm(points, Vector3d::Zero());
  for (std::size_t p = 0; p < points; ++p) {
    const auto closest = distance.closest(completion.surface.points_mm[p]);
    const auto& triangle = seen.triangles[static_cast<std::size_t>(closest.triangle)];
    if (closest.distance_mm > farthest_seen_mm) continue;
    if (std::any_of(triangle.begin(), triangle.end(), [&](int corner) { return border.contains(corner); })) continue;
    if (seen_normals[static_cast<std::size_t>(triangle[0])].dot(normals[p]) < 0.3) continue;
    is_seen[p] = 1;
    to_seen_mm[p] = closest.point_mm - completion.surface.points_mm[p];
  }
  const RestBeyond rest(model, completion.surface.points_mm, is_seen, to_seen_mm, options.noise_mm);
  const std::vector<Vector3d> fitted_mm = completion.surface.points_mm;
  for (std::size_t p = 0; p < points; ++p) {
    if (is_seen[p] != 0) {
      completion.surface.points_mm[p] += to_seen_mm[p];
      continue;
    }
    const RestBeyond::There there = rest.at(fitted_mm[p]);
    completion.surface.points_mm[p] += there.expected_mm;
    const double explained = there.share * std::pow(model.residual_sd_mm[static_cast<Eigen::Index>(p)], 2);
    sd_mm[p] = std::sqrt(std::max(0.0, normals[p].dot(completion.fit.covariance_mm2[p] * normals[p]) - explained));
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
