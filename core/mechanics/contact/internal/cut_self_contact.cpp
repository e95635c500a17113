#include "mechanics/contact/internal/cut_self_contact.h"

#include <algorithm>
#include <Eigen/Geometry>
#include <map>
#include <optional>

#include "mechanics/scenario/rigid_tool.h"

namespace glisson::mechanics {

using Eigen::Vector3d;

CutSelfContact::CutSelfContact(const geometry::Surface& surface, const std::vector<int>& node_of_point,
                               const std::vector<int>& wall_points) {
  std::map<int, std::size_t> number_of;  // of a point of the surface
  for (const int point : wall_points) {
    number_of[point] = points_mm_.size();
    nodes_.push_back(node_of_point[point]);
    points_mm_.push_back(surface.points_mm[point]);
  }
  around_.resize(points_mm_.size());
  for (const auto& corners : surface.triangles) {
    if (!std::all_of(corners.begin(), corners.end(), [&](int point) { return number_of.contains(point); })) continue;
    Triangle triangle;
    for (int i = 0; i < 3; ++i) {
      triangle.nodes[i] = node_of_point[corners[i]];
      triangle.rest_mm[i] = surface.points_mm[corners[i]];
      around_[number_of[corners[i]]].push_back(static_cast<int>(triangles_.size()));
    }
    triangles_.push_back(triangle);
  }
}

double CutSelfContact::find(const Eigen::VectorXd& u_mm, Search search) {
  std::vector<CutContact> next;
  double deepest_mm = 0;
  auto known = cut_contacts_.begin();
  const auto take_known_before = [&](std::size_t owner) {  // of points that are nowhere now
    for (; known != cut_contacts_.end() && known->owner < owner; ++known) {
      if (search != Search::anew) next.push_back(*known);
    }
  };
  for (CutContact& met : cut_contacts_now(u_mm)) {
    take_known_before(met.owner);
    deepest_mm = std::max(deepest_mm, met.depth_mm);
    for (; known != cut_contacts_.end() && known->owner == met.owner; ++known) {
      if (search != Search::more || known->triangle == met.triangle) {
        met.multiplier_mN += known->multiplier_mN;
      } else {
        next.push_back(*known);
      }
    }
    next.push_back(met);
  }
  take_known_before(points_mm_.size());
  cut_contacts_ = std::move(next);
  return deepest_mm;
}

std::vector<CutContact> CutSelfContact::cut_contacts_now(const Eigen::VectorXd& u_mm) const {
  constexpr double before_mm = 1.0, behind_mm = 5.0;
  struct Moved {
    std::array<Vector3d, 3> corners_mm;
    Vector3d middle_mm, normal;
    double reach_mm = 0;
  };
  std::vector<Moved> moved;
  for (const Triangle& triangle : triangles_) {
    Moved now;
    for (int i = 0; i < 3; ++i) now.corners_mm[i] = triangle.rest_mm[i] + u_mm.segment<3>(3 * triangle.nodes[i]);
    now.middle_mm = (now.corners_mm[0] + now.corners_mm[1] + now.corners_mm[2]) / 3;
    now.normal = (now.corners_mm[1] - now.corners_mm[0]).cross(now.corners_mm[2] - now.corners_mm[0]).normalized();
    for (const Vector3d& corner : now.corners_mm)
      now.reach_mm = std::max(now.reach_mm, (corner - now.middle_mm).norm());
    moved.push_back(now);
  }
  std::vector<CutContact> found;
  for (std::size_t p = 0; p < points_mm_.size(); ++p) {
    const Vector3d here_mm = points_mm_[p] + u_mm.segment<3>(3 * nodes_[p]);
    Vector3d own_normal = Vector3d::Zero();
    for (const int t : around_[p]) own_normal += moved[t].normal;
    own_normal.normalize();
    double nearest_mm = behind_mm;
    std::optional<CutContact> met;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      // Walls that face each other, and so not a wall's own triangles.
      if (moved[t].normal.dot(own_normal) > -0.5) continue;
      if ((here_mm - moved[t].middle_mm).norm() > nearest_mm + moved[t].reach_mm) continue;
      const Nearest nearest = nearest_of(Rod{here_mm, here_mm, 0.0}, moved[t].corners_mm);
      if (!(nearest.distance_mm < nearest_mm)) continue;
      Vector3d place_mm = Vector3d::Zero(), place_at_rest_mm = place_mm;
      for (int i = 0; i < 3; ++i) {
        place_mm += nearest.barycentric[i] * moved[t].corners_mm[i];
        place_at_rest_mm += nearest.barycentric[i] * triangles_[t].rest_mm[i];
      }
      const double gap_mm = moved[t].normal.dot(here_mm - place_mm);
      // Well past a wall's rim it is not in the way.
      const double aside_mm = (here_mm - place_mm - gap_mm * moved[t].normal).norm();
      if (gap_mm > before_mm || aside_mm > 0.5 * std::abs(gap_mm) + 0.1 * moved[t].reach_mm) continue;
      // To the nearest place, which in a fold is not straight ahead; just past a rim that says nothing.
      const double depth_mm = gap_mm < 0 ? std::min(nearest.distance_mm, -3.0 * gap_mm) : 0.0;
      nearest_mm = nearest.distance_mm;
      met = CutContact{p,
                       t,
                       nodes_[p],
                       triangles_[t].nodes,
                       nearest.barycentric,
                       moved[t].normal,
                       points_mm_[p] - place_at_rest_mm,
                       depth_mm};
    }
    if (met) found.push_back(*met);
  }
  return found;
}

}  // namespace glisson::mechanics
