#include "meshing/internal/voxel_faces.h"

namespace glisson::meshing {

geometry::Surface voxel_faces(const PieceMap& map) {
  const imaging::Grid& grid = map.grid;
  geometry::Surface surface;
  imaging::Grid corners = grid;
  for (int& length : corners.size) ++length;
  std::vector<int> number(corners.voxels(), -1);
  const auto point = [&](const Eigen::Vector3i& corner) {
    int& known = number[corners.offset(corner.x(), corner.y(), corner.z())];
    if (known < 0) {
      known = static_cast<int>(surface.points_mm.size());
      surface.points_mm.push_back(grid.spacing_mm.cwiseProduct(corner.cast<double>() - Eigen::Vector3d::Constant(0.5)));
    }
    return known;
  };
  const auto add_face = [&](const Eigen::Vector3i& first, const Eigen::Vector3i& along, const Eigen::Vector3i& then) {
    const int a = point(first);
    const int b = point(first + along);
    const int c = point(first + along + then);
    const int d = point(first + then);
    surface.triangles.push_back({a, b, c});
    surface.triangles.push_back({a, c, d});
  };
  for (int k = 0; k + 1 < grid.size[2]; ++k) {
    for (int j = 0; j + 1 < grid.size[1]; ++j) {
      for (int i = 0; i + 1 < grid.size[0]; ++i) {
        const Eigen::Vector3i voxel(i, j, k);
        const bool inside = map.piece[grid.offset(i, j, k)] != 0;
        for (int axis = 0; axis < 3; ++axis) {
          const Eigen::Vector3i step = Eigen::Vector3i::Unit(axis);
          const Eigen::Vector3i next = voxel + step;
          const bool next_inside = map.piece[grid.offset(next.x(), next.y(), next.z())] != 0;
          if (inside == next_inside) continue;
          const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + 1) % 3);
          const Eigen::Vector3i v = Eigen::Vector3i::Unit((axis + 2) % 3);
          if (inside) {
            add_face(next, u, v);  // u x v is the axis: outward, towards the next voxel
          } else {
            add_face(next, v, u);
          }
        }
      }
    }
  }
  return surface;
}

}  // namespace glisson::meshing
