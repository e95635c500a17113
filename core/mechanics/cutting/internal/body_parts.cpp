#include "mechanics/cutting/internal/body_parts.h"

#include <algorithm>
#include <cmath>

#include "mechanics/cutting/internal/crossed_faces.h"
#include "mechanics/elements/load_vector.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/potentials/stiffness_matrix.h"
#include "mechanics/potentials/tangent_sum.h"

namespace glisson::mechanics {

using Eigen::Index;
using Eigen::SparseMatrix;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

BodyParts::BodyParts(const Body& body, const Crossing& crossing)
    : body_(body), crossing_(crossing), crossed_(body.mesh.cells.size(), -1) {
  for (std::size_t c = 0; c < crossing.cells.size(); ++c) crossed_[crossing.cells[c].cell] = static_cast<int>(c);
  const NodeLayout& layout = body.layout;
  node_height_mm_.assign(static_cast<std::size_t>(layout.nodes()), 0.0);
  for (std::size_t p = 0; p < body.mesh.points_mm.size(); ++p) {
    if (layout.node_of_point[p] >= 0) node_height_mm_[layout.node_of_point[p]] = crossing.height_mm[p];
  }
  for (std::size_t e = 0; e < layout.edges.size(); ++e) {
    const auto& [a, b] = layout.edges[e];
    node_height_mm_[static_cast<std::size_t>(layout.corner_nodes) + e] =
        0.5 * (crossing.height_mm[a] + crossing.height_mm[b]);
  }
}

std::vector<CellPoint> BodyParts::points_in(std::size_t cell, Side side) const {
  std::vector<CellPoint> points;
  if (crossed_[cell] < 0) {
    if ((crossing_.height_mm[body_.mesh.cells[cell][0]] > 0) != (side == above)) return {};
    for (const TetPoint& q : tet_points_degree_2()) points.push_back({q.barycentric, q.weight});
    return points;
  }
  Vector4d height_mm;
  for (int i = 0; i < 4; ++i) height_mm[i] = crossing_.height_mm[body_.mesh.cells[cell][i]];
  for (const CellPiece& piece : pieces_of(height_mm)) {
    if (piece.above != (side == above)) continue;
    const double share = std::abs(piece.corners.determinant());
    for (const TetPoint& q : tet_points_degree_2()) {
      points.push_back({piece.corners * q.barycentric, share * q.weight});
    }
  }
  return points;
}

SparseMatrix<double> BodyParts::stiffness(Side side, const std::vector<std::uint8_t>& counts,
                                          const std::vector<double>& springs_mN_mm) const {
  const NodeLayout& layout = body_.layout;
  const PairStiffness pair(body_);
  const auto column_of_cell = [&](std::size_t cell, int b) {
    const auto& corners = body_.mesh.cells[cell];
    const bool is_asked = std::any_of(corners.begin(), corners.end(), [&](int p) { return counts[p] != 0; });
    const CellGeometry shape = cell_geometry(body_.mesh, cell);
    std::vector<std::pair<TetGradients, double>> at;
    for (const CellPoint& q : is_asked ? points_in(cell, side) : std::vector<CellPoint>{}) {
      at.emplace_back(tet_gradients(tet_derivatives(layout.order, q.barycentric), shape), q.share * shape.volume_mm3);
    }
    return [&pair, at = std::move(at), b, cell](int a) {
      Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
      for (const auto& [gradients, weight_mm3] : at) {
        block += weight_mm3 * pair(cell, gradients.row(a), gradients.row(b));
      }
      return block;
    };
  };
  TangentSum sum(layout);
  sum.add_cells(column_of_cell);
  const BlockSink sink = sum.within_cells();
  for (const FoundationFace& spring : body_.resolved.foundations) {
    const BoundaryFace& face = body_.boundary[spring.face];
    for (const FacePart& part : parts_of(crossing_, face)) {
      if (part.above != (side == above)) continue;
      for (const TrianglePoint& q : triangle_points_degree_4()) {
        const auto values = quadratic_triangle_values(part.corners * q.barycentric);
        const double weight = spring.stiffness_kPa_per_mm * part.share * face.area_mm2 * q.weight;
        for (int a = 0; a < 6; ++a) {
          for (int b = 0; b < 6; ++b) {
            sink.add(face.nodes[a], face.nodes[b], weight * values[a] * values[b] * Eigen::Matrix3d::Identity());
          }
        }
      }
    }
  }
  SparseMatrix<double> lower = sum.take();
  for (std::size_t i = 0; i < springs_mN_mm.size(); ++i) {  // the diagonal is the first of its column
    if ((node_height_mm_[i / 3] > 0) == (side == above)) lower.valuePtr()[lower.outerIndexPtr()[i]] += springs_mN_mm[i];
  }
  lower.prune([](Index, Index, double value) { return value != 0; });
  return lower.selfadjointView<Eigen::Lower>();
}

VectorXd BodyParts::load_mN(Side side, const Loads& loads) const {
  VectorXd force_mN = VectorXd::Zero(3 * Index{body_.layout.nodes()});
  for (const Load& load : loads) {
    if (const auto* tool = std::get_if<ToolLoad>(&load)) {
      const auto touched = spread(*tool, body_.boundary);
      if (!touched) continue;
      for (const std::size_t f : touched->faces) add_traction(body_.boundary[f], side, touched->traction_kPa, force_mN);
    } else if (const auto* pressure = std::get_if<PressureLoad>(&load)) {
      for (const BoundaryFace& face : body_.boundary) {
        add_traction(face, side, -pressure->pressure_kPa * face.normal, force_mN);
      }
    } else {
      const Vector3d force_per_mm3 = body_.options.density_kg_mm3 * std::get<GravityLoad>(load).acceleration_mm_s2;
      for (std::size_t c = 0; c < body_.mesh.cells.size(); ++c) {
        const double volume_mm3 = geometry::cell_volume_mm3(body_.mesh, c);
        for (const CellPoint& q : points_in(c, side)) {
          const TetValues values = tet_values(body_.layout.order, q.barycentric);
          for (Index a = 0; a < values.size(); ++a) {
            force_mN.segment<3>(3 * Index{body_.layout.cells[c][static_cast<std::size_t>(a)]}) +=
                q.share * volume_mm3 * values[a] * force_per_mm3;
          }
        }
      }
    }
  }
  return force_mN;
}

void BodyParts::add_traction(const BoundaryFace& face, Side side, const Vector3d& traction_kPa,
                             VectorXd& force_mN) const {
  for (const FacePart& part : parts_of(crossing_, face)) {
    if (part.above != (side == above)) continue;
    for (const TrianglePoint& q : triangle_points_degree_4()) {
      const auto values = quadratic_triangle_values(part.corners * q.barycentric);
      for (int a = 0; a < 6; ++a) {
        force_mN.segment<3>(3 * Index{face.nodes[a]}) +=
            q.weight * part.share * face.area_mm2 * values[a] * traction_kPa;
      }
    }
  }
}

}  // namespace glisson::mechanics
