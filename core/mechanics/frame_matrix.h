#pragma once
// Matrices over frames (frame_basis.h), assembled: P^T K P in blocks of 12x12, P being how places follow frames. For
// a few thousand frames at most: a frame meets a hundred others, and each block is 1.2 kB. Inside of this room.

#include <Eigen/SparseCore>
#include <vector>

#include "mechanics/block_csr.h"
#include "mechanics/frame_basis.h"

namespace glisson::mechanics {

// Which frames meet in some cell, themselves included, ascending.
[[nodiscard]] Lists frames_that_meet(const FrameBasis& basis);

// A symmetric matrix of 12x12 blocks, both triangles stored.
class FrameMatrix {
 public:
  explicit FrameMatrix(Lists columns_of_row)
      : columns_(std::move(columns_of_row)), blocks_(columns_.items.size(), FrameBlock::Zero()) {}

  [[nodiscard]] int rows() const { return static_cast<int>(columns_.starts.size()) - 1; }
  [[nodiscard]] const Lists& columns() const { return columns_; }
  [[nodiscard]] std::vector<FrameBlock>& blocks() { return blocks_; }
  [[nodiscard]] const std::vector<FrameBlock>& blocks() const { return blocks_; }
  [[nodiscard]] std::size_t position(int row, int column) const {
    return static_cast<std::size_t>(std::lower_bound(columns_.begin(row), columns_.end(row), column) -
                                    columns_.items.data());
  }
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::SparseMatrix<double> lower() const;
  // a A + b B, of one pattern.
  [[nodiscard]] static FrameMatrix sum(double a, const FrameMatrix& first, double b, const FrameMatrix& second);

 private:
  Lists columns_;
  std::vector<FrameBlock> blocks_;
};

// P^T K P, `stiffness` being K over the places; and of that the blocks of the diagonal alone.
[[nodiscard]] FrameMatrix reduced(const BlockMatrix<double>& stiffness, const FrameBasis& basis);
[[nodiscard]] FrameMatrix reduced(const BlockMatrix<double>& stiffness, const FrameBasis& basis, Lists frames_meeting);
[[nodiscard]] std::vector<FrameBlock> diagonal_reduced(const BlockMatrix<double>& stiffness, const FrameBasis& basis);

}  // namespace glisson::mechanics
