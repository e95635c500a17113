#pragma once
// Building blocks of implicit surfaces: about how far a point lies outside a shape, in mm, negative inside.
//
// Blends are the polynomial smooth minimum: min(a, b) - h^2 k / 4 with h = max(k - |a - b|, 0) / k. Here k is the width
// over which two surfaces run into each other. Source: Bloomenthal (ed.) 1997, Introduction to implicit surfaces.

#include <Eigen/Geometry>
#include <vector>

namespace glisson::anatomy {

// An ellipsoid. Distances are first order: exact on the surface, right in sign everywhere.
struct Ellipsoid {
  Eigen::Vector3d center_mm{0, 0, 0};
  Eigen::Vector3d semi_axes_mm{1, 1, 1};
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns

  [[nodiscard]] double distance_mm(const Eigen::Vector3d& position_mm) const;
};

// Turned about x, y and z (in that order), in degrees.
[[nodiscard]] Ellipsoid ellipsoid(const Eigen::Vector3d& center_mm, const Eigen::Vector3d& semi_axes_mm,
                                  const Eigen::Vector3d& turns_deg = {0, 0, 0});

// A chain of round cones: a centre line with a radius at each of its points, straight between them.
struct Tube {
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<double> radii_mm;

  [[nodiscard]] double distance_mm(const Eigen::Vector3d& position_mm) const;
};

// The same course and radii by cubic splines through the points (Catmull and Rom 1974), in finer pieces.
[[nodiscard]] Tube smoothed(const Tube& tube, int pieces_each = 5);

// What lies within half a thickness of a four-cornered flat patch, a to b to c to d.
struct Slab {
  Eigen::Vector3d corner_mm{0, 0, 0}, along_mm{1, 0, 0}, across_mm{0, 1, 0};  // the two edges, about square
  double half_thickness_mm = 1;

  [[nodiscard]] double distance_mm(const Eigen::Vector3d& position_mm) const;
};

// Distance from the stretch a to b, and how far along it the nearest point lies (0 to 1).
struct OnStretch {
  double distance_mm = 0;
  double along = 0;
};
[[nodiscard]] OnStretch on_stretch(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p);

[[nodiscard]] double united(double a, double b, double width_mm);
[[nodiscard]] double common(double a, double b, double width_mm);
[[nodiscard]] double without(double a, double taken_away, double width_mm);

}  // namespace glisson::anatomy
