#include "mechanics/solvers/internal/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"

namespace glisson::mechanics {
namespace {

// Calls work(begin, end) for fixed ranges of the values and sums what it gives back.
template <typename Work>
double sum_over(std::size_t values, const Work& work) {
  constexpr std::size_t in_chunk = 3 * BlockCsr::rows_in_chunk;
  std::vector<double> partial((values + in_chunk - 1) / in_chunk, 0.0);
  parallel_for(partial.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      partial[chunk] = work(chunk * in_chunk, std::min((chunk + 1) * in_chunk, values));
    }
  });
  return std::accumulate(partial.begin(), partial.end(), 0.0);
}

}  // namespace

int conjugate_gradients(const BlockCsr& matrix, const std::vector<float>& mask, LatticePreconditioner& preconditioner,
                        double target_norm, int max_iterations, GradientBuffers& buffers) {
  // References and not one structured binding, which a lambda may not capture in clang before 16.
  std::vector<float>& r = buffers.residual;
  std::vector<float>& x = buffers.solution;
  std::vector<float>& p = buffers.direction;
  std::vector<float>& q = buffers.product;
  std::vector<float>& z = buffers.preconditioned;
  const std::size_t values = 3 * static_cast<std::size_t>(matrix.rows());
  std::fill(x.begin(), x.end(), 0.0F);
  double r_dot_z = preconditioner.apply(r, z);
  p = z;
  for (int iteration = 1; iteration <= max_iterations; ++iteration) {
    const double curvature = matrix.multiply(p, mask, q);
    if (!(curvature > 0)) return iteration;  // single precision has no more to give
    const auto length = static_cast<float>(r_dot_z / curvature);
    const double squared_norm = sum_over(values, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) {
        x[i] += length * p[i];
        r[i] -= length * q[i];
        sum += static_cast<double>(r[i]) * r[i];
      }
      return sum;
    });
    if (std::sqrt(squared_norm) <= target_norm) return iteration;
    const double next = preconditioner.apply(r, z);
    const auto keep = static_cast<float>(next / r_dot_z);
    r_dot_z = next;
    parallel_for(values, 3 * BlockCsr::rows_in_chunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) p[i] = z[i] + keep * p[i];
    });
  }
  return max_iterations;
}

}  // namespace glisson::mechanics
