#include "mechanics/dynamics/internal/element_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/dynamics/internal/element_batch.cpp"
// Vectors whose length the compiler does not know cannot be kept in arrays.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// After it, and once a target.
#include "mechanics/elements/internal/matrix_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glisson::mechanics {
namespace HWY_NAMESPACE {

static_assert(ElementBatch::lanes == cells_at_a_time);

HWY_INLINE Matrix load(const std::array<std::array<ElementBatch::Lanes, 3>, 3>& from, std::size_t lane) {
  Matrix matrix;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) matrix.m[r][c] = hn::Load(Tag(), from[r][c].data() + lane);
  }
  return matrix;
}

HWY_INLINE Matrix transposed_times(const Matrix& a, const Matrix& b) {
  Matrix c;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      c.m[i][j] = dot3(a.m[0][i], b.m[0][j], a.m[1][i], b.m[1][j], a.m[2][i], b.m[2][j]);
    }
  }
  return c;
}

HWY_INLINE Matrix times(const Matrix& a, const Matrix& b) {
  Matrix c;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      c.m[i][j] = dot3(a.m[i][0], b.m[0][j], a.m[i][1], b.m[1][j], a.m[i][2], b.m[2][j]);
    }
  }
  return c;
}

HWY_INLINE void add_to_diagonal(Matrix& a, Vector value) {
  for (int d = 0; d < 3; ++d) a.m[d][d] = hn::Add(a.m[d][d], value);
}

// grad w + rest I.
HWY_INLINE Matrix gradient(const ElementBatch& batch, std::size_t lane, const double* w, double rest) {
  const Tag tag;
  const hn::RebindToSigned<Tag> signed_tag;
  const auto origin = hn::Load(signed_tag, batch.first[0].data() + lane);
  Matrix moved;
  for (int i = 0; i < 3; ++i) {
    const auto node = hn::Load(signed_tag, batch.first[i + 1].data() + lane);
    for (int d = 0; d < 3; ++d) {
      moved.m[d][i] = hn::Sub(hn::GatherIndex(tag, w + d, node), hn::GatherIndex(tag, w + d, origin));
    }
  }
  Matrix f;
  for (int d = 0; d < 3; ++d) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto& own = batch.gradients[axis];
      f.m[d][axis] = dot3(moved.m[d][0], hn::Load(tag, own[0].data() + lane), moved.m[d][1],
                          hn::Load(tag, own[1].data() + lane), moved.m[d][2], hn::Load(tag, own[2].data() + lane));
    }
  }
  add_to_diagonal(f, hn::Set(tag, rest));
  return f;
}

HWY_INLINE bool lane_of(const std::uint8_t* bits, std::size_t lane) { return (bits[lane / 8] >> (lane % 8)) & 1; }

// The rotations of F = R S. Newton's iteration X <- (X + X^-T) / 2 (Higham 1986, SIAM J. Sci. Stat. Comput. 7:1160) is
// quadratic from anywhere with det > 0 and needs four or five steps from moderate strain; what is crushed or inside
// out takes the slow, sure way.
HWY_INLINE Matrix rotations_of(const Matrix& f, void (*slow_rotation)(const double f[3][3], double r[3][3])) {
  const Tag tag;
  const Vector half = hn::Set(tag, 0.5);
  Matrix x = f;
  auto running = hn::Eq(half, half);
  auto unsolved = hn::Lt(half, half);
  for (int step = 0; step < 12 && !hn::AllFalse(tag, running); ++step) {
    const Matrix cofactors = cofactor(x);
    const Vector det = determinant(x, cofactors);
    const auto sound = hn::Gt(det, hn::Set(tag, 0.02));
    unsolved = hn::Or(unsolved, hn::AndNot(sound, running));
    running = hn::And(running, sound);
    const Vector share = hn::Div(half, det);
    Vector change = hn::Zero(tag);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        const Vector next = hn::MulAdd(share, cofactors.m[r][c], hn::Mul(half, x.m[r][c]));
        const Vector difference = hn::Sub(next, x.m[r][c]);
        change = hn::MulAdd(difference, difference, change);
        x.m[r][c] = hn::IfThenElse(running, next, x.m[r][c]);
      }
    }
    running = hn::And(running, hn::Ge(change, hn::Set(tag, 1e-9)));  // the error left is about half of that: 5e-10
  }
  unsolved = hn::Or(unsolved, running);
  if (hn::AllFalse(tag, unsolved)) return x;

  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(tag, unsolved, bits);
  HWY_ALIGN double lanes[2][3][3][ElementBatch::lanes];
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      hn::Store(f.m[r][c], tag, lanes[0][r][c]);
      hn::Store(x.m[r][c], tag, lanes[1][r][c]);
    }
  }
  for (std::size_t lane = 0; lane < hn::Lanes(tag); ++lane) {
    if (!lane_of(bits, lane)) continue;
    double one[3][3], rotation[3][3];
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) one[r][c] = lanes[0][r][c][lane];
    }
    slow_rotation(one, rotation);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) lanes[1][r][c][lane] = rotation[r][c];
    }
  }
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) x.m[r][c] = hn::Load(tag, lanes[1][r][c]);
  }
  return x;
}

