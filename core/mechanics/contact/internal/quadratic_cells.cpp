#include "mechanics/contact/internal/quadratic_cells.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/contact/internal/quadratic_cells.cpp"
// Vectors whose length the compiler does not know cannot be kept in arrays.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// After it, and once a target.
#include <hwy/contrib/math/math-inl.h>

#include "mechanics/elements/internal/matrix_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glisson::mechanics {
namespace HWY_NAMESPACE {

static_assert(QuadraticBatch::lanes == cells_at_a_time);

struct Point {
  Vector v[3];
};

constexpr double a = 0.58541019662496845446, b = 0.13819660112501051518;  // quadrature.h

HWY_INLINE Vector squared_norm(const Matrix& x) {
  Vector sum = hn::Zero(Tag());
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) sum = hn::MulAdd(x.m[i][j], x.m[i][j], sum);
  }
  return sum;
}

// C = F^T F, its upper triangle.
HWY_INLINE Matrix right_cauchy_green(const Matrix& f) {
  Matrix c;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      c.m[i][j] = dot3(f.m[0][i], f.m[0][j], f.m[1][i], f.m[1][j], f.m[2][i], f.m[2][j]);
      c.m[j][i] = c.m[i][j];
    }
  }
  return c;
}

// stable_neo_hookean.h: mu (1 - 1 / (I + 1)) F + lambda (J - alpha) cof F.
HWY_INLINE Matrix neo_hookean(const Matrix& f, const Matrix& cof, Vector j, Vector norm2, Vector mu, Vector lambda) {
  const Tag tag;
  const Vector one = hn::Set(tag, 1.0);
  const Vector alpha = hn::MulAdd(hn::Set(tag, 0.75), hn::Div(mu, lambda), one);
  const Vector on_f = hn::Mul(mu, hn::Sub(one, hn::Div(one, hn::Add(norm2, one))));
  const Vector on_cof = hn::Mul(lambda, hn::Sub(j, alpha));
  Matrix p;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) p.m[r][c] = hn::MulAdd(on_f, f.m[r][c], hn::Mul(on_cof, cof.m[r][c]));
  }
  return p;
}

// isochoric.h, Veronda and Westmann's law.
HWY_INLINE Matrix veronda_westmann(const Matrix& f, const Matrix& cof, const Matrix& c, Vector j_given, Vector norm2,
                                   Vector mu, Vector bulk, double stiffening) {
  const Tag tag;
  const Vector one = hn::Set(tag, 1.0), half = hn::Set(tag, 0.5);
  const Vector j = hn::Max(j_given, hn::Set(tag, 1e-3));  // what is inside out is counted, and not shown
  const Vector shrink_1 = hn::Exp(tag, hn::Mul(hn::Set(tag, -2.0 / 3.0), hn::Log(tag, j)));
  const Vector shrink_2 = hn::Mul(shrink_1, shrink_1);
  const Vector second = hn::Mul(half, hn::Sub(hn::Mul(norm2, norm2), squared_norm(c)));
  const Vector i1 = hn::Mul(shrink_1, norm2);
  // A step too far is taken back by whoever asks; its force must only be a number.
  const Vector exponent =
      hn::Min(hn::Mul(hn::Set(tag, stiffening), hn::Sub(i1, hn::Set(tag, 3.0))), hn::Set(tag, 60.0));
  const Vector w1 = hn::Mul(mu, hn::Exp(tag, exponent)), w2 = hn::Mul(hn::Set(tag, -0.5), mu);
  const Vector by_1 = hn::Mul(w1, shrink_1), by_2 = hn::Mul(w2, shrink_2), by_j = hn::Div(one, j);
  Vector on_cof = hn::Mul(bulk, hn::Sub(j, one));
  on_cof = hn::Sub(on_cof, hn::Mul(hn::Mul(hn::Set(tag, 2.0 / 3.0), by_1), hn::Mul(norm2, by_j)));
  on_cof = hn::Sub(on_cof, hn::Mul(hn::Mul(hn::Set(tag, 4.0 / 3.0), by_2), hn::Mul(second, by_j)));
  const Vector on_f = hn::MulAdd(hn::Add(by_2, by_2), norm2, hn::Add(by_1, by_1)),
               on_fc = hn::Sub(hn::Zero(tag), hn::Add(by_2, by_2));
  Matrix p;
  for (int r = 0; r < 3; ++r) {
    for (int k = 0; k < 3; ++k) {
      const Vector fc = dot3(f.m[r][0], c.m[0][k], f.m[r][1], c.m[1][k], f.m[r][2], c.m[2][k]);
      p.m[r][k] = hn::MulAdd(on_f, f.m[r][k], hn::MulAdd(on_fc, fc, hn::Mul(on_cof, cof.m[r][k])));
    }
  }
  return p;
}

