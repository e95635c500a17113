#pragma once
// A supernodal Cholesky factor with its numbers rounded to single precision. It takes half the memory and half the time
// of a solve, which waits for memory. The upper triangles, which CHOLMOD stores as zeros, are left out but for narrow
// ones. A solution carries about four digits, and is refined by residuals in double precision (constrained_system.h;
// Higham, Accuracy and Stability of Numerical Algorithms, chapter 12).

#include <cholmod.h>

#include <cstdint>
#include <cstdlib>
#include <Eigen/Core>
#include <memory>
#include <vector>

namespace glisson::mechanics {

class SinglePrecisionFactor {
 public:
  // `factor` is supernodal, L L^T of a permuted matrix. Its numbers are rounded where they lie, so that both never
  // stand side by side. They are then no longer its own; the rest may be freed.
  explicit SinglePrecisionFactor(cholmod_factor& factor);

  // One column a right-hand side. Safe from several threads at once.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;
  [[nodiscard]] std::uint64_t bytes() const { return count_ * sizeof(float); }

 private:
  // At most `widest` of CHOLMOD's columns.
  struct Supernode {
    int first_column, columns;
    std::size_t first_row;  // in rows_: its own columns' rows, then those below
    int rows;
    std::size_t first_value;  // in values_: `columns` columns of `rows` numbers
  };
  void solve_forward(Eigen::MatrixXf& x) const;
  void solve_backward(Eigen::MatrixXf& x) const;

  std::vector<int> order_;  // the unknown at each place of the elimination
  std::vector<Supernode> supernodes_;
  std::vector<int> rows_;
  struct Free {
    void operator()(float* values) const { std::free(values); }
  };
  std::unique_ptr<float, Free> values_;  // CHOLMOD's block, which malloc gave
  std::size_t count_ = 0;
};

}  // namespace glisson::mechanics