CellKernels::Turned turn(ElementBatch* begin, const ElementBatch* end, const double* u, bool fixed,
                         void (*slow_rotation)(const double f[3][3], double r[3][3])) {
  const Tag tag;
  const Vector half = hn::Set(tag, 0.5), one = hn::Set(tag, 1.0);
  Vector energy = hn::Zero(tag);
  CellKernels::Turned turned;
  for (ElementBatch* batch = begin; batch != end; ++batch) {
    for (std::size_t lane = 0; lane < ElementBatch::lanes; lane += hn::Lanes(tag)) {
      const Matrix f = gradient(*batch, lane, u, 1.0);
      Matrix rotation;
      if (fixed) {
        rotation = load(batch->rotation, lane);
      } else {
        rotation = rotations_of(f, slow_rotation);
        for (int r = 0; r < 3; ++r) {
          for (int c = 0; c < 3; ++c) hn::Store(rotation.m[r][c], tag, batch->rotation[r][c].data() + lane);
        }
      }
      const Matrix stretch = transposed_times(rotation, f);
      Vector squares = hn::Zero(tag), trace = hn::Zero(tag);
      for (int r = 0; r < 3; ++r) {
        const Vector stretched = hn::Sub(stretch.m[r][r], one);
        trace = hn::Add(trace, stretched);
        squares = hn::MulAdd(stretched, stretched, squares);
        for (int c = r + 1; c < 3; ++c) {  // counted twice: 2 ((a + b) / 2)^2
          const Vector sum = hn::Add(stretch.m[r][c], stretch.m[c][r]);
          squares = hn::MulAdd(hn::Mul(half, sum), sum, squares);
        }
      }
      energy = hn::MulAdd(hn::Load(tag, batch->mu_volume.data() + lane), squares, energy);
      energy =
          hn::MulAdd(hn::Mul(half, hn::Load(tag, batch->lambda_volume.data() + lane)), hn::Mul(trace, trace), energy);
      turned.inverted_cells += static_cast<int>(hn::CountTrue(tag, hn::Le(determinant(f, cofactor(f)), hn::Zero(tag))));
    }
  }
  turned.strain_energy_uJ = hn::GetLane(hn::SumOfLanes(tag, energy));
  return turned;
}

void add_forces(const ElementBatch* begin, const ElementBatch* end, const double* w, double rest, double factor,
                double* forces) {
  const Tag tag;
  const Vector scale = hn::Set(tag, factor);
  for (const ElementBatch* batch = begin; batch != end; ++batch) {
    HWY_ALIGN double of_node[4][3][ElementBatch::lanes];
    for (std::size_t lane = 0; lane < ElementBatch::lanes; lane += hn::Lanes(tag)) {
      const Matrix f = gradient(*batch, lane, w, rest);
      const Matrix rotation = load(batch->rotation, lane);
      Matrix strain = transposed_times(rotation, f);
      add_to_diagonal(strain, hn::Set(tag, -rest));
      const Vector mu = hn::Mul(scale, hn::Load(tag, batch->mu_volume.data() + lane));
      const Vector lambda = hn::Mul(scale, hn::Load(tag, batch->lambda_volume.data() + lane));
      Matrix stress;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) stress.m[r][c] = hn::Mul(mu, hn::Add(strain.m[r][c], strain.m[c][r]));
      }
      add_to_diagonal(stress, hn::Mul(lambda, hn::Add(strain.m[0][0], hn::Add(strain.m[1][1], strain.m[2][2]))));
      const Matrix of_corner = times(times(rotation, stress), load(batch->gradients, lane));
      for (int d = 0; d < 3; ++d) {
        const Vector sum = hn::Add(of_corner.m[d][0], hn::Add(of_corner.m[d][1], of_corner.m[d][2]));
        hn::Store(hn::Neg(sum), tag, of_node[0][d] + lane);
        for (int i = 0; i < 3; ++i) hn::Store(of_corner.m[d][i], tag, of_node[i + 1][d] + lane);
      }
    }
    for (int cell = 0; cell < batch->count; ++cell) {
      for (int i = 0; i < 4; ++i) {
        double* force = forces + batch->first[i][cell];
        for (int d = 0; d < 3; ++d) force[d] += of_node[i][d][cell];
      }
    }
  }
}

CellKernels kernels() { return {turn, add_forces}; }

}  // namespace HWY_NAMESPACE
}  // namespace glisson::mechanics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glisson::mechanics {

HWY_EXPORT(kernels);

CellKernels cell_kernels() { return HWY_DYNAMIC_DISPATCH(kernels)(); }

}  // namespace glisson::mechanics
#endif
