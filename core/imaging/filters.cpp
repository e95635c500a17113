// Blurs and distances go line by line along each axis, holes by rows. ITK's connected components are the rest: its
// templates compile slowly, and all of them are here.

#include "imaging/filters.h"

#include <itkConnectedComponentImageFilter.h>
#include <itkMultiThreaderBase.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>

#include "base/parallel.h"
#include "base/result.h"

namespace glisson::imaging {
namespace {

template <typename Value>
using ItkImage = itk::Image<Value, 3>;

// ITK's image over the same values, which are neither copied nor owned. Positions in space play no part here.
template <typename Value>
typename ItkImage<Value>::Pointer view(const Grid& grid, const std::vector<Value>& values) {
  GLISSON_ASSERT(values.size() == grid.voxels() && !values.empty());
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(static_cast<itk::ThreadIdType>(thread_count()));
  auto image = ItkImage<Value>::New();
  typename ItkImage<Value>::SizeType size;
  typename ItkImage<Value>::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = static_cast<itk::SizeValueType>(grid.size[axis]);
    spacing[axis] = grid.spacing_mm[axis];
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  // The inputs of filters are only read.
  image->GetPixelContainer()->SetImportPointer(const_cast<Value*>(values.data()), values.size(), false);
  return image;
}

template <typename Value>
std::vector<Value> values_of(const ItkImage<Value>& image) {
  const Value* first = image.GetBufferPointer();
  return {first, first + image.GetBufferedRegion().GetNumberOfPixels()};
}

// Lines along an axis that lie beside each other are changed together: they share cache lines. Value n of line c stands
// at [n * together + c].
constexpr std::size_t together = 16;
// Calls change(lines, count), of some length each, for all lines of values along an axis.
template <typename Change>
void change_lines(std::vector<float>& values, const Grid& grid, std::size_t axis, const Change& change);

// What is nearest to a place of a line: `squared_mm2` off it, beside `at_mm` on it.
struct Site {
  double squared_mm2, at_mm;
};
// Squared distances of a line's places from what lies beside them, made those from what lies beside any place of the
// line. One of lines that lie together.
void spread_along(float* squared_mm2, std::size_t length, double spacing_mm);

// A Gaussian as a sum of two recursions of the fourth order, one each way (Deriche 1993, with the constants of
// Farnebäck and Westin, J Math Imaging Vis 26:293, 2006).
struct Recursion {
  explicit Recursion(double sd_voxels);
  std::array<double, 4> forth, back;  // of the values: this one and the three before; the four after
  std::array<double, 4> own;          // of its own values, the four before or after
};
void blur_along(float* lines, std::size_t length, const Recursion& recursion);

// Voxels begin..end of a row that the mask does not hold.
struct Gap {
  std::size_t row;
  int begin, end;
  bool open;  // reaches the grid's border
};

}  // namespace

std::vector<float> gaussian_blur(std::vector<float> values, const Grid& grid, double sd_mm) {
  constexpr int fewest_voxels = 4;  // of the recursion
  constexpr double smallest_sd_voxels = 1.0 / 3;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double sd_voxels = sd_mm / grid.spacing_mm[static_cast<Eigen::Index>(axis)];
    if (grid.size[axis] < fewest_voxels || sd_voxels < smallest_sd_voxels) continue;
    const Recursion recursion(sd_voxels);
    const auto length = static_cast<std::size_t>(grid.size[axis]);
    change_lines(values, grid, axis,
                 [&](float* lines, std::size_t /*count*/) { blur_along(lines, length, recursion); });
  }
  return values;
}

std::vector<float> squared_distances_mm2(const Mask& mask) {
  std::vector<float> squared_mm2(mask.values.size());
  for (std::size_t voxel = 0; voxel < squared_mm2.size(); ++voxel) {
    squared_mm2[voxel] = mask.values[voxel] != 0 ? 0.0F : std::numeric_limits<float>::infinity();
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double spacing_mm = mask.grid.spacing_mm[static_cast<Eigen::Index>(axis)];
    const auto length = static_cast<std::size_t>(mask.grid.size[axis]);
    change_lines(squared_mm2, mask.grid, axis, [&](float* lines, std::size_t count) {
      for (std::size_t c = 0; c < count; ++c) spread_along(lines + c, length, spacing_mm);
    });
  }
  return squared_mm2;
}

std::vector<float> squared_depths_mm2(const Mask& mask) {
  Mask outside = mask;
  for (std::uint8_t& value : outside.values) value = value == 0 ? 1 : 0;
  return squared_distances_mm2(outside);
}

ConnectedVoxels connected_voxels(const Mask& mask, Neighbours neighbours) {
  auto filter = itk::ConnectedComponentImageFilter<ItkImage<std::uint8_t>, ItkImage<std::uint32_t>>::New();
  filter->SetInput(view(mask.grid, mask.values));
  filter->SetFullyConnected(neighbours == Neighbours::all);
  filter->Update();
  ConnectedVoxels connected{values_of(*filter->GetOutput()), std::vector<std::size_t>(filter->GetObjectCount() + 1, 0)};
  for (const std::uint32_t piece : connected.piece) ++connected.sizes[piece];
  return connected;
}

