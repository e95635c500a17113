#pragma once
// A population whose modes are known: ellipsoids of two axes that differ, with a dome that differs by itself.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/noise.h"
#include "geometry/surface.h"

namespace glisson::test {

constexpr double x_sd_mm = 8, y_sd_mm = 5, dome_sd_mm = 6;

// A sphere of radius 1 by rings of points; closed, counter-clockwise from outside.
inline geometry::Surface unit_sphere(int rings = 20, int around = 32) {
  geometry::Surface sphere;
  sphere.points_mm.emplace_back(0, 0, 1);
  for (int ring = 1; ring < rings; ++ring) {
    const double polar = std::numbers::pi * ring / rings;
    for (int k = 0; k < around; ++k) {
      const double turn = 2 * std::numbers::pi * (k + 0.5 * (ring % 2)) / around;
      sphere.points_mm.emplace_back(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                                    std::cos(polar));
    }
  }
  sphere.points_mm.emplace_back(0, 0, -1);
  const int last = static_cast<int>(sphere.points_mm.size()) - 1;
  const auto at = [&](int ring, int k) { return 1 + (ring - 1) * around + (k + around) % around; };
  for (int k = 0; k < around; ++k) {
    sphere.triangles.push_back({0, at(1, k), at(1, k + 1)});
    sphere.triangles.push_back({last, at(rings - 1, k + 1), at(rings - 1, k)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      const int shift = ring % 2;  // odd rings are turned by half a step
      sphere.triangles.push_back({at(ring, k), at(ring + 1, k + shift), at(ring, k + 1)});
      sphere.triangles.push_back({at(ring + 1, k + shift), at(ring + 1, k + 1 + shift), at(ring, k + 1)});
    }
  }
  return sphere;
}

// Half axes 80 + 8 b0, 60 + 5 b1 and 55 mm; the dome, where z is above half, is 6 b2 higher at its top.
inline geometry::Surface ellipsoid(const std::array<double, 3>& b) {
  geometry::Surface surface = unit_sphere();
  for (Eigen::Vector3d& point : surface.points_mm) {
    const double dome = std::max(0.0, 2 * point.z() - 1);
    point = Eigen::Vector3d((80 + x_sd_mm * b[0]) * point.x(), (60 + y_sd_mm * b[1]) * point.y(),
                            55 * point.z() + dome_sd_mm * b[2] * dome);
  }
  return surface;
}

inline std::array<double, 3> drawn(std::uint64_t seed) {
  const Eigen::Vector2d first = normal_pair(seed, 0), second = normal_pair(seed, 1);
  return {first.x(), first.y(), second.x()};
}

// So many of them, each moved, with noise of a few tenths of a millimetre at each point.
inline std::vector<geometry::Surface> ellipsoids(int count) {
  std::vector<geometry::Surface> all;
  for (int i = 0; i < count; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    geometry::Surface surface = ellipsoid(drawn(mixed(11, seed)));
    for (std::size_t p = 0; p < surface.points_mm.size(); ++p) {
      const Eigen::Vector2d a = normal_pair(mixed(12, seed), p), b = normal_pair(mixed(13, seed), p);
      surface.points_mm[p] += 0.2 * Eigen::Vector3d(a.x(), a.y(), b.x()) + Eigen::Vector3d(3.0 * i, -2.0 * i, 5);
    }
    all.push_back(std::move(surface));
  }
  return all;
}

}  // namespace glisson::test
