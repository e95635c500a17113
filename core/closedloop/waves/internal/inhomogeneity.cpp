#include "closedloop/waves/internal/inhomogeneity.h"

#include <cmath>
#include <utility>

namespace glisson::closedloop {
namespace {

// Where each quantity stands in a row of the table.
constexpr std::size_t bump = 0, first = 1, second = 4, laplacian = 10, laplacian_of_first = 11;
std::size_t second_at(int a, int b) {
  constexpr std::array<std::array<std::size_t, 3>, 3> at{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
  return second + at.at(static_cast<std::size_t>(a)).at(static_cast<std::size_t>(b));
}

}  // namespace

Belonging smoothed(double signed_distance_mm, const Eigen::Vector3d& gradient, double width_mm) {
  const double t = signed_distance_mm / width_mm;
  if (t <= -1) return {};
  if (t >= 1) return {1, Eigen::Vector3d::Zero()};
  // 1/2 + 15/16 (t - 2 t^3 / 3 + t^5 / 5), whose first two derivatives vanish at the ends.
  const double t2 = t * t;
  return {0.5 + 15.0 / 16 * t * (1 - t2 * (2.0 / 3 - t2 / 5)), 15.0 / 16 * (1 - t2) * (1 - t2) / width_mm * gradient};
}

RegionForms::RegionForms(const WeakForms& forms, TestFunctions functions, imaging::Grid grid)
    : forms_(forms), functions_(std::move(functions)), grid_(std::move(grid)) {
  for (int k = -functions_.reach(2); k <= functions_.reach(2); ++k) {
    for (int j = -functions_.reach(1); j <= functions_.reach(1); ++j) {
      for (int i = -functions_.reach(0); i <= functions_.reach(0); ++i) {
        const std::array<int, 3> offset{i, j, k};
        std::array<double, kept> row{};
        row[bump] = functions_.value({0, 0, 0}, offset);
        for (int a = 0; a < 3; ++a) {
          const auto at = static_cast<std::size_t>(a);
          const Derivative once = plus({0, 0, 0}, a);
          row.at(first + at) = functions_.value(once, offset);
          for (int b = 0; b < 3; ++b) {
            row.at(second_at(a, b)) = functions_.value(plus(once, b), offset);
            row.at(laplacian_of_first + at) += functions_.value(plus(plus(once, b), b), offset);
          }
          row[laplacian] += row.at(second_at(a, a));
        }
        table_.push_back(row);
      }
    }
  }
}

RegionSums RegionForms::sums(const Patch& patch, const std::vector<std::vector<std::complex<float>>>& fields,
                             const std::vector<double>& slice_phase, const Region& region) const {
  const bool curl = forms_.pressure_is_free;
  const int tests = curl ? 3 : forms_.groups(),
            axes = curl ? 3 : 1;  // by component all components have the same test functions
  RegionSums sums{Eigen::VectorXcd::Zero(forms_.count()), Eigen::MatrixXd::Zero(tests, tests),
                  Eigen::MatrixXd::Zero(tests, tests), Eigen::MatrixXd::Zero(tests, tests)};
  Eigen::MatrixXd w(tests, axes), l(tests, axes), b(tests, axes);
  double weights = 0;
  std::size_t at = 0;
  for (int k = -functions_.reach(2); k <= functions_.reach(2); ++k) {
    for (int j = -functions_.reach(1); j <= functions_.reach(1); ++j) {
      for (int i = -functions_.reach(0); i <= functions_.reach(0); ++i) {
        const auto& row = table_[at++];
        const double weight = row[bump] * row[bump];
        weights += weight;
        const std::array<int, 3> voxel{patch.middle[0] + i, patch.middle[1] + j, patch.middle[2] + k};
        const auto [share, slope] = region(voxel);
        if (share == 0) continue;
        sums.share += weight * share;
        if (curl) {
          for (int e = 0; e < 3; ++e) {
            for (int c = 0; c < 3; ++c) {
              w(e, c) = l(e, c) = b(e, c) = 0;
              if (c == e) {
                // w_e = 0; what is left is the transposed gradient: sum over j of slope_j d_e w_j.
                const int u = (e + 1) % 3, v = (e + 2) % 3;
                b(e, c) = slope[u] * row.at(second_at(e, v)) - slope[v] * row.at(second_at(e, u));
                continue;
              }
              const int other = 3 - c - e;
              const double sign = (c - other) * (other - e) * (e - c) / 2.0;
              w(e, c) = sign * row.at(first + static_cast<std::size_t>(other));
              l(e, c) = sign * row.at(laplacian_of_first + static_cast<std::size_t>(other));
              double turned = 0;
              for (int a = 0; a < 3; ++a) turned += slope[a] * sign * row.at(second_at(other, a));
              const int u = (e + 1) % 3, v = (e + 2) % 3;
              turned += slope[u] * row.at(second_at(c, v)) - slope[v] * row.at(second_at(c, u));
              b(e, c) = share * l(e, c) + turned;
            }
          }
        } else {
          for (int t = 0; t < tests; ++t) {
            const int axis = t - 1;
            w(t, 0) = t == 0 ? row[bump] : row.at(first + static_cast<std::size_t>(axis));
            l(t, 0) = t == 0 ? row[laplacian] : row.at(laplacian_of_first + static_cast<std::size_t>(axis));
            double turned = 0;
            for (int a = 0; a < 3; ++a)
              turned += slope[a] * (t == 0 ? row.at(first + static_cast<std::size_t>(a)) : row.at(second_at(axis, a)));
            b(t, 0) = share * l(t, 0) + turned;
          }
        }
        sums.with_w.noalias() += w * b.transpose();
        sums.with_l.noalias() += l * b.transpose();
        sums.own.noalias() += b * b.transpose();
        const std::size_t voxel_at = grid_.offset(voxel[0], voxel[1], voxel[2]);
        const std::complex<double> turn = slice_phase.empty()
                                              ? std::complex<double>(1)
                                              : std::polar(1.0, -slice_phase[static_cast<std::size_t>(voxel[2])]);
        for (std::size_t c = 0; c < fields.size(); ++c) {
          const std::complex<double> u = turn * std::complex<double>(fields[c][voxel_at]);
          const auto component = static_cast<Eigen::Index>(c);
          if (curl) {
            for (int e = 0; e < 3; ++e) sums.seen[e] += b(e, component) * u;
          } else {
            for (int t = 0; t < tests; ++t) sums.seen[component * tests + t] += b(t, 0) * u;
          }
        }
      }
    }
  }
  sums.share /= weights;
  return sums;
}

RegionForms::Forms RegionForms::with_region(const RegionSums& sums, const Medium& medium, double ratio,
                                            const Eigen::MatrixXcd& covariance, const Eigen::VectorXcd& seen) {
  const std::complex<double> more = (ratio - 1) * medium.shear_kPa;
  const Eigen::MatrixXcd crossed = medium.inertia * sums.with_w.cast<std::complex<double>>() +
                                   medium.shear_kPa * sums.with_l.cast<std::complex<double>>();
  const Eigen::MatrixXcd block =
      std::conj(more) * crossed + more * crossed.adjoint() + std::norm(more) * sums.own.cast<std::complex<double>>();
  Forms forms{covariance, seen + more * sums.seen};
  for (Eigen::Index at = 0; at < covariance.rows(); at += block.rows())
    forms.covariance.block(at, at, block.rows(), block.rows()) += block;
  return forms;
}

}  // namespace glisson::closedloop
