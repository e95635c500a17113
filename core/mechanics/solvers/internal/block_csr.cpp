#include "mechanics/solvers/internal/block_csr.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"

namespace glisson::mechanics {

template <typename Scalar>
BlockMatrix<Scalar>::BlockMatrix(Lists columns_of_row)
    : columns_(std::move(columns_of_row)), values_(9 * columns_.items.size() + 1, Scalar{0}) {}  // read by fours

template <typename Scalar>
std::size_t BlockMatrix<Scalar>::position(int row, int column) const {
  const int* found = std::lower_bound(columns_.begin(row), columns_.end(row), column);
  GLISSON_ASSERT(found != columns_.end(row) && *found == column);
  return static_cast<std::size_t>(found - columns_.items.data());
}

template <typename Scalar>
double BlockMatrix<Scalar>::multiply(const std::vector<Scalar>& x, const std::vector<Scalar>& mask,
                                     std::vector<Scalar>& y) const {
  using Vector4 = Eigen::Matrix<Scalar, 4, 1>;
  GLISSON_ASSERT(x.size() > 3 * static_cast<std::size_t>(rows()) && y.size() == x.size());
  std::vector<double> partial(static_cast<std::size_t>(chunks()), 0.0);
  parallel_for(partial.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      const int first = static_cast<int>(chunk) * rows_in_chunk, last = std::min(first + rows_in_chunk, rows());
      double dot = 0;
      for (int row = first; row < last; ++row) {
        // Four lanes, of which the last is never used: a block's column and the first number of the next.
        Vector4 sum = Vector4::Zero();
        const Scalar* values = block(columns_.starts[row]);
        for (const int* column = columns_.begin(row); column != columns_.end(row); ++column, values += 9) {
          const Scalar* at = x.data() + 3 * static_cast<std::size_t>(*column);
          sum += Eigen::Map<const Vector4>(values) * at[0] + Eigen::Map<const Vector4>(values + 3) * at[1] +
                 Eigen::Map<const Vector4>(values + 6) * at[2];
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

template <typename Scalar>
std::uint64_t BlockMatrix<Scalar>::bytes_of_a_product() const {
  return columns_.items.size() * (9 * sizeof(Scalar) + sizeof(int)) +
         static_cast<std::uint64_t>(rows()) * (sizeof(std::size_t) + 6 * sizeof(Scalar));
}

template class BlockMatrix<float>;
template class BlockMatrix<double>;

BlockMatrix<double> both_triangles(const Eigen::SparseMatrix<double>& lower) {
  const auto rows = static_cast<int>(lower.cols() / 3);
  const int* starts = lower.outerIndexPtr();
  const int* items = lower.innerIndexPtr();
  Lists columns;
  columns.starts.assign(static_cast<std::size_t>(rows) + 1, 0);
  const auto visit = [&](const auto& take) {  // each block of the lower triangle, by columns
    for (int j = 0; j < rows; ++j) {
      for (int entry = starts[3 * j]; entry < starts[3 * j + 1]; entry += 3) take(items[entry] / 3, j);
    }
  };
  visit([&](int i, int j) {
    ++columns.starts[static_cast<std::size_t>(i) + 1];
    if (i != j) ++columns.starts[static_cast<std::size_t>(j) + 1];
  });
  std::partial_sum(columns.starts.begin(), columns.starts.end(), columns.starts.begin());
  columns.items.resize(columns.starts.back());
  // Row i takes the columns before it in their order, then, once its own column comes, those after it.
  std::vector<std::size_t> next(columns.starts.begin(), columns.starts.end() - 1);
  visit([&](int i, int j) {
    columns.items[next[static_cast<std::size_t>(i)]++] = j;
    if (i != j) columns.items[next[static_cast<std::size_t>(j)]++] = i;
  });
  BlockMatrix<double> matrix(std::move(columns));
  parallel_for(static_cast<std::size_t>(rows), 1024, [&](std::size_t begin, std::size_t end) {
    for (auto j = static_cast<int>(begin); j < static_cast<int>(end); ++j) {
      const int first = starts[3 * j];
      for (int entry = 0; first + entry < starts[3 * j + 1]; entry += 3) {
        const int i = items[first + entry] / 3;
        double* below = matrix.block(matrix.position(i, j));
        double* above = matrix.block(matrix.position(j, i));
        for (int c = 0; c < 3; ++c) {
          for (int r = i == j ? c : 0; r < 3; ++r) {
            // Column c of three begins c entries later, and its list of rows is c entries shorter.
            const double value = lower.valuePtr()[starts[3 * j + c] + entry - c + r];
            below[3 * c + r] = value;
            above[3 * r + c] = value;
          }
        }
      }
    }
  });
  return matrix;
}

}  // namespace glisson::mechanics
