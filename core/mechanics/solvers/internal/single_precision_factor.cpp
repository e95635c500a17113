#include "mechanics/solvers/internal/single_precision_factor.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include "base/result.h"

// The BLAS that CHOLMOD itself stands on, in single precision.
extern "C" {
void strsm_(const char* side, const char* triangle, const char* transposed, const char* unit, const int* rows,
            const int* columns, const float* scale, const float* a, const int* leading_a, float* b,
            const int* leading_b);
void sgemm_(const char* transposed_a, const char* transposed_b, const int* rows, const int* columns, const int* inner,
            const float* scale, const float* a, const int* leading_a, const float* b, const int* leading_b,
            const float* scale_c, float* c, const int* leading_c);
void strsv_(const char* triangle, const char* transposed, const char* unit, const int* size, const float* a,
            const int* leading_a, float* x, const int* step_x);
void sgemv_(const char* transposed, const int* rows, const int* columns, const float* scale, const float* a,
            const int* leading_a, const float* x, const int* step_x, const float* scale_y, float* y, const int* step_y);
}

namespace glisson::mechanics {
namespace {

// Of so few sides one after the other: numbers are read as they lie, where BLAS copies them first for several.
constexpr int few_sides = 6;
constexpr int next = 1;
constexpr float one = 1;

struct Panel {
  const float* values;
  int rows, columns, leading;
};

// y = scale A x + kept y, of A or its transpose; a column a side, whose first numbers lie `step` apart.
void multiply(const char* transposed, const Panel& a, int sides, float scale, const float* x, int step_x, float kept,
              float* y, int step_y) {
  if (sides > few_sides) {
    const bool turned = *transposed == 'T';
    const int rows = turned ? a.columns : a.rows, inner = turned ? a.rows : a.columns;
    sgemm_(transposed, "N", &rows, &sides, &inner, &scale, a.values, &a.leading, x, &step_x, &kept, y, &step_y);
    return;
  }
  for (int side = 0; side < sides; ++side) {
    sgemv_(transposed, &a.rows, &a.columns, &scale, a.values, &a.leading, x + std::ptrdiff_t{side} * step_x, &next,
           &kept, y + std::ptrdiff_t{side} * step_y, &next);
  }
}

// x = A^-1 x of a lower triangle, or of its transpose.
void divide(const char* transposed, const Panel& a, int sides, float* x, int step_x) {
  if (sides > few_sides) {
    strsm_("L", "L", transposed, "N", &a.columns, &sides, &one, a.values, &a.leading, x, &step_x);
    return;
  }
  for (int side = 0; side < sides; ++side) {
    strsv_("L", transposed, "N", &a.columns, a.values, &a.leading, x + std::ptrdiff_t{side} * step_x, &next);
  }
}

// Columns that share their rows. Of a square of them half is zeros.
constexpr int widest = 64;

}  // namespace

SinglePrecisionFactor::SinglePrecisionFactor(cholmod_factor& factor) {
  GLISSON_ASSERT(factor.is_super != 0 && factor.is_ll != 0 && factor.xtype == CHOLMOD_REAL);
  const auto* order = static_cast<const int*>(factor.Perm);
  const auto* first_column = static_cast<const int*>(factor.super);
  const auto* first_row = static_cast<const int*>(factor.pi);
  const auto* first_value = static_cast<const int*>(factor.px);
  const auto* rows = static_cast<const int*>(factor.s);
  order_.assign(order, order + factor.n);
  rows_.assign(rows, rows + factor.ssize);
  auto* bytes = static_cast<std::byte*>(std::exchange(factor.x, nullptr));
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const int all_columns = first_column[s + 1] - first_column[s], all_rows = first_row[s + 1] - first_row[s];
    for (int begin = 0; begin < all_columns; begin += widest) {
      const Supernode node{first_column[s] + begin, std::min(widest, all_columns - begin),
                           static_cast<std::size_t>(first_row[s] + begin), all_rows - begin, count_};
      supernodes_.push_back(node);
      for (int column = begin; column < begin + node.columns; ++column) {
        const std::size_t top =
            static_cast<std::size_t>(first_value[s]) + static_cast<std::size_t>(column) * all_rows + begin;
        // What is written lies before what is still to be read: as many numbers, of half the size.
        for (std::size_t i = top; i < top + static_cast<std::size_t>(node.rows); ++i, ++count_) {
          double value = 0;
          std::memcpy(&value, bytes + i * sizeof(double), sizeof(double));
          const auto rounded = static_cast<float>(value);
          std::memcpy(bytes + count_ * sizeof(float), &rounded, sizeof(float));
        }
      }
    }
  }
  void* smaller = std::realloc(bytes, std::max<std::size_t>(1, count_) * sizeof(float));
  values_.reset(static_cast<float*>(smaller != nullptr ? smaller : bytes));
}

