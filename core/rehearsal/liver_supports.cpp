#include "rehearsal/liver_supports.h"

#include <cmath>

namespace glisson::rehearsal {
namespace {

constexpr double abdominal_wall_kPa = 22.0;
constexpr double abdominal_wall_thickness_mm = 20.0;

bool has_whole_face(const geometry::Surface& boundary, const std::vector<bool>& marked) {
  for (const auto& [a, b, c] : boundary.triangles) {
    if (marked[static_cast<std::size_t>(a)] && marked[static_cast<std::size_t>(b)] &&
        marked[static_cast<std::size_t>(c)]) {
      return true;
    }
  }
  return false;
}

}  // namespace

Result<void> mark_attachments(geometry::TetMesh& liver) {
  const geometry::Surface boundary = geometry::boundary_surface(liver);
  const std::vector<Eigen::Vector3d> normals = geometry::point_normals(boundary);
  const geometry::Box box = geometry::bounding_box(boundary.points_mm);
  const Eigen::Vector3d back_and_head = Eigen::Vector3d(0, 1, 1).normalized();
  const geometry::Field* mesh_point = geometry::find_field(boundary.point_fields, "mesh_point");
  GLISSON_ASSERT(mesh_point != nullptr);

  geometry::Field bare_area{"bare_area", 1, std::vector<double>(liver.points_mm.size(), 0.0)};
  geometry::Field diaphragm{"diaphragm", 1, std::vector<double>(liver.points_mm.size(), 0.0)};
  std::vector<bool> bare(boundary.points_mm.size());
  for (std::size_t i = 0; i < boundary.points_mm.size(); ++i) {
    const auto point = static_cast<std::size_t>(mesh_point->values[i]);
    const Eigen::Vector3d height = boundary.points_mm[i] - box.center_mm();
    bare[i] = height.y() > 0 && height.z() > 0 && normals[i].dot(back_and_head) > std::cos(M_PI / 4);
    bare_area.values[point] = bare[i] ? 1.0 : 0.0;
    diaphragm.values[point] = !bare[i] && normals[i].z() > std::cos(M_PI / 3) ? 1.0 : 0.0;
  }
  if (!has_whole_face(boundary, bare)) {
    return failure(Error{"liver-no-attachment",
                         GLISSON_TEXT("No part of the surface looks like the liver's bare area (its upper rear)."),
                         {},
                         GLISSON_TEXT("Name the supports in the scenario, by a sphere or a box."),
                         {}});
  }
  geometry::set_field(liver.point_fields, std::move(bare_area));
  geometry::set_field(liver.point_fields, std::move(diaphragm));
  return {};
}

std::vector<mechanics::Support> usual_supports() {
  return {
      {mechanics::NamedPoints{"bare_area"}, mechanics::Fixed{}},
      {mechanics::NamedPoints{"diaphragm"}, mechanics::Foundation{abdominal_wall_kPa / abdominal_wall_thickness_mm}}};
}

}  // namespace glisson::rehearsal
