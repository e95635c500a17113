#include "meshing/internal/pinches.h"

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "geometry/surface.h"

namespace glisson::meshing {
namespace {

using geometry::TetMesh;

bool has(const TetMesh& mesh, int cell, int point) {
  const auto& corners = mesh.cells[static_cast<std::size_t>(cell)];
  return std::find(corners.begin(), corners.end(), point) != corners.end();
}

// The cells, which all hold one point or edge, by groups that hang together through faces; the largest volume first.
std::vector<std::vector<int>> groups_by_faces(const TetMesh& mesh, const std::vector<int>& cells);

// Every cell that must go for this round.
std::set<int> cells_beyond_pinches(const TetMesh& mesh, const std::vector<int>& pinched);

void keep_cells(TetMesh& mesh, const std::set<int>& gone) {
  std::vector<int> kept;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    if (!gone.contains(cell)) kept.push_back(cell);
  }
  mesh = part_of(mesh, kept);
}

}  // namespace

std::size_t remove_pinches(TetMesh& mesh) {
  const std::size_t before = mesh.cells.size();
  while (!mesh.cells.empty()) {
    const std::vector<int> part = parts_by_faces(mesh);
    std::set<int> gone;
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
      if (part[static_cast<std::size_t>(cell)] != 0) gone.insert(cell);
    }
    if (gone.empty()) {
      const geometry::Surface surface = boundary_surface(mesh);
      const auto& mesh_point = find_field(surface.point_fields, "mesh_point")->values;
      std::vector<int> pinched;
      for (const int point : pinched_points(surface)) {
        pinched.push_back(static_cast<int>(mesh_point[static_cast<std::size_t>(point)]));
      }
      gone = cells_beyond_pinches(mesh, pinched);
    }
    if (gone.empty()) break;
    keep_cells(mesh, gone);
  }
  return before - mesh.cells.size();
}

namespace {

std::set<int> cells_beyond_pinches(const TetMesh& mesh, const std::vector<int>& pinched) {
  std::vector<std::vector<int>> cells_at(pinched.size());
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    for (std::size_t i = 0; i < pinched.size(); ++i) {
      if (has(mesh, cell, pinched[i])) cells_at[i].push_back(cell);
    }
  }
  std::set<int> gone;
  for (std::size_t i = 0; i < pinched.size(); ++i) {
    std::vector<std::vector<int>> smaller = groups_by_faces(mesh, cells_at[i]);
    smaller.erase(smaller.begin());
    for (std::size_t j = 0; j < pinched.size() && smaller.empty(); ++j) {
      if (i == j) continue;
      std::vector<int> at_edge;
      std::copy_if(cells_at[i].begin(), cells_at[i].end(), std::back_inserter(at_edge),
                   [&](int cell) { return has(mesh, cell, pinched[j]); });
      if (at_edge.empty()) continue;
      smaller = groups_by_faces(mesh, at_edge);
      smaller.erase(smaller.begin());
    }
    // A hollow that touches the outside in this point alone: the point goes with all its cells.
    if (smaller.empty()) smaller.push_back(cells_at[i]);
    for (const auto& group : smaller) gone.insert(group.begin(), group.end());
  }
  return gone;
}

std::vector<std::vector<int>> groups_by_faces(const TetMesh& mesh, const std::vector<int>& cells) {
  geometry::DisjointSets sets(cells.size());
  for (std::size_t a = 0; a < cells.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      int common = 0;
      for (const int corner : mesh.cells[static_cast<std::size_t>(cells[a])]) common += has(mesh, cells[b], corner);
      if (common == 3) sets.join(a, b);
    }
  }
  std::vector<std::vector<int>> by_root(cells.size());
  std::vector<double> volume_mm3(cells.size(), 0);
  for (std::size_t a = 0; a < cells.size(); ++a) {
    by_root[sets.root(a)].push_back(cells[a]);
    volume_mm3[sets.root(a)] += cell_volume_mm3(mesh, static_cast<std::size_t>(cells[a]));
  }
  std::vector<std::size_t> roots;
  for (std::size_t root = 0; root < cells.size(); ++root) {
    if (!by_root[root].empty()) roots.push_back(root);
  }
  std::stable_sort(roots.begin(), roots.end(),
                   [&](std::size_t a, std::size_t b) { return volume_mm3[a] > volume_mm3[b]; });
  std::vector<std::vector<int>> groups;
  for (const std::size_t root : roots) groups.push_back(by_root[root]);
  return groups;
}

}  // namespace
}  // namespace glisson::meshing
