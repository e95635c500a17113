#include "mechanics/elements/boundary.h"

#include <fmt/format.h>
#include <limits>

#include <Eigen/Geometry>

#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {
namespace {

FaceMass unit_face_mass(ElementOrder order) {
  const int count = order == ElementOrder::linear ? 3 : 6;
  FaceMass mass = FaceMass::Zero(count, count);
  for (const TrianglePoint& point : triangle_points_degree_4()) {
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1> values =
        order == ElementOrder::linear
            ? Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>(point.barycentric)
            : Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>(quadratic_triangle_values(point.barycentric));
    mass += point.weight * values * values.transpose();
  }
  return mass;
}

}  // namespace

std::vector<BoundaryFace> boundary_faces(const geometry::TetMesh& mesh, const NodeLayout& layout) {
  const geometry::Surface surface = geometry::boundary_surface(mesh);
  const geometry::Field* mesh_point = geometry::find_field(surface.point_fields, "mesh_point");
  GLISSON_ASSERT(mesh_point != nullptr);

  std::vector<BoundaryFace> faces;
  faces.reserve(surface.triangles.size());
  for (const auto& triangle : surface.triangles) {
    BoundaryFace face;
    for (int i = 0; i < 3; ++i) face.points[i] = static_cast<int>(mesh_point->values[triangle[i]]);
    const auto& [a, b, c] = face.points;
    const Eigen::Vector3d twice_area =
        (mesh.points_mm[b] - mesh.points_mm[a]).cross(mesh.points_mm[c] - mesh.points_mm[a]);
    face.area_mm2 = 0.5 * twice_area.norm();
    face.normal = twice_area.normalized();
    face.centroid_mm = (mesh.points_mm[a] + mesh.points_mm[b] + mesh.points_mm[c]) / 3.0;
    face.nodes.fill(-1);
    for (int i = 0; i < 3; ++i) {
      face.nodes[i] = layout.node_of_point[face.points[i]];
      if (layout.order == ElementOrder::quadratic) {
        face.nodes[3 + i] = layout.node_of_edge(face.points[i], face.points[(i + 1) % 3]);
      }
    }
    faces.push_back(face);
  }
  return faces;
}

Result<std::vector<std::size_t>> faces_within(const std::vector<BoundaryFace>& boundary,
                                              const Eigen::Vector3d& center_mm, double radius_mm) {
  std::vector<std::size_t> within;
  double nearest_squared_mm2 = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    const double squared_distance_mm2 = (boundary[f].centroid_mm - center_mm).squaredNorm();
    nearest_squared_mm2 = std::min(nearest_squared_mm2, squared_distance_mm2);
    if (squared_distance_mm2 <= radius_mm * radius_mm) within.push_back(f);
  }
  if (!within.empty()) return within;
  return failure(Error{
      "tool-touches-nothing",
      GLISSON_TEXT("The tool at ({0}, {1}, {2}) mm with radius {3} mm touches nothing: the centre of "
                   "the nearest face of the surface is {4} mm away."),
      {fmt::format("{:.1f}", center_mm.x()), fmt::format("{:.1f}", center_mm.y()), fmt::format("{:.1f}", center_mm.z()),
       fmt::format("{:.1f}", radius_mm), fmt::format("{:.1f}", std::sqrt(nearest_squared_mm2))},
      GLISSON_TEXT("Move its centre onto the surface, or make its radius larger than {4} mm."),
      {}});
}

void add_traction(const BoundaryFace& face, const Eigen::Vector3d& traction_kPa, Eigen::VectorXd& force_mN) {
  // A uniform traction loads a linear triangle's corners with a third of its area each, and of a quadratic one's
  // nodes the middles alone: the integrals of the corner functions vanish.
  const int first = face.nodes[3] < 0 ? 0 : 3;
  for (int i = first; i < first + 3; ++i) {
    force_mN.segment<3>(3 * face.nodes[i]) += face.area_mm2 / 3.0 * traction_kPa;
  }
}

FaceMass face_mass_mm2(const BoundaryFace& face, ElementOrder order) {
  static const FaceMass of_linear = unit_face_mass(ElementOrder::linear);
  static const FaceMass of_quadratic = unit_face_mass(ElementOrder::quadratic);
  return face.area_mm2 * (order == ElementOrder::linear ? of_linear : of_quadratic);
}

}  // namespace glisson::mechanics
