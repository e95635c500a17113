#include "rehearsal/comparison.h"

#include <algorithm>
#include <Eigen/Geometry>

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;

Result<const geometry::Field*> displacement_of(const ComparedResult& result);
Result<void> check_same_mesh(const geometry::TetMesh& a, const geometry::TetMesh& b);
ComparedResult compared(const mechanics::Simulation& simulation);
void compare_surfaces(const geometry::TetMesh& mesh, const std::vector<mechanics::ToolLoad>& tools,
                      Comparison& comparison);

}  // namespace

Result<Comparison> compare(const mechanics::Simulation& a, const mechanics::Simulation& b) {
  for (const mechanics::Simulation* simulation : {&a, &b}) {
    if (simulation->result.converged()) continue;
    return failure("comparison-mismatch", GLISSON_TEXT("A result that did not converge cannot be compared: {0}"),
                   {simulation->result.why_stopped});
  }
  return compare(compared(a), compared(b));
}

Result<Comparison> compare(const ComparedResult& a, const ComparedResult& b) {
  if (auto checked = check_same_mesh(a.mesh, b.mesh); !checked) return failure(std::move(checked.error()));
  const auto in_a = displacement_of(a);
  if (!in_a) return failure(in_a.error());
  const auto in_b = displacement_of(b);
  if (!in_b) return failure(in_b.error());

  Comparison comparison;
  comparison.difference_mm.resize(a.mesh.points_mm.size());
  for (std::size_t p = 0; p < comparison.difference_mm.size(); ++p) {
    const Eigen::Map<const Vector3d> u((*in_a)->values.data() + 3 * p), v((*in_b)->values.data() + 3 * p);
    comparison.difference_mm[p] = (u - v).norm();
  }
  compare_surfaces(a.mesh, a.tools.empty() ? b.tools : a.tools, comparison);

  comparison.landmarks = differences_between(a.landmarks, b.landmarks);
  for (const LandmarkDifference& landmark : comparison.landmarks) {
    comparison.max_mm = std::max(comparison.max_mm, landmark.difference_mm);
  }
  return comparison;
}

std::vector<LandmarkDifference> differences_between(const std::vector<mechanics::DisplacedLandmark>& a,
                                                    const std::vector<mechanics::DisplacedLandmark>& b) {
  std::vector<LandmarkDifference> differences;
  for (const mechanics::DisplacedLandmark& one : a) {
    const auto other = std::find_if(b.begin(), b.end(), [&](const auto& candidate) { return candidate.id == one.id; });
    if (other == b.end()) continue;
    differences.push_back(
        {one.id, one.displacement_mm, other->displacement_mm, (one.displaced_mm - other->displaced_mm).norm()});
  }
  return differences;
}

namespace {

Result<const geometry::Field*> displacement_of(const ComparedResult& result) {
  const geometry::Field* field = geometry::find_field(result.mesh.point_fields, mechanics::displacement_field);
  if (field != nullptr && field->components == 3 && field->values.size() == 3 * result.mesh.points_mm.size()) {
    return field;
  }
  return failure("comparison-mismatch", GLISSON_TEXT("A result lacks the point array {0} with three values a point."),
                 {mechanics::displacement_field});
}

Result<void> check_same_mesh(const geometry::TetMesh& a, const geometry::TetMesh& b) {
  const std::string hint = GLISSON_TEXT("Compare results of the same mesh.");
  if (a.points_mm.size() != b.points_mm.size() || a.cells != b.cells) {
    return failure(Error{"comparison-mismatch",
                         GLISSON_TEXT("The two results are not of the same mesh: {0} points and {1} cells against {2} "
                                      "and {3}."),
                         {std::to_string(a.points_mm.size()), std::to_string(a.cells.size()),
                          std::to_string(b.points_mm.size()), std::to_string(b.cells.size())},
                         hint,
                         {}});
  }
  constexpr double same_place_mm = 1e-3;
  for (std::size_t p = 0; p < a.points_mm.size(); ++p) {
    if ((a.points_mm[p] - b.points_mm[p]).norm() <= same_place_mm) continue;
    return failure(Error{"comparison-mismatch",
                         GLISSON_TEXT("The two results are not of the same mesh: point {0} rests at different places."),
                         {std::to_string(p)},
                         hint,
                         {}});
  }
  return {};
}

ComparedResult compared(const mechanics::Simulation& simulation) {
  ComparedResult result{simulation.mesh, simulation.landmarks, {}};
  for (const mechanics::Load& load : simulation.scenario.loads) {
    if (const auto* tool = std::get_if<mechanics::ToolLoad>(&load)) result.tools.push_back(*tool);
  }
  return result;
}

void compare_surfaces(const geometry::TetMesh& mesh, const std::vector<mechanics::ToolLoad>& tools,
                      Comparison& comparison) {
  const geometry::Surface surface = geometry::boundary_surface(mesh);
  const auto& mesh_point = geometry::find_field(surface.point_fields, "mesh_point")->values;
  const auto difference_at = [&](int point) {
    return comparison.difference_mm[static_cast<std::size_t>(mesh_point[point])];
  };

  double area_mm2 = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const double area =
        0.5 * (surface.points_mm[b] - surface.points_mm[a]).cross(surface.points_mm[c] - surface.points_mm[a]).norm();
    comparison.mean_mm += area * (difference_at(a) + difference_at(b) + difference_at(c)) / 3.0;
    area_mm2 += area;
  }
  comparison.mean_mm /= area_mm2;

  for (std::size_t p = 0; p < surface.points_mm.size(); ++p) {
    const double difference_mm = difference_at(static_cast<int>(p));
    comparison.max_mm = std::max(comparison.max_mm, difference_mm);
    for (const mechanics::ToolLoad& tool : tools) {
      if ((surface.points_mm[p] - tool.center_mm).norm() > 2.0 * tool.radius_mm) continue;
      comparison.max_near_tool_mm = std::max(comparison.max_near_tool_mm.value_or(0.0), difference_mm);
    }
  }
}

}  // namespace
}  // namespace glisson::rehearsal
