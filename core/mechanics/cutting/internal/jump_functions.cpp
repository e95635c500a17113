#include "mechanics/cutting/internal/jump_functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mechanics/cutting/internal/crossed_faces.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/potentials/stiffness_matrix.h"

namespace glisson::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

// Which number a point has in a list, -1: none.
std::vector<int> numbers_of(const std::vector<int>& points, std::size_t all) {
  std::vector<int> number(all, -1);
  for (std::size_t i = 0; i < points.size(); ++i) number[points[i]] = static_cast<int>(i);
  return number;
}

// The cells that any of the points belongs to, as numbers in the crossing, ascending.
std::vector<int> cells_around(const Crossing& crossing, const std::vector<int>& points) {
  std::vector<int> cells;
  for (const int point : points) {
    cells.insert(cells.end(), crossing.cells_of_point[point].begin(), crossing.cells_of_point[point].end());
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

// H - H_i on the two sides.
struct Sides {
  double above, below;
};
Sides sides_of(const Crossing& crossing, int point) {
  return crossing.height_mm[point] > 0 ? Sides{0, -1} : Sides{1, 0};
}

// The crossed faces of the boundary that have one of the points as a corner, ascending.
std::vector<std::size_t> faces_touching(const Body& body, const Crossing& crossing, const std::vector<int>& points);

// Integrals over a face of a point's function with another quantity, part by part: `at(barycentric, function value of
// each corner, weight in mm2)`.
template <typename At>
void integrate(const Crossing& crossing, const BoundaryFace& face, const At& at) {
  for (const FacePart& part : parts_of(crossing, face)) {
    for (const TrianglePoint& q : triangle_points_degree_4()) {
      const Vector3d l = part.corners * q.barycentric;
      Vector3d values;
      for (int i = 0; i < 3; ++i) {
        const Sides sides = sides_of(crossing, face.points[i]);
        values[i] = l[i] * (part.above ? sides.above : sides.below);
      }
      at(l, values, q.weight * part.share * face.area_mm2);
    }
  }
}

// The same over what of the boundary stands on springs: `at(face, barycentric, function values, mN/mm)`.
template <typename At>
void for_springs(const Body& body, const Crossing& crossing, const std::vector<int>& points, const At& at) {
  const std::vector<std::size_t> touching = faces_touching(body, crossing, points);
  for (const FoundationFace& spring : body.resolved.foundations) {
    if (!std::binary_search(touching.begin(), touching.end(), spring.face)) continue;
    const BoundaryFace& face = body.boundary[spring.face];
    integrate(crossing, face, [&](const Vector3d& l, const Vector3d& values, double weight_mm2) {
      at(face, l, values, spring.stiffness_kPa_per_mm * weight_mm2);
    });
  }
}

// Of the nodes of a face.
using FaceValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
FaceValues values_of_nodes(ElementOrder order, const Vector3d& l) {
  if (order == ElementOrder::linear) return l;
  return quadratic_triangle_values(l);
}

}  // namespace

Eigen::SparseMatrix<double> coupling(const Body& body, const Crossing& crossing, const std::vector<int>& points) {
  const NodeLayout& layout = body.layout;
  const PairStiffness pair(body);
  const std::vector<int> number = numbers_of(points, body.mesh.points_mm.size());
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int node, int column, const Matrix3d& block) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) entries.emplace_back(3 * node + r, 3 * column + c, block(r, c));
    }
  };
  for (const int crossed : cells_around(crossing, points)) {
    const CrossedCell& cut = crossing.cells[crossed];
    const auto cell = static_cast<std::size_t>(cut.cell);
    const CellGeometry shape = cell_geometry(body.mesh, cell);
    const double above_mm3 = cut.division.share_above * shape.volume_mm3;
    const double below_mm3 = shape.volume_mm3 - above_mm3;
    const TetGradients above = tet_gradients(tet_derivatives(layout.order, cut.division.centroid_above), shape);
    const TetGradients below = tet_gradients(tet_derivatives(layout.order, cut.division.centroid_below), shape);
    for (int b = 0; b < 4; ++b) {
      const int point = body.mesh.cells[cell][b];
      if (number[point] < 0) continue;
      const Sides sides = sides_of(crossing, point);
      const Vector3d gradient = shape.barycentric_gradients.row(b);
      for (int a = 0; a < layout.nodes_per_cell(); ++a) {
        const Vector3d of_node = above_mm3 * sides.above * above.row(a) + below_mm3 * sides.below * below.row(a);
        add(layout.cells[cell][a], number[point], pair(cell, of_node, gradient));
      }
    }
  }
  for_springs(body, crossing, points,
              [&](const BoundaryFace& face, const Vector3d& l, const Vector3d& values, double stiffness) {
                const FaceValues of_nodes = values_of_nodes(layout.order, l);
                for (int i = 0; i < 3; ++i) {
                  if (number[face.points[i]] < 0) continue;
                  for (Eigen::Index a = 0; a < of_nodes.size(); ++a) {
                    add(face.nodes[a], number[face.points[i]],
                        stiffness * values[i] * of_nodes[a] * Matrix3d::Identity());
                  }
                }
              });
  Eigen::SparseMatrix<double> columns(3 * layout.nodes(), 3 * static_cast<int>(points.size()));
  columns.setFromTriplets(entries.begin(), entries.end());
  return columns;
}

