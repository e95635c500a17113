// Separable convolution, axis by axis.

#include "imaging/gaussian_blur.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"

namespace glisson::imaging {
namespace {

// The weights of the voxels 0, 1, 2, ... to either side; together they sum to one.
std::vector<float> half_kernel(double sd_voxels, int longest) {
  std::vector<double> weights{1.0};
  double sum = 1.0;
  for (int step = 1; step <= std::min<double>(std::ceil(3.0 * sd_voxels), longest); ++step) {
    weights.push_back(std::exp(-0.5 * step * step / (sd_voxels * sd_voxels)));
    sum += 2.0 * weights.back();
  }
  std::vector<float> kernel(weights.size());
  std::transform(weights.begin(), weights.end(), kernel.begin(),
                 [&](double weight) { return static_cast<float>(weight / sum); });
  return kernel;
}

// out += weight * in
void add_scaled(const float* in, float weight, float* out, std::size_t count) {
  for (std::size_t n = 0; n < count; ++n) out[n] += weight * in[n];
}

void blur_along(std::size_t axis, const Grid& grid, double sd_mm, const std::vector<float>& in,
                std::vector<float>& out) {
  const std::array<std::size_t, 3> size{static_cast<std::size_t>(grid.size[0]), static_cast<std::size_t>(grid.size[1]),
                                        static_cast<std::size_t>(grid.size[2])};
  const std::vector<float> kernel =
      half_kernel(sd_mm / grid.spacing_mm[static_cast<Eigen::Index>(axis)], grid.size[axis] - 1);
  const std::size_t row = size[0];
  const std::size_t stride = axis == 0 ? 1 : axis == 1 ? row : row * size[1];

  // One row along i at a time: its neighbours along the axis are whole rows, or itself moved along.
  parallel_for(size[1] * size[2], 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      float* to = &out[r * row];
      const float* from = &in[r * row];
      std::fill(to, to + row, 0.0F);
      add_scaled(from, kernel[0], to, row);
      const std::size_t place = axis == 1 ? r % size[1] : r / size[1];
      for (std::size_t step = 1; step < kernel.size(); ++step) {
        if (axis == 0) {
          add_scaled(from, kernel[step], to + step, row - step);
          add_scaled(from + step, kernel[step], to, row - step);
        } else {
          if (place >= step) add_scaled(from - step * stride, kernel[step], to, row);
          if (place + step < size[axis]) add_scaled(from + step * stride, kernel[step], to, row);
        }
      }
    }
  });
}

}  // namespace

std::vector<float> gaussian_blur(std::vector<float> values, const Grid& grid, double sd_mm) {
  std::vector<float> blurred(values.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (sd_mm < 0.1 * grid.spacing_mm[static_cast<Eigen::Index>(axis)]) continue;
    blur_along(axis, grid, sd_mm, values, blurred);
    values.swap(blurred);
  }
  return values;
}

}  // namespace glisson::imaging
