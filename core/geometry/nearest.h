#pragma once
// What lies nearest: among points, and on a surface. Positions in mm, in whatever frame both sides share.
//
// Both classes are built once and asked often, from several threads at once if need be.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "geometry/surface.h"

namespace glisson::geometry {

// Among many points, by a k-d tree.
class NearestPoint {
 public:
  struct Found {
    int point = -1;
    double squared_distance_mm2 = 0;
  };

  // `points_mm` must hold at least one point, all of them finite.
  explicit NearestPoint(std::vector<Eigen::Vector3d> points_mm);

  [[nodiscard]] Found nearest(const Eigen::Vector3d& position_mm) const;

  // The `count` nearest (or all, if there are fewer), the nearest first.
  [[nodiscard]] std::vector<Found> nearest(const Eigen::Vector3d& position_mm, int count) const;

  // All within the radius, the nearest first.
  [[nodiscard]] std::vector<Found> within(const Eigen::Vector3d& position_mm, double radius_mm) const;

  [[nodiscard]] const std::vector<Eigen::Vector3d>& points_mm() const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

// On a surface, by a tree of boxes around its triangles.
class SurfaceDistance {
 public:
  struct Closest {
    Eigen::Vector3d point_mm{0, 0, 0};
    int triangle = -1;
    double distance_mm = 0;
  };

  // `surface` must have passed check_surface and hold at least one triangle of positive area; flat ones are passed
  // over.
  explicit SurfaceDistance(const Surface& surface);

  [[nodiscard]] Closest closest(const Eigen::Vector3d& position_mm) const;

  // Whether a position is inside, which means something only for a watertight surface. A ray from inside crosses it an
  // odd number of times. The majority of three rays decides, since one may graze an edge. Does not depend on how the
  // triangles are turned.
  [[nodiscard]] bool is_inside(const Eigen::Vector3d& position_mm) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

// How far two surfaces are from each other, both ways: samples of each against all of the other.
struct SurfaceGap {
  double hausdorff_mm = 0;  // the largest distance of any sample of either from the other
  double mean_mm = 0;       // over the area of both
};

// Each triangle is cut in equal parts no longer than spacing_mm, whose middles are the samples, together with all
// points of the surface. The true Hausdorff distance is larger by at most spacing_mm. Both surfaces as SurfaceDistance
// wants them.
[[nodiscard]] SurfaceGap gap_between(const Surface& a, const Surface& b, double spacing_mm);

}  // namespace glisson::geometry
