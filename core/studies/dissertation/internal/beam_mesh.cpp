#include "studies/dissertation/internal/beam_mesh.h"

#include <utility>

namespace glisson::studies {

geometry::TetMesh beam_mesh(const std::array<int, 3>& bricks, const Eigen::Vector3d& size_mm) {
  const auto& [nx, ny, nz] = bricks;
  geometry::TetMesh mesh;
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        mesh.points_mm.push_back(size_mm.cwiseProduct(Eigen::Vector3d(double(i) / nx, double(j) / ny, double(k) / nz)));
      }
    }
  }
  // One tetrahedron for each order in which x, y and z can be walked from a brick's first corner to its last.
  constexpr std::array<std::array<std::size_t, 3>, 6> walks{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        for (const auto& walk : walks) {
          std::array<int, 3> at{i, j, k};
          std::array<int, 4> cell{};
          for (std::size_t step = 0; step < 4; ++step) {
            if (step > 0) ++at[walk[step - 1]];
            cell[step] = at[0] + (bricks[0] + 1) * (at[1] + (bricks[1] + 1) * at[2]);
          }
          mesh.cells.push_back(cell);
          if (geometry::cell_volume_mm3(mesh, mesh.cells.size() - 1) < 0) {
            std::swap(mesh.cells.back()[2], mesh.cells.back()[3]);
          }
        }
      }
    }
  }
  return mesh;
}

void name_beam_end(geometry::TetMesh& beam, const std::string& array) {
  geometry::Field named{array, 1, {}};
  for (const Eigen::Vector3d& point : beam.points_mm) named.values.push_back(point.x() == 0 ? 1.0 : 0.0);
  geometry::set_field(beam.point_fields, std::move(named));
}

}  // namespace glisson::studies
