#include "rehearsal/resection.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>
#include <map>

#include "base/units.h"
#include "geometry/fields.h"
#include "geometry/nearest.h"
#include "mechanics/simulation.h"

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using geometry::CutSurface;
using geometry::Surface;

ResectionSide side_of(const Surface& surface, const CutSurface& cut, bool specimen_is_above);
double smallest_distance_mm(const Surface& structure, const Surface& cut);

// The cut as it is measured: through the mesh exactly, where the mesh that is moved has points near to it shifted.
Surface exact_cut(const geometry::TetMesh& liver, const CutSurface& cut);

// Closed outlines that the cut leaves on a surface, in order.
std::vector<std::vector<Vector3d>> outlines(const Surface& surface, const CutSurface& cut);
VesselCrossing crossing_of(const std::string& name, const std::vector<Vector3d>& outline, const Vector3d& normal);

}  // namespace

void measure_as(Resection& plan, double liver_ml) {
  const double scale = liver_ml / (plan.specimen_ml + plan.remnant_ml);
  for (double* volume_ml : {&plan.specimen_ml, &plan.remnant_ml, &plan.volume_error_ml}) *volume_ml *= scale;
}

std::string to_string(ResectionSide side) {
  switch (side) {
    case ResectionSide::specimen: return "specimen";
    case ResectionSide::remnant: return "remnant";
    case ResectionSide::both: return "both";
  }
  GLISSON_ASSERT(false);
}

Result<Resection> plan_resection(const geometry::TetMesh& liver, const CutSurface& cut,
                                 const std::vector<NamedStructure>& structures,
                                 const std::optional<Vector3d>& specimen_mm) {
  if (auto checked = geometry::check_tetrahedra(liver); !checked) return failure(std::move(checked.error()));
  return plan_resection(at_rest(liver), cut, structures, specimen_mm);
}

Result<Resection> plan_resection(const LyingLiver& lying, const CutSurface& cut,
                                 const std::vector<NamedStructure>& structures,
                                 const std::optional<Vector3d>& specimen_mm) {
  const geometry::TetMesh& liver = lying.mesh;
  if (auto checked = geometry::check_tetrahedra(liver); !checked) return failure(std::move(checked.error()));
  for (const NamedStructure& structure : structures) {
    if (auto checked = geometry::check_surface(structure.surface); !checked) return failure(std::move(checked.error()));
  }
  const geometry::DividedVolume volume = geometry::divided_volume(liver, cut, lying.rest_volumes_mm3);
  if (volume.above_mm3 <= 0 || volume.below_mm3 <= 0) {
    return failure(Error{"cut-misses",
                         GLISSON_TEXT("The cut passes the liver by."),
                         {},
                         GLISSON_TEXT("Move it through the liver; positions are patient coordinates (LPS, mm)."),
                         {}});
  }
  Resection plan;
  plan.specimen_is_above = volume.above_mm3 < volume.below_mm3;
  if (specimen_mm) {
    const double height_mm = cut.height_mm(*specimen_mm);
    if (!(std::abs(height_mm) > 1e-6)) {
      return failure("specimen-on-cut", GLISSON_TEXT("The point of the specimen lies on the cut, or is not finite."));
    }
    plan.specimen_is_above = height_mm > 0;
  }
  plan.specimen_ml = units::ml_from_mm3(plan.specimen_is_above ? volume.above_mm3 : volume.below_mm3);
  plan.remnant_ml = units::ml_from_mm3(plan.specimen_is_above ? volume.below_mm3 : volume.above_mm3);
  plan.volume_error_ml = units::ml_from_mm3(volume.error_mm3);
  plan.retraction = lying.validity;
  plan.split = geometry::split_tetrahedra(liver, cut);
  plan.cut = exact_cut(liver, cut);
  plan.cut_area_mm2 = geometry::area_mm2(plan.cut);

  const geometry::SurfaceDistance border(geometry::boundary_surface(liver));
  for (const NamedStructure& structure : structures) {
    const ResectionSide side = side_of(structure.surface, cut, plan.specimen_is_above);
    if (structure.kind == StructureKind::tumour) {
      const double margin_mm = side == ResectionSide::both ? 0.0 : smallest_distance_mm(structure.surface, plan.cut);
      plan.tumours.push_back({structure.name, side, margin_mm, structure.shift_mm});
      if (side != ResectionSide::specimen) {
        plan.notes.push_back(fmt::format("{} is {}.", structure.name,
                                         side == ResectionSide::both ? "cut through" : "left in the remnant"));
      }
      continue;
    }
    if (structure.kind == StructureKind::cyst) {
      plan.cysts.push_back({structure.name, side});
      continue;
    }
    plan.vessels.push_back({structure.name, side});
    for (const auto& outline : outlines(structure.surface, cut)) {
      if (outline.size() < 3) continue;
      VesselCrossing crossing = crossing_of(structure.name, outline, cut.normal());
      constexpr double out_of_the_liver_mm = 2.0;
      if (border.is_inside(crossing.center_mm) ||
          border.closest(crossing.center_mm).distance_mm <= out_of_the_liver_mm) {
        plan.crossings.push_back(std::move(crossing));
      }
    }
  }
  std::sort(plan.crossings.begin(), plan.crossings.end(),
            [](const VesselCrossing& a, const VesselCrossing& b) { return a.diameter_mm > b.diameter_mm; });
  return plan;
}

