// The normal equations need sums over a neighbourhood, of Gaussian weights times powers of the coordinates. These are
// separable: three passes along the axes give those of all voxels at once.

#include "elastography/internal/local_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Cholesky>

#include "base/parallel.h"

namespace glisson::elastography {
namespace {

using imaging::Grid;
using imaging::Mask;
using Powers = std::array<int, 3>;

constexpr double reach_in_sd = 3;

// Powers of the basis functions: 1, x, y, x2, y2, xy; and those with z.
std::vector<Powers> basis_of(FitDimension dimension) {
  if (dimension == FitDimension::slice) {
    return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}};
  }
  return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
}

// All sums of weights times x^a y^b z^c times the field, a + b + c <= order (c = 0 alone in slices). Coordinates are in
// standard deviations of the Gaussian.
class MomentFilter {
 public:
  MomentFilter(const Grid& grid, double sd_mm, double coordinate_mm, FitDimension dimension)
      : grid_(grid), sd_mm_(sd_mm), coordinate_mm_(coordinate_mm), dimension_(dimension) {}

  [[nodiscard]] std::vector<std::vector<float>> moments(const std::vector<float>& field, int order) const;

  // Where moments() puts a moment.
  [[nodiscard]] std::size_t index(const Powers& powers, int order) const {
    std::size_t n = 0;
    for (int c = 0; c <= maximum_in_z(order); ++c) {
      for (int b = 0; b + c <= order; ++b) {
        for (int a = 0; a + b + c <= order; ++a, ++n) {
          if (Powers{a, b, c} == powers) return n;
        }
      }
    }
    GLISSON_ASSERT(false);
    return n;
  }

 private:
  [[nodiscard]] int maximum_in_z(int order) const { return dimension_ == FitDimension::slice ? 0 : order; }
  [[nodiscard]] std::vector<float> filtered(const std::vector<float>& field, std::size_t axis, int power) const;

  Grid grid_;
  double sd_mm_, coordinate_mm_;
  FitDimension dimension_;
};

std::vector<std::vector<float>> MomentFilter::moments(const std::vector<float>& field, int order) const {
  const auto count = static_cast<std::size_t>(order) + 1;
  std::vector<std::vector<float>> along_x(count);
  parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a) along_x[a] = filtered(field, 0, static_cast<int>(a));
  });
  struct Wanted {
    Powers powers;
    std::size_t plane;  // which of the products of x and y it is made from
  };
  std::vector<std::pair<int, int>> planes;
  for (int b = 0; b <= order; ++b) {
    for (int a = 0; a + b <= order; ++a) planes.emplace_back(a, b);
  }
  std::vector<std::vector<float>> along_xy(planes.size());
  parallel_for(planes.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      along_xy[n] = filtered(along_x[static_cast<std::size_t>(planes[n].first)], 1, planes[n].second);
    }
  });
  std::vector<Wanted> wanted;
  for (int c = 0; c <= maximum_in_z(order); ++c) {
    for (std::size_t n = 0; n < planes.size(); ++n) {
      if (planes[n].first + planes[n].second + c <= order) {
        wanted.push_back({{planes[n].first, planes[n].second, c}, n});
      }
    }
  }
  std::vector<std::vector<float>> found(wanted.size());
  parallel_for(wanted.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto& plane = along_xy[wanted[n].plane];
      found[index(wanted[n].powers, order)] =
          dimension_ == FitDimension::slice ? plane : filtered(plane, 2, wanted[n].powers[2]);
    }
  });
  return found;
}

std::vector<float> MomentFilter::filtered(const std::vector<float>& field, std::size_t axis, int power) const {
  const double spacing_mm = grid_.spacing_mm[static_cast<Eigen::Index>(axis)];
  const int radius = static_cast<int>(std::ceil(reach_in_sd * sd_mm_ / spacing_mm));
  std::vector<float> weight;
  for (int step = -radius; step <= radius; ++step) {
    const double sds = step * spacing_mm / sd_mm_;
    weight.push_back(
        static_cast<float>(std::exp(-0.5 * sds * sds) * std::pow(step * spacing_mm / coordinate_mm_, power)));
  }
  const std::array<std::size_t, 3> stride{
      1, static_cast<std::size_t>(grid_.size[0]),
      static_cast<std::size_t>(grid_.size[0]) * static_cast<std::size_t>(grid_.size[1])};
  const int length = grid_.size[axis];
  std::vector<float> outcome(field.size(), 0);
  // Whole rows at a time for the axes across memory: out[at] += weight * in[at + step] for all of a row's voxels.
  const std::size_t run = stride[axis];
  const std::size_t block = run * static_cast<std::size_t>(length);
  for (std::size_t start = 0; start < field.size(); start += block) {
    for (int at = 0; at < length; ++at) {
      float* const out = &outcome[start + static_cast<std::size_t>(at) * run];
      const int first = std::max(-radius, -at);
      const int last = std::min(radius, length - 1 - at);
      for (int step = first; step <= last; ++step) {
        const float w = weight[static_cast<std::size_t>(step + radius)];
        const float* const in = &field[start + static_cast<std::size_t>(at + step) * run];
        for (std::size_t n = 0; n < run; ++n) out[n] += w * in[n];
      }
    }
  }
  return outcome;
}

}  // namespace

