#include "mechanics/point_location.h"

#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/LU>

#include "base/parallel.h"
#include "mechanics/box_tree.h"
#include "mechanics/shape_functions.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

struct OuterFace {
  std::array<int, 3> points;
  int cell;
};

std::vector<OuterFace> outer_faces(const geometry::TetMesh& mesh);
BoxTree tree_of_cells(const geometry::TetMesh& mesh);
BoxTree tree_of_faces(const geometry::TetMesh& mesh, const std::vector<OuterFace>& faces);
Eigen::Vector4d barycentric_in(const geometry::TetMesh& mesh, int cell, const Vector3d& position_mm);
Vector3d nearest_in_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c);

}  // namespace

std::vector<PointInMesh> locate_points(const geometry::TetMesh& mesh, const std::vector<Vector3d>& positions_mm) {
  const BoxTree cells = tree_of_cells(mesh);
  const std::vector<OuterFace> faces = outer_faces(mesh);
  const BoxTree tree_of_outer = tree_of_faces(mesh, faces);

  const auto clamped = [](const Eigen::Vector4d& barycentric) -> Eigen::Vector4d {
    const Eigen::Vector4d positive = barycentric.cwiseMax(0.0);
    return positive / positive.sum();
  };
  const auto locate = [&](const Vector3d& position_mm) {
    PointInMesh place;
    // A place on a face between cells belongs to both: the slack of 1e-9 keeps rounding from losing it to neither.
    const bool inside = cells.visit_containing(position_mm, [&](int cell) {
      const Eigen::Vector4d barycentric = barycentric_in(mesh, cell, position_mm);
      if (!(barycentric.minCoeff() >= -1e-9)) return false;
      place = {cell, clamped(barycentric), 0.0};
      return true;
    });
    if (inside) return place;
    double nearest_squared_mm2 = std::numeric_limits<double>::infinity();
    tree_of_outer.visit_nearest(position_mm, [&](int f) {
      const auto& [a, b, c] = faces[f].points;
      const Vector3d foot_mm =
          nearest_in_triangle(position_mm, mesh.points_mm[a], mesh.points_mm[b], mesh.points_mm[c]);
      const double squared_distance_mm2 = (foot_mm - position_mm).squaredNorm();
      if (squared_distance_mm2 < nearest_squared_mm2) {
        nearest_squared_mm2 = squared_distance_mm2;
        place = {faces[f].cell, clamped(barycentric_in(mesh, faces[f].cell, foot_mm)), std::sqrt(squared_distance_mm2)};
      }
      return squared_distance_mm2;
    });
    return place;
  };

  std::vector<PointInMesh> places(positions_mm.size());
  parallel_for(places.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) places[i] = locate(positions_mm[i]);
  });
  return places;
}

namespace {

std::vector<OuterFace> outer_faces(const geometry::TetMesh& mesh) {
  const geometry::Surface surface = geometry::boundary_surface(mesh);
  const auto& mesh_point = geometry::find_field(surface.point_fields, "mesh_point")->values;
  const auto& mesh_cell = geometry::find_field(surface.cell_fields, "mesh_cell")->values;
  std::vector<OuterFace> faces(surface.triangles.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) faces[f].points[i] = static_cast<int>(mesh_point[surface.triangles[f][i]]);
    faces[f].cell = static_cast<int>(mesh_cell[f]);
  }
  return faces;
}

template <typename Points>
Eigen::AlignedBox3d box_around(const geometry::TetMesh& mesh, const Points& points) {
  Eigen::AlignedBox3d box;
  for (const int p : points) box.extend(mesh.points_mm[p]);
  const Vector3d slack = Vector3d::Constant(1e-9 * (box.diagonal().norm() + box.center().norm()));
  return {Vector3d(box.min() - slack), Vector3d(box.max() + slack)};
}

BoxTree tree_of_cells(const geometry::TetMesh& mesh) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(mesh.cells.size());
  for (const auto& cell : mesh.cells) boxes.push_back(box_around(mesh, cell));
  return BoxTree(boxes);
}

BoxTree tree_of_faces(const geometry::TetMesh& mesh, const std::vector<OuterFace>& faces) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(faces.size());
  for (const OuterFace& face : faces) boxes.push_back(box_around(mesh, face.points));
  return BoxTree(boxes);
}

Eigen::Vector4d barycentric_in(const geometry::TetMesh& mesh, int cell, const Vector3d& position_mm) {
  const CellGeometry shape = cell_geometry(mesh, static_cast<std::size_t>(cell));
  Eigen::Vector4d barycentric = shape.barycentric_gradients * (position_mm - mesh.points_mm[mesh.cells[cell][0]]);
  barycentric[0] += 1.0;
  return barycentric;
}

// Ericson, Real-Time Collision Detection, 5.1.5: which of the triangle's seven Voronoi regions holds the point.
Vector3d nearest_in_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a;
  const double d1 = ab.dot(p - a), d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = ab.dot(p - b), d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const double d5 = ab.dot(p - c), d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  return a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac;
}

}  // namespace
}  // namespace glisson::mechanics
