#include "mechanics/block_csr.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"

namespace glisson::mechanics {

BlockCsr::BlockCsr(Lists columns_of_row)
    : columns_(std::move(columns_of_row)), values_(9 * columns_.items.size() + 1, 0.0F) {}  // blocks are read by fours

std::size_t BlockCsr::position(int row, int column) const {
  const int* found = std::lower_bound(columns_.begin(row), columns_.end(row), column);
  GLISSON_ASSERT(found != columns_.end(row) && *found == column);
  return static_cast<std::size_t>(found - columns_.items.data());
}

double BlockCsr::multiply(const std::vector<float>& x, const std::vector<float>& mask, std::vector<float>& y) const {
  GLISSON_ASSERT(x.size() > 3 * static_cast<std::size_t>(rows()) && y.size() == x.size());
  std::vector<double> partial(static_cast<std::size_t>(chunks()), 0.0);
  parallel_for(partial.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      const int first = static_cast<int>(chunk) * rows_in_chunk, last = std::min(first + rows_in_chunk, rows());
      double dot = 0;
      for (int row = first; row < last; ++row) {
        // Four lanes, of which the last is never used: a block's column and the first number of the next.
        Eigen::Vector4f sum = Eigen::Vector4f::Zero();
        const float* values = block(columns_.starts[row]);
        for (const int* column = columns_.begin(row); column != columns_.end(row); ++column, values += 9) {
          const float* at = x.data() + 3 * static_cast<std::size_t>(*column);
          sum += Eigen::Map<const Eigen::Vector4f>(values) * at[0] +
                 Eigen::Map<const Eigen::Vector4f>(values + 3) * at[1] +
                 Eigen::Map<const Eigen::Vector4f>(values + 6) * at[2];
        }
        for (int d = 0; d < 3; ++d) {
          const std::size_t i = 3 * static_cast<std::size_t>(row) + d;
          y[i] = mask[i] * sum[d];
          dot += static_cast<double>(x[i]) * y[i];
        }
      }
      partial[chunk] = dot;
    }
  });
  return std::accumulate(partial.begin(), partial.end(), 0.0);
}

std::uint64_t BlockCsr::bytes_of_a_product() const {
  return columns_.items.size() * (9 * sizeof(float) + sizeof(int)) +
         static_cast<std::uint64_t>(rows()) * (sizeof(std::size_t) + 6 * sizeof(float));
}

}  // namespace glisson::mechanics
