#pragma once
// What makes conjugate gradients fast on a moving body: an additive method of three levels, r -> D^-1 r + P (w B^-1 + Q
// (Q^T P^T A P Q)^-1 Q^T) P^T r. D is the 3x3 blocks of A's diagonal. P interpolates trilinearly from a regular lattice
// laid through the body, a few nodes to its cell. B is the diagonal blocks of P^T A P. Q interpolates from every other
// point of that lattice. The few unknowns of the widest hold the smooth motions, turning and bending among them, and
// are solved for exactly. D alone leaves these to hundreds of iterations. The lattice between passes on what is too
// wide for D and too narrow for them (Bramble, Pasciak and Xu 1990, Math. Comp. 55:1; Toselli and Widlund 2005, Domain
// Decomposition Methods, 2.5 and 3). The lattices may lag behind A: that costs iterations, never exactness.

#include <array>
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mechanics/solvers/cholesky_factor.h"
#include "mechanics/solvers/internal/block_csr.h"

namespace glisson::mechanics {

class LatticePreconditioner {
 public:
  // `mask` is 1 for what is free and 0 for what is fixed, 3 a node and one more. The spacing is that of the widest
  // lattice and must exceed every edge of the mesh.
  LatticePreconditioner(const std::vector<Eigen::Vector3d>& positions_mm, std::vector<float> mask, double spacing_mm);

  // From the present matrix: the diagonal, cheap, for every step; the lattices' matrices, dearer, when it pays.
  void refresh_diagonal(const BlockCsr& matrix);
  // Where the factorisation of the widest fails, the other two levels work alone.
  void refresh_lattices(const BlockCsr& matrix);

  // z from r, 3 values a node and one more; gives back r . z.
  double apply(const std::vector<float>& r, std::vector<float>& z);

  // Of the widest lattice.
  [[nodiscard]] std::size_t lattice_points() const { return wide_.size(); }

 private:
  // A point of the narrow lattice around a node, or of the wide one around a point of the narrow.
  struct Share {
    int point;
    float weight;
  };
  // A cell of the narrow lattice: its corners, and the nodes in it (a range of members_).
  struct Brick {
    std::array<int, 8> corners;
    std::size_t begin, end;
  };
  struct Member {
    int node;
    std::array<float, 8> weights;  // of the brick's corners
  };
  struct Place {
    Eigen::Vector3i cell;  // of the narrow lattice
    Eigen::Vector3d within;
    int brick;
  };

  [[nodiscard]] Eigen::SparseMatrix<double> wide_matrix(const BlockCsr& matrix) const;
  void refresh_narrow(const BlockCsr& matrix);

  std::vector<float> mask_;
  std::vector<Place> places_;                    // of the nodes
  std::vector<Brick> bricks_;                    // along the nodes
  std::vector<Member> members_;                  // every node once
  std::vector<Eigen::Vector3i> narrow_, wide_;   // points of the lattices; a wide one's in steps of the wide lattice
  Lists bricks_of_point_;                        // 8 * brick + corner, for each point of the narrow lattice
  std::vector<std::vector<Share>> shares_;       // in the wide lattice, of each point of the narrow one
  std::vector<float> inverse_diagonal_;          // 9 a node, and one more
  std::vector<Eigen::Matrix3f> narrow_inverse_;  // w B^-1
  std::optional<CholeskyFactor> factor_;
  Eigen::MatrixXf wide_inverse_;  // instead of the factor, where it is small enough to be multiplied with sooner
  std::vector<Eigen::Vector4f> brick_sums_, narrow_values_;  // of one application; 8 a brick, one a point
  Eigen::VectorXf wide_values_, wide_shift_;
  std::vector<double> partial_;
};

}  // namespace glisson::mechanics
