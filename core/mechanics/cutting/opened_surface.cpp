#include "mechanics/cutting/opened_surface.h"

#include <algorithm>
#include <array>
#include <Eigen/Geometry>
#include <map>
#include <utility>

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

class OpenedSurface {
 public:
  OpenedSurface(const geometry::TetMesh& mesh, const std::vector<Vector3d>& displacement_mm,
                const std::vector<Vector3d>& jumps_mm)
      : mesh_(mesh), displacement_mm_(displacement_mm), jumps_mm_(jumps_mm) {}

  void add_boundary(const geometry::Surface& boundary, const std::vector<OpenCell>& open);
  void add_walls(const OpenCell& cell);
  geometry::Surface take() {
    geometry::set_field(made_.cell_fields, std::move(wall_));
    geometry::set_field(made_.point_fields, std::move(at_rest_));
    return std::move(made_);
  }

 private:
  void add(const std::array<int, 3>& triangle, bool wall) {
    made_.triangles.push_back(triangle);
    wall_.values.push_back(wall ? 1.0 : 0.0);
  }
  void add_point(const Vector3d& place_mm, const Vector3d& at_rest_mm) {
    made_.points_mm.push_back(place_mm);
    at_rest_.values.insert(at_rest_.values.end(), at_rest_mm.begin(), at_rest_mm.end());
  }
  // Where the cut crosses the edge between two corners of a cell, on its side above (1) or below (0).
  int on_edge(const OpenCell& cell, int a, int b, int side);
  void divide(const OpenCell& cell, const std::array<int, 3>& triangle, const std::array<int, 3>& corners);

  const geometry::TetMesh& mesh_;
  const std::vector<Vector3d>& displacement_mm_;
  const std::vector<Vector3d>& jumps_mm_;
  geometry::Surface made_;
  geometry::Field wall_{"wall", 1, {}}, at_rest_{"at_rest_mm", 3, {}};
  std::map<std::array<int, 3>, int> place_;  // by points of the mesh, the smaller first, and the side
};

}  // namespace

geometry::Surface opened_surface(const geometry::TetMesh& mesh, const geometry::Surface& boundary,
                                 const std::vector<OpenCell>& open, const std::vector<Vector3d>& displacement_mm,
                                 const std::vector<Vector3d>& jumps_mm) {
  OpenedSurface made(mesh, displacement_mm, jumps_mm);
  made.add_boundary(boundary, open);
  for (const OpenCell& cell : open) made.add_walls(cell);
  return made.take();
}

