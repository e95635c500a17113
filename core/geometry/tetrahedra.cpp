#include "geometry/tetrahedra.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <Eigen/Geometry>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "geometry/disjoint_sets.h"
#include "geometry/fields.h"
#include "geometry/internal/cell_faces.h"

namespace glisson::geometry {
namespace {

using Eigen::Vector3d;
using Cell = std::array<int, 4>;

struct Face {
  std::array<int, 3> sorted;  // the same whichever cell it is seen from
  std::array<int, 3> corners;
  int cell;
};

// Every face of every cell, those of the same three points beside each other.
std::vector<Face> faces_side_by_side(const TetMesh& mesh);

// The number of items at `first` that are the same face.
std::size_t cells_at_face(const std::vector<Face>& faces, std::size_t first);

// Is the order of its corners, outward from the cell, an even permutation of the sorted one?
bool turns_even(const Face& face);

CellCorners corners_of(const TetMesh& mesh, std::size_t cell);
double volume_mm3(const CellCorners& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]) / 6.0;
}

struct CellQuality {
  double min_dihedral_deg = 0;
  double max_dihedral_deg = 0;
  double aspect = 0;
};
CellQuality quality_of(const CellCorners& corners);

Result<void> check_indices_and_positions(const TetMesh& mesh);
Result<void> check_volumes(const TetMesh& mesh);
Result<void> check_that_it_hangs_together(const TetMesh& mesh);

}  // namespace

double cell_volume_mm3(const TetMesh& mesh, std::size_t cell) { return volume_mm3(corners_of(mesh, cell)); }

double volume_mm3(const TetMesh& mesh) {
  double sum = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) sum += cell_volume_mm3(mesh, cell);
  return sum;
}

Vector3d cell_centroid_mm(const TetMesh& mesh, std::size_t cell) {
  const CellCorners corners = corners_of(mesh, cell);
  return 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
}

Surface boundary_surface(const TetMesh& mesh) {
  const std::vector<Face> faces = faces_side_by_side(mesh);
  std::vector<Face> outer;
  for (std::size_t i = 0; i < faces.size(); i += cells_at_face(faces, i)) {
    if (cells_at_face(faces, i) == 1) outer.push_back(faces[i]);
  }
  std::sort(outer.begin(), outer.end(),
            [](const Face& a, const Face& b) { return std::tie(a.cell, a.sorted) < std::tie(b.cell, b.sorted); });

  std::vector<int> renumbered(mesh.points_mm.size(), -1);
  for (const Face& face : outer) {
    for (const int corner : face.corners) renumbered[static_cast<std::size_t>(corner)] = 0;
  }
  Surface surface;
  Field mesh_point{"mesh_point", 1, {}};
  Field mesh_cell{"mesh_cell", 1, {}};
  for (std::size_t point = 0; point < renumbered.size(); ++point) {
    if (renumbered[point] < 0) continue;
    renumbered[point] = static_cast<int>(surface.points_mm.size());
    surface.points_mm.push_back(mesh.points_mm[point]);
    mesh_point.values.push_back(static_cast<double>(point));
  }
  for (const Face& face : outer) {
    std::array<int, 3> corners = face.corners;
    for (int& corner : corners) corner = renumbered[static_cast<std::size_t>(corner)];
    surface.triangles.push_back(corners);
    mesh_cell.values.push_back(face.cell);
  }
  surface.point_fields.push_back(std::move(mesh_point));
  surface.cell_fields.push_back(std::move(mesh_cell));
  return surface;
}

std::vector<int> parts_by_faces(const TetMesh& mesh) {
  const std::vector<Face> faces = faces_side_by_side(mesh);
  DisjointSets sets(mesh.cells.size());
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].sorted != faces[i - 1].sorted) continue;
    sets.join(static_cast<std::size_t>(faces[i].cell), static_cast<std::size_t>(faces[i - 1].cell));
  }
  std::vector<std::size_t> cells_at_root(mesh.cells.size(), 0);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) ++cells_at_root[sets.root(cell)];
  std::vector<std::size_t> roots(mesh.cells.size());
  std::iota(roots.begin(), roots.end(), std::size_t{0});
  std::stable_sort(roots.begin(), roots.end(),
                   [&](std::size_t a, std::size_t b) { return cells_at_root[a] > cells_at_root[b]; });
  std::vector<int> rank(mesh.cells.size());
  for (std::size_t i = 0; i < roots.size(); ++i) rank[roots[i]] = static_cast<int>(i);
  std::vector<int> part(mesh.cells.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) part[cell] = rank[sets.root(cell)];
  return part;
}

