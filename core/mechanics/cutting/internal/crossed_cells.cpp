#include "mechanics/cutting/internal/crossed_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace glisson::mechanics {

using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

double mean_edge_mm(const geometry::TetMesh& mesh);
// Of each point whether cells around it are looked at; empty where all are.
std::vector<std::uint8_t> near_line(const geometry::TetMesh& mesh, const geometry::CutSurface& surface,
                                    const std::vector<double>& height_mm);

// Where the edge between two corners meets the surface.
Vector4d on_edge(const Vector4d& height_mm, int a, int b) {
  const double share_of_b = height_mm[a] / (height_mm[a] - height_mm[b]);
  return (1.0 - share_of_b) * Vector4d::Unit(a) + share_of_b * Vector4d::Unit(b);
}

// The volumes of tetrahedra as shares of the cell, and where their common centroid lies.
struct Mass {
  double share = 0;
  Vector4d moment = Vector4d::Zero();

  void add(const Vector4d& a, const Vector4d& b, const Vector4d& c, const Vector4d& d) {
    Eigen::Matrix4d corners;
    corners << a, b, c, d;
    const double part = std::abs(corners.determinant());
    share += part;
    moment += part * (a + b + c + d) / 4.0;
  }
};

}  // namespace

CellDivision divide(const Vector4d& height_mm) {
  std::array<int, 4> above{}, below{};
  int n_above = 0, n_below = 0;
  for (int i = 0; i < 4; ++i) (height_mm[i] > 0 ? above[n_above++] : below[n_below++]) = i;

  CellDivision division;
  Mass mass;
  if (n_above == 2) {
    const int p = above[0], q = above[1], r = below[0], s = below[1];
    const Vector4d pr = on_edge(height_mm, p, r), ps = on_edge(height_mm, p, s);
    const Vector4d qr = on_edge(height_mm, q, r), qs = on_edge(height_mm, q, s);
    division.wall = {pr, ps, qs, qr};
    mass.add(Vector4d::Unit(p), pr, ps, Vector4d::Unit(q));
    mass.add(pr, ps, Vector4d::Unit(q), qr);
    mass.add(ps, Vector4d::Unit(q), qr, qs);
  } else {
    const int lone = n_above == 1 ? above[0] : below[0];
    const auto& others = n_above == 1 ? below : above;
    for (int i = 0; i < 3; ++i) division.wall.push_back(on_edge(height_mm, lone, others[i]));
    mass.add(Vector4d::Unit(lone), division.wall[0], division.wall[1], division.wall[2]);
  }
  const Vector4d whole = Vector4d::Constant(0.25);
  Vector4d counted = mass.moment / mass.share, other = (whole - mass.moment) / (1.0 - mass.share);
  const bool counted_above = n_above <= 2;
  division.share_above = counted_above ? mass.share : 1.0 - mass.share;
  division.centroid_above = counted_above ? counted : other;
  division.centroid_below = counted_above ? other : counted;
  return division;
}

// One corner alone on its side and the wedge behind it, or two wedges.
std::vector<CellPiece> pieces_of(const Vector4d& height_mm) {
  std::vector<int> above, below;
  for (int i = 0; i < 4; ++i) (height_mm[i] > 0 ? above : below).push_back(i);
  std::vector<CellPiece> pieces;
  const auto add = [&](bool is_above, const Vector4d& a, const Vector4d& b, const Vector4d& c, const Vector4d& d) {
    Eigen::Matrix4d corners;
    corners << a, b, c, d;
    pieces.push_back({corners, is_above});
  };
  const auto corner = [](int i) -> Vector4d { return Vector4d::Unit(i); };
  const auto wedge = [&](bool is_above, const std::array<Vector4d, 3>& near, const std::array<Vector4d, 3>& far) {
    add(is_above, near[0], near[1], near[2], far[0]);
    add(is_above, near[1], near[2], far[0], far[1]);
    add(is_above, near[2], far[0], far[1], far[2]);
  };
  if (above.size() == 2) {
    const int p = above[0], q = above[1], r = below[0], s = below[1];
    const Vector4d pr = on_edge(height_mm, p, r), ps = on_edge(height_mm, p, s);
    const Vector4d qr = on_edge(height_mm, q, r), qs = on_edge(height_mm, q, s);
    wedge(true, {corner(p), pr, ps}, {corner(q), qr, qs});
    wedge(false, {corner(r), pr, qr}, {corner(s), ps, qs});
    return pieces;
  }
  const bool lone_above = above.size() == 1;
  const int lone = lone_above ? above[0] : below[0];
  std::array<Vector4d, 3> wall, others;
  for (std::size_t i = 0; i < 3; ++i) {
    const int other = (lone_above ? below : above)[i];
    others[i] = corner(other);
    wall[i] = on_edge(height_mm, lone, other);
  }
  add(lone_above, corner(lone), wall[0], wall[1], wall[2]);
  wedge(!lone_above, wall, others);
  return pieces;
}

std::vector<double> heights_mm(const geometry::TetMesh& mesh, const geometry::CutSurface& surface) {
  std::vector<double> heights;
  const double nearest_mm = 0.01 * mean_edge_mm(mesh);
  for (const Vector3d& point : mesh.points_mm) {
    const double height_mm = surface.height_mm(point);
    heights.push_back(std::abs(height_mm) < nearest_mm ? nearest_mm : height_mm);
  }
  return heights;
}

