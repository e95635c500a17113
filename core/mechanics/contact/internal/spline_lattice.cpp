#include "mechanics/contact/internal/spline_lattice.h"

#include <algorithm>
#include <cmath>

#include "geometry/surface.h"

namespace glisson::mechanics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Eigen::VectorXf;
using Vector4 = Eigen::Vector4f;  // the fourth lane is not used

// Of the three B-splines over a cell, for a place within it.
std::array<float, 3> quadratic_splines(double t) {
  return {static_cast<float>(0.5 * (1 - t) * (1 - t)), static_cast<float>(0.5 + t - t * t),
          static_cast<float>(0.5 * t * t)};
}

}  // namespace

SplineLattice::SplineLattice(const std::vector<Vector3d>& positions_mm, const std::vector<std::uint8_t>& fixed,
                             int most_wide_points)
    : fixed_(fixed) {
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
  values.assign(wide_of_.size(), Vector4::Zero());
  for (std::size_t n = 0; n < places_.size(); ++n) {
    const Place& place = places_[n];
    Vector4 value(0, 0, 0, 0);
    for (int d = 0; d < 3; ++d) {
      value[d] = fixed_[3 * n + d] ? 0.0F : static_cast<float>(r[3 * static_cast<Eigen::Index>(n) + d]);
    }
    for (int k = 0; k < 3; ++k) {
      const Vector4 by_k = place.weights[2][k] * value;
      for (int j = 0; j < 3; ++j) {
        const Vector4 by_j = place.weights[1][j] * by_k;
        Vector4* at = values.data() + place.first + nx_ * (j + ny_ * k);
        for (int i = 0; i < 3; ++i) at[i] += place.weights[0][i] * by_j;
      }
    }
  }
}

void SplineLattice::down_to_wide(const Values& values, VectorXf& wide) const {
  wide = VectorXf::Zero(3 * wide_points_);
  for (std::size_t p = 0; p < values.size(); ++p) {
    for (const WideShare& share : wide_of_[p]) {
      if (share.point >= 0) wide.segment<3>(3 * share.point) += share.weight * values[p].head<3>();
    }
  }
}

void SplineLattice::up_from_wide(const VectorXf& wide, Values& values) const {
  for (std::size_t p = 0; p < values.size(); ++p) {
    for (const WideShare& share : wide_of_[p]) {
      if (share.point >= 0) values[p].head<3>() += share.weight * wide.segment<3>(3 * share.point);
    }
  }
}

void SplineLattice::up(const Values& values, VectorXd& z) const {
  for (std::size_t n = 0; n < places_.size(); ++n) {
    const Place& place = places_[n];
    Vector4 value(0, 0, 0, 0);
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) {
        const Vector4* at = values.data() + place.first + nx_ * (j + ny_ * k);
        const float weight = place.weights[1][j] * place.weights[2][k];
        for (int i = 0; i < 3; ++i) value += weight * place.weights[0][i] * at[i];
      }
    }
    for (int d = 0; d < 3; ++d) {
      if (!fixed_[3 * n + d]) z[3 * static_cast<Eigen::Index>(n) + d] += double{value[d]};
    }
  }
}

}  // namespace glisson::mechanics
