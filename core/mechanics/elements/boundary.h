#pragma once
// The outer faces of a body with their nodes: where tools push, pressure acts and foundations spring.

#include <array>
#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "geometry/tetrahedra.h"
#include "mechanics/elements/node_layout.h"

namespace glisson::mechanics {

struct BoundaryFace {
  std::array<int, 3> points;  // of the mesh, counter-clockwise from outside
  std::array<int, 6> nodes;   // corners, then the middles of 0-1, 1-2, 2-0 (-1 for linear cells)
  Eigen::Vector3d centroid_mm;
  Eigen::Vector3d normal;  // unit, outward
  double area_mm2;
};

[[nodiscard]] std::vector<BoundaryFace> boundary_faces(const geometry::TetMesh& mesh, const NodeLayout& layout);

// The faces whose centroid lies within the radius. Failure: "tool-touches-nothing", with the distance to the nearest.
[[nodiscard]] Result<std::vector<std::size_t>> faces_within(const std::vector<BoundaryFace>& boundary,
                                                            const Eigen::Vector3d& center_mm, double radius_mm);

// Adds the nodal forces (mN, 3 a node) of a uniform traction (kPa) on one face.
void add_traction(const BoundaryFace& face, const Eigen::Vector3d& traction_kPa, Eigen::VectorXd& force_mN);

// The integral of N_i N_j over a face (mm2), 3x3 for linear cells and 6x6 for quadratic ones.
using FaceMass = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
[[nodiscard]] FaceMass face_mass_mm2(const BoundaryFace& face, ElementOrder order);

}  // namespace glisson::mechanics
