#pragma once
// Displacements that follow fewer unknowns than a body has nodes, u = P q: functions of several unknowns each, which
// reach some way around the place where they stand. For those who change such functions (cutting/opening.h).
//
// Lengths mm, patient coordinates (LPS) at rest.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace glisson::mechanics {

class ReducedFunctions {
 public:
  virtual ~ReducedFunctions() = default;
  [[nodiscard]] virtual int unknowns() const = 0;  // of each function
  // Those that act on a point of the mesh, ascending.
  [[nodiscard]] virtual std::vector<int> acting_on(int point) const = 0;
  // The columns of P that belong to these: 3 rows a node, unknowns() columns a function.
  [[nodiscard]] virtual Eigen::SparseMatrix<double> columns(const std::vector<int>& functions) const = 0;
  // Springs in place of what is fixed (mN/mm, 3 a node), since no unknown stands at a node; 0 where it is free.
  [[nodiscard]] virtual const std::vector<double>& springs_mN_mm() const = 0;
};

}  // namespace glisson::mechanics