LocalFitter::LocalFitter(const Mask& mask, double sd_mm, FitDimension dimension)
    : grid_(mask.grid), sd_mm_(sd_mm), dimension_(dimension), mask_(mask), fitted_(mask) {
  const MomentFilter filter(grid_, sd_mm, sd_mm, dimension);
  // The square of a Gaussian is a Gaussian whose standard deviation is smaller by the square root of 2.
  const MomentFilter of_squared_weights(grid_, sd_mm / std::sqrt(2.0), sd_mm, dimension);
  const std::vector<float> inside(mask.values.begin(), mask.values.end());
  const auto moments = filter.moments(inside, 4);
  const auto squared_moments = of_squared_weights.moments(inside, 4);

  support_ = moments[filter.index({0, 0, 0}, 4)];
  const auto everywhere = filter.moments(std::vector<float>(mask.values.size(), 1), 0).front();
  for (std::size_t v = 0; v < support_.size(); ++v) support_[v] /= everywhere[v];
  solve(moments, squared_moments);
}

void LocalFitter::solve(const std::vector<std::vector<float>>& moments,
                        const std::vector<std::vector<float>>& squared_moments) {
  const MomentFilter filter(grid_, sd_mm_, sd_mm_, dimension_);
  const std::vector<Powers> basis = basis_of(dimension_);
  const auto size = static_cast<Eigen::Index>(basis.size());
  std::vector<std::size_t> moment_of(basis.size() * basis.size());
  for (std::size_t r = 0; r < basis.size(); ++r) {
    for (std::size_t c = 0; c < basis.size(); ++c) {
      const Powers sum{basis[r][0] + basis[c][0], basis[r][1] + basis[c][1], basis[r][2] + basis[c][2]};
      moment_of[r * basis.size() + c] = filter.index(sum, 4);
    }
  }
  std::vector<std::uint32_t> voxels;
  row_of_.assign(mask_.values.size(), 0);
  for (std::size_t v = 0; v < mask_.values.size(); ++v) {
    if (mask_.values[v] == 0) continue;
    row_of_[v] = static_cast<std::uint32_t>(voxels.size());
    voxels.push_back(static_cast<std::uint32_t>(v));
  }
  noise_gain_.assign(mask_.values.size(), {0, 0, 0});
  value_rows_.assign(voxels.size() * basis.size(), 0);
  laplacian_rows_.assign(voxels.size() * basis.size(), 0);

  parallel_for(voxels.size(), 256, [&](std::size_t begin, std::size_t end) {
    Eigen::MatrixXd normal(size, size);
    Eigen::MatrixXd squared(size, size);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(size, 2);  // value, Laplacian (in standard deviations)
    wanted(0, 0) = 1;
    for (Eigen::Index n = 0; n < size; ++n) {
      const Powers& p = basis[static_cast<std::size_t>(n)];
      if (std::max({p[0], p[1], p[2]}) < 2) continue;
      wanted(n, 0) = 1;  // s^2/2 of the Laplacian 2 c / s^2
      wanted(n, 1) = 2 / (sd_mm_ * sd_mm_);
    }
    for (std::size_t row = begin; row < end; ++row) {
      const std::size_t v = voxels[row];
      for (Eigen::Index r = 0; r < size; ++r) {
        for (Eigen::Index c = 0; c < size; ++c) {
          const std::size_t m = moment_of[static_cast<std::size_t>(r * size + c)];
          normal(r, c) = static_cast<double>(moments[m][v]);
          squared(r, c) = static_cast<double>(squared_moments[m][v]);
        }
      }
      const Eigen::LLT<Eigen::MatrixXd> factor(normal);
      const bool solvable =
          factor.info() == Eigen::Success && factor.matrixLLT().diagonal().minCoeff() > 1e-3 * std::sqrt(normal(0, 0));
      if (!solvable) {
        fitted_.values[v] = 0;
        continue;
      }
      const Eigen::MatrixXd rows = factor.solve(wanted);
      const Eigen::Matrix2d gain = rows.transpose() * squared * rows;
      noise_gain_[v] = {static_cast<float>(gain(0, 0)), static_cast<float>(gain(0, 1)), static_cast<float>(gain(1, 1))};
      for (Eigen::Index n = 0; n < size; ++n) {
        value_rows_[row * basis.size() + static_cast<std::size_t>(n)] = static_cast<float>(rows(n, 0));
        laplacian_rows_[row * basis.size() + static_cast<std::size_t>(n)] = static_cast<float>(rows(n, 1));
      }
    }
  });
}

LocalFit LocalFitter::fit(const ComplexField& field) const {
  const MomentFilter filter(grid_, sd_mm_, sd_mm_, dimension_);
  const std::vector<Powers> basis = basis_of(dimension_);
  std::vector<std::size_t> moment_of(basis.size());
  for (std::size_t n = 0; n < basis.size(); ++n) moment_of[n] = filter.index(basis[n], 2);

  std::vector<float> real(field.size(), 0);
  std::vector<float> imaginary(field.size(), 0);
  for (std::size_t v = 0; v < field.size(); ++v) {
    if (mask_.values[v] == 0) continue;
    real[v] = field[v].real();
    imaginary[v] = field[v].imag();
  }
  const auto of_real = filter.moments(real, 2);
  const auto of_imaginary = filter.moments(imaginary, 2);
  LocalFit fit{ComplexField(field.size(), 0), ComplexField(field.size(), 0)};
  for (std::size_t v = 0; v < field.size(); ++v) {
    if (fitted_.values[v] == 0) continue;
    const std::size_t row = row_of_[v] * basis.size();
    for (std::size_t n = 0; n < basis.size(); ++n) {
      const std::complex<float> moment(of_real[moment_of[n]][v], of_imaginary[moment_of[n]][v]);
      fit.value[v] += value_rows_[row + n] * moment;
      fit.laplacian[v] += laplacian_rows_[row + n] * moment;
    }
  }
  return fit;
}

}  // namespace glisson::elastography