Eigen::MatrixXd stiffness_between(const Body& body, const Crossing& crossing, const std::vector<int>& rows,
                                  const std::vector<int>& columns) {
  const PairStiffness pair(body);
  const std::vector<int> row_of = numbers_of(rows, body.mesh.points_mm.size());
  const std::vector<int> column_of = numbers_of(columns, body.mesh.points_mm.size());
  Eigen::MatrixXd stiffness =
      Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(rows.size()), 3 * static_cast<Eigen::Index>(columns.size()));
  for (const int crossed : cells_around(crossing, columns)) {
    const CrossedCell& cut = crossing.cells[crossed];
    const auto cell = static_cast<std::size_t>(cut.cell);
    const CellGeometry shape = cell_geometry(body.mesh, cell);
    const double above_mm3 = cut.division.share_above * shape.volume_mm3;
    for (int a = 0; a < 4; ++a) {
      const int row = row_of[body.mesh.cells[cell][a]];
      if (row < 0) continue;
      const Sides of_row = sides_of(crossing, body.mesh.cells[cell][a]);
      for (int b = 0; b < 4; ++b) {
        const int column = column_of[body.mesh.cells[cell][b]];
        if (column < 0) continue;
        const Sides of_column = sides_of(crossing, body.mesh.cells[cell][b]);
        const double filled_mm3 = above_mm3 * of_row.above * of_column.above +
                                  (shape.volume_mm3 - above_mm3) * of_row.below * of_column.below;
        if (filled_mm3 == 0) continue;
        stiffness.block<3, 3>(3 * row, 3 * column) +=
            filled_mm3 * pair(cell, shape.barycentric_gradients.row(a), shape.barycentric_gradients.row(b));
      }
    }
  }
  for_springs(body, crossing, columns,
              [&](const BoundaryFace& face, const Vector3d&, const Vector3d& values, double of_spring) {
                for (int i = 0; i < 3; ++i) {
                  for (int j = 0; j < 3; ++j) {
                    const int row = row_of[face.points[i]], column = column_of[face.points[j]];
                    if (row < 0 || column < 0) continue;
                    stiffness.block<3, 3>(3 * row, 3 * column).diagonal().array() += of_spring * values[i] * values[j];
                  }
                }
              });
  return stiffness;
}

void add_foundation_springs(const Body& body, const Crossing& crossing, const std::vector<int>& number,
                            std::vector<Eigen::Triplet<double>>& with_nodes,
                            std::vector<Eigen::Triplet<double>>& between) {
  std::vector<int> points;
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (number[p] >= 0) points.push_back(static_cast<int>(p));
  }
  for_springs(body, crossing, points,
              [&](const BoundaryFace& face, const Vector3d& l, const Vector3d& values, double stiffness) {
                const FaceValues of_nodes = values_of_nodes(body.layout.order, l);
                for (int i = 0; i < 3; ++i) {
                  const int jump = number[face.points[i]];
                  if (jump < 0) continue;
                  for (Eigen::Index a = 0; a < of_nodes.size(); ++a) {
                    with_nodes.emplace_back(face.nodes[a], jump, stiffness * values[i] * of_nodes[a]);
                  }
                  for (int j = 0; j < 3; ++j) {
                    const int other = number[face.points[j]];
                    if (other >= 0) between.emplace_back(jump, other, stiffness * values[i] * values[j]);
                  }
                }
              });
}

