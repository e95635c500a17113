#pragma once
// Shapes whose area and volume are known in closed form.

#include <array>
#include <Eigen/Core>
#include <map>
#include <utility>

#include "geometry/surface.h"
#include "geometry/tetrahedra.h"

namespace glisson::test {

// A box cut into nx * ny * nz bricks of six tetrahedra each (Kuhn's subdivision, which fits from brick to brick).
inline geometry::TetMesh box_of_tetrahedra(const std::array<int, 3>& bricks, const Eigen::Vector3d& size_mm,
                                           const Eigen::Vector3d& corner_mm = Eigen::Vector3d::Zero()) {
  geometry::TetMesh mesh;
  const auto point = [&](int i, int j, int k) { return i + (bricks[0] + 1) * (j + (bricks[1] + 1) * k); };
  for (int k = 0; k <= bricks[2]; ++k) {
    for (int j = 0; j <= bricks[1]; ++j) {
      for (int i = 0; i <= bricks[0]; ++i) {
        const Eigen::Vector3d fraction(double(i) / bricks[0], double(j) / bricks[1], double(k) / bricks[2]);
        mesh.points_mm.push_back(corner_mm + fraction.cwiseProduct(size_mm));
      }
    }
  }
  // One tetrahedron for each order in which x, y and z can be walked from the brick's first corner to its last.
  constexpr std::array<std::array<int, 3>, 6> walks{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int k = 0; k < bricks[2]; ++k) {
    for (int j = 0; j < bricks[1]; ++j) {
      for (int i = 0; i < bricks[0]; ++i) {
        for (const auto& walk : walks) {
          std::array<int, 3> at{i, j, k};
          std::array<int, 4> cell{point(at[0], at[1], at[2])};
          for (std::size_t step = 0; step < 3; ++step) {
            ++at[static_cast<std::size_t>(walk[step])];
            cell[step + 1] = point(at[0], at[1], at[2]);
          }
          mesh.cells.push_back(cell);
          if (cell_volume_mm3(mesh, mesh.cells.size() - 1) < 0) std::swap(mesh.cells.back()[2], mesh.cells.back()[3]);
        }
      }
    }
  }
  return mesh;
}

// A sphere as an icosahedron whose triangles are cut in four `subdivisions` times; its points lie on the sphere.
inline geometry::Surface sphere_surface(double radius_mm, int subdivisions,
                                        const Eigen::Vector3d& center_mm = Eigen::Vector3d::Zero()) {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  geometry::Surface sphere;
  sphere.points_mm = {{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                      {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                      {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
  sphere.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int round = 0; round < subdivisions; ++round) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(sphere.points_mm.size()));
      if (is_new) {
        sphere.points_mm.push_back(
            0.5 * (sphere.points_mm[static_cast<std::size_t>(a)] + sphere.points_mm[static_cast<std::size_t>(b)]));
      }
      return found->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : sphere.triangles) {
      const int ab = middle(a, b);
      const int bc = middle(b, c);
      const int ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    sphere.triangles = std::move(finer);
    for (Eigen::Vector3d& point : sphere.points_mm) point.normalize();
  }
  for (Eigen::Vector3d& point : sphere.points_mm) point = center_mm + radius_mm * point.normalized();
  return sphere;
}

}  // namespace glisson::test
