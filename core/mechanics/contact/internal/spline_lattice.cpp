#include "mechanics/contact/internal/spline_lattice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/contact/internal/spline_lattice.cpp"
// Vectors whose length the compiler does not know cannot be kept in arrays.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glisson::mechanics {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

template <typename Visit>
void for_points_around(const SplineLattice::Place& place, const std::array<int, 9>& rows, const Visit& visit) {
  for (std::size_t row = 0; row < 9; ++row) {
    for (std::size_t i = 0; i < 3; ++i) {
      visit(4 * static_cast<std::size_t>(place.first + rows[row]) + 4 * i,
            place.weights[0][i] * place.weights[1][row % 3] * place.weights[2][row / 3]);
    }
  }
}

void add_down(const SplineLattice::Place* places, std::size_t count, const double* r, const float* is_free,
              std::array<int, 9> rows, float* values) {
  for (std::size_t n = 0; n < count; ++n) {
    for_points_around(places[n], rows, [&](std::size_t at, float weight) {
      for (std::size_t d = 0; d < 3; ++d)
        values[at + d] += weight * is_free[3 * n + d] * static_cast<float>(r[3 * n + d]);
    });
  }
}

void add_up(const SplineLattice::Place* places, std::size_t count, const float* values, const float* is_free,
            std::array<int, 9> rows, double* z) {
  for (std::size_t n = 0; n < count; ++n) {
    for_points_around(places[n], rows, [&](std::size_t at, float weight) {
      for (std::size_t d = 0; d < 3; ++d) z[3 * n + d] += double{is_free[3 * n + d] * weight * values[at + d]};
    });
  }
}

#else

namespace hn = hwy::HWY_NAMESPACE;

// Four points of a lattice's row at a time, the last of which has no weight: sixteen lanes, in pieces where vectors
// are shorter.
constexpr std::size_t row_lanes = 16;
using Tag = hn::CappedTag<float, row_lanes>;
using Vector = hn::Vec<Tag>;
constexpr std::size_t most_pieces = 4;

struct Row {
  Vector piece[most_pieces];
};

// Which of four weights belongs to each lane of a row.
struct PointOfLane {
  decltype(hn::IndicesFromVec(Tag(), hn::Zero(hn::RebindToSigned<Tag>()))) piece[most_pieces];

  PointOfLane() {
    const Tag tag;
    HWY_ALIGN std::int32_t point[row_lanes];
    for (std::size_t lane = 0; lane < row_lanes; ++lane) point[lane] = static_cast<std::int32_t>(lane / 4);
    for (std::size_t from = 0, p = 0; from < row_lanes; from += hn::Lanes(tag), ++p) {
      piece[p] = hn::IndicesFromVec(tag, hn::Load(hn::RebindToSigned<Tag>(), point + from));
    }
  }
};

HWY_INLINE Row weights_of_points(const float* weights, const PointOfLane& points) {
  const Tag tag;
  const Vector all = hn::LoadDup128(tag, weights);
  Row row;
  for (std::size_t from = 0, p = 0; from < row_lanes; from += hn::Lanes(tag), ++p) {
    row.piece[p] = hn::TableLookupLanes(all, points.piece[p]);
  }
  return row;
}

void add_down(const SplineLattice::Place* places, std::size_t count, const double* r, const float* is_free,
              std::array<int, 9> rows, float* values) {
  const Tag tag;
  const PointOfLane points;
  for (std::size_t n = 0; n < count; ++n) {
    const SplineLattice::Place& place = places[n];
    HWY_ALIGN float value[4] = {0, 0, 0, 0};
    for (std::size_t d = 0; d < 3; ++d) value[d] = is_free[3 * n + d] * static_cast<float>(r[3 * n + d]);
    const Vector repeated = hn::LoadDup128(tag, value);
    const Row along = weights_of_points(place.weights[0].data(), points);
    Row weighted;
    for (std::size_t from = 0, p = 0; from < row_lanes; from += hn::Lanes(tag), ++p) {
      weighted.piece[p] = hn::Mul(along.piece[p], repeated);
    }
    for (std::size_t row = 0; row < 9; ++row) {
      float* at = values + 4 * (place.first + rows[row]);
      const Vector weight = hn::Set(tag, place.weights[1][row % 3] * place.weights[2][row / 3]);
      for (std::size_t from = 0, p = 0; from < row_lanes; from += hn::Lanes(tag), ++p) {
        hn::StoreU(hn::MulAdd(weight, weighted.piece[p], hn::LoadU(tag, at + from)), tag, at + from);
      }
    }
  }
}

