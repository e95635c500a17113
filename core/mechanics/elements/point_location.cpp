#include "mechanics/elements/point_location.h"

#include <atomic>

#include "base/parallel.h"
#include "geometry/nearest.h"
#include "mechanics/elements/box_tree.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;

BoxTree tree_of_cells(const geometry::TetMesh& mesh);
Eigen::Vector4d barycentric_in(const geometry::TetMesh& mesh, int cell, const Vector3d& position_mm);
Eigen::Vector4d clamped(const Eigen::Vector4d& barycentric);

}  // namespace

std::vector<PointInMesh> locate_points(const geometry::TetMesh& mesh, const std::vector<Vector3d>& positions_mm) {
  const BoxTree cells = tree_of_cells(mesh);
  const geometry::Surface boundary = geometry::boundary_surface(mesh);
  const geometry::SurfaceDistance to_boundary(boundary);
  const auto& cell_behind = geometry::find_field(boundary.cell_fields, "mesh_cell")->values;

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
    const auto closest = to_boundary.closest(position_mm);
    const int cell = static_cast<int>(cell_behind[static_cast<std::size_t>(closest.triangle)]);
    return PointInMesh{cell, clamped(barycentric_in(mesh, cell, closest.point_mm)), closest.distance_mm};
  };

  std::vector<PointInMesh> places(positions_mm.size());
  parallel_for(places.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) places[i] = locate(positions_mm[i]);
  });
  return places;
}

int cells_in_others(const geometry::TetMesh& mesh) {
  const BoxTree cells = tree_of_cells(mesh);
  std::atomic<int> count{0};
  parallel_for(mesh.cells.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t own = begin; own < end; ++own) {
      const Vector3d centroid_mm = geometry::cell_centroid_mm(mesh, own);
      constexpr double well_inside = 1e-6;
      const bool in_another = cells.visit_containing(centroid_mm, [&](int cell) {
        return static_cast<std::size_t>(cell) != own &&
               barycentric_in(mesh, cell, centroid_mm).minCoeff() > well_inside;
      });
      if (in_another) ++count;
    }
  });
  return count;
}

namespace {

BoxTree tree_of_cells(const geometry::TetMesh& mesh) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(mesh.cells.size());
  for (const auto& cell : mesh.cells) {
    Eigen::AlignedBox3d box;
    for (const int p : cell) box.extend(mesh.points_mm[p]);
    const Vector3d slack = Vector3d::Constant(1e-9 * (box.diagonal().norm() + box.center().norm()));
    boxes.emplace_back(Vector3d(box.min() - slack), Vector3d(box.max() + slack));
  }
  return BoxTree(boxes);
}

Eigen::Vector4d barycentric_in(const geometry::TetMesh& mesh, int cell, const Vector3d& position_mm) {
  const CellGeometry shape = cell_geometry(mesh, static_cast<std::size_t>(cell));
  Eigen::Vector4d barycentric = shape.barycentric_gradients * (position_mm - mesh.points_mm[mesh.cells[cell][0]]);
  barycentric[0] += 1.0;
  return barycentric;
}

Eigen::Vector4d clamped(const Eigen::Vector4d& barycentric) {
  const Eigen::Vector4d positive = barycentric.cwiseMax(0.0);
  return positive / positive.sum();
}

}  // namespace
}  // namespace glisson::mechanics
