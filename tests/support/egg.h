#pragma once
// An organ of tetrahedra whose shape is known, and half of its surface as a camera sees it.

#include <Eigen/Geometry>
#include <random>

#include "geometry/tetrahedra.h"
#include "guidance/frame.h"

namespace glisson::guidance {

// An egg of tetrahedra, 80 x 60 x 40 mm: a shape that fits into itself in few ways.
inline geometry::TetMesh egg() {
  constexpr int n = 8;
  geometry::TetMesh mesh;
  for (int z = 0; z <= n; ++z) {
    for (int y = 0; y <= n; ++y) {
      for (int x = 0; x <= n; ++x) {
        const Eigen::Vector3d cube = Eigen::Vector3d(2.0 * x / n - 1, 2.0 * y / n - 1, 2.0 * z / n - 1);
        const double largest = cube.cwiseAbs().maxCoeff();
        Eigen::Vector3d ball = largest > 0 ? Eigen::Vector3d(cube.normalized() * largest) : Eigen::Vector3d(0, 0, 0);
        ball[0] *= 1 + 0.25 * ball[1];
        mesh.points_mm.push_back(ball.cwiseProduct(Eigen::Vector3d(40, 30, 20)));
      }
    }
  }
  const auto at = [](int x, int y, int z) { return (z * (n + 1) + y) * (n + 1) + x; };
  constexpr int paths[6][3] = {{1, 3, 7}, {3, 2, 7}, {2, 6, 7}, {6, 4, 7}, {4, 5, 7}, {5, 1, 7}};
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        const auto corner = [&](int k) { return at(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2 & 1)); };
        for (const auto& path : paths) {
          std::array<int, 4> cell{corner(0), corner(path[0]), corner(path[1]), corner(path[2])};
          mesh.cells.push_back(cell);
          if (geometry::cell_volume_mm3(mesh, mesh.cells.size() - 1) < 0)
            std::swap(mesh.cells.back()[0], mesh.cells.back()[1]);
        }
      }
    }
  }
  return mesh;
}

inline Eigen::Isometry3d somewhere() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.rotate(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()));
  pose.pretranslate(Eigen::Vector3d(15, -40, 160));
  return pose;
}

// The half of the egg's surface that looks along +z, with noise of 0.4 mm.
inline SeenFrame half_seen(const geometry::TetMesh& mesh, const Eigen::Isometry3d& pose) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.4);
  SeenFrame frame;
  frame.id = "f0";
  frame.noise_mm = 0.4;
  const geometry::Surface surface = geometry::boundary_surface(mesh);
  for (const auto& triangle : surface.triangles) {
    const auto corner = [&](int k) { return surface.points_mm[static_cast<std::size_t>(triangle[k])]; };
    for (const Eigen::Vector3d& weights :
         {Eigen::Vector3d(0.6, 0.2, 0.2), Eigen::Vector3d(0.2, 0.6, 0.2), Eigen::Vector3d(0.2, 0.2, 0.6)}) {
      const Eigen::Vector3d place = weights[0] * corner(0) + weights[1] * corner(1) + weights[2] * corner(2);
      if (place[2] < 0) continue;
      frame.points_mm.push_back(pose * place + Eigen::Vector3d(noise(random), noise(random), noise(random)));
    }
  }
  return frame;
}

}  // namespace glisson::guidance