void add_up(const SplineLattice::Place* places, std::size_t count, const float* values, const float* is_free,
            std::array<int, 9> rows, double* z) {
  const Tag tag;
  const hn::CappedTag<float, 4> four;
  const PointOfLane points;
  for (std::size_t n = 0; n < count; ++n) {
    const SplineLattice::Place& place = places[n];
    const Row along = weights_of_points(place.weights[0].data(), points);
    Row sum;
    for (Vector& piece : sum.piece) piece = hn::Zero(tag);
    for (std::size_t row = 0; row < 9; ++row) {
      const float* at = values + 4 * (place.first + rows[row]);
      const Vector weight = hn::Set(tag, place.weights[1][row % 3] * place.weights[2][row / 3]);
      for (std::size_t from = 0, p = 0; from < row_lanes; from += hn::Lanes(tag), ++p) {
        sum.piece[p] = hn::MulAdd(weight, hn::LoadU(tag, at + from), sum.piece[p]);
      }
    }
    HWY_ALIGN float lanes[row_lanes];
    for (std::size_t from = 0, p = 0; from < row_lanes; from += hn::Lanes(tag), ++p) {
      hn::Store(hn::Mul(along.piece[p], sum.piece[p]), tag, lanes + from);
    }
    HWY_ALIGN float value[4];
    hn::Store(hn::Add(hn::Add(hn::Load(four, lanes), hn::Load(four, lanes + 4)), hn::Load(four, lanes + 8)), four,
              value);
    for (std::size_t d = 0; d < 3; ++d) z[3 * n + d] += double{is_free[3 * n + d] * value[d]};
  }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace glisson::mechanics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <cmath>

#include "geometry/surface.h"

namespace glisson::mechanics {

HWY_EXPORT(add_down);
HWY_EXPORT(add_up);

namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Eigen::VectorXf;

// Of the three B-splines over a cell, for a place within it.
std::array<float, 4> quadratic_splines(double t) {
  return {static_cast<float>(0.5 * (1 - t) * (1 - t)), static_cast<float>(0.5 + t - t * t),
          static_cast<float>(0.5 * t * t), 0};
}

}  // namespace

SplineLattice::SplineLattice(const std::vector<Vector3d>& positions_mm, const std::vector<std::uint8_t>& fixed,
                             int most_wide_points) {
  for (const std::uint8_t held : fixed) is_free_.push_back(held ? 0.0F : 1.0F);
  const geometry::Box box = geometry::bounding_box(positions_mm);
  const Vector3d size_mm = box.max_mm - box.min_mm;
  for (double spacing_mm = 0.5 * std::cbrt(size_mm.prod() / most_wide_points);; spacing_mm *= 1.04) {
    nx_ = static_cast<int>(size_mm.x() / spacing_mm) + 3;
    ny_ = static_cast<int>(size_mm.y() / spacing_mm) + 3;
    nz_ = static_cast<int>(size_mm.z() / spacing_mm) + 3;
    places_.clear();
    const std::size_t grid =
        static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_);
    std::vector<std::uint8_t> is_near(grid, 0);
    for (const Vector3d& at_mm : positions_mm) {
      Place place{};
      std::array<int, 3> cell{};
      for (int d = 0; d < 3; ++d) {
        const double along = (at_mm[d] - box.min_mm[d]) / spacing_mm;
        cell[d] = static_cast<int>(along);
        place.weights[d] = quadratic_splines(along - cell[d]);
      }
      place.first = cell[0] + nx_ * (cell[1] + ny_ * cell[2]);
      places_.push_back(place);
      for (int i = 0; i < 27; ++i) {
        is_near[static_cast<std::size_t>(place.first + i % 3 + nx_ * (i / 3 % 3 + ny_ * (i / 9)))] = 1;
      }
    }
    number_wide_points(is_near);
    if (wide_points_ <= std::max(most_wide_points, 64)) return;  // one cell has as many
  }
}