struct Seen {
  int inverted = 0;
  double largest_squared = 0;
};

template <bool stiffens>
HWY_INLINE Seen add_forces(const QuadraticBatch* begin, const QuadraticBatch* end, const double* u, double stiffening,
                           double* forces, std::int64_t last_node, double* squared) {
  const Tag tag;
  const hn::CappedTag<double, 4> of_one_node;
  const hn::RebindToSigned<Tag> signed_tag;
  const Vector one = hn::Set(tag, 1.0);
  const Vector corner = hn::Set(tag, 4 * b - 1), edge = hn::Set(tag, 4 * b), own = hn::Set(tag, 4 * (a - b));
  Seen seen;
  Vector worst = hn::Zero(tag);
  for (const QuadraticBatch* batch = begin; batch != end; ++batch) {
    HWY_ALIGN double of_node[10][QuadraticBatch::lanes][4];  // the fourth is 0
    for (std::size_t lane = 0; lane < QuadraticBatch::lanes; lane += hn::Lanes(tag)) {
      Point moved[10];
      for (int i = 0; i < 10; ++i) {
        const auto at = hn::Load(signed_tag, batch->first[i].data() + lane);
        for (int d = 0; d < 3; ++d) moved[i].v[d] = hn::GatherIndex(tag, u + d, at);
      }
      Point gradient[4];
      for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 3; ++i) gradient[i + 1].v[axis] = hn::Load(tag, batch->gradients[axis][i].data() + lane);
        gradient[0].v[axis] = hn::Neg(hn::Add(hn::Add(gradient[1].v[axis], gradient[2].v[axis]), gradient[3].v[axis]));
      }
      // What all four points have in common.
      Matrix common;
      for (int d = 0; d < 3; ++d) {
        for (int axis = 0; axis < 3; ++axis) common.m[d][axis] = d == axis ? one : hn::Zero(tag);
        for (int k = 0; k < 4; ++k) {
          Vector edges = hn::Zero(tag);
          for (int q = 0; q < 4; ++q) {
            if (q != k) edges = hn::Add(edges, moved[node_between[k][q]].v[d]);
          }
          const Vector by_k = hn::MulAdd(corner, moved[k].v[d], hn::Mul(edge, edges));
          for (int axis = 0; axis < 3; ++axis) {
            common.m[d][axis] = hn::MulAdd(by_k, gradient[k].v[axis], common.m[d][axis]);
          }
        }
      }
      const Vector volume = hn::Load(tag, batch->volume.data() + lane);
      const Vector first = hn::Load(tag, batch->constants[0].data() + lane);
      const Vector second = hn::Load(tag, batch->constants[1].data() + lane);
      const auto counts = hn::Gt(volume, hn::Zero(tag));
      Point sum[10];
      for (auto& point : sum) {
        for (auto& v : point.v) v = hn::Zero(tag);
      }
      Point total[4];
      for (auto& point : total) {
        for (auto& v : point.v) v = hn::Zero(tag);
      }
      Vector largest = hn::Zero(tag);
      for (int q = 0; q < 4; ++q) {
        Matrix f = common;
        for (int k = 0; k < 4; ++k) {
          for (int d = 0; d < 3; ++d) {
            const Vector w = hn::Mul(own, moved[node_between[k][q]].v[d]);
            for (int axis = 0; axis < 3; ++axis) f.m[d][axis] = hn::MulAdd(w, gradient[k].v[axis], f.m[d][axis]);
          }
        }
        const Matrix cof = cofactor(f);
        const Vector j = determinant(f, cof);
        const Vector norm2 = squared_norm(f);
        const Matrix c = right_cauchy_green(f);
        Matrix strained = c;
        for (int d = 0; d < 3; ++d) strained.m[d][d] = hn::Sub(c.m[d][d], one);
        largest = hn::Max(largest, squared_norm(strained));
        seen.inverted += static_cast<int>(hn::CountTrue(tag, hn::And(counts, hn::Le(j, hn::Zero(tag)))));
        const Matrix p = stiffens ? veronda_westmann(f, cof, c, j, norm2, first, second, stiffening)
                                  : neo_hookean(f, cof, j, norm2, first, second);
        for (int k = 0; k < 4; ++k) {
          for (int d = 0; d < 3; ++d) {
            const Vector t = hn::Mul(
                volume, dot3(p.m[d][0], gradient[k].v[0], p.m[d][1], gradient[k].v[1], p.m[d][2], gradient[k].v[2]));
            total[k].v[d] = hn::Add(total[k].v[d], t);
            sum[node_between[k][q]].v[d] = hn::MulAdd(own, t, sum[node_between[k][q]].v[d]);
          }
        }
      }
      for (int k = 0; k < 4; ++k) {
        for (int d = 0; d < 3; ++d) {
          sum[k].v[d] = hn::MulAdd(corner, total[k].v[d], sum[k].v[d]);
          for (int q = k + 1; q < 4; ++q) {
            Vector& at = sum[node_between[k][q]].v[d];
            at = hn::MulAdd(edge, hn::Add(total[k].v[d], total[q].v[d]), at);
          }
        }
      }
      for (int i = 0; i < 10; ++i) {
        hn::StoreInterleaved4(sum[i].v[0], sum[i].v[1], sum[i].v[2], hn::Zero(tag), tag, of_node[i][lane]);
      }
      largest = hn::IfThenElseZero(counts, largest);
      worst = hn::Max(worst, largest);
      hn::StoreU(largest, tag, squared + lane);
    }
    squared += QuadraticBatch::lanes;
    for (int cell = 0; cell < batch->count; ++cell) {
      for (int i = 0; i < 10; ++i) {
        const std::int64_t first = batch->first[i][cell];
        double* force = forces + first;
        const double* taken = of_node[i][cell];
        if (first == last_node) {  // nothing follows that a whole vector could be taken off
          for (int d = 0; d < 3; ++d) force[d] -= taken[d];
          continue;
        }
        for (std::size_t d = 0; d < 4; d += hn::Lanes(of_one_node)) {
          hn::StoreU(hn::Sub(hn::LoadU(of_one_node, force + d), hn::Load(of_one_node, taken + d)), of_one_node,
                     force + d);
        }
      }
    }
  }
  seen.largest_squared = hn::GetLane(hn::MaxOfLanes(tag, worst));
  return seen;
}

