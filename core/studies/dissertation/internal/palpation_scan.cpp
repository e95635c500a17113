#include "studies/dissertation/internal/palpation_scan.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "geometry/mesh_file.h"
#include "geometry/nearest.h"
#include "registration/rigid.h"

namespace glisson::studies {
namespace {

using Eigen::Vector3d;
using geometry::Surface;

// The first point lies on the axis.
Surface revolved(const std::vector<Eigen::Vector2d>& profile_mm) {
  constexpr int sectors = 72;
  const int rings = static_cast<int>(profile_mm.size()) - 1;
  Surface surface;
  surface.points_mm.emplace_back(0, 0, profile_mm.front().y());
  for (int ring = 1; ring <= rings; ++ring) {
    for (int s = 0; s < sectors; ++s) {
      const double angle = 2 * std::numbers::pi * s / sectors;
      surface.points_mm.emplace_back(profile_mm[ring].x() * std::cos(angle), profile_mm[ring].x() * std::sin(angle),
                                     profile_mm[ring].y());
    }
  }
  const auto at = [](int ring, int s) { return ring == 0 ? 0 : 1 + (ring - 1) * sectors + s % sectors; };
  for (int ring = 0; ring < rings; ++ring) {
    for (int s = 0; s < sectors; ++s) {
      surface.triangles.push_back({at(ring, s), at(ring + 1, s), at(ring + 1, s + 1)});
      if (ring > 0) surface.triangles.push_back({at(ring, s), at(ring + 1, s + 1), at(ring, s + 1)});
    }
  }
  return surface;
}

// Faces that look at the scanner and that the tool does not hide; points that are left over go.
Surface seen(const Surface& surface, double hidden_radius_mm, double top_mm) {
  const Vector3d towards_scanner = Vector3d(0.2, -0.6, 0.8).normalized();
  Surface part;
  std::vector<int> number(surface.points_mm.size(), -1);
  for (const auto& triangle : surface.triangles) {
    const auto corner = [&](std::size_t n) { return surface.points_mm[static_cast<std::size_t>(triangle[n])]; };
    const Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const Vector3d centre = (corner(0) + corner(1) + corner(2)) / 3;
    const bool hidden = centre.z() > 0.5 * top_mm && centre.head<2>().norm() < hidden_radius_mm;
    if (normal.dot(towards_scanner) <= 0 || hidden) continue;
    std::array<int, 3> kept{};
    for (std::size_t n = 0; n < 3; ++n) {
      int& at = number[static_cast<std::size_t>(triangle[n])];
      if (at < 0) {
        at = static_cast<int>(part.points_mm.size());
        part.points_mm.push_back(corner(n));
      }
      kept[n] = at;
    }
    part.triangles.push_back(kept);
  }
  return part;
}

}  // namespace

PalpationScans simulated_scans(const std::vector<Eigen::Vector2d>& rest_profile_mm, const PressedProfile& pressed,
                               double ball_radius_mm, unsigned seed) {
  const double top_mm = rest_profile_mm.front().y();
  PalpationScans scans{seen(revolved(rest_profile_mm), 0, top_mm),
                       seen(revolved(pressed.profile_mm), ball_radius_mm, top_mm)};
  std::mt19937 random(seed);
  const Eigen::Isometry3d rough =
      Eigen::Translation3d(5, -4, 3) * Eigen::AngleAxisd(5 * std::numbers::pi / 180, Vector3d(1, 2, 0.5).normalized());
  for (Surface* scan : {&scans.rest, &scans.pressed}) {
    for (Vector3d& point : scan->points_mm) {
      for (double& coordinate : point) {
        // The sum of twelve uniform numbers: normal enough, and the same everywhere.
        double sum = -6;
        for (int n = 0; n < 12; ++n) sum += static_cast<double>(random()) / 4294967296.0;
        coordinate += 0.1 * sum;
      }
      point = rough * point;
    }
  }
  return scans;
}

Result<PalpationScans> scans_in(const std::filesystem::path& folder, const std::string& phantom,
                                const std::string& trial) {
  auto rest = geometry::read_surface(folder / (phantom + "-rest.ply"));
  if (!rest) return failure(rest.error());
  auto pressed = geometry::read_surface(folder / (trial + ".ply"));
  if (!pressed) return failure(pressed.error());
  return PalpationScans{std::move(*rest), std::move(*pressed)};
}

Result<NamedNumbers> compare(const PressedPhantom& model, const PalpationScans& scans, double ball_radius_mm) {
  registration::RigidIcpOptions icp;
  icp.overlap = registration::Overlap::source_is_part;
  const auto aligned = registration::rigid_icp(scans.rest, model.rest, icp);
  if (!aligned) return failure(aligned.error());
  const Surface scan = registration::moved(scans.pressed, aligned->transform);
  double top_mm = 0;
  for (const Vector3d& p : model.rest.points_mm) top_mm = std::max(top_mm, p.z());
  const geometry::SurfaceDistance distance(model.pressed);
  std::vector<bool> used(scan.points_mm.size(), false);
  for (const auto& triangle : scan.triangles) {
    for (const int corner : triangle) used[static_cast<std::size_t>(corner)] = true;
  }
  double sum = 0, squares = 0, worst = 0, near = 0, near_count = 0, count = 0;
  for (std::size_t p = 0; p < scan.points_mm.size(); ++p) {
    if (!used[p]) continue;
    const double away_mm = distance.closest(scan.points_mm[p]).distance_mm;
    count += 1;
    sum += away_mm;
    squares += away_mm * away_mm;
    worst = std::max(worst, away_mm);
    const bool top = scan.points_mm[p].z() > 0.5 * top_mm;
    if (!top || scan.points_mm[p].head<2>().norm() > 2 * ball_radius_mm) continue;
    near += away_mm;
    near_count += 1;
  }
  return NamedNumbers{{"mean_mm", sum / count},
                      {"rms_mm", std::sqrt(squares / count)},
                      {"max_mm", worst},
                      {"near_tool_mm", near_count > 0 ? near / near_count : 0},
                      {"alignment_mm", aligned->rms_mm},
                      {"scan_points", count}};
}

}  // namespace glisson::studies
