#pragma once
// The mesh's error where a specimen stiffens with strain. Under large loads it is another than the one of small loads,
// times the load (refinement.h): at a tool's edge the coarse mesh strains less, and so stiffens less.
//
// Equilibria of the declared specimen and of the one whose cells are divided into eight are solved under each tool
// alone, at half of its largest load and at all of it. Between them the difference is a polynomial of the load.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "closedloop/palpation/internal/refinement.h"
#include "closedloop/palpation/internal/solver.h"
#include "closedloop/palpation/internal/state.h"

namespace glisson::closedloop {

// A tool's loads reach from `pulled_mN` (at most 0) to `pressed_mN` (at least 0).
struct LoadRange {
  double pulled_mN = 0, pressed_mN = 0;
};

class ErrorAtStrain {
 public:
  // `ranges` are one a tool, in the order of `tools`, which are the solver's first columns.
  ErrorAtStrain(PalpationSolver solver, std::vector<Eigen::Vector3d> marker_places_mm, std::vector<FaceLoad> tools,
                const std::vector<LoadRange>& ranges);

  // What the finer mesh changes at the markers (mm, 3 rows a marker, a column a column of amounts), times
  // `error_of_first_step`, without its part that is linear in the load. `amounts` are the solver's loads (rows). Zero
  // where the mesh has more than `maximum_cells_strained`, or no equilibrium is found. Solved at coefficients
  // that are powers of two, and linear in their logarithm between them; what was solved is remembered.
  [[nodiscard]] Eigen::MatrixXd beyond_linear_mm(const Stiffening& stiffening, const Eigen::MatrixXd& amounts) const;

 private:
  struct Fine;
  std::shared_ptr<Fine> fine_;
};
inline constexpr std::size_t maximum_cells_strained = 2000;  // a factor of eight times as many takes seconds

}  // namespace glisson::closedloop
