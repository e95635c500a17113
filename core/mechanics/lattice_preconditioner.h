#pragma once
// What makes conjugate gradients fast on a moving body: r -> D^-1 r + P (P^T A P)^-1 P^T r, an additive method of two
// levels. D is the 3x3 blocks of A's diagonal. P interpolates trilinearly from a regular lattice laid through the body,
// several cells wide: its few unknowns hold the smooth motions, turning and bending among them, which D alone leaves to
// hundreds of iterations (any text on domain decomposition, e.g. Toselli and Widlund 2005, 2.5 and 3). The small matrix
// is factorised, and may lag behind A: that costs iterations, never exactness. Inside of this room.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mechanics/block_csr.h"
#include "mechanics/cholesky_factor.h"

namespace glisson::mechanics {

class LatticePreconditioner {
 public:
  // `mask` is 1 for what is free and 0 for what is held, 3 a node. The spacing must exceed every edge of the mesh.
  LatticePreconditioner(const std::vector<Eigen::Vector3d>& positions_mm, std::vector<float> mask, double spacing_mm);

  // From the present matrix: the diagonal, cheap, for every step; the lattice's matrix, dearer, when it pays.
  void refresh_diagonal(const BlockCsr& matrix);
  // Where its factorisation fails, the diagonal works alone.
  void refresh_lattice(const BlockCsr& matrix);

  // z from r, 3 values a node and one more; gives back r . z.
  double apply(const std::vector<float>& r, std::vector<float>& z) const;

  [[nodiscard]] std::size_t lattice_points() const { return lattice_.size(); }

 private:
  struct Corner {
    int point;  // of the lattice
    float weight;
  };
  struct Share {
    int node;
    float weight;
  };

  std::vector<float> mask_;
  std::vector<std::array<Corner, 8>> corners_;  // of the lattice cell around each node
  std::vector<Eigen::Vector3i> cell_;           // which one that is
  std::vector<Eigen::Vector3i> lattice_;        // the points of the lattice that some node uses
  std::vector<std::vector<Share>> shares_;      // of each such point
  std::vector<float> inverse_diagonal_;         // 9 a node
  std::optional<CholeskyFactor> factor_;
  Eigen::MatrixXf
      inverse_;  // instead of the factor, where it is small enough for both cores to multiply with it sooner
};

}  // namespace glisson::mechanics
