#include "mechanics/contact/internal/contact_candidates.h"

#include <fmt/format.h>
#include <algorithm>
#include <Eigen/Geometry>
#include <limits>

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

std::array<Vector3d, 3> corners_of(const geometry::Surface& surface, const std::array<int, 3>& points,
                                   const VectorXd& moved_mm) {
  std::array<Vector3d, 3> corners;
  for (int i = 0; i < 3; ++i) corners[i] = surface.points_mm[points[i]] + moved_mm.segment<3>(3 * points[i]);
  return corners;
}

}  // namespace

void keep(const TrackedContact& place, const geometry::Surface& surface, std::vector<TrackedContact>& kept) {
  // Nearer than this another place tells nothing new: the surface between them sags into a ball of 5 mm by 0.01 mm.
  constexpr double apart_mm = 0.3;
  const auto at_rest = [&](const TrackedContact& k) -> Vector3d {
    const auto& p = surface.points_mm;
    return k.weights[0] * p[k.points[0]] + k.weights[1] * p[k.points[1]] + k.weights[2] * p[k.points[2]];
  };
  const bool known = std::any_of(kept.begin(), kept.end(), [&](const TrackedContact& other) {
    return other.tool == place.tool && other.rod == place.rod && (at_rest(other) - at_rest(place)).norm() < apart_mm;
  });
  if (!known) kept.push_back(place);
}

std::vector<ContactCandidate> contact_candidates(const geometry::Surface& surface,
                                                 const std::vector<ContactTool>& tools, const VectorXd& advance_mm,
                                                 const VectorXd& moved_mm, double margin_mm) {
  std::vector<ContactCandidate> places;
  for (std::size_t t = 0; t < tools.size(); ++t) {
    const auto* tool = std::get_if<TouchingTool>(&tools[t].what);
    if (tool == nullptr) continue;
    const ToolShape rods = placed(tool->shape, tool->pose.advanced(advance_mm[static_cast<Eigen::Index>(t)]));
    for (std::size_t r = 0; r < rods.size(); ++r) {
      const Rod& rod = rods[r];
      const double reach_mm = rod.radius_mm + margin_mm;
      const Vector3d low = rod.from_mm.cwiseMin(rod.to_mm).array() - reach_mm;
      const Vector3d high = rod.from_mm.cwiseMax(rod.to_mm).array() + reach_mm;
      for (const auto& triangle : surface.triangles) {
        const std::array<Vector3d, 3> corners = corners_of(surface, triangle, moved_mm);
        if ((corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]).array() > high.array()).any() ||
            (corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]).array() < low.array()).any()) {
          continue;
        }
        const Nearest nearest = nearest_of(rod, corners);
        if (nearest.distance_mm > reach_mm) continue;
        const Vector3d outward = unit_or_zero((corners[1] - corners[0]).cross(corners[2] - corners[0]));
        const Vector3d arm = nearest.barycentric[0] * corners[0] + nearest.barycentric[1] * corners[1] +
                             nearest.barycentric[2] * corners[2] - nearest.on_axis_mm;
        // A pierced triangle is pushed back into the body. A tool lies outside: what faces away from it is the far side
        // of the body, and is not touched.
        const Vector3d normal = nearest.distance_mm > 1e-9 ? Vector3d(arm / nearest.distance_mm) : Vector3d(-outward);
        if (normal.dot(outward) > 0.2) continue;
        // Triangles that meet at the nearest place find the same one.
        const Vector3d place_mm = nearest.on_axis_mm + arm;
        const bool seen_before = std::any_of(places.begin(), places.end(), [&](const ContactCandidate& other) {
          return other.tool == t && (other.place_mm - place_mm).squaredNorm() < 1e-12 &&
                 other.normal.dot(normal) > 1.0 - 1e-9;
        });
        if (seen_before) continue;
        places.push_back({t, r, triangle, nearest.barycentric, normal, nearest.distance_mm - rod.radius_mm, place_mm});
      }
    }
  }
  return places;
}