TetMesh part_of(const TetMesh& mesh, const std::vector<int>& cells) {
  std::vector<int> renumbered(mesh.points_mm.size(), -1);
  for (const int cell : cells) {
    for (const int corner : mesh.cells[static_cast<std::size_t>(cell)])
      renumbered[static_cast<std::size_t>(corner)] = 0;
  }
  TetMesh part;
  std::vector<int> points;
  for (std::size_t point = 0; point < renumbered.size(); ++point) {
    if (renumbered[point] < 0) continue;
    renumbered[point] = static_cast<int>(points.size());
    points.push_back(static_cast<int>(point));
    part.points_mm.push_back(mesh.points_mm[point]);
  }
  for (const int cell : cells) {
    Cell corners = mesh.cells[static_cast<std::size_t>(cell)];
    for (int& corner : corners) corner = renumbered[static_cast<std::size_t>(corner)];
    part.cells.push_back(corners);
  }
  part.point_fields = select(mesh.point_fields, points);
  part.cell_fields = select(mesh.cell_fields, cells);
  return part;
}

TetQuality quality(const TetMesh& mesh) {
  if (mesh.cells.empty()) return {};
  TetQuality worst{180.0, 0.0, 0.0, 0.0};
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const CellQuality of_cell = quality_of(corners_of(mesh, cell));
    worst.min_dihedral_deg = std::min(worst.min_dihedral_deg, of_cell.min_dihedral_deg);
    worst.max_dihedral_deg = std::max(worst.max_dihedral_deg, of_cell.max_dihedral_deg);
    worst.max_aspect = std::max(worst.max_aspect, of_cell.aspect);
    worst.mean_aspect += of_cell.aspect / static_cast<double>(mesh.cells.size());
  }
  return worst;
}

Result<void> check_tetrahedra(const TetMesh& mesh) {
  if (auto checked = check_cells(mesh); !checked) return checked;
  return check_that_it_hangs_together(mesh);
}

Result<void> check_cells(const TetMesh& mesh) {
  if (mesh.cells.empty()) return failure("mesh-empty", GLISSON_TEXT("The mesh holds no tetrahedra."));
  if (auto checked = check_indices_and_positions(mesh); !checked) return checked;
  return check_volumes(mesh);
}

namespace {

std::vector<Face> faces_side_by_side(const TetMesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(4 * mesh.cells.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const auto& local : faces_of_cell) {
      Face face{};
      for (std::size_t i = 0; i < 3; ++i) face.corners[i] = mesh.cells[cell][static_cast<std::size_t>(local[i])];
      face.sorted = face.corners;
      std::sort(face.sorted.begin(), face.sorted.end());
      face.cell = static_cast<int>(cell);
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return std::tie(a.sorted, a.cell) < std::tie(b.sorted, b.cell); });
  return faces;
}

std::size_t cells_at_face(const std::vector<Face>& faces, std::size_t first) {
  std::size_t end = first + 1;
  while (end < faces.size() && faces[end].sorted == faces[first].sorted) ++end;
  return end - first;
}

bool turns_even(const Face& face) {
  const auto& [a, b, c] = face.corners;
  const int exchanged = (a > b) + (a > c) + (b > c);
  return exchanged % 2 == 0;
}

CellCorners corners_of(const TetMesh& mesh, std::size_t cell) {
  CellCorners corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.points_mm[static_cast<std::size_t>(mesh.cells[cell][i])];
  return corners;
}

