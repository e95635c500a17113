#pragma once
// How far the declared model's finite elements are from the exact solution of its equations, as a finer solve shows it.
// Every cell is divided into eight, and the loads and supports stay on the same faces. What that changes at the markers
// is taken for the error.
//
// The finer equations are solved roughly, by conjugate gradients. The preconditioner is the coarse factor and the
// diagonal. What the coarse mesh cannot represent is short-ranged, so few steps show it to about a tenth of itself.

#include <Eigen/Core>
#include <vector>

#include "closedloop/palpation/internal/loading.h"
#include "closedloop/palpation/internal/solver.h"

namespace glisson::closedloop {

// A unit load of the solver that is a uniform traction on some faces of the boundary.
struct FaceLoad {
  Eigen::Index load = 0;           // the solver's column
  std::vector<std::size_t> faces;  // of the declared body's boundary
  Eigen::Vector3d traction_kPa{0, 0, 0};
};

// A millinewton of each tool, each tool once, in the order of the solver's columns.
[[nodiscard]] std::vector<FaceLoad> tool_loads(const Palpation& experiment, const std::vector<History>& histories,
                                               const mechanics::Body& body);

// By the edges of tools and of clamps errors fall with the cells' size to the power of 1.4. So the whole error is 1.6
// times what the first step changes.
inline constexpr double error_of_first_step = 1.6;

// The change at the markers (mm, 3 rows a marker, a column a load), times `error_of_first_step`. No columns where the
// mesh has more than `maximum_cells_refined`: refining would take longer than all the rest.
inline constexpr std::size_t maximum_cells_refined = 16000;
[[nodiscard]] Eigen::MatrixXd discretisation_error_mm(const PalpationSolver& solver,
                                                      const std::vector<Eigen::Vector3d>& marker_places_mm,
                                                      const std::vector<FaceLoad>& loads);

// The declared specimen with every cell divided into eight, ready to be solved under the tools' loads, in their order.
// Its markers are those of `marker_places_mm`. Failures: those of mechanics/elements/body.h and
// PalpationSolver::create.
Result<PalpationSolver> refined_solver(const PalpationSolver& solver,
                                       const std::vector<Eigen::Vector3d>& marker_places_mm,
                                       const std::vector<FaceLoad>& loads);

// Each cell divided into eight. The points are the nodes of the coarse layout, in its order. In a quadratic layout
// displacements are then values at the fine mesh's points.
[[nodiscard]] geometry::TetMesh refined(const mechanics::Body& body);

}  // namespace glisson::closedloop