std::vector<ContactCandidate> tracked_candidates(const geometry::Surface& surface,
                                                 const std::vector<TrackedContact>& kept,
                                                 const std::vector<ContactTool>& tools, const VectorXd& advance_mm,
                                                 const VectorXd& moved_mm, double margin_mm) {
  std::vector<ContactCandidate> places;
  for (const TrackedContact& place : kept) {
    const auto& tool = std::get<TouchingTool>(tools[place.tool].what);
    const Pose pose = tool.pose.advanced(advance_mm[static_cast<Eigen::Index>(place.tool)]);
    const Rod rod = placed({tool.shape[place.rod]}, pose).front();
    const std::array<Vector3d, 3> corners = corners_of(surface, place.points, moved_mm);
    const Vector3d at_mm =
        place.weights[0] * corners[0] + place.weights[1] * corners[1] + place.weights[2] * corners[2];
    const Vector3d axis = rod.to_mm - rod.from_mm;
    const double along =
        axis.squaredNorm() > 0 ? std::clamp((at_mm - rod.from_mm).dot(axis) / axis.squaredNorm(), 0.0, 1.0) : 0.0;
    const Vector3d arm = at_mm - rod.from_mm - along * axis;
    const double distance_mm = arm.norm(), gap_mm = distance_mm - rod.radius_mm;
    if (gap_mm > margin_mm) continue;
    const Vector3d outward = unit_or_zero((corners[1] - corners[0]).cross(corners[2] - corners[0]));
    const Vector3d normal = distance_mm > 1e-9 ? Vector3d(arm / distance_mm) : Vector3d(-outward);
    places.push_back({place.tool, place.rod, place.points, place.weights, normal, gap_mm, at_mm});
  }
  return places;
}

// By steps of the distance itself, which cannot pass the surface (sphere tracing).
Result<double> way_to_surface(const geometry::Surface& surface, const TouchingTool& tool, const VectorXd& moved_mm) {
  const geometry::Box box = geometry::bounding_box(surface.points_mm);
  const double farthest_mm = (tool.pose.position_mm - box.center_mm()).norm() + box.diagonal_mm();
  double way_mm = 0;
  while (way_mm < farthest_mm) {
    const Pose pose{tool.pose.rotation, tool.pose.position_mm + way_mm * tool.pose.forward()};
    double gap_mm = std::numeric_limits<double>::infinity();
    for (const Rod& rod : placed(tool.shape, pose)) {
      for (const auto& triangle : surface.triangles) {
        const std::array<Vector3d, 3> corners = corners_of(surface, triangle, moved_mm);
        gap_mm = std::min(gap_mm, nearest_of(rod, corners).distance_mm - rod.radius_mm);
      }
    }
    if (gap_mm < 0.05) return way_mm;
    way_mm += gap_mm;
  }
  return failure(
      Error{"tool-touches-nothing",
            GLISSON_TEXT("The tool at ({0}, {1}, {2}) mm meets no surface on its way."),
            {fmt::format("{:.1f}", tool.pose.position_mm.x()), fmt::format("{:.1f}", tool.pose.position_mm.y()),
             fmt::format("{:.1f}", tool.pose.position_mm.z())},
            GLISSON_TEXT("Move it in front of the liver, or turn it towards it."),
            {}});
}

Result<Gripped> grip(const geometry::Surface& surface, std::size_t index, const Grasp& grasp) {
  Gripped gripped{index, {}, {}};
  if (!grasp.at_rest_mm.allFinite() || !std::isfinite(grasp.radius_mm) || grasp.radius_mm <= 0) {
    return failure("tool-invalid", GLISSON_TEXT("A grasper needs a finite place and a radius above zero."));
  }
  std::vector<double> area_of_point_mm2(surface.points_mm.size(), 0.0);  // a third of the triangles around it
  for (const auto& [a, b, c] : surface.triangles) {
    const auto& p = surface.points_mm;
    const double third_mm2 = (p[b] - p[a]).cross(p[c] - p[a]).norm() / 6.0;
    for (const int corner : {a, b, c}) area_of_point_mm2[corner] += third_mm2;
  }
  double sum = 0;
  for (std::size_t p = 0; p < surface.points_mm.size(); ++p) {
    if ((surface.points_mm[p] - grasp.at_rest_mm).norm() > grasp.radius_mm) continue;
    gripped.points.push_back(static_cast<int>(p));
    gripped.weights.push_back(area_of_point_mm2[p]);
    sum += area_of_point_mm2[p];
  }
  if (gripped.points.empty()) {
    return failure(Error{"tool-touches-nothing",
                         GLISSON_TEXT("The grasper holds no point of the surface."),
                         {},
                         GLISSON_TEXT("Move it onto the surface, or open its jaws wider."),
                         {}});
  }
  for (double& weight : gripped.weights) weight /= sum;
  return gripped;
}

Result<void> check_no_patch(const std::vector<ContactTool>& tools) {
  for (const ContactTool& tool : tools) {
    if (!std::holds_alternative<ToolLoad>(tool.what)) continue;
    return failure(Error{"not-available",
                         GLISSON_TEXT("The tool {0} spreads its force over a patch, which a session knows at large "
                                      "strain alone."),
                         {tool.id},
                         GLISSON_TEXT("Take the material neo-hookean, or jaws that pull."),
                         {}});
  }
  return {};
}

}  // namespace glisson::mechanics
