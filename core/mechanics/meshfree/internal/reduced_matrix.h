#pragma once
// Matrices over handles (affine_basis.h), assembled: P^T K P in blocks of 12x12, P being how places follow handles. For
// a few thousand handles at most: a handle meets a hundred others, and each block is 1.2 kB.

#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/meshfree/internal/affine_basis.h"
#include "mechanics/solvers/internal/block_csr.h"

namespace glisson::mechanics {

// Which handles meet in some cell, themselves included, ascending.
[[nodiscard]] Lists handles_that_meet(const AffineBasis& basis);

// A symmetric matrix of 12x12 blocks, both triangles stored.
class ReducedMatrix {
 public:
  explicit ReducedMatrix(Lists columns_of_row)
      : columns_(std::move(columns_of_row)), blocks_(columns_.items.size(), HandleBlock::Zero()) {}

  [[nodiscard]] int rows() const { return static_cast<int>(columns_.starts.size()) - 1; }
  [[nodiscard]] const Lists& columns() const { return columns_; }
  [[nodiscard]] std::vector<HandleBlock>& blocks() { return blocks_; }
  [[nodiscard]] const std::vector<HandleBlock>& blocks() const { return blocks_; }
  [[nodiscard]] std::size_t position(int row, int column) const {
    return static_cast<std::size_t>(std::lower_bound(columns_.begin(row), columns_.end(row), column) -
                                    columns_.items.data());
  }
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::MatrixXd times_columns(const Eigen::MatrixXd& x) const;
  [[nodiscard]] Eigen::SparseMatrix<double> lower() const;
  // a A + b B, of one pattern.
  [[nodiscard]] static ReducedMatrix sum(double a, const ReducedMatrix& first, double b, const ReducedMatrix& second);

 private:
  Lists columns_;
  std::vector<HandleBlock> blocks_;
};

// P^T K P, `stiffness` being K over the places; and of that the blocks of the diagonal alone.
[[nodiscard]] ReducedMatrix reduced(const BlockMatrix<double>& stiffness, const AffineBasis& basis);
[[nodiscard]] ReducedMatrix reduced(const BlockMatrix<double>& stiffness, const AffineBasis& basis,
                                    Lists handles_meeting);
[[nodiscard]] std::vector<HandleBlock> diagonal_reduced(const BlockMatrix<double>& stiffness, const AffineBasis& basis);

}  // namespace glisson::mechanics
