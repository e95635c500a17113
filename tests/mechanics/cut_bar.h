#pragma once
// A bar that a live cut opens, and the same bar meshed with the cut.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bodies.h"
#include "geometry/cut_surface.h"
#include "geometry/tetrahedra.h"
#include "mechanics/scenario/scenario.h"

namespace glisson::mechanics::test {

// Clamped at one end and resting on springs at a part of its bottom; an oblique cut from above opens. Not the block on
// which the bridges' stiffness was chosen (whole_walls.h).
inline const Eigen::Vector3d size_mm(80, 24, 40);
inline constexpr double youngs_kPa = 8.0;
inline constexpr double bed_to_mm = 60;

// Where the cut crosses the bar at a height; a curved one bulges across it.
inline double cut_x_mm(double z_mm, double y_mm = 0, double bulge_mm = 0) {
  return 33.7 + 0.3 * z_mm + bulge_mm * std::sin(std::numbers::pi * y_mm / size_mm.y());
}
inline const geometry::CutSurface wall =
    geometry::CutSurface::plane({cut_x_mm(0), 0, 0}, Eigen::Vector3d(1, 0, -0.3).normalized()).value();
inline Eigen::Vector3d on_front_mm(double z_mm) { return {cut_x_mm(z_mm), 0, z_mm}; }

inline void name_supports_of_bar(geometry::TetMesh& mesh) {
  name_points(mesh, "clamped", [](const Eigen::Vector3d& p) { return p.x() < 1e-6; });
  name_points(mesh, "bed", [](const Eigen::Vector3d& p) { return p.z() < 1e-6 && p.x() < bed_to_mm + 1e-6; });
}
inline std::vector<Support> supports_of_bar() {
  return {{NamedPoints{"clamped"}, Fixed{}}, {NamedPoints{"bed"}, Foundation{0.05}}};
}

// Where points lie at the bed's end, as those meshed with the cut have them: else beds are not of one length.
inline geometry::TetMesh bar(int nx, int ny, int nz) {
  geometry::TetMesh mesh = box(nx, ny, nz, size_mm);
  disturb_inner_points(mesh, 0.1 * size_mm.x() / nx);
  return mesh;
}

inline geometry::CutSurface curved_wall(double bulge_mm) {
  std::vector<Eigen::Vector3d> points_mm;
  for (double z_mm = -5; z_mm < 46; z_mm += 10) {
    for (double y_mm = 0; y_mm < 25; y_mm += 3) points_mm.emplace_back(cut_x_mm(z_mm, y_mm, bulge_mm), y_mm, z_mm);
  }
  return geometry::CutSurface::through(points_mm).value();
}

// Meshed with the cut: the points of its wall are doubled above the front.
struct MeshedCut {
  geometry::TetMesh mesh;
  std::vector<int> wall_points;
};
inline MeshedCut meshed_with_the_cut(int nx, int ny, int nz, double front_z_mm, double bulge_mm = 0) {
  const int left = nx / 2;
  const double to_bed = bed_to_mm - cut_x_mm(0), right_mm = size_mm.x() - cut_x_mm(0);
  const int bed = left + static_cast<int>(std::lround((nx - left) * to_bed / right_mm));
  const auto wall_x_mm = [&](const Eigen::Vector3d& p) { return cut_x_mm(p.z(), p.y(), bulge_mm); };
  const auto on_wall = [&](const Eigen::Vector3d& p) { return std::abs(p.x() - wall_x_mm(p)) < 1e-6; };
  geometry::TetMesh mesh = bent_box(nx, ny, nz, [&](const Eigen::Vector3d& unit) {
    const double i = unit.x() * nx, y = unit.y() * size_mm.y(), z = unit.z() * size_mm.z();
    const double cut = cut_x_mm(z, y, bulge_mm);
    const double x = i <= left  ? cut * i / left
                     : i <= bed ? cut + (bed_to_mm - cut) * (i - left) / (bed - left)
                                : bed_to_mm + (size_mm.x() - bed_to_mm) * (i - bed) / (nx - bed);
    return Eigen::Vector3d(x, y, z);
  });
  std::vector<int> double_of(mesh.points_mm.size(), -1), wall_points;
  for (std::size_t p = 0, all = mesh.points_mm.size(); p < all; ++p) {
    const Eigen::Vector3d at = mesh.points_mm[p];
    if (!on_wall(at) || at.z() < front_z_mm + 1e-6) continue;
    double_of[p] = static_cast<int>(mesh.points_mm.size());
    mesh.points_mm.push_back(at);
    wall_points.insert(wall_points.end(), {static_cast<int>(p), double_of[p]});
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Eigen::Vector3d middle = geometry::cell_centroid_mm(mesh, c);
    if (middle.x() < wall_x_mm(middle)) continue;
    for (int& p : mesh.cells[c]) {
      if (double_of[p] >= 0) p = double_of[p];
    }
  }
  return {std::move(mesh), std::move(wall_points)};
}

// Of its free end.
inline Eigen::Vector3d at_corner(const geometry::TetMesh& mesh, const std::vector<Eigen::Vector3d>& u_mm) {
  for (std::size_t p = 0; p < mesh.points_mm.size(); ++p) {
    if ((mesh.points_mm[p] - size_mm).norm() < 1e-6) return u_mm[p];
  }
  ADD_FAILURE() << "no corner";
  return Eigen::Vector3d::Zero();
}

}  // namespace glisson::mechanics::test
