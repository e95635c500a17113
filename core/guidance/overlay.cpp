#include "guidance/overlay.h"

#include <algorithm>
#include <utility>

namespace glisson::guidance {

using Eigen::Vector3d;

namespace {

double mean_depth_mm(const std::vector<Vector3d>& points_mm) {
  double sum = 0;
  for (const Vector3d& point : points_mm) sum += point.z();
  return points_mm.empty() ? 0 : sum / static_cast<double>(points_mm.size());
}

// The triangles all of whose corners lie before the camera.
std::vector<std::array<Eigen::Vector2d, 3>> projected(const vision::Camera& camera,
                                                      const std::vector<Vector3d>& points_mm,
                                                      const std::vector<std::array<int, 3>>& triangles) {
  const auto pixels = vision::project(camera, points_mm);
  std::vector<std::array<Eigen::Vector2d, 3>> shown;
  for (const auto& [a, b, c] : triangles) {
    const auto &pa = pixels[static_cast<std::size_t>(a)], &pb = pixels[static_cast<std::size_t>(b)],
               &pc = pixels[static_cast<std::size_t>(c)];
    if (pa && pb && pc) shown.push_back({*pa, *pb, *pc});
  }
  return shown;
}

}  // namespace

EmbeddedStructure embedded(std::string name, const vision::Rgb& colour, geometry::Surface at_rest,
                           const geometry::TetMesh& mesh) {
  auto places = mechanics::locate_points(mesh, at_rest.points_mm);
  return {std::move(name), colour, std::move(at_rest), std::move(places)};
}

std::vector<Vector3d> placed_points_mm(const EmbeddedStructure& structure, const geometry::TetMesh& mesh,
                                       const ElasticPlacement& placement) {
  std::vector<Vector3d> points_mm = structure.at_rest.points_mm;
  for (std::size_t p = 0; p < points_mm.size(); ++p) {
    const mechanics::PointInMesh& place = structure.places[p];
    const auto& corners = mesh.cells[static_cast<std::size_t>(place.cell)];
    for (int k = 0; k < 4; ++k) {
      points_mm[p] += place.barycentric[k] *
                      placement.displacement_mm[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])];
    }
    points_mm[p] = placement.pose * points_mm[p];
  }
  return points_mm;
}

void draw_placed(vision::Frame& frame, const vision::Camera& camera, const geometry::TetMesh& mesh,
                 const std::vector<EmbeddedStructure>& structures, const ElasticPlacement& placement) {
  if (!placement.converged) return;
  std::vector<std::pair<const EmbeddedStructure*, std::vector<Vector3d>>> placed;
  for (const EmbeddedStructure& structure : structures) {
    placed.emplace_back(&structure, placed_points_mm(structure, mesh, placement));
  }
  std::stable_sort(placed.begin(), placed.end(),
                   [](const auto& a, const auto& b) { return mean_depth_mm(a.second) > mean_depth_mm(b.second); });
  const int width_px = std::max(1, frame.height / 240);
  for (const auto& [structure, points_mm] : placed) {
    vision::draw_outline(frame, projected(camera, points_mm, structure->at_rest.triangles), structure->colour,
                         width_px);
  }
}

}  // namespace glisson::guidance
