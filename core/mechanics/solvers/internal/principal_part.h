#pragma once
// Some rows of a symmetric matrix, and the same columns.

#include <Eigen/SparseCore>
#include <vector>

namespace glisson::mechanics {

// Of the lower triangle, in the order of `kept`, which ascends; again a lower triangle.
[[nodiscard]] inline Eigen::SparseMatrix<double> principal_part(const Eigen::SparseMatrix<double>& lower,
                                                                const std::vector<int>& kept) {
  std::vector<int> number(static_cast<std::size_t>(lower.rows()), -1);
  for (std::size_t k = 0; k < kept.size(); ++k) number[kept[k]] = static_cast<int>(k);
  const auto size = static_cast<Eigen::Index>(kept.size());
  Eigen::SparseMatrix<double> part(size, size);
  part.reserve(lower.nonZeros());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    part.startVec(static_cast<Eigen::Index>(k));
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, kept[k]); entry; ++entry) {
      const int row = number[entry.row()];
      if (row >= 0) part.insertBack(row, static_cast<Eigen::Index>(k)) = entry.value();
    }
  }
  part.finalize();
  return part;
}

}  // namespace glisson::mechanics
