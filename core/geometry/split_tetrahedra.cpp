#include "geometry/split_tetrahedra.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>

#include "geometry/fields.h"
#include "geometry/internal/cell_faces.h"

namespace glisson::geometry {
namespace {

using Eigen::Vector3d;
using Polygon = std::vector<int>;

constexpr std::uint8_t both_sides = 3;

constexpr std::array<std::array<int, 2>, 6> edges_of_cell{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

double volume_of(const CellCorners& c) { return std::abs((c[1] - c[0]).cross(c[2] - c[0]).dot(c[3] - c[0])) / 6.0; }

// The share of a tetrahedron's volume where the linear function with these values at its corners is above zero.
double share_above(std::array<double, 4> h);
double volume_above(const CellCorners& corners, const std::array<double, 4>& heights, const CutSurface& cut,
                    int levels);

// Heights with the points near the surface put on it.
std::vector<double> snapped(const TetMesh& mesh, std::vector<double> heights, double snap, double& largest_shift_mm);

// Builds the divided mesh; points are numbered as they come, those of the undivided mesh first.
class Splitter {
 public:
  Splitter(const TetMesh& mesh, const std::vector<double>& heights, const Vector3d& above);
  void divide(std::size_t cell);
  SplitMesh finish(const SplitOptions& options);

 private:
  int point_on_edge(int a, int b);
  // The part of a face, or of the cut, on one side; `sign` 1 above, -1 below.
  Polygon clipped(const std::array<int, 3>& face, int sign);
  void add_piece(std::size_t cell, int sign, const std::vector<Polygon>& faces);
  void add_cell(std::size_t parent, int sign, std::array<int, 4> corners);
  void add_cut(const Polygon& polygon);
  void set_point_fields();
  void find_faces_on_cut();
  void set_cut_surface();
  void open(const SplitOptions& options);
  [[nodiscard]] std::vector<std::uint8_t> sides_of_points() const;
  [[nodiscard]] int sign(int point) const {
    if (point >= static_cast<int>(heights_.size())) return 0;
    return (heights_[point] > 0) - (heights_[point] < 0);
  }

  const TetMesh& mesh_;
  const std::vector<double>& heights_;
  Vector3d above_;
  SplitMesh split_;
  std::map<std::array<int, 2>, int> edge_points_;
  std::vector<std::array<int, 2>> ends_;  // of each new point
  std::vector<double> along_;             // where it lies on its edge, 0 at the first end
  std::vector<std::array<int, 3>> cut_;
};

}  // namespace

DividedVolume divided_volume(const TetMesh& mesh, const CutSurface& cut, int levels) {
  std::vector<double> volumes_mm3;
  volumes_mm3.reserve(mesh.cells.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) volumes_mm3.push_back(cell_volume_mm3(mesh, cell));
  return divided_volume(mesh, cut, volumes_mm3, levels);
}

DividedVolume divided_volume(const TetMesh& mesh, const CutSurface& cut, const std::vector<double>& cell_volumes_mm3,
                             int levels) {
  GLISSON_ASSERT(cell_volumes_mm3.size() == mesh.cells.size());
  DividedVolume volume;
  double coarser_mm3 = 0;
  const int finest = cut.is_plane() ? 0 : std::max(1, levels);
  for (std::size_t k = 0; k < mesh.cells.size(); ++k) {
    CellCorners corners;
    std::array<double, 4> heights{};
    for (int i = 0; i < 4; ++i) {
      corners[i] = mesh.points_mm[mesh.cells[k][i]];
      heights[i] = cut.height_mm(corners[i]);
    }
    const double scale = cell_volumes_mm3[k] / volume_of(corners);
    const double above_mm3 = scale * volume_above(corners, heights, cut, finest);
    volume.above_mm3 += above_mm3;
    volume.below_mm3 += cell_volumes_mm3[k] - above_mm3;
    if (finest > 0) coarser_mm3 += scale * volume_above(corners, heights, cut, finest - 1);
  }
  if (finest > 0) volume.error_mm3 = std::abs(volume.above_mm3 - coarser_mm3);
  return volume;
}

SplitMesh split_tetrahedra(const TetMesh& mesh, const CutSurface& cut, const SplitOptions& options) {
  std::vector<double> heights;
  heights.reserve(mesh.points_mm.size());
  for (const Vector3d& point : mesh.points_mm) heights.push_back(cut.height_mm(point));
  double largest_shift_mm = 0;
  heights = snapped(mesh, std::move(heights), options.snap, largest_shift_mm);

  Splitter splitter(mesh, heights, cut.normal());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) splitter.divide(cell);
  SplitMesh split = splitter.finish(options);
  split.largest_shift_mm = largest_shift_mm;
  return split;
}

namespace {

double share_above(std::array<double, 4> h) {
  std::sort(h.begin(), h.end());
  if (h[3] <= 0) return 0;
  if (h[0] >= 0) return 1;
  // One corner alone on its side cuts off a small tetrahedron; two and two are the difference of such.
  const auto corner_share = [](double alone, double a, double b, double c) {
    return alone / (alone - a) * alone / (alone - b) * alone / (alone - c);
  };
  if (h[2] <= 0) return corner_share(h[3], h[0], h[1], h[2]);
  if (h[1] >= 0) return 1.0 - corner_share(h[0], h[1], h[2], h[3]);
  // Above are corners 2 and 3: the wedge of the edge 2-3 with the four crossings, as three tetrahedra.
  const double s20 = h[2] / (h[2] - h[0]), s21 = h[2] / (h[2] - h[1]);
  const double s30 = h[3] / (h[3] - h[0]), s31 = h[3] / (h[3] - h[1]);
  return s20 * s21 * (1.0 - s31) + s20 * s31 * (1.0 - s30) + s30 * s31;
}

double volume_above(const CellCorners& corners, const std::array<double, 4>& heights, const CutSurface& cut,
                    int levels) {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  double longest_mm = 0;
  for (const auto& [i, k] : edges_of_cell) longest_mm = std::max(longest_mm, (corners[i] - corners[k]).norm());
  // A sheet bends little within a cell: one that keeps an edge's length from it is not crossed.
  const bool near = *low<longest_mm&& * high> - longest_mm;
  if (levels == 0 || !near) return volume_of(corners) * share_above(heights);
  std::array<Vector3d, 6> middles;
  std::array<double, 6> middle_heights{};
  for (std::size_t e = 0; e < 6; ++e) {
    middles[e] = 0.5 * (corners[edges_of_cell[e][0]] + corners[edges_of_cell[e][1]]);
    middle_heights[e] = cut.height_mm(middles[e]);
  }
  // Four at the corners, and the octahedron between them about its diagonal from edge 0-1 to edge 2-3.
  constexpr int children[8][4] = {{0, 4, 5, 6}, {1, 4, 7, 8}, {2, 5, 7, 9}, {3, 6, 8, 9},
                                  {4, 9, 5, 6}, {4, 9, 6, 8}, {4, 9, 8, 7}, {4, 9, 7, 5}};
  double sum = 0;
  for (const auto& child : children) {
    CellCorners part;
    std::array<double, 4> values{};
    for (int i = 0; i < 4; ++i) {
      part[i] = child[i] < 4 ? corners[child[i]] : middles[child[i] - 4];
      values[i] = child[i] < 4 ? heights[child[i]] : middle_heights[child[i] - 4];
    }
    sum += volume_above(part, values, cut, levels - 1);
  }
  return sum;
}

std::vector<double> snapped(const TetMesh& mesh, std::vector<double> heights, double snap, double& largest_shift_mm) {
  std::vector<std::uint8_t> near(heights.size(), 0);
  for (const auto& cell : mesh.cells) {
    for (const auto& [i, k] : edges_of_cell) {
      const int a = cell[i], b = cell[k];
      if (!(heights[a] * heights[b] < 0)) continue;
      const double at = heights[a] / (heights[a] - heights[b]);
      if (at < snap) near[a] = 1;
      if (at > 1.0 - snap) near[b] = 1;
    }
  }
  for (std::size_t p = 0; p < heights.size(); ++p) {
    if (!near[p]) continue;
    largest_shift_mm = std::max(largest_shift_mm, std::abs(heights[p]));
    heights[p] = 0;
  }
  return heights;
}

Splitter::Splitter(const TetMesh& mesh, const std::vector<double>& heights, const Vector3d& above)
    : mesh_(mesh), heights_(heights), above_(above) {
  split_.mesh.points_mm = mesh.points_mm;
}

void Splitter::divide(std::size_t cell) {
  const std::array<int, 4>& corners = mesh_.cells[cell];
  int above = 0, below = 0;
  for (const int corner : corners) {
    above += sign(corner) > 0;
    below += sign(corner) < 0;
  }
  if (above == 0 || below == 0) {
    // A cell all of whose points were put on the surface lies where most of it was; such are thin.
    add_cell(cell, above > 0 ? 1 : -1, corners);
    return;
  }
  Polygon cut;
  for (const int corner : corners) {
    if (sign(corner) == 0) cut.push_back(corner);
  }
  for (const auto& [i, k] : edges_of_cell) {
    if (sign(corners[i]) * sign(corners[k]) < 0) cut.push_back(point_on_edge(corners[i], corners[k]));
  }
  // Four crossings came in the order of the edges: with the sorted pairs (p0, p1 above; n0, n1 below) p0n0, p0n1, p1n0,
  // p1n1 in some order; around the quadrilateral neighbours share an end.
  if (cut.size() == 4) {
    const auto share_an_end = [&](int a, int b) {
      const auto& x = ends_[static_cast<std::size_t>(a) - heights_.size()];
      const auto& y = ends_[static_cast<std::size_t>(b) - heights_.size()];
      return x[0] == y[0] || x[0] == y[1] || x[1] == y[0] || x[1] == y[1];
    };
    if (!share_an_end(cut[0], cut[1])) std::swap(cut[1], cut[2]);
    if (!share_an_end(cut[1], cut[2])) std::swap(cut[2], cut[3]);
  }
  for (const int side : {1, -1}) {
    std::vector<Polygon> faces;
    for (const auto& local : faces_of_cell) {
      Polygon face = clipped({corners[local[0]], corners[local[1]], corners[local[2]]}, side);
      if (face.size() >= 3) faces.push_back(std::move(face));
    }
    faces.push_back(cut);
    add_piece(cell, side, faces);
  }
  add_cut(cut);
}

int Splitter::point_on_edge(int a, int b) {
  const std::array<int, 2> edge{std::min(a, b), std::max(a, b)};
  const auto [found, is_new] = edge_points_.try_emplace(edge, static_cast<int>(split_.mesh.points_mm.size()));
  if (is_new) {
    const double along = heights_[edge[0]] / (heights_[edge[0]] - heights_[edge[1]]);
    split_.mesh.points_mm.emplace_back((1.0 - along) * mesh_.points_mm[edge[0]] + along * mesh_.points_mm[edge[1]]);
    ends_.push_back(edge);
    along_.push_back(along);
  }
  return found->second;
}

Polygon Splitter::clipped(const std::array<int, 3>& face, int side) {
  Polygon polygon;
  bool has_inside = false;
  for (int i = 0; i < 3; ++i) {
    const int here = face[i], next = face[(i + 1) % 3];
    if (sign(here) != -side) polygon.push_back(here);
    has_inside |= sign(here) == side;
    if (sign(here) * sign(next) < 0) polygon.push_back(point_on_edge(here, next));
  }
  return has_inside ? polygon : Polygon{};
}

void Splitter::add_piece(std::size_t cell, int side, const std::vector<Polygon>& faces) {
  int apex = faces.front().front();
  for (const Polygon& face : faces) apex = std::min(apex, *std::min_element(face.begin(), face.end()));
  for (Polygon face : faces) {
    if (std::find(face.begin(), face.end(), apex) != face.end()) continue;
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    for (std::size_t i = 1; i + 1 < face.size(); ++i) add_cell(cell, side, {apex, face[0], face[i], face[i + 1]});
  }
}

void Splitter::add_cell(std::size_t parent, int side, std::array<int, 4> corners) {
  const auto& p = split_.mesh.points_mm;
  const double six_volumes =
      (p[corners[1]] - p[corners[0]]).cross(p[corners[2]] - p[corners[0]]).dot(p[corners[3]] - p[corners[0]]);
  if (six_volumes < 0) std::swap(corners[2], corners[3]);
  split_.mesh.cells.push_back(corners);
  split_.parent.push_back(static_cast<int>(parent));
  split_.side.push_back(static_cast<std::int8_t>(side));
}

void Splitter::add_cut(const Polygon& polygon) {
  Polygon face = polygon;
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  for (std::size_t i = 1; i + 1 < face.size(); ++i) cut_.push_back({face[0], face[i], face[i + 1]});
}

SplitMesh Splitter::finish(const SplitOptions& options) {
  split_.mesh.cell_fields = select(mesh_.cell_fields, split_.parent);
  set_field(split_.mesh.cell_fields, {"cut_side", 1, {split_.side.begin(), split_.side.end()}});
  set_point_fields();
  find_faces_on_cut();
  set_cut_surface();
  open(options);
  return std::move(split_);
}

std::vector<std::uint8_t> Splitter::sides_of_points() const {
  std::vector<std::uint8_t> sides(split_.mesh.points_mm.size(), 0);
  for (std::size_t c = 0; c < split_.mesh.cells.size(); ++c) {
    for (const int p : split_.mesh.cells[c]) sides[p] |= split_.side[c] > 0 ? 1 : 2;
  }
  return sides;
}

void Splitter::set_point_fields() {
  std::vector<double> on_cut;
  for (const std::uint8_t sides : sides_of_points()) on_cut.push_back(sides == both_sides ? 1.0 : 0.0);

  for (const Field& field : mesh_.point_fields) {
    const bool names = field.components == 1 && std::all_of(field.values.begin(), field.values.end(),
                                                            [](double v) { return v == 0.0 || v == 1.0; });
    Field grown = field;
    const auto width = static_cast<std::size_t>(field.components);
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      for (std::size_t k = 0; k < width; ++k) {
        const double a = field.values[width * static_cast<std::size_t>(ends_[e][0]) + k];
        const double b = field.values[width * static_cast<std::size_t>(ends_[e][1]) + k];
        grown.values.push_back(names ? std::min(a, b) : (1.0 - along_[e]) * a + along_[e] * b);
      }
    }
    if (field.name == "on_cut") {
      for (std::size_t p = 0; p < on_cut.size(); ++p) on_cut[p] = std::max(on_cut[p], grown.values[p]);
    } else {
      split_.mesh.point_fields.push_back(std::move(grown));
    }
  }
  split_.mesh.point_fields.push_back({"on_cut", 1, std::move(on_cut)});
}

void Splitter::find_faces_on_cut() {
  // Faces between old cells that the cut follows because all their points were put on it.
  std::map<std::array<int, 3>, int> faces;
  for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
    for (const auto& local : faces_of_cell) {
      std::array<int, 3> face{mesh_.cells[c][local[0]], mesh_.cells[c][local[1]], mesh_.cells[c][local[2]]};
      if (sign(face[0]) != 0 || sign(face[1]) != 0 || sign(face[2]) != 0) continue;
      std::sort(face.begin(), face.end());
      int fourth = 0;
      for (const int corner : mesh_.cells[c]) fourth += sign(corner);
      faces[face] |= fourth > 0 ? 1 : 2;
    }
  }
  for (const auto& [face, sides] : faces) {
    if (sides == both_sides) cut_.push_back(face);
  }
}