namespace {

ResectionSide side_of(const Surface& surface, const CutSurface& cut, bool specimen_is_above) {
  bool above = false, below = false;
  for (const Vector3d& point : surface.points_mm) (cut.height_mm(point) > 0 ? above : below) = true;
  if (above && below) return ResectionSide::both;
  return above == specimen_is_above ? ResectionSide::specimen : ResectionSide::remnant;
}

// From the points of each to the triangles of the other.
double smallest_distance_mm(const Surface& structure, const Surface& cut) {
  double smallest_mm = std::numeric_limits<double>::infinity();
  const geometry::SurfaceDistance to_cut(cut), to_structure(structure);
  for (const Vector3d& point : structure.points_mm) {
    smallest_mm = std::min(smallest_mm, to_cut.closest(point).distance_mm);
  }
  for (const Vector3d& point : cut.points_mm) {
    smallest_mm = std::min(smallest_mm, to_structure.closest(point).distance_mm);
  }
  return smallest_mm;
}

Surface exact_cut(const geometry::TetMesh& liver, const CutSurface& cut) {
  geometry::SplitMesh split = geometry::split_tetrahedra(liver, cut, {.snap = 0, .is_open = {}});
  if (const geometry::Field* moved = geometry::find_field(split.mesh.point_fields, mechanics::displacement_field)) {
    std::vector<int> points;
    for (const double p : geometry::find_field(split.cut.point_fields, "mesh_point")->values) {
      points.push_back(static_cast<int>(p));
    }
    split.cut.point_fields.push_back(geometry::select({*moved}, points).front());
  }
  return std::move(split.cut);
}

std::vector<std::vector<Vector3d>> outlines(const Surface& surface, const CutSurface& cut) {
  std::vector<double> height_mm;
  for (const Vector3d& point : surface.points_mm) height_mm.push_back(cut.height_mm(point));
  const auto above = [&](int p) { return height_mm[static_cast<std::size_t>(p)] > 0; };

  // A triangle that the cut crosses joins two edges; an edge of a closed surface has two such triangles.
  using Edge = std::array<int, 2>;
  std::map<Edge, std::vector<Edge>> joined;
  for (const auto& triangle : surface.triangles) {
    std::vector<Edge> crossed;
    for (int i = 0; i < 3; ++i) {
      const int a = triangle[i], b = triangle[(i + 1) % 3];
      if (above(a) != above(b)) crossed.push_back({std::min(a, b), std::max(a, b)});
    }
    if (crossed.size() != 2) continue;
    joined[crossed[0]].push_back(crossed[1]);
    joined[crossed[1]].push_back(crossed[0]);
  }
  std::vector<std::vector<Vector3d>> found;
  std::map<Edge, bool> visited;
  for (const auto& [start, neighbours] : joined) {
    if (visited[start]) continue;
    std::vector<Vector3d> outline;
    Edge at = start;
    for (bool on = true; on;) {
      visited[at] = true;
      const double share = height_mm[at[0]] / (height_mm[at[0]] - height_mm[at[1]]);
      outline.emplace_back((1 - share) * surface.points_mm[at[0]] + share * surface.points_mm[at[1]]);
      on = false;
      for (const Edge& next : joined[at]) {
        if (visited[next]) continue;
        at = next;
        on = true;
        break;
      }
    }
    found.push_back(std::move(outline));
  }
  return found;
}

VesselCrossing crossing_of(const std::string& name, const std::vector<Vector3d>& outline, const Vector3d& normal) {
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& point : outline) middle += point / static_cast<double>(outline.size());
  const Vector3d first = normal.unitOrthogonal(), second = normal.cross(first);
  // Area, centroid and second moments of the polygon, by its triangles from the middle.
  double area = 0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second_moment = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto in_plane = [&](const Vector3d& p) {
      return Eigen::Vector2d((p - middle).dot(first), (p - middle).dot(second));
    };
    const Eigen::Vector2d p = in_plane(outline[i]), q = in_plane(outline[(i + 1) % outline.size()]);
    const double part = 0.5 * (p.x() * q.y() - p.y() * q.x());
    area += part;
    moment += part * (p + q) / 3.0;
    second_moment += part / 12.0 * (p * p.transpose() + q * q.transpose() + (p + q) * (p + q).transpose());
  }
  if (area == 0) return {name, middle, 0, 0};
  const Eigen::Vector2d centroid = moment / area;
  const Eigen::Matrix2d spread = second_moment / area - centroid * centroid.transpose();
  const double narrow = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvalues()[0];
  return {name, middle + centroid.x() * first + centroid.y() * second, 4.0 * std::sqrt(std::max(0.0, narrow)),
          std::abs(area)};
}

}  // namespace
}  // namespace glisson::rehearsal
