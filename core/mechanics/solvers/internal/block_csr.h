#pragma once
// A square sparse matrix of 3x3 blocks stored by rows: what conjugate gradients multiply with, in single precision
// (BlockCsr) or double. Both triangles are stored, so that threads share nothing when multiplying.

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "mechanics/elements/block_assembly.h"

namespace glisson::mechanics {

template <typename Scalar>
class BlockMatrix {
 public:
  static constexpr int rows_in_chunk = 1024;  // one chunk's sum is one partial sum, whatever the number of threads

  // All zero; the columns of each row sorted.
  explicit BlockMatrix(Lists columns_of_row);

  [[nodiscard]] int rows() const { return static_cast<int>(columns_.starts.size()) - 1; }
  [[nodiscard]] int chunks() const { return (rows() + rows_in_chunk - 1) / rows_in_chunk; }
  [[nodiscard]] const Lists& columns() const { return columns_; }

  // Where a block is stored; it must be in the pattern.
  [[nodiscard]] std::size_t position(int row, int column) const;
  // Nine numbers, column after column.
  [[nodiscard]] Scalar* block(std::size_t position) { return values_.data() + 9 * position; }
  [[nodiscard]] const Scalar* block(std::size_t position) const { return values_.data() + 9 * position; }
  [[nodiscard]] std::vector<Scalar>& values() { return values_; }
  [[nodiscard]] const std::vector<Scalar>& values() const { return values_; }

  // y = mask * (A x), 3 values a row; gives back x . y. Both vectors must have one value more than the rows need.
  double multiply(const std::vector<Scalar>& x, const std::vector<Scalar>& mask, std::vector<Scalar>& y) const;

  // What one multiplication reads and writes in memory at least: blocks, column numbers, x and y.
  [[nodiscard]] std::uint64_t bytes_of_a_product() const;

 private:
  Lists columns_;
  std::vector<Scalar> values_;
};

using BlockCsr = BlockMatrix<float>;

// Both triangles of a symmetric matrix, from its lower one (3x3 blocks whole, as assemble_blocks makes it).
[[nodiscard]] BlockMatrix<double> both_triangles(const Eigen::SparseMatrix<double>& lower);

}  // namespace glisson::mechanics
