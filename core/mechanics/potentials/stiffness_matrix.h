#pragma once
// The stiffness of a whole body as one symmetric sparse matrix (mN/mm), its lower triangle stored by columns.

#include <Eigen/SparseCore>
#include <optional>

#include "mechanics/elements/body.h"
#include "mechanics/materials/deformation.h"

namespace glisson::mechanics {

// How much force (per volume of a cell) a displacement of b puts on a, from the gradients of their shape functions. It
// comes by the body's isotropic material, and by its fibres where it has any.
class PairStiffness {
 public:
  explicit PairStiffness(const Body& body);
  [[nodiscard]] Eigen::Matrix3d operator()(std::size_t cell, const Eigen::Vector3d& gradient_a,
                                           const Eigen::Vector3d& gradient_b) const;

 private:
  const Body& body_;
  std::optional<Matrix9d> anisotropy_;  // what fibres add to the isotropic tangent, per unit of Young's modulus
};

// 3 rows and columns a node, x y z; with the foundations and the capsule at rest. The result does not depend on the
// number of threads: each column is summed by one thread, in the order of the cells.
[[nodiscard]] Eigen::SparseMatrix<double> assemble_stiffness(const Body& body);

}  // namespace glisson::mechanics
