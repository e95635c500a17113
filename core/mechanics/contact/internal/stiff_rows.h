#pragma once
// Rows of stiffness beside a body's tangent: what contacts and jaws see of it and how they answer. Points on a divided
// face are 12 or 48, with friction three rows each, and all of them see 18 values of the face's six nodes. Where rows
// are more than the values that they see, those values are solved for in their place.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <utility>
#include <vector>

namespace glisson::mechanics {

// Sees the sum of directions times displacements, less so many times a further unknown.
struct LinearFunctional {
  std::vector<std::pair<int, Eigen::Vector3d>> on;  // nodes, each once, and after their numbers those of jumps
  int further = -1;                                 // of the unknowns after the nodes; -1: none
  double along = 0;
};

struct StiffRow {
  std::vector<std::pair<int, Eigen::Vector3d>> on;  // as of a functional
  int further = -1;
  double along = 0;
  double stiffness = 0;
  double gap_mm = 0;       // it presses with -k times what this becomes
  bool two_sided = false;  // or else only where that is below zero
};

// Each row sees the sum of its shares times what the functionals see.
struct CondensedRows {
  std::vector<LinearFunctional> functionals;
  Eigen::SparseMatrix<double, Eigen::RowMajor> shares;  // rows x functionals
};
[[nodiscard]] CondensedRows condensed(const std::vector<StiffRow>& rows);

}  // namespace glisson::mechanics