std::uint32_t ConnectedVoxels::largest() const {
  if (sizes.size() < 2) return 0;
  return static_cast<std::uint32_t>(std::max_element(sizes.begin() + 1, sizes.end()) - sizes.begin());
}

Mask fill_holes(const Mask& mask) {
  GLISSON_ASSERT(mask.values.size() == mask.grid.voxels() && !mask.values.empty());
  const std::array<int, 3>& size = mask.grid.size;
  const auto height = static_cast<std::size_t>(size[1]), rows = height * static_cast<std::size_t>(size[2]);
  std::vector<Gap> gaps;
  std::vector<std::size_t> first{0};   // of each row's gaps
  std::vector<std::size_t> to_follow;  // gaps that are open, whose neighbours are to be looked at
  for (std::size_t row = 0; row < rows; ++row) {
    const std::uint8_t* const values = &mask.values[row * static_cast<std::size_t>(size[0])];
    const bool at_border = row % height == 0 || row % height + 1 == height || row < height || row + height >= rows;
    for (int i = 0; i < size[0]; ++i) {
      if (values[i] != 0) continue;
      Gap gap{row, i, i + 1, false};
      while (gap.end < size[0] && values[gap.end] == 0) ++gap.end;
      gap.open = at_border || gap.begin == 0 || gap.end == size[0];
      if (gap.open) to_follow.push_back(gaps.size());
      gaps.push_back(gap);
      i = gap.end;
    }
    first.push_back(gaps.size());
  }
  const auto open_beside = [&](const Gap& gap, std::size_t row) {
    for (std::size_t other = first[row]; other < first[row + 1]; ++other) {
      if (gaps[other].open || gaps[other].begin >= gap.end || gaps[other].end <= gap.begin) continue;
      gaps[other].open = true;
      to_follow.push_back(other);
    }
  };
  while (!to_follow.empty()) {
    const Gap gap = gaps[to_follow.back()];
    to_follow.pop_back();
    if (gap.row % height > 0) open_beside(gap, gap.row - 1);
    if (gap.row % height + 1 < height) open_beside(gap, gap.row + 1);
    if (gap.row >= height) open_beside(gap, gap.row - height);
    if (gap.row + height < rows) open_beside(gap, gap.row + height);
  }
  Mask filled = mask;
  for (const Gap& gap : gaps) {
    if (gap.open) continue;
    std::fill_n(&filled.values[gap.row * static_cast<std::size_t>(size[0]) + static_cast<std::size_t>(gap.begin)],
                gap.end - gap.begin, std::uint8_t{1});
  }
  return filled;
}

