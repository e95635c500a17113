#include "geometry/nearest.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <Eigen/Geometry>
#include <nanoflann.hpp>

#include "base/parallel.h"
#include "base/result.h"

namespace glisson::geometry {
namespace {

using Eigen::Vector3d;

// What nanoflann asks of a set of points.
struct PointSet {
  std::vector<Vector3d> points_mm;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points_mm.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t point, std::size_t axis) const {
    return points_mm[point][static_cast<Eigen::Index>(axis)];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using PointTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointSet>, PointSet, 3>;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using TriangleTree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

// So far away that it no longer matters where, and near enough that squares of distances stay finite.
Vector3d within_reach(const Vector3d& position_mm) {
  constexpr double far_mm = 1e100;
  return position_mm.cwiseMax(-far_mm).cwiseMin(far_mm);
}

Kernel::Point_3 to_cgal(const Vector3d& position) { return {position.x(), position.y(), position.z()}; }

// Sums over the samples of `from` of their distances to the surface that `to` was made of.
struct OneWay {
  double largest_mm = 0;
  double weighted_sum = 0;  // mm * mm2
  double area_mm2 = 0;
};
OneWay one_way(const Surface& from, const SurfaceDistance& to, double spacing_mm);

}  // namespace

struct NearestPoint::Tree {
  explicit Tree(std::vector<Vector3d> points_mm) : set{std::move(points_mm)}, tree(3, set) { tree.buildIndex(); }
  PointSet set;
  PointTree tree;
};

NearestPoint::NearestPoint(std::vector<Vector3d> points_mm) {
  GLISSON_ASSERT(!points_mm.empty());
  tree_ = std::make_shared<const Tree>(std::move(points_mm));
}

NearestPoint::Found NearestPoint::nearest(const Vector3d& position_mm) const {
  std::uint32_t point = 0;
  double squared_distance_mm2 = 0;
  nanoflann::KNNResultSet<double, std::uint32_t> found(1);
  found.init(&point, &squared_distance_mm2);
  tree_->tree.findNeighbors(found, within_reach(position_mm).data(), nanoflann::SearchParams());
  return {static_cast<int>(point), squared_distance_mm2};
}

std::vector<NearestPoint::Found> NearestPoint::nearest(const Vector3d& position_mm, int count) const {
  const std::size_t wanted = std::min(static_cast<std::size_t>(std::max(count, 0)), tree_->set.points_mm.size());
  if (wanted == 0) return {};
  std::vector<std::uint32_t> points(wanted);
  std::vector<double> squared_distances_mm2(wanted);
  tree_->tree.knnSearch(within_reach(position_mm).data(), wanted, points.data(), squared_distances_mm2.data());
  std::vector<Found> found;
  for (std::size_t i = 0; i < wanted; ++i) found.push_back({static_cast<int>(points[i]), squared_distances_mm2[i]});
  return found;
}

std::vector<NearestPoint::Found> NearestPoint::within(const Vector3d& position_mm, double radius_mm) const {
  std::vector<std::pair<std::uint32_t, double>> matches;
  tree_->tree.radiusSearch(position_mm.data(), radius_mm * radius_mm, matches, nanoflann::SearchParams());
  std::vector<Found> found;
  for (const auto& [point, squared_distance_mm2] : matches) {
    found.push_back({static_cast<int>(point), squared_distance_mm2});
  }
  return found;
}

const std::vector<Vector3d>& NearestPoint::points_mm() const { return tree_->set.points_mm; }

struct SurfaceDistance::Tree {
  Triangles triangles;
  std::vector<int> number;  // of each of them in the surface
  TriangleTree tree;
};

SurfaceDistance::SurfaceDistance(const Surface& surface) {
  auto tree = std::make_shared<Tree>();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& [a, b, c] = surface.triangles[i];
    const Kernel::Triangle_3 triangle(to_cgal(surface.points_mm[static_cast<std::size_t>(a)]),
                                      to_cgal(surface.points_mm[static_cast<std::size_t>(b)]),
                                      to_cgal(surface.points_mm[static_cast<std::size_t>(c)]));
    if (triangle.is_degenerate()) continue;
    tree->triangles.push_back(triangle);
    tree->number.push_back(static_cast<int>(i));
  }
  GLISSON_ASSERT(!tree->triangles.empty());
  tree->tree.rebuild(tree->triangles.cbegin(), tree->triangles.cend());
  tree->tree.accelerate_distance_queries();
  tree_ = std::move(tree);
}

SurfaceDistance::Closest SurfaceDistance::closest(const Vector3d& position_mm) const {
  const auto [point, triangle] = tree_->tree.closest_point_and_primitive(to_cgal(within_reach(position_mm)));
  const Vector3d point_mm(point.x(), point.y(), point.z());
  return {point_mm, tree_->number[static_cast<std::size_t>(triangle - tree_->triangles.cbegin())],
          (point_mm - within_reach(position_mm)).norm()};
}

bool SurfaceDistance::is_inside(const Vector3d& position_mm) const {
  // Directions that no axis, diagonal or symmetry of a model is likely to share.
  static const std::array<Kernel::Vector_3, 3> directions{Kernel::Vector_3(0.8123, 0.4771, 0.3355),
                                                          Kernel::Vector_3(-0.2917, 0.9011, -0.3210),
                                                          Kernel::Vector_3(0.1733, -0.3819, 0.9078)};
  int odd = 0;
  for (const Kernel::Vector_3& direction : directions) {
    const Kernel::Ray_3 ray(to_cgal(position_mm), direction);
    if (tree_->tree.number_of_intersected_primitives(ray) % 2 == 1) ++odd;
  }
  return odd >= 2;
}

SurfaceGap gap_between(const Surface& a, const Surface& b, double spacing_mm) {
  const OneWay there = one_way(a, SurfaceDistance(b), spacing_mm);
  const OneWay back = one_way(b, SurfaceDistance(a), spacing_mm);
  return {std::max(there.largest_mm, back.largest_mm),
          (there.weighted_sum + back.weighted_sum) / (there.area_mm2 + back.area_mm2)};
}

namespace {

OneWay over_triangle(const std::array<Vector3d, 3>& corners, const SurfaceDistance& to, double spacing_mm) {
  const Vector3d ab = corners[1] - corners[0];
  const Vector3d ac = corners[2] - corners[0];
  const double longest_mm = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
  const int parts = std::max(1, static_cast<int>(std::ceil(longest_mm / spacing_mm)));
  OneWay sums;
  sums.area_mm2 = 0.5 * ab.cross(ac).norm();
  const double weight = sums.area_mm2 / (static_cast<double>(parts) * parts);
  const auto sample = [&](double along_ab, double along_ac) {
    const double distance_mm = to.closest(corners[0] + along_ab / parts * ab + along_ac / parts * ac).distance_mm;
    sums.largest_mm = std::max(sums.largest_mm, distance_mm);
    return distance_mm;
  };
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; i + j < parts; ++j) {
      sums.weighted_sum += weight * sample(i + 1.0 / 3, j + 1.0 / 3);
      if (i + j + 1 < parts) sums.weighted_sum += weight * sample(i + 2.0 / 3, j + 2.0 / 3);
    }
  }
  return sums;
}

OneWay one_way(const Surface& from, const SurfaceDistance& to, double spacing_mm) {
  // Summed triangle by triangle afterwards, so that the digits do not depend on how the threads share the work.
  std::vector<OneWay> of_triangle(from.triangles.size());
  parallel_for(from.triangles.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::array<Vector3d, 3> corners;
      for (std::size_t n = 0; n < 3; ++n) corners[n] = from.points_mm[static_cast<std::size_t>(from.triangles[i][n])];
      of_triangle[i] = over_triangle(corners, to, spacing_mm);
    }
  });
  std::vector<double> at_point_mm(from.points_mm.size());
  parallel_for(from.points_mm.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) at_point_mm[i] = to.closest(from.points_mm[i]).distance_mm;
  });
  OneWay sums;
  for (const double distance_mm : at_point_mm) sums.largest_mm = std::max(sums.largest_mm, distance_mm);
  for (const OneWay& one : of_triangle) {
    sums.largest_mm = std::max(sums.largest_mm, one.largest_mm);
    sums.weighted_sum += one.weighted_sum;
    sums.area_mm2 += one.area_mm2;
  }
  return sums;
}

}  // namespace
}  // namespace glisson::geometry