Eigen::MatrixXd SinglePrecisionFactor::solve(const Eigen::MatrixXd& right_hand_sides) const {
  GLISSON_ASSERT(static_cast<std::size_t>(right_hand_sides.rows()) == order_.size());
  // Scaled to one, so that small residuals do not leave the range of single precision.
  Eigen::RowVectorXd scale = right_hand_sides.cwiseAbs().colwise().maxCoeff();
  for (double& largest : scale) largest = largest > 0 ? largest : 1.0;
  Eigen::MatrixXf x(right_hand_sides.rows(), right_hand_sides.cols());
  for (Eigen::Index column = 0; column < x.cols(); ++column) {
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
      x(i, column) = static_cast<float>(right_hand_sides(order_[i], column) / scale[column]);
    }
  }
  solve_forward(x);
  solve_backward(x);
  Eigen::MatrixXd solution(x.rows(), x.cols());
  for (Eigen::Index column = 0; column < x.cols(); ++column) {
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
      solution(order_[i], column) = scale[column] * static_cast<double>(x(i, column));
    }
  }
  return solution;
}

// L y = b: each supernode's own unknowns, then what they add to the rows below it. A load on few unknowns reaches few
// supernodes: the others stay zero.
void SinglePrecisionFactor::solve_forward(Eigen::MatrixXf& x) const {
  const int n = static_cast<int>(x.rows()), sides = static_cast<int>(x.cols());
  Eigen::MatrixXf below;
  for (const Supernode& node : supernodes_) {
    const float* values = values_.get() + node.first_value;
    float* own = x.data() + node.first_column;
    const int count = node.rows - node.columns;
    if (x.middleRows(node.first_column, node.columns).isZero(0)) continue;
    divide("N", {values, node.columns, node.columns, node.rows}, sides, own, n);
    if (count == 0) continue;
    below.resize(count, sides);
    multiply("N", {values + node.columns, count, node.columns, node.rows}, sides, 1, own, n, 0, below.data(), count);
    const int* row = rows_.data() + node.first_row + node.columns;
    for (int side = 0; side < sides; ++side) {
      for (int i = 0; i < count; ++i) x(row[i], side) -= below(i, side);
    }
  }
}

// L^T x = y, from the last supernode to the first.
void SinglePrecisionFactor::solve_backward(Eigen::MatrixXf& x) const {
  const int n = static_cast<int>(x.rows()), sides = static_cast<int>(x.cols());
  Eigen::MatrixXf below;
  for (auto node = supernodes_.rbegin(); node != supernodes_.rend(); ++node) {
    const float* values = values_.get() + node->first_value;
    float* own = x.data() + node->first_column;
    const int count = node->rows - node->columns;
    if (count > 0) {
      below.resize(count, sides);
      const int* row = rows_.data() + node->first_row + node->columns;
      for (int side = 0; side < sides; ++side) {
        for (int i = 0; i < count; ++i) below(i, side) = x(row[i], side);
      }
      multiply("T", {values + node->columns, count, node->columns, node->rows}, sides, -1, below.data(), count, 1, own,
               n);
    }
    divide("T", {values, node->columns, node->columns, node->rows}, sides, own, n);
  }
}

}  // namespace glisson::mechanics
