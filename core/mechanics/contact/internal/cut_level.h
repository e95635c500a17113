#pragma once
// What a live cut adds to the levels that precondition conjugate gradients (spline_levels.h). The wide splines around
// the cut come once more, times a function H that jumps across it. The jumps of those come too:
//   r -> Y (Y^T A Y)^-1 Y^T r + D^-1 r on the jumps,
// Y the splines times H at the nodes, and at the jumps the splines themselves. Parts that the cut has separated then
// move apart in few steps. H = 1/2 + theta / 2 pi, with theta the angle around the front from straight ahead. It is 1
// above and 0 below far behind the front, and continuous ahead of it. So behaves the first branch function of a crack's
// tip in linear elasticity (Moes, Dolbow and Belytschko 1999, Int. J. Numer. Meth. Eng. 46:131). Y^T A Y is that at
// rest, with a point for each side of a cell: it need not be exact to precondition.

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "mechanics/contact/internal/open_cells.h"
#include "mechanics/contact/internal/spline_lattice.h"

namespace glisson::mechanics {

class CutLevel {
 public:
  // `wide_of_node` are the wide splines around each node (SplineLattice::wide_around).
  CutLevel(const Body& body, const SplineLattice& lattice,
           const std::vector<SplineLattice::Shares<float>>& wide_of_node, const OpenCells& open,
           const std::vector<CutFront>& fronts);

  [[nodiscard]] Eigen::Index values() const { return inverse_.rows(); }  // 3 a function
  // Of an unknown, a node or what follows the nodes, the functions there.
  [[nodiscard]] const SplineLattice::Shares<float>& around(int unknown) const {
    const int entry = entry_of_[static_cast<std::size_t>(unknown)];
    return entry < 0 ? none_ : entries_[static_cast<std::size_t>(entry)].second;
  }
  [[nodiscard]] const Eigen::Matrix3d& own_inverse(int jump) const {
    return own_inverse_[static_cast<std::size_t>(jump)];
  }
  [[nodiscard]] int jumps() const { return static_cast<int>(own_inverse_.size()); }

  // (Y^T A Y)^-1; that times Y^T r; z += Y values.
  [[nodiscard]] const Eigen::MatrixXf& inverse() const { return inverse_; }
  [[nodiscard]] Eigen::VectorXf answer(const Eigen::VectorXd& r) const;
  void spread(const Eigen::VectorXf& values, Eigen::VectorXd& z) const;

 private:
  using Shares = SplineLattice::Shares<float>;
  void add(int unknown, int function, float weight);
  [[nodiscard]] Eigen::MatrixXd stiffness(const Body& body, const OpenCells& open, int functions) const;

  const SplineLattice& lattice_;
  std::vector<std::pair<int, Shares>> entries_;  // an unknown and its functions
  std::vector<int> entry_of_;                    // of each unknown, -1: none
  Eigen::MatrixXf inverse_;
  std::vector<Eigen::Matrix3d> own_inverse_;
  Shares none_;
};

}  // namespace glisson::mechanics
