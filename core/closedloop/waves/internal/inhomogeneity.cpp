#include "closedloop/waves/internal/inhomogeneity.h"

#include <cmath>
#include <utility>

namespace glisson::closedloop {
namespace {

// The test function's component along `axis` as derivatives of the bump, each with its sign; of those by component one.
struct Term {
  double sign = 0;
  Derivative derivative{0, 0, 0};
};
Term term_of(const WeakForms& forms, int test, int axis) {
  if (!forms.pressure_is_free) return {1, test == 0 ? Derivative{0, 0, 0} : plus({0, 0, 0}, test - 1)};
  if (test == axis) return {};
  const int other = 3 - test - axis;  // curl: d_other of the bump, by the sign of (axis, other, test)
  return {(axis - other) * (other - test) * (test - axis) / 2.0, plus({0, 0, 0}, other)};
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
    : forms_(forms),
      functions_(std::move(functions)),
      grid_(std::move(grid)),
      tests_(forms.pressure_is_free ? 3 : forms.groups()),
      axes_(forms.pressure_is_free ? 3 : 1) {
  const Eigen::Index voxels =
      Eigen::Index{2 * functions_.reach(0) + 1} * (2 * functions_.reach(1) + 1) * (2 * functions_.reach(2) + 1);
  const Eigen::Index columns = Eigen::Index{tests_} * axes_;
  weights_ = Eigen::VectorXd::Zero(voxels);
  w_ = l_ = Eigen::MatrixXd::Zero(voxels, columns);
  for (Eigen::MatrixXd& one : by_slope_) one = w_;
  Eigen::Index at = 0;
  for (int k = -functions_.reach(2); k <= functions_.reach(2); ++k) {
    for (int j = -functions_.reach(1); j <= functions_.reach(1); ++j) {
      for (int i = -functions_.reach(0); i <= functions_.reach(0); ++i, ++at) {
        const std::array<int, 3> offset{i, j, k};
        weights_[at] = std::pow(functions_.value({0, 0, 0}, offset), 2);
        for (int axis = 0; axis < axes_; ++axis) {
          for (int test = 0; test < tests_; ++test) {
            const auto [sign, derivative] = term_of(forms_, test, axis);
            const Eigen::Index column = Eigen::Index{axis} * tests_ + test;
            w_(at, column) = sign * functions_.value(derivative, offset);
            for (int a = 0; a < 3; ++a) {
              l_(at, column) += sign * functions_.value(plus(plus(derivative, a), a), offset);
              double& slope = by_slope_.at(static_cast<std::size_t>(a))(at, column);
              slope = sign * functions_.value(plus(derivative, a), offset);
              if (!forms_.pressure_is_free) continue;
              const auto [other_sign, other] = term_of(forms_, test, a);  // the transposed gradient
              slope += other_sign * functions_.value(plus(other, axis), offset);
            }
          }
        }
      }
    }
  }
}

RegionSums RegionForms::sums(const Patch& patch, const Fields& fields, const std::vector<double>& slice_phase,
                             const Region& region) const {
  const Eigen::Index voxels = weights_.size();
  Eigen::VectorXd share(voxels);
  std::array<Eigen::VectorXd, 3> slope{Eigen::VectorXd(voxels), Eigen::VectorXd(voxels), Eigen::VectorXd(voxels)};
  Eigen::MatrixXcd u(voxels, static_cast<Eigen::Index>(fields.size()));
  Eigen::Index at = 0;
  for (int k = -functions_.reach(2); k <= functions_.reach(2); ++k) {
    const int slice = patch.middle[2] + k;
    const std::complex<double> turn = turned_back(slice_phase, slice);
    for (int j = -functions_.reach(1); j <= functions_.reach(1); ++j) {
      for (int i = -functions_.reach(0); i <= functions_.reach(0); ++i, ++at) {
        const std::array<int, 3> voxel{patch.middle[0] + i, patch.middle[1] + j, slice};
        const Belonging here = region(voxel);
        share[at] = here.share;
        for (Eigen::Index a = 0; a < 3; ++a) slope.at(static_cast<std::size_t>(a))[at] = here.slope[a];
        const std::size_t offset = grid_.offset(voxel[0], voxel[1], voxel[2]);
        for (std::size_t c = 0; c < fields.size(); ++c)
          u(at, static_cast<Eigen::Index>(c)) = turn * std::complex<double>(fields[c][offset]);
      }
    }
  }
  Eigen::MatrixXd b = share.asDiagonal() * l_;
  for (std::size_t a = 0; a < 3; ++a) b += slope.at(a).asDiagonal() * by_slope_.at(a);
  RegionSums sums{Eigen::VectorXcd::Zero(forms_.count()), Eigen::MatrixXd::Zero(tests_, tests_),
                  Eigen::MatrixXd::Zero(tests_, tests_), Eigen::MatrixXd::Zero(tests_, tests_),
                  weights_.dot(share) / weights_.sum()};
  for (int axis = 0; axis < axes_; ++axis) {
    const auto of_axis = b.middleCols(Eigen::Index{axis} * tests_, tests_);
    sums.with_w += w_.middleCols(Eigen::Index{axis} * tests_, tests_).transpose() * of_axis;
    sums.with_l += l_.middleCols(Eigen::Index{axis} * tests_, tests_).transpose() * of_axis;
    sums.own += of_axis.transpose() * of_axis;
    if (axes_ == 3) sums.seen += of_axis.transpose() * u.col(axis);
  }
  if (axes_ == 1) {
    const Eigen::MatrixXcd seen = b.transpose() * u;
    sums.seen = Eigen::VectorXcd::Map(seen.data(), seen.size());
  }
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