void forces_of(bool stiffens, const QuadraticBatch* begin, const QuadraticBatch* end, const double* u,
               double stiffening, double* forces, std::int64_t last_node, double* squared, int* inverted,
               double* largest_squared) {
  const Seen seen = stiffens ? add_forces<true>(begin, end, u, stiffening, forces, last_node, squared)
                             : add_forces<false>(begin, end, u, stiffening, forces, last_node, squared);
  *inverted = seen.inverted;
  *largest_squared = seen.largest_squared;
}

}  // namespace HWY_NAMESPACE
}  // namespace glisson::mechanics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <cmath>
#include <Eigen/SVD>
#include <set>

#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"
#include "mechanics/elements/strain.h"
#include "mechanics/materials/isochoric.h"
#include "mechanics/materials/linear_elasticity.h"

namespace glisson::mechanics {

HWY_EXPORT(forces_of);

QuadraticCells::QuadraticCells(const Body& body, const ChosenLaw& law)
    : law_(law.law), stiffening_(law.strain_stiffening) {
  GLISSON_ASSERT(body.options.order == ElementOrder::quadratic &&
                 (law_ == MaterialLaw::neo_hookean || law_ == MaterialLaw::veronda_westmann));
  // Along the body's longest side, so that what follows each other shares nodes.
  std::vector<int> order(body.mesh.cells.size());
  std::vector<Eigen::Vector3d> centre_mm;
  for (std::size_t c = 0; c < order.size(); ++c) {
    order[c] = static_cast<int>(c);
    centre_mm.push_back(geometry::cell_centroid_mm(body.mesh, c));
  }
  int axis = 0;
  const geometry::Box box = geometry::bounding_box(body.layout.positions_mm);
  (box.max_mm - box.min_mm).maxCoeff(&axis);
  std::sort(order.begin(), order.end(), [&](int left, int right) {
    return std::pair(centre_mm[static_cast<std::size_t>(left)][axis], left) <
           std::pair(centre_mm[static_cast<std::size_t>(right)][axis], right);
  });
  for (std::size_t from = 0; from < order.size(); from += QuadraticBatch::lanes) {
    QuadraticBatch batch{};
    batch.count = static_cast<int>(std::min<std::size_t>(QuadraticBatch::lanes, order.size() - from));
    for (int lane = 0; lane < QuadraticBatch::lanes; ++lane) {
      const auto cell =
          static_cast<std::size_t>(order[from + static_cast<std::size_t>(std::min(lane, batch.count - 1))]);
      const CellGeometry shape = cell_geometry(body.mesh, cell);
      const Lame& lame = body.materials[cell];
      batch.cell[lane] = static_cast<int>(cell);
      for (int i = 0; i < 10; ++i) batch.first[i][lane] = 3 * std::int64_t{body.layout.cells[cell][i]};
      for (int d = 0; d < 3; ++d) {
        for (int i = 0; i < 3; ++i) batch.gradients[d][i][lane] = shape.barycentric_gradients(i + 1, d);
      }
      batch.volume[lane] = lane < batch.count ? 0.25 * shape.volume_mm3 : 0.0;
      const bool stable = law_ == MaterialLaw::neo_hookean;
      batch.constants[0][lane] = stable ? 4.0 / 3.0 * lame.mu_kPa : lame.mu_kPa;
      batch.constants[1][lane] = stable ? lame.lambda_kPa + 5.0 / 6.0 * lame.mu_kPa : bulk_from_lame(lame);
    }
    batches_.push_back(batch);
  }
}

QuadraticCells QuadraticCells::without(const std::vector<int>& cells) const {
  const std::set<int> left_out(cells.begin(), cells.end());
  QuadraticCells others = *this;
  for (QuadraticBatch& batch : others.batches_) {
    for (int lane = 0; lane < QuadraticBatch::lanes; ++lane) {
      if (left_out.count(batch.cell[lane]) > 0) batch.volume[lane] = 0;
    }
  }
  return others;
}

QuadraticCells::Strained QuadraticCells::add_force(const Eigen::VectorXd& u_mm, Eigen::VectorXd& force_mN,
                                                   std::vector<double>& squared) const {
  squared.resize(batches_.size() * QuadraticBatch::lanes);
  Strained strained;
  HWY_DYNAMIC_DISPATCH(forces_of)
  (law_ == MaterialLaw::veronda_westmann, batches_.data(), batches_.data() + batches_.size(), u_mm.data(), stiffening_,
   force_mN.data(), force_mN.size() - 3, squared.data(), &strained.inverted_points, &strained.largest_squared);
  return strained;
}

// An eigenvalue l^2 of C is at most |C - I| from 1; only where that leaves room for more than was found is it computed.
double QuadraticCells::largest_strain(const Body& body, const Eigen::VectorXd& u_mm,
                                      const std::vector<double>& squared) const {
  const auto bound = [](double squares) {
    const double s = std::sqrt(squares);
    return std::max(std::sqrt(1 + s) - 1, s < 1 ? 1 - std::sqrt(1 - s) : 1.0);
  };
  double largest = 0;
  const auto look_at = [&](std::size_t k) {
    const int cell = batches_[k / QuadraticBatch::lanes].cell[k % QuadraticBatch::lanes];
    for (const TetPoint& point : tet_points_degree_2()) {
      const Eigen::Matrix3d f =
          Eigen::Matrix3d::Identity() +
          displacement_gradient(body.mesh, body.layout, static_cast<std::size_t>(cell), point.barycentric, u_mm);
      const Eigen::Vector3d stretches = Eigen::JacobiSVD<Eigen::Matrix3d>(f).singularValues();
      largest = std::max(largest, (stretches.array() - 1).abs().maxCoeff());
    }
  };
  if (squared.empty() || *std::max_element(squared.begin(), squared.end()) == 0) return 0;
  look_at(static_cast<std::size_t>(std::max_element(squared.begin(), squared.end()) - squared.begin()));
  for (std::size_t k = 0; k < squared.size(); ++k) {
    if (bound(squared[k]) > largest) look_at(k);
  }
  return largest;
}

}  // namespace glisson::mechanics
#endif