Crossing crossing_of(const geometry::TetMesh& mesh, const geometry::CutSurface& surface,
                     std::vector<double> height_of_points_mm) {
  Crossing crossing;
  crossing.height_mm = std::move(height_of_points_mm);
  const std::vector<std::uint8_t> is_near = near_line(mesh, surface, crossing.height_mm);
  crossing.cells_of_point.resize(mesh.points_mm.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& corners = mesh.cells[c];
    Vector4d height_mm;
    for (int i = 0; i < 4; ++i) height_mm[i] = crossing.height_mm[corners[i]];
    if (height_mm.minCoeff() > 0 || height_mm.maxCoeff() < 0) continue;
    if (!is_near.empty() && std::none_of(corners.begin(), corners.end(), [&](int p) { return is_near[p] != 0; }))
      continue;
    for (const int point : corners) crossing.cells_of_point[point].push_back(static_cast<int>(crossing.cells.size()));

    CrossedCell crossed{static_cast<int>(c), divide(height_mm), 0, Vector4d::Zero(), Vector3d::Zero()};
    Eigen::Matrix<double, 3, 4> corner_mm;
    for (int i = 0; i < 4; ++i) corner_mm.col(i) = mesh.points_mm[corners[i]];
    const auto& wall = crossed.division.wall;
    Vector3d twice_area_mm2 = Vector3d::Zero();
    for (std::size_t k = 2; k < wall.size(); ++k) {
      const Vector3d twice = (corner_mm * (wall[k - 1] - wall[0])).cross(corner_mm * (wall[k] - wall[0])).eval();
      twice_area_mm2 += twice;
      crossed.wall_area_mm2 += 0.5 * twice.norm();
      crossed.wall_centroid += 0.5 * twice.norm() * (wall[0] + wall[k - 1] + wall[k]) / 3.0;
    }
    crossed.wall_centroid /= crossed.wall_area_mm2;
    crossed.wall_normal = twice_area_mm2.normalized();
    const Vector3d upwards = corner_mm * (crossed.division.centroid_above - crossed.division.centroid_below);
    if (crossed.wall_normal.dot(upwards) < 0) crossed.wall_normal *= -1.0;
    crossing.cells.push_back(std::move(crossed));
  }
  return crossing;
}

// The middles of small triangles, 36 of each triangle of a fan.
std::vector<std::pair<Vector4d, double>> places_on_wall(const CrossedCell& crossed,
                                                        const Eigen::Matrix<double, 3, 4>& corner_mm) {
  constexpr int parts = 6;
  std::vector<std::pair<Vector4d, double>> places;
  const auto& wall = crossed.division.wall;
  for (std::size_t k = 2; k < wall.size(); ++k) {
    const Vector4d a = wall[0], ab = (wall[k - 1] - a) / parts, ac = (wall[k] - a) / parts;
    const double area_mm2 = 0.5 * (corner_mm * ab).cross(corner_mm * ac).norm();
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; i + j < parts; ++j) {
        places.emplace_back(a + (i + 1.0 / 3) * ab + (j + 1.0 / 3) * ac, area_mm2);
        if (i + j + 1 < parts) places.emplace_back(a + (i + 2.0 / 3) * ab + (j + 2.0 / 3) * ac, area_mm2);
      }
    }
  }
  return places;
}

namespace {

std::vector<std::uint8_t> near_line(const geometry::TetMesh& mesh, const geometry::CutSurface& surface,
                                    const std::vector<double>& height_mm) {
  if (!surface.is_swept()) return {};
  double longest_mm = 0;
  for (const auto& cell : mesh.cells) {
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < i; ++k) {
        longest_mm = std::max(longest_mm, (mesh.points_mm[cell[i]] - mesh.points_mm[cell[k]]).norm());
      }
    }
  }
  const double reach_mm = 2 * longest_mm, depth_mm = surface.into_mm().norm();
  const double length_mm = surface.on_line(surface.through_mm().back()).along_mm;
  std::vector<std::uint8_t> is_near(mesh.points_mm.size(), 0);
  for (std::size_t p = 0; p < is_near.size(); ++p) {
    if (std::abs(height_mm[p]) > longest_mm) continue;  // no corner of a cell that is crossed
    const auto at = surface.on_line(mesh.points_mm[p]);
    is_near[p] = at.along_mm > -reach_mm && at.along_mm < length_mm + reach_mm && at.deep_mm > -depth_mm - reach_mm &&
                         at.deep_mm < depth_mm + reach_mm
                     ? 1
                     : 0;
  }
  return is_near;
}

double mean_edge_mm(const geometry::TetMesh& mesh) {
  double sum_mm = 0;
  for (const auto& cell : mesh.cells) {
    for (int i = 1; i < 4; ++i) sum_mm += (mesh.points_mm[cell[i]] - mesh.points_mm[cell[0]]).norm();
  }
  return sum_mm / (3.0 * static_cast<double>(mesh.cells.size()));
}

}  // namespace
}  // namespace glisson::mechanics