void SplineLattice::number_wide_points(const std::vector<std::uint8_t>& is_near) {
  // Spline p begins at cell p - 2 and spans three; wide spline m begins at cell 2 m - 4 and is 1/4, 3/4, 3/4, 1/4 of
  // the narrow ones 2 m - 2 to 2 m + 1. Narrow spline p is therefore in the wide ones of (p - 1) / 2, and so on.
  wide_of_.assign(is_near.size(), {});
  const auto in_wide = [](int p) {
    const int half = p / 2;  // p = 2 half or 2 half + 1
    return p % 2 == 0 ? std::array<std::pair<int, float>, 2>{{{half, 0.75F}, {half + 1, 0.25F}}}
                      : std::array<std::pair<int, float>, 2>{{{half, 0.25F}, {half + 1, 0.75F}}};
  };
  wide_points_ = 0;
  const int wx = nx_ / 2 + 2, wy = ny_ / 2 + 2;
  std::vector<int> number(
      static_cast<std::size_t>(wx) * static_cast<std::size_t>(wy) * static_cast<std::size_t>(nz_ / 2 + 2), -1);
  for (int z = 0, p = 0; z < nz_; ++z) {
    for (int y = 0; y < ny_; ++y) {
      for (int x = 0; x < nx_; ++x, ++p) {
        for (int k = 0; k < 8; ++k) {
          const auto [ix, fx] = in_wide(x)[k & 1];
          const auto [iy, fy] = in_wide(y)[(k >> 1) & 1];
          const auto [iz, fz] = in_wide(z)[k >> 2];
          WideShare& share = wide_of_[static_cast<std::size_t>(p)][static_cast<std::size_t>(k)];
          share = {-1, fx * fy * fz};
          if (!is_near[static_cast<std::size_t>(p)]) continue;
          int& own = number[static_cast<std::size_t>(ix + wx * (iy + wy * iz))];
          if (own < 0) own = wide_points_++;
          share.point = own;
        }
      }
    }
  }
}

SplineLattice::Shares<float> SplineLattice::around(int node) const {
  const Place& place = places_[static_cast<std::size_t>(node)];
  Shares<float> shares;
  for (int i = 0; i < 27; ++i) {
    shares.emplace_back(place.first + i % 3 + nx_ * (i / 3 % 3 + ny_ * (i / 9)),
                        place.weights[0][i % 3] * place.weights[1][i / 3 % 3] * place.weights[2][i / 9]);
  }
  return shares;
}

SplineLattice::Shares<float> SplineLattice::wide_around(int node) const {
  Shares<float> shares;
  for (const auto& [point, weight] : around(node)) {
    for (const WideShare& wide : wide_of_[static_cast<std::size_t>(point)]) {
      const auto known =
          std::find_if(shares.begin(), shares.end(), [&](const auto& s) { return s.first == wide.point; });
      if (known == shares.end()) {
        shares.emplace_back(wide.point, wide.weight * weight);
      } else {
        known->second += wide.weight * weight;
      }
    }
  }
  return shares;
}

void SplineLattice::down(const VectorXd& r, Values& values) const {
  values.assign(wide_of_.size() + 1, Eigen::Vector4f::Zero());  // the last row's fourth point
  HWY_DYNAMIC_DISPATCH(add_down)
  (places_.data(), places_.size(), r.data(), is_free_.data(), rows_around(), values.front().data());
}

void SplineLattice::down_to_wide(const Values& values, VectorXf& wide) const {
  wide = VectorXf::Zero(3 * wide_points_);
  for (std::size_t p = 0; p < wide_of_.size(); ++p) {
    for (const WideShare& share : wide_of_[p]) {
      if (share.point >= 0) wide.segment<3>(3 * share.point) += share.weight * values[p].head<3>();
    }
  }
}

void SplineLattice::up_from_wide(const VectorXf& wide, Values& values) const {
  for (std::size_t p = 0; p < wide_of_.size(); ++p) {
    for (const WideShare& share : wide_of_[p]) {
      if (share.point >= 0) values[p].head<3>() += share.weight * wide.segment<3>(3 * share.point);
    }
  }
}

void SplineLattice::up(const Values& values, VectorXd& z) const {
  HWY_DYNAMIC_DISPATCH(add_up)
  (places_.data(), places_.size(), values.front().data(), is_free_.data(), rows_around(), z.data());
}

// Where the nine rows of points around a node begin, from its first.
std::array<int, 9> SplineLattice::rows_around() const {
  std::array<int, 9> rows{};
  for (int row = 0; row < 9; ++row) rows[static_cast<std::size_t>(row)] = nx_ * (row % 3 + ny_ * (row / 3));
  return rows;
}

}  // namespace glisson::mechanics
#endif
