#include "widgets/guide/placed_scene.h"

#include <algorithm>

#include "guidance/hand_pose.h"
#include "guidance/seen_line.h"
#include "scene/anatomy.h"

namespace glisson::widgets {
namespace {

using Eigen::Vector3d;

constexpr scene::Colour cloud_colour{0.45, 0.95, 0.55};
constexpr scene::Colour current_colour{1.0, 0.85, 0.2}, marked_colour{0.85, 0.7, 0.45};

// Octahedra of 1.2 mm in one surface: hundreds of spheres would each be drawn apart.
std::shared_ptr<const geometry::Surface> dots(const std::vector<Vector3d>& points_mm) {
  constexpr std::size_t most = 700;
  constexpr double radius_mm = 1.2;
  constexpr int corners[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                 {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  auto surface = std::make_shared<geometry::Surface>();
  const std::size_t step = std::max<std::size_t>(1, (points_mm.size() + most - 1) / most);
  for (std::size_t p = 0; p < points_mm.size(); p += step) {
    const int first = static_cast<int>(surface->points_mm.size());
    for (int axis = 0; axis < 3; ++axis) {
      surface->points_mm.emplace_back(points_mm[p] + radius_mm * Vector3d::Unit(axis));
      surface->points_mm.emplace_back(points_mm[p] - radius_mm * Vector3d::Unit(axis));
    }
    for (const auto& [a, b, c] : corners) surface->triangles.push_back({first + a, first + b, first + c});
  }
  return surface;
}

}  // namespace

scene::Scene placed_scene(const casefile::GuidedSequence& guided, const guidance::ElasticPlacement& placement,
                          const std::vector<Vector3d>& seen_mm) {
  scene::Scene shown;
  const Eigen::Isometry3d back = placement.pose.inverse();
  for (const guidance::EmbeddedStructure& structure : guided.structures) {
    if (structure.at_rest.triangles.empty()) continue;  // lines on the liver
    auto surface = std::make_shared<geometry::Surface>();
    surface->triangles = structure.at_rest.triangles;
    surface->points_mm = guidance::placed_points_mm(structure, guided.guidance.mesh, placement);
    for (Vector3d& point : surface->points_mm) point = back * point;
    const scene::Appearance look = scene::appearance_of(structure.name);
    shown.surfaces.push_back({structure.name, surface, look.colour, look.opacity, look.finish, {}});
  }
  if (!seen_mm.empty()) {
    std::vector<Vector3d> in_scan_mm;
    for (const Vector3d& point : seen_mm) in_scan_mm.push_back(back * point);
    shown.surfaces.push_back({"seen", dots(in_scan_mm), cloud_colour, 1, scene::Finish::solid, {}, false});
  }
  return shown;
}

scene::Scene marking_scene(const casefile::GuidedSequence& guided, const casefile::MarkedLines& marked,
                           const std::string& current) {
  scene::Scene shown =
      placed_scene(guided, guidance::rigid_placement(Eigen::Isometry3d::Identity(), guided.guidance.mesh), {});
  for (const casefile::MarkedLine& line : marked.lines) {
    if (line.at_rest_mm.empty()) continue;
    shown.surfaces.push_back({"marked",
                              dots(guidance::filled_in(line.at_rest_mm, 1.5)),
                              line.id == current ? current_colour : marked_colour,
                              1,
                              scene::Finish::solid,
                              {},
                              false});
  }
  return shown;
}

scene::Camera laparoscope_camera(const casefile::GuidedSequence& guided, const guidance::ElasticPlacement& placement,
                                 const vision::Camera& camera, int width_px, double aspect) {
  const Eigen::Matrix3d back = placement.pose.linear().transpose();
  scene::Camera from;
  from.focus_mm = geometry::bounding_box(guided.structures.front().at_rest.points_mm).center_mm();
  from.sight = back * Vector3d::UnitZ();
  from.up = -(back * Vector3d::UnitY());
  from.visible_height_mm = (placement.pose * from.focus_mm).z() * width_px / camera.matrix(0, 0) / aspect;
  return from;
}

}  // namespace glisson::widgets
