#include "mechanics/scenario/cut.h"

#include <algorithm>
#include <set>

#include "geometry/split_tetrahedra.h"

namespace glisson::mechanics {

Result<CutInSpace> CutInSpace::of(const Cut& cut) {
  auto surface = cut.points_mm.empty() ? geometry::CutSurface::plane(cut.center_mm, cut.normal)
                                       : geometry::CutSurface::through(cut.points_mm);
  if (!surface) return failure(std::move(surface.error()));
  return CutInSpace{std::move(*surface), cut.center_mm, cut.radius_mm};
}

bool CutInSpace::separates(const Eigen::Vector3d& a_mm, double height_a_mm, const Eigen::Vector3d& b_mm,
                           double height_b_mm) const {
  if ((height_a_mm < 0) == (height_b_mm < 0)) return false;
  return is_open_at(a_mm + height_a_mm / (height_a_mm - height_b_mm) * (b_mm - a_mm));
}

Result<OpenedBody> open_cuts(const geometry::TetMesh& mesh, const std::vector<Cut>& cuts, Along along) {
  OpenedBody body{mesh, {}};
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    const auto cut = CutInSpace::of(cuts[c]);
    if (!cut) return failure(cut.error());
    geometry::SplitOptions options;
    if (along == Along::exactly) options.snap = 1e-3;
    options.is_open = [&](const Eigen::Vector3d& place_mm) { return cut->is_open_at(place_mm); };
    geometry::SplitMesh split = geometry::split_tetrahedra(body.mesh, cut->surface, options);
    if (split.doubled.empty()) {
      return failure(Error{"cut-misses",
                           GLISSON_TEXT("Cut {0} opens the body nowhere."),
                           {std::to_string(c + 1)},
                           GLISSON_TEXT("Move it through the body, or open it wider; positions are LPS, in mm."),
                           {}});
    }
    for (const auto& [below, above] : split.doubled) body.walls.push_back({below, above, cut->surface.normal()});
    body.mesh = std::move(split.mesh);
  }
  return body;
}

std::vector<int> points_on(const std::vector<OpenedBody::Wall>& walls) {
  std::set<int> points;
  for (const OpenedBody::Wall& wall : walls) points.insert({wall.below, wall.above});
  return {points.begin(), points.end()};
}

CutOpening opening_of(const OpenedBody& body, const std::vector<Eigen::Vector3d>& displacement_mm) {
  CutOpening opening;
  for (const OpenedBody::Wall& wall : body.walls) {
    const Eigen::Vector3d apart_mm = displacement_mm[wall.above] - displacement_mm[wall.below];
    opening.largest_opening_mm = std::max(opening.largest_opening_mm, apart_mm.norm());
    opening.largest_overlap_mm = std::max(opening.largest_overlap_mm, -apart_mm.dot(wall.normal));
  }
  return opening;
}

}  // namespace glisson::mechanics
