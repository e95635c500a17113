#pragma once
// Bodies for the tests of mechanics: boxes of tetrahedra, bent into other shapes where a test asks for it.

#include <cmath>
#include <cstdint>
#include <functional>

#include "geometry/tetrahedra.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics::test {

using Bend = std::function<Eigen::Vector3d(const Eigen::Vector3d& unit)>;

// nx * ny * nz bricks of six tetrahedra each (Kuhn's division, so that bricks fit each other), the unit cube mapped
// by `bend`, which must keep its orientation.
inline geometry::TetMesh bent_box(int nx, int ny, int nz, const Bend& bend) {
  geometry::TetMesh mesh;
  const auto point = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) mesh.points_mm.push_back(bend({double(i) / nx, double(j) / ny, double(k) / nz}));
    }
  }
  constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        for (const auto& order : orders) {
          // A path along the brick's edges from its first corner to its last, one axis after the other.
          int at[3] = {i, j, k};
          std::array<int, 4> cell{point(i, j, k), 0, 0, 0};
          for (int step = 0; step < 3; ++step) {
            ++at[order[step]];
            cell[step + 1] = point(at[0], at[1], at[2]);
          }
          mesh.cells.push_back(cell);
          if (geometry::cell_volume_mm3(mesh, mesh.cells.size() - 1) < 0)
            std::swap(mesh.cells.back()[2], mesh.cells.back()[3]);
        }
      }
    }
  }
  return mesh;
}

inline geometry::TetMesh box(int nx, int ny, int nz, const Eigen::Vector3d& size_mm) {
  return bent_box(nx, ny, nz, [&](const Eigen::Vector3d& unit) { return unit.cwiseProduct(size_mm).eval(); });
}

// Adds a point array that is 1 where the predicate holds.
inline void name_points(geometry::TetMesh& mesh, const std::string& array,
                        const std::function<bool(const Eigen::Vector3d&)>& holds) {
  geometry::Field field{array, 1, {}};
  for (const auto& point : mesh.points_mm) field.values.push_back(holds(point) ? 1.0 : 0.0);
  geometry::set_field(mesh.point_fields, std::move(field));
}

// Moves the inner points about, repeatably, so that no exactness can come from the mesh being regular.
inline void disturb_inner_points(geometry::TetMesh& mesh, double amount_mm) {
  const geometry::Surface surface = geometry::boundary_surface(mesh);
  std::vector<std::uint8_t> outer(mesh.points_mm.size(), 0);
  for (const double p : geometry::find_field(surface.point_fields, "mesh_point")->values) outer[std::size_t(p)] = 1;
  for (std::size_t p = 0; p < outer.size(); ++p) {
    if (outer[p]) continue;
    const double t = 12.9898 * double(p);
    mesh.points_mm[p] += amount_mm * Eigen::Vector3d(std::sin(t), std::sin(1.7 * t + 1), std::sin(2.3 * t + 2));
  }
}

inline std::vector<double> uniform(const geometry::TetMesh& mesh, double youngs_kPa) {
  return std::vector<double>(mesh.cells.size(), youngs_kPa);
}

inline Support fixed(const std::string& array) { return {NamedPoints{array}, Fixed{}}; }
inline Support held_along(const std::string& array, bool x, bool y, bool z) {
  return {NamedPoints{array}, Fixed{{x, y, z}}};
}

// The mesh point nearest to a place.
inline std::size_t point_at(const geometry::TetMesh& mesh, const Eigen::Vector3d& place_mm) {
  std::size_t nearest = 0;
  for (std::size_t p = 1; p < mesh.points_mm.size(); ++p) {
    if ((mesh.points_mm[p] - place_mm).squaredNorm() < (mesh.points_mm[nearest] - place_mm).squaredNorm()) nearest = p;
  }
  return nearest;
}

}  // namespace glisson::mechanics::test
