#pragma once
// A body as two parts, above and below a surface: the stiffness of each and what loads do to it, crossed cells and
// faces divided. Integrals are exact but for the surface's bend within a cell. Inside of this room.

#include <cstdint>
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/cutting/internal/crossed_cells.h"
#include "mechanics/elements/body.h"

namespace glisson::mechanics {

enum Side : std::uint8_t { below = 0, above = 1 };

// Where a cell is integrated over on one side, by shares of its volume.
struct CellPoint {
  Eigen::Vector4d barycentric;
  double share;
};

// A body in two parts.
class BodyParts {
 public:
  BodyParts(const Body& body, const Crossing& crossing);

  // K of a part over the nodes (mN/mm, both triangles), of the cells around the points that count, with its springs.
  [[nodiscard]] Eigen::SparseMatrix<double> stiffness(Side side, const std::vector<std::uint8_t>& counts,
                                                      const std::vector<double>& springs_mN_mm) const;
  [[nodiscard]] Eigen::VectorXd load_mN(Side side, const Loads& loads) const;  // 3 a node
  [[nodiscard]] double height_mm(int node) const { return node_height_mm_[static_cast<std::size_t>(node)]; }

 private:
  [[nodiscard]] std::vector<CellPoint> points_in(std::size_t cell, Side side) const;
  void add_traction(const BoundaryFace& face, Side side, const Eigen::Vector3d& traction_kPa,
                    Eigen::VectorXd& force_mN) const;

  const Body& body_;
  const Crossing& crossing_;
  std::vector<int> crossed_;  // of each cell its number in the crossing, -1: none
  std::vector<double> node_height_mm_;
};

}  // namespace glisson::mechanics
