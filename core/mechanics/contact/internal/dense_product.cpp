#include "mechanics/contact/internal/dense_product.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/contact/internal/dense_product.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glisson::mechanics {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 16>;

// y += of `count` columns, 1 to 4.
template <std::size_t count>
HWY_INLINE void add_columns(const float* first, std::size_t rows, const float* x, float* y) {
  const Tag tag;
  for (std::size_t row = 0; row < rows; row += hn::Lanes(tag)) {
    auto sum = hn::LoadU(tag, y + row);
    for (std::size_t c = 0; c < count; ++c) {
      sum = hn::MulAdd(hn::Set(tag, x[c]), hn::LoadU(tag, first + c * rows + row), sum);
    }
    hn::StoreU(sum, tag, y + row);
  }
}

void add_product(const float* matrix, std::size_t rows, std::size_t columns, const float* x, float* y) {
  std::size_t c = 0;
  for (; c + 4 <= columns; c += 4) add_columns<4>(matrix + c * rows, rows, x + c, y);
  for (; c < columns; ++c) add_columns<1>(matrix + c * rows, rows, x + c, y);
}

}  // namespace HWY_NAMESPACE
}  // namespace glisson::mechanics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "base/result.h"

namespace glisson::mechanics {

HWY_EXPORT(add_product);

namespace {

constexpr Eigen::Index lanes = 16;

}  // namespace

Eigen::MatrixXf padded_rows(const Eigen::MatrixXf& matrix) {
  Eigen::MatrixXf padded = Eigen::MatrixXf::Zero((matrix.rows() + lanes - 1) / lanes * lanes, matrix.cols());
  padded.topRows(matrix.rows()) = matrix;
  return padded;
}

void multiply(const Eigen::MatrixXf& padded, const Eigen::VectorXf& x, Eigen::VectorXf& y) {
  GLISSON_ASSERT(padded.rows() % lanes == 0 && x.size() == padded.cols());
  Eigen::VectorXf product = Eigen::VectorXf::Zero(padded.rows());
  HWY_DYNAMIC_DISPATCH(add_product)
  (padded.data(), static_cast<std::size_t>(padded.rows()), static_cast<std::size_t>(padded.cols()), x.data(),
   product.data());
  y = product.head(padded.cols());
}

}  // namespace glisson::mechanics
#endif