VectorXd load_on(const Body& body, const Crossing& crossing, const Loads& loads, const std::vector<int>& points) {
  const std::vector<int> number = numbers_of(points, body.mesh.points_mm.size());
  VectorXd force_mN = VectorXd::Zero(3 * static_cast<Eigen::Index>(points.size()));
  const auto add_to_face = [&](std::size_t f, const Vector3d& traction_kPa) {
    const BoundaryFace& face = body.boundary[f];
    integrate(crossing, face, [&](const Vector3d&, const Vector3d& values, double weight_mm2) {
      for (int i = 0; i < 3; ++i) {
        if (number[face.points[i]] < 0) continue;
        force_mN.segment<3>(3 * number[face.points[i]]) += weight_mm2 * values[i] * traction_kPa;
      }
    });
  };
  const std::vector<std::size_t> touching = faces_touching(body, crossing, points);
  const std::vector<int> cells = cells_around(crossing, points);
  for (const Load& load : loads) {
    if (const auto* tool = std::get_if<ToolLoad>(&load)) {
      const auto touched = spread(*tool, body.boundary);
      if (!touched) continue;
      for (const std::size_t f : touched->faces) {
        if (std::binary_search(touching.begin(), touching.end(), f)) add_to_face(f, touched->traction_kPa);
      }
    } else if (const auto* pressure = std::get_if<PressureLoad>(&load)) {
      for (const std::size_t f : touching) add_to_face(f, -pressure->pressure_kPa * body.boundary[f].normal);
      for (const int c : cells) {
        const CrossedCell& cut = crossing.cells[c];
        for (int i = 0; i < 4; ++i) {
          const int n = number[body.mesh.cells[cut.cell][i]];
          if (n < 0) continue;
          force_mN.segment<3>(3 * n) +=
              pressure->pressure_kPa * cut.wall_area_mm2 * cut.wall_centroid[i] * cut.wall_normal;
        }
      }
    } else {
      const Vector3d force_per_mm3 = body.options.density_kg_mm3 * std::get<GravityLoad>(load).acceleration_mm_s2;
      for (const int c : cells) {
        const CrossedCell& cut = crossing.cells[c];
        const double volume_mm3 = geometry::cell_volume_mm3(body.mesh, cut.cell);
        const double above_mm3 = cut.division.share_above * volume_mm3;
        for (int i = 0; i < 4; ++i) {
          const int point = body.mesh.cells[cut.cell][i];
          if (number[point] < 0) continue;
          const Sides sides = sides_of(crossing, point);
          force_mN.segment<3>(3 * number[point]) +=
              (above_mm3 * sides.above * cut.division.centroid_above[i] +
               (volume_mm3 - above_mm3) * sides.below * cut.division.centroid_below[i]) *
              force_per_mm3;
        }
      }
    }
  }
  return force_mN;
}

double value_at(const geometry::TetMesh& mesh, const Crossing& crossing, int point, const PointInMesh& place) {
  const auto& corners = mesh.cells[place.cell];
  double height_mm = 0, value = 0;
  bool some_above = false, some_below = false;
  for (int i = 0; i < 4; ++i) {
    const double h = crossing.height_mm[corners[i]];
    height_mm += place.barycentric[i] * h;
    (h > 0 ? some_above : some_below) = true;
    if (corners[i] == point) value = place.barycentric[i];
  }
  if (!some_above || !some_below) return 0;
  const Sides sides = sides_of(crossing, point);
  return value * (height_mm > 0 ? sides.above : sides.below);
}

double share_filled(const geometry::TetMesh& mesh, const Crossing& crossing, int point,
                    const std::vector<double>& volume_around_mm3) {
  const Sides sides = sides_of(crossing, point);
  double filled_mm3 = 0;
  for (const int c : crossing.cells_of_point[point]) {
    const CrossedCell& cut = crossing.cells[c];
    const double share = sides.above != 0 ? cut.division.share_above : 1.0 - cut.division.share_above;
    filled_mm3 += share * geometry::cell_volume_mm3(mesh, cut.cell);
  }
  return filled_mm3 / volume_around_mm3[point];
}

namespace {

std::vector<std::size_t> faces_touching(const Body& body, const Crossing& crossing, const std::vector<int>& points) {
  const std::vector<int> number = numbers_of(points, body.mesh.points_mm.size());
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < body.boundary.size(); ++f) {
    const auto& corners = body.boundary[f].points;
    int above = 0, named = 0;
    for (const int point : corners) {
      above += crossing.height_mm[point] > 0 ? 1 : 0;
      named += number[point] >= 0 ? 1 : 0;
    }
    // On a face that is not crossed every function of its corners is zero.
    if (above > 0 && above < 3 && named > 0) faces.push_back(f);
  }
  return faces;
}

}  // namespace
}  // namespace glisson::mechanics