namespace {

template <typename Change>
void change_lines(std::vector<float>& values, const Grid& grid, std::size_t axis, const Change& change) {
  const std::array<std::size_t, 3> size{static_cast<std::size_t>(grid.size[0]), static_cast<std::size_t>(grid.size[1]),
                                        static_cast<std::size_t>(grid.size[2])};
  const std::array<std::size_t, 3> stride{1, size[0], size[0] * size[1]};
  const std::size_t beside = axis == 0 ? 1 : 0, across = 3 - axis - beside;
  const std::size_t length = size[axis], groups = (size[beside] + together - 1) / together;
  parallel_for(groups * size[across], 8, [&](std::size_t begin, std::size_t end) {
    std::vector<float> lines(together * length);
    for (std::size_t group = begin; group < end; ++group) {
      const std::size_t from = group % groups * together, count = std::min(together, size[beside] - from);
      float* const start = &values[from * stride[beside] + group / groups * stride[across]];
      const auto at = [&](std::size_t n, std::size_t c) -> float& {
        return start[n * stride[axis] + c * stride[beside]];
      };
      for (std::size_t n = 0; n < length; ++n) {
        for (std::size_t c = 0; c < count; ++c) lines[n * together + c] = at(n, c);
      }
      change(lines.data(), count);
      for (std::size_t n = 0; n < length; ++n) {
        for (std::size_t c = 0; c < count; ++c) at(n, c) = lines[n * together + c];
      }
    }
  });
}

Recursion::Recursion(double sd_voxels) {
  // The half kernel is a sum of two damped waves, (a cos(w n) + b sin(w n)) exp(l n) with n in deviations.
  struct Wave {
    double a, b, w, l;
  };
  constexpr Wave first{1.3530, 1.8151, 0.6681, -1.3932}, second{-0.3531, 0.0902, 2.0787, -1.3732};
  const auto turned = [&](const Wave& wave) {
    return std::polar(std::exp(wave.l / sd_voxels), wave.w / sd_voxels);  // from one voxel to the next
  };
  const std::complex<double> p = turned(first), q = turned(second);
  // Each wave by itself obeys a recursion of the second order: its denominator and its numerator, in powers of z^-1.
  const std::array<double, 3> of_p{1, -2 * p.real(), std::norm(p)}, of_q{1, -2 * q.real(), std::norm(q)};
  const auto numerator = [](const Wave& wave, const std::complex<double>& turn) {
    return std::array<double, 2>{wave.a, wave.b * turn.imag() - wave.a * turn.real()};
  };
  const std::array<double, 2> over_p = numerator(first, p), over_q = numerator(second, q);
  std::array<double, 5> denominator{};
  forth = {};
  for (std::size_t m = 0; m < 3; ++m) {
    for (std::size_t n = 0; n < 3; ++n) denominator[m + n] += of_p[m] * of_q[n];
    for (std::size_t n = 0; n < 2; ++n) forth[m + n] += over_p[n] * of_q[m] + over_q[n] * of_p[m];
  }
  std::copy_n(denominator.begin() + 1, 4, own.begin());
  // Both ways hold the middle, which is to count once; and a constant stays what it is.
  const double gain =
      std::accumulate(forth.begin(), forth.end(), 0.0) / std::accumulate(denominator.begin(), denominator.end(), 0.0);
  const double sum = 2 * gain - forth[0];
  for (double& value : forth) value /= sum;
  for (std::size_t n = 0; n < 4; ++n) back[n] = (n < 3 ? forth[n + 1] : 0.0) - own[n] * forth[0];
}

void blur_along(float* lines, std::size_t length, const Recursion& recursion) {
  using Lanes = std::array<double, together>;
  const auto& [forth, back, own] = recursion;
  const auto sum = [](const std::array<double, 4>& values) { return values[0] + values[1] + values[2] + values[3]; };
  // Beyond both ends their values go on, and what comes of that.
  std::vector<Lanes> in(length + 8), passed(length + 4), blurred(length);
  for (std::size_t n = 0; n < in.size(); ++n) {
    const float* const from = lines + together * std::min(n > 4 ? n - 4 : 0, length - 1);
    std::copy_n(from, together, in[n].begin());
  }
  const auto settled = [&](Lanes at_end, const std::array<double, 4>& weights) {
    for (double& value : at_end) value *= sum(weights) / (1 + sum(recursion.own));
    return at_end;
  };
  std::fill_n(passed.begin(), 4, settled(in.front(), forth));
  for (std::size_t n = 0; n < length; ++n) {
    const Lanes* const x = &in[n + 4];
    Lanes* const y = &passed[n + 4];
    for (std::size_t c = 0; c < together; ++c) {
      y[0][c] = forth[0] * x[0][c] + forth[1] * x[-1][c] + forth[2] * x[-2][c] + forth[3] * x[-3][c] -
                own[0] * y[-1][c] - own[1] * y[-2][c] - own[2] * y[-3][c] - own[3] * y[-4][c];
      blurred[n][c] = y[0][c];
    }
  }
  std::fill_n(passed.end() - 4, 4, settled(in.back(), back));
  for (std::size_t n = length; n-- > 0;) {
    const Lanes* const x = &in[n + 4];
    Lanes* const y = &passed[n];
    for (std::size_t c = 0; c < together; ++c) {
      y[0][c] = back[0] * x[1][c] + back[1] * x[2][c] + back[2] * x[3][c] + back[3] * x[4][c] - own[0] * y[1][c] -
                own[1] * y[2][c] - own[2] * y[3][c] - own[3] * y[4][c];
      lines[n * together + c] = static_cast<float>(blurred[n][c] + y[0][c]);
    }
  }
}

// Of three sites in a row the middle one is nearest to no place of the line (Maurer's RemoveEDT).
bool hides(const Site& before, const Site& middle, const Site& after) {
  const double a = middle.at_mm - before.at_mm, b = after.at_mm - middle.at_mm, c = a + b;
  return c * middle.squared_mm2 - b * before.squared_mm2 - a * after.squared_mm2 - a * b * c > 0;
}

void spread_along(float* squared_mm2, std::size_t length, double spacing_mm) {
  std::vector<Site> sites;
  std::size_t inside = 0;
  for (std::size_t n = 0; n < length; ++n) {
    const float beside_mm2 = squared_mm2[n * together];
    if (!std::isfinite(beside_mm2)) continue;
    inside += beside_mm2 == 0 ? 1U : 0U;
    const Site site{static_cast<double>(beside_mm2), spacing_mm * static_cast<double>(n)};
    while (sites.size() >= 2 && hides(sites[sites.size() - 2], sites.back(), site)) sites.pop_back();
    sites.push_back(site);
  }
  if (sites.empty() || inside == length) return;
  const auto from = [](const Site& site, double at_mm) {
    return site.squared_mm2 + (site.at_mm - at_mm) * (site.at_mm - at_mm);
  };
  std::size_t nearest = 0;
  for (std::size_t n = 0; n < length; ++n) {
    const double at_mm = spacing_mm * static_cast<double>(n);
    while (nearest + 1 < sites.size() && from(sites[nearest], at_mm) > from(sites[nearest + 1], at_mm)) ++nearest;
    squared_mm2[n * together] = static_cast<float>(from(sites[nearest], at_mm));
  }
}

}  // namespace
}  // namespace glisson::imaging
