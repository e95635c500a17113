#include "studies/dissertation/internal/matching_problems.h"

#include <fmt/format.h>
#include <cmath>

#include "anatomy/patient.h"
#include "base/files.h"
#include "geometry/mesh_file.h"
#include "registration/geo.h"

namespace glisson::studies {
namespace {

constexpr double bend_rad = 0.7;
constexpr double liver_spacing_mm = 6;

struct NamedPose {
  std::string name;
  geometry::Surface surface;
};
using Shape = std::vector<NamedPose>;

Result<std::vector<Shape>> shapes_of(const MatchingOptions& options);
std::string content_of(const geometry::Surface& surface);

}  // namespace

Result<MatchingProblems> MatchingProblems::create(const MatchingOptions& options, const Progress& progress) {
  const auto shapes = shapes_of(options);
  if (!shapes) return failure(shapes.error());
  double surfaces = 0, sampled = 0;
  for (const Shape& shape : *shapes) surfaces += static_cast<double>(shape.size());

  MatchingProblems problems;
  for (const Shape& shape : *shapes) {
    const std::size_t first = problems.poses_.size();
    for (const NamedPose& named : shape) {
      Pose pose;
      pose.area_mm2 = geometry::area_mm2(named.surface);
      pose.fingerprint = content_of(named.surface);
      for (const int start : options.starts) {
        const int within = std::min(start, static_cast<int>(named.surface.points_mm.size()) - 1);
        auto samples = registration::sample_surface(named.surface, options.points.back(), within);
        if (!samples) return failure(samples.error());
        if (progress.cancelled()) return cancelled();
        pose.between_mm.push_back(std::move(samples->between_mm));
      }
      problems.poses_.push_back(std::move(pose));
      progress.report(++sampled / surfaces, GLISSON_TEXT("Sampling"));
    }
    for (std::size_t i = 0; i < shape.size(); ++i) {
      for (std::size_t j = 0; j < shape.size(); ++j) {
        for (std::size_t start = 0; i != j && start < options.starts.size(); ++start) {
          problems.pairs_.push_back({first + i, first + j, start});
          std::string asked;
          for (const int points : options.points) asked += fmt::format(" {}", points);
          problems.list_.push_back(
              {fmt::format("{:03}-{}-to-{}-from-{}", problems.list_.size() + 1, shape[i].name, shape[j].name,
                           options.starts[start]),
               sha256_of_text(fmt::format("matching {} {} {} {} {} {} {}", problems.poses_[first + i].fingerprint,
                                          problems.poses_[first + j].fingerprint, options.starts.front(),
                                          options.starts[start], options.passes, options.points_of_all_widths, asked) +
                              version())});
        }
      }
    }
  }
  return problems;
}

registration::MatchingProblem MatchingProblems::of(std::size_t problem, int points) const {
  const Pair& pair = pairs_[problem];
  const registration::GeoOptions geo;
  const double size_mm = std::sqrt(std::max(poses_[pair.source].area_mm2, poses_[pair.target].area_mm2));
  registration::MatchingProblem made;
  made.source_mm = poses_[pair.source].between_mm.front().topLeftCorner(points, points);
  made.target_mm = poses_[pair.target].between_mm[pair.start].topLeftCorner(points, points);
  made.sigma_mm = geo.relative_sigma * size_mm;
  made.tau_mm = geo.relative_tau * size_mm;
  return made;
}

geometry::Surface bent(geometry::Surface surface, double angle_rad) {
  const geometry::Box box = geometry::bounding_box(surface.points_mm);
  const double radius_mm = (box.max_mm.x() - box.min_mm.x()) / angle_rad;
  const Eigen::Vector3d middle_mm = box.center_mm();
  for (Eigen::Vector3d& point_mm : surface.points_mm) {
    const Eigen::Vector3d from_mm = point_mm - middle_mm;
    const double turned_rad = from_mm.x() / radius_mm;
    const double arm_mm = radius_mm - from_mm.y();
    point_mm.x() = middle_mm.x() + arm_mm * std::sin(turned_rad);
    point_mm.y() = middle_mm.y() + radius_mm - arm_mm * std::cos(turned_rad);
  }
  return surface;
}

namespace {

Result<std::vector<Shape>> shapes_of(const MatchingOptions& options) {
  std::vector<Shape> shapes;
  for (const auto& files : options.shapes) {
    Shape shape;
    for (const auto& file : files) {
      auto surface = geometry::read_surface(file);
      if (!surface) return failure(surface.error());
      shape.push_back({file.stem().string(), std::move(*surface)});
    }
    shapes.push_back(std::move(shape));
  }
  for (int liver = 0; options.shapes.empty() && liver < options.livers; ++liver) {
    anatomy::PatientOptions patient;
    patient.seed = options.first_seed + static_cast<std::uint64_t>(liver);
    auto surface = anatomy::make_liver_surface(patient, liver_spacing_mm);
    if (!surface) return failure(surface.error());
    geometry::Surface pose = bent(*surface, bend_rad);
    const std::string name = fmt::format("liver-{}", patient.seed);
    shapes.push_back({{name, std::move(*surface)}, {name + "-bent", std::move(pose)}});
  }
  return shapes;
}

std::string content_of(const geometry::Surface& surface) {
  std::string bytes;
  bytes.append(reinterpret_cast<const char*>(surface.points_mm.data()),
               surface.points_mm.size() * sizeof(Eigen::Vector3d));
  bytes.append(reinterpret_cast<const char*>(surface.triangles.data()),
               surface.triangles.size() * sizeof(std::array<int, 3>));
  return sha256_of_text(bytes);
}

}  // namespace
}  // namespace glisson::studies
