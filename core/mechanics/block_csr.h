#pragma once
// A square sparse matrix of 3x3 blocks in single precision, stored by rows: what conjugate gradients multiply with.
// Both triangles are stored, so that threads share nothing when multiplying. Inside of this room.

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "mechanics/block_assembly.h"

namespace glisson::mechanics {

class BlockCsr {
 public:
  static constexpr int rows_in_chunk = 1024;  // one chunk's sum is one partial sum, whatever the number of threads

  // All zero; the columns of each row sorted.
  explicit BlockCsr(Lists columns_of_row);

  [[nodiscard]] int rows() const { return static_cast<int>(columns_.starts.size()) - 1; }
  [[nodiscard]] int chunks() const { return (rows() + rows_in_chunk - 1) / rows_in_chunk; }
  [[nodiscard]] const Lists& columns() const { return columns_; }

  // Where a block is stored; it must be in the pattern.
  [[nodiscard]] std::size_t position(int row, int column) const;
  // Nine numbers, column after column.
  [[nodiscard]] float* block(std::size_t position) { return values_.data() + 9 * position; }
  [[nodiscard]] const float* block(std::size_t position) const { return values_.data() + 9 * position; }
  [[nodiscard]] std::vector<float>& values() { return values_; }

  // y = mask * (A x), 3 values a row; gives back x . y. x and y must have one value more than the rows need.
  double multiply(const std::vector<float>& x, const std::vector<float>& mask, std::vector<float>& y) const;

  // What one multiplication reads and writes in memory at least: blocks, column numbers, x and y.
  [[nodiscard]] std::uint64_t bytes_of_a_product() const;

 private:
  Lists columns_;
  std::vector<float> values_;
};

}  // namespace glisson::mechanics