CellQuality quality_of(const CellCorners& corners) {
  std::array<Vector3d, 4> outward;  // normal of face i, as long as twice its area
  double largest_doubled_area = 0;
  double longest_squared = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [a, b, c] = faces_of_cell[i];
    const Vector3d& first = corners[static_cast<std::size_t>(a)];
    outward[i] = (corners[static_cast<std::size_t>(b)] - first).cross(corners[static_cast<std::size_t>(c)] - first);
    largest_doubled_area = std::max(largest_doubled_area, outward[i].norm());
    for (std::size_t j = 0; j < i; ++j) {
      longest_squared = std::max(longest_squared, (corners[i] - corners[j]).squaredNorm());
    }
  }

  CellQuality result{180.0, 0.0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double between_normals = std::atan2(outward[i].cross(outward[j]).norm(), outward[i].dot(outward[j]));
      const double dihedral_deg = 180.0 - between_normals * 180.0 / std::numbers::pi;
      result.min_dihedral_deg = std::min(result.min_dihedral_deg, dihedral_deg);
      result.max_dihedral_deg = std::max(result.max_dihedral_deg, dihedral_deg);
    }
  }
  const double shortest_height = 6.0 * std::abs(volume_mm3(corners)) / largest_doubled_area;
  if (shortest_height > 0) {
    // The regular tetrahedron's height is sqrt(2/3) of its edge.
    result.aspect = std::sqrt(longest_squared) * std::sqrt(2.0 / 3.0) / shortest_height;
  }
  return result;
}

Result<void> check_indices_and_positions(const TetMesh& mesh) {
  const auto points = static_cast<std::int64_t>(mesh.points_mm.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int corner : mesh.cells[cell]) {
      if (corner < 0 || corner >= points) {
        return failure("mesh-index", GLISSON_TEXT("Tetrahedron {0} names point {1}; the mesh has {2} points."),
                       {std::to_string(cell), std::to_string(corner), std::to_string(points)});
      }
    }
  }
  for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) {
    if (!mesh.points_mm[i].allFinite()) {
      return failure("mesh-not-finite", GLISSON_TEXT("Point {0} of the mesh has no finite position."),
                     {std::to_string(i)});
    }
    constexpr double farthest_mm = 1e9;  // a thousand kilometres
    if (mesh.points_mm[i].cwiseAbs().maxCoeff() > farthest_mm) {
      return failure("mesh-too-far", GLISSON_TEXT("Point {0} of the mesh lies farther off than a thousand kilometres."),
                     {std::to_string(i)});
    }
  }
  return {};
}

Result<void> check_volumes(const TetMesh& mesh) {
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const double volume = cell_volume_mm3(mesh, cell);
    if (!(volume > 0)) {
      return failure("mesh-inverted", GLISSON_TEXT("Tetrahedron {0} is flat or inside out: its volume is {1} mm3."),
                     {std::to_string(cell), fmt::format("{:.3g}", volume)});
    }
  }
  return {};
}

Result<void> check_that_it_hangs_together(const TetMesh& mesh) {
  const std::vector<Face> faces = faces_side_by_side(mesh);
  for (std::size_t i = 0; i < faces.size(); i += cells_at_face(faces, i)) {
    const std::size_t cells = cells_at_face(faces, i);
    if (cells <= 2) continue;
    return failure("mesh-face-shared",
                   GLISSON_TEXT("The face of the points {0}, {1} and {2} belongs to {3} tetrahedra; at most two can."),
                   {std::to_string(faces[i].sorted[0]), std::to_string(faces[i].sorted[1]),
                    std::to_string(faces[i].sorted[2]), std::to_string(cells)});
  }
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].sorted != faces[i - 1].sorted || turns_even(faces[i]) != turns_even(faces[i - 1])) continue;
    return failure(Error{"mesh-tangled",
                         GLISSON_TEXT("Tetrahedra {0} and {1} lie on the same side of the face that they share: they "
                                      "overlap."),
                         {std::to_string(faces[i - 1].cell), std::to_string(faces[i].cell)},
                         GLISSON_TEXT("Mesh it anew."),
                         {}});
  }

  std::vector<std::size_t> cells_of_part;
  for (const int part : parts_by_faces(mesh)) {
    cells_of_part.resize(std::max(cells_of_part.size(), static_cast<std::size_t>(part) + 1), 0);
    ++cells_of_part[static_cast<std::size_t>(part)];
  }
  const std::size_t parts = cells_of_part.size();
  if (parts == 1) return {};
  constexpr std::size_t maximum_named = 5;
  cells_of_part.resize(std::min(parts, maximum_named));
  return failure(Error{"mesh-in-parts",
                       GLISSON_TEXT("The mesh falls in {0} parts that share no face, of {1} tetrahedra."),
                       {std::to_string(parts),
                        fmt::format("{}{}", fmt::join(cells_of_part, ", "), parts > maximum_named ? ", ..." : "")},
                       GLISSON_TEXT("Keep the largest part, or join them before meshing."),
                       {}});
}

}  // namespace
}  // namespace glisson::geometry
