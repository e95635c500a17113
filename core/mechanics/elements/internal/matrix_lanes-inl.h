// 3x3 matrices in vectors, one cell a lane: what the batches of cells share. Included once a target, after
// Highway, whose own headers are guarded in the same way.

#if defined(GLISSON_MATRIX_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSON_MATRIX_LANES_INL_H_
#undef GLISSON_MATRIX_LANES_INL_H_
#else
#define GLISSON_MATRIX_LANES_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glisson::mechanics {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
inline constexpr int cells_at_a_time = 8;
using Tag = hn::CappedTag<double, cells_at_a_time>;
using Vector = hn::Vec<Tag>;
struct Matrix {
  Vector m[3][3];
};

HWY_INLINE Vector dot3(Vector a0, Vector b0, Vector a1, Vector b1, Vector a2, Vector b2) {
  return hn::MulAdd(a0, b0, hn::MulAdd(a1, b1, hn::Mul(a2, b2)));
}

// The determinant's derivative by X.
HWY_INLINE Matrix cofactor(const Matrix& x) {
  Matrix c;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      c.m[i][j] = hn::MulSub(x.m[i1][j1], x.m[i2][j2], hn::Mul(x.m[i1][j2], x.m[i2][j1]));
    }
  }
  return c;
}

HWY_INLINE Vector determinant(const Matrix& x, const Matrix& cofactors) {
  return dot3(x.m[0][0], cofactors.m[0][0], x.m[1][0], cofactors.m[1][0], x.m[2][0], cofactors.m[2][0]);
}

}  // namespace HWY_NAMESPACE
}  // namespace glisson::mechanics
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