// Turned so that it is seen counter-clockwise from above.
void Splitter::set_cut_surface() {
  const TetMesh& mesh = split_.mesh;
  std::map<int, int> number;
  for (auto triangle : cut_) {
    const Vector3d normal = (mesh.points_mm[triangle[1]] - mesh.points_mm[triangle[0]])
                                .cross(mesh.points_mm[triangle[2]] - mesh.points_mm[triangle[0]]);
    if (normal.dot(above_) < 0) std::swap(triangle[1], triangle[2]);
    for (int& p : triangle) p = number.try_emplace(p, static_cast<int>(number.size())).first->second;
    split_.cut.triangles.push_back(triangle);
  }
  split_.cut.points_mm.resize(number.size());
  Field mesh_point{"mesh_point", 1, std::vector<double>(number.size())};
  for (const auto& [point, at] : number) {
    split_.cut.points_mm[at] = mesh.points_mm[point];
    mesh_point.values[at] = point;
  }
  split_.cut.point_fields.push_back(std::move(mesh_point));
}

void Splitter::open(const SplitOptions& options) {
  TetMesh& mesh = split_.mesh;
  const std::vector<std::uint8_t> sides = sides_of_points();
  std::vector<int> copy_of(mesh.points_mm.size(), -1);
  std::vector<int> order(mesh.points_mm.size());
  for (std::size_t p = 0; p < order.size(); ++p) order[p] = static_cast<int>(p);
  for (std::size_t p = 0; p < copy_of.size(); ++p) {
    if (sides[p] != both_sides || (options.is_open && !options.is_open(mesh.points_mm[p]))) continue;
    copy_of[p] = static_cast<int>(order.size());
    order.push_back(static_cast<int>(p));
    split_.doubled.push_back({static_cast<int>(p), copy_of[p]});
  }
  for (const auto& [below, above] : split_.doubled) mesh.points_mm.push_back(mesh.points_mm[below]);
  mesh.point_fields = select(mesh.point_fields, order);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (split_.side[c] < 0) continue;
    for (int& p : mesh.cells[c]) {
      if (copy_of[p] >= 0) p = copy_of[p];
    }
  }
}

}  // namespace
}  // namespace glisson::geometry