namespace {

void OpenedSurface::add_boundary(const geometry::Surface& boundary, const std::vector<OpenCell>& open) {
  std::vector<const OpenCell*> open_cell(mesh_.cells.size(), nullptr);
  for (const OpenCell& cell : open) open_cell[cell.cell] = &cell;
  const auto& mesh_point = geometry::find_field(boundary.point_fields, "mesh_point")->values;
  const auto& mesh_cell = geometry::find_field(boundary.cell_fields, "mesh_cell")->values;
  for (const double p : mesh_point) {
    const Vector3d& at_rest_mm = mesh_.points_mm[static_cast<std::size_t>(p)];
    add_point(at_rest_mm + displacement_mm_[static_cast<std::size_t>(p)], at_rest_mm);
  }
  for (std::size_t t = 0; t < boundary.triangles.size(); ++t) {
    const auto& triangle = boundary.triangles[t];
    const OpenCell* cell = open_cell[static_cast<std::size_t>(mesh_cell[t])];
    if (cell == nullptr) {
      add(triangle, false);
      continue;
    }
    std::array<int, 3> corners{};  // of the cell
    int above = 0;
    for (int i = 0; i < 3; ++i) {
      const auto& of_cell = mesh_.cells[cell->cell];
      const int point = static_cast<int>(mesh_point[triangle[i]]);
      corners[i] = static_cast<int>(std::find(of_cell.begin(), of_cell.end(), point) - of_cell.begin());
      above += cell->height_mm[corners[i]] > 0 ? 1 : 0;
    }
    if (above == 0 || above == 3) {
      add(triangle, false);
    } else {
      divide(*cell, triangle, corners);
    }
  }
}

// Into the corner that is alone on its side, and the two triangles of the rest.
void OpenedSurface::divide(const OpenCell& cell, const std::array<int, 3>& triangle,
                           const std::array<int, 3>& corners) {
  const auto is_above = [&](int i) { return cell.height_mm[corners[i]] > 0; };
  int lone = 0;
  while (is_above(lone) == is_above((lone + 1) % 3) || is_above(lone) == is_above((lone + 2) % 3)) ++lone;
  const int next = (lone + 1) % 3, last = (lone + 2) % 3;
  const int side = is_above(lone) ? 1 : 0;
  const auto at = [&](int to, int of_side) { return on_edge(cell, corners[lone], corners[to], of_side); };
  add({triangle[lone], at(next, side), at(last, side)}, false);
  add({at(next, 1 - side), triangle[next], triangle[last]}, false);
  add({at(next, 1 - side), triangle[last], at(last, 1 - side)}, false);
}

void OpenedSurface::add_walls(const OpenCell& cell) {
  Eigen::Matrix<double, 3, 4> corner_mm;
  for (int i = 0; i < 4; ++i) corner_mm.col(i) = mesh_.points_mm[mesh_.cells[cell.cell][i]];
  std::vector<std::array<int, 2>> edges;
  for (const Vector4d& place : cell.wall) {
    std::array<int, 2> edge{};
    int found = 0;
    for (int i = 0; i < 4; ++i) {
      if (place[i] > 0 && found < 2) edge[found++] = i;
    }
    edges.push_back(edge);
  }
  // The wall of the part below looks up, that of the part above down.
  const Vector3d turning = (corner_mm * (cell.wall[1] - cell.wall[0])).cross(corner_mm * (cell.wall[2] - cell.wall[0]));
  Vector3d up = Vector3d::Zero();
  for (int i = 0; i < 4; ++i) up += cell.height_mm[i] * (corner_mm.col(i) - corner_mm.rowwise().mean());
  const bool turns_up = turning.dot(up) > 0;
  for (std::size_t k = 2; k < edges.size(); ++k) {
    for (const int side : {0, 1}) {
      const auto at = [&](std::size_t e) { return on_edge(cell, edges[e][0], edges[e][1], side); };
      const bool as_listed = turns_up == (side == 0);
      add({at(0), as_listed ? at(k - 1) : at(k), as_listed ? at(k) : at(k - 1)}, true);
    }
  }
}

int OpenedSurface::on_edge(const OpenCell& cell, int a, int b, int side) {
  const auto& points = mesh_.cells[cell.cell];
  const std::array<int, 3> key{std::min(points[a], points[b]), std::max(points[a], points[b]), side};
  const auto [place, is_new] = place_.try_emplace(key, static_cast<int>(made_.points_mm.size()));
  if (!is_new) return place->second;
  const double share_of_b = cell.height_mm[a] / (cell.height_mm[a] - cell.height_mm[b]);
  Vector3d at_mm = Vector3d::Zero(), at_rest_mm = Vector3d::Zero();
  for (const auto& [corner, share] : {std::pair{a, 1.0 - share_of_b}, {b, share_of_b}}) {
    Vector3d moved_mm = displacement_mm_[points[corner]];
    if (cell.jump[corner] >= 0) {
      moved_mm +=
          (side - (cell.height_mm[corner] > 0 ? 1 : 0)) * jumps_mm_[static_cast<std::size_t>(cell.jump[corner])];
    }
    at_rest_mm += share * mesh_.points_mm[points[corner]];
    at_mm += share * (mesh_.points_mm[points[corner]] + moved_mm);
  }
  add_point(at_mm, at_rest_mm);
  return place->second;
}

}  // namespace
}  // namespace glisson::mechanics
