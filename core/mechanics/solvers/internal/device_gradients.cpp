#include "mechanics/solvers/internal/device_gradients.h"

#include <algorithm>
#include <cmath>

namespace glisson::mechanics {
namespace {

// A row's blocks lie one after the other, columns first: 27 of 32 items read three blocks together, neighbours beside
// neighbours. Scalars: 0 p.q, 1 r.z, 2 r.z before, 3 r.r.
constexpr const char* gradients_source = R"(
#define LANES 32
#define ROWS 4
#define GROUP 128

float sum_of_group(float mine, __local float* seen) {
  const int lane = get_local_id(0);
  barrier(CLK_LOCAL_MEM_FENCE);
  seen[lane] = mine;
  for (int half_of_them = GROUP / 2; half_of_them > 0; half_of_them /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (lane < half_of_them) seen[lane] += seen[lane + half_of_them];
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  return seen[0];
}

// 1 / the diagonal blocks, columns first; nothing where a node is held.
__kernel void invert_diagonal(__global const int* starts, __global const int* columns, __global const float* values,
                              __global float* inverse, const int rows) {
  const int row = get_global_id(0);
  if (row >= rows) return;
  __global const float* a = values;
  for (int at = starts[row]; at < starts[row + 1]; ++at) {
    if (columns[at] == row) a = values + (size_t)9 * at;
  }
  const float c0 = a[4] * a[8] - a[7] * a[5], c1 = a[7] * a[2] - a[1] * a[8], c2 = a[1] * a[5] - a[4] * a[2];
  const float determinant = a[0] * c0 + a[3] * c1 + a[6] * c2;
  const float scale = determinant != 0.0f ? 1.0f / determinant : 0.0f;
  __global float* b = inverse + (size_t)9 * row;
  b[0] = scale * c0;
  b[1] = scale * c1;
  b[2] = scale * c2;
  b[3] = scale * (a[6] * a[5] - a[3] * a[8]);
  b[4] = scale * (a[0] * a[8] - a[6] * a[2]);
  b[5] = scale * (a[3] * a[2] - a[0] * a[5]);
  b[6] = scale * (a[3] * a[7] - a[6] * a[4]);
  b[7] = scale * (a[6] * a[1] - a[0] * a[7]);
  b[8] = scale * (a[0] * a[4] - a[3] * a[1]);
}

// q = mask * (A p), and p.q of each group.
__kernel void multiply(__global const int* starts, __global const int* columns, __global const float* values,
                       __global const float* mask, __global const float* p, __global float* q,
                       __global float* partial, const int rows, __local float* seen) {
  const int lane = get_local_id(0) % LANES;
  const int row = get_group_id(0) * ROWS + get_local_id(0) / LANES;
  float sum = 0.0f;
  if (row < rows && lane < 27) {
    const int end = starts[row + 1];
    for (int at = starts[row] + lane / 9; at < end; at += 3)
      sum += values[(size_t)9 * at + lane % 9] * p[3 * columns[at] + lane % 9 / 3];
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  seen[get_local_id(0)] = sum;
  barrier(CLK_LOCAL_MEM_FENCE);
  float product = 0.0f;
  if (row < rows && lane < 3) {
    float total = 0.0f;
    for (int other = lane; other < 27; other += 3) total += seen[get_local_id(0) - lane + other];
    total *= mask[3 * row + lane];
    q[3 * row + lane] = total;
    product = total * p[3 * row + lane];
  }
  product = sum_of_group(product, seen);
  if (get_local_id(0) == 0) partial[get_group_id(0)] = product;
}

// The sum of what each group found, by one group.
__kernel void add_up(__global const float* partial, const int count, __global float* scalars, const int place,
                     __local float* seen) {
  float sum = 0.0f;
  for (int i = get_local_id(0); i < count; i += GROUP) sum += partial[i];
  sum = sum_of_group(sum, seen);
  if (get_local_id(0) == 0) {
    if (place == 1) scalars[2] = scalars[1];
    scalars[place] = sum;
  }
}

// x += a p, r -= a q with a = r.z / p.q (nothing at first); z = D^-1 r; r.z and r.r of each group.
__kernel void advance(__global float* x, __global float* r, __global float* z, __global const float* p,
                      __global const float* q, __global const float* inverse, __global const float* mask,
                      __global const float* scalars, __global float* partial, const int rows, const int first,
                      const int groups, __local float* seen) {
  const int row = get_global_id(0);
  float r_dot_z = 0.0f, r_dot_r = 0.0f;
  if (row < rows) {
    const float length = first || !(scalars[0] > 0.0f) ? 0.0f : scalars[1] / scalars[0];
    float now[3];
    for (int d = 0; d < 3; ++d) {
      const int i = 3 * row + d;
      if (!first) {
        x[i] += length * p[i];
        r[i] -= length * q[i];
      }
      now[d] = r[i];
      r_dot_r += now[d] * now[d];
    }
    __global const float* b = inverse + (size_t)9 * row;
    for (int d = 0; d < 3; ++d) {
      const float value = mask[3 * row + d] * (b[d] * now[0] + b[3 + d] * now[1] + b[6 + d] * now[2]);
      z[3 * row + d] = value;
      r_dot_z += now[d] * value;
    }
  }
  r_dot_z = sum_of_group(r_dot_z, seen);
  r_dot_r = sum_of_group(r_dot_r, seen);
  if (get_local_id(0) == 0) {
    partial[get_group_id(0)] = r_dot_z;
    partial[groups + get_group_id(0)] = r_dot_r;
  }
}

// p = z + k p with k = r.z / r.z before (p = z at first).
__kernel void turn(__global float* p, __global const float* z, __global const float* scalars, const int values,
                   const int first) {
  const int i = get_global_id(0);
  if (i >= values) return;
  const float keep = first || !(scalars[2] > 0.0f) ? 0.0f : scalars[1] / scalars[2];
  p[i] = z[i] + keep * p[i];
})";
constexpr std::size_t items_in_group = 128;
constexpr std::size_t rows_of_group = 4;

std::vector<std::int32_t> starts_of(const BlockCsr& matrix) {
  const auto& starts = matrix.columns().starts;
  return {starts.begin(), starts.end()};
}

}  // namespace

Result<DeviceGradients> DeviceGradients::open(const BlockCsr& matrix, const std::vector<float>& mask,
                                              const std::string& device_name) {
  auto session = opencl::Session::open(gradients_source, device_name);
  if (!session) return failure(session.error());
  DeviceGradients gradients(matrix, mask, std::move(*session));
  if (auto ready = gradients.session_.finish(); !ready) return failure(ready.error());
  return gradients;
}

DeviceGradients::DeviceGradients(const BlockCsr& matrix, const std::vector<float>& mask, opencl::Session session)
    : session_(std::move(session)), rows_(matrix.rows()) {
  const auto rows = static_cast<std::size_t>(rows_);
  starts_ = session_.buffer_of(starts_of(matrix));
  columns_ = session_.buffer_of(matrix.columns().items);
  mask_ = session_.buffer_of(mask);
  values_ = session_.buffer(sizeof(float) * matrix.values().size());
  inverse_diagonal_ = session_.buffer(sizeof(float) * 9 * rows);
  for (opencl::Buffer* vector : {&r_, &x_, &p_, &q_, &z_}) *vector = session_.buffer(sizeof(float) * 3 * rows);
  partial_ = session_.buffer(sizeof(float) * std::max(rows / rows_of_group + 1, 2 * (rows / items_in_group + 1)));
  scalars_ = session_.buffer(sizeof(float) * 4);
}

Result<int> DeviceGradients::solve(const BlockCsr& matrix, double target_norm, int max_iterations,
                                   GradientBuffers& buffers) {
  const auto rows = static_cast<std::size_t>(rows_);
  GLISSON_ASSERT(matrix.rows() == rows_);
  const std::size_t bytes = sizeof(float) * 3 * rows;
  const opencl::LocalBytes seen{sizeof(float) * items_in_group};
  const opencl::Range by_rows{opencl::whole_groups(rows, items_in_group), items_in_group};
  const opencl::Range by_values{opencl::whole_groups(3 * rows, items_in_group), items_in_group};
  const std::size_t product_groups = (rows + rows_of_group - 1) / rows_of_group;
  const auto row_groups = static_cast<std::int32_t>(by_rows.items / items_in_group);
  const std::int32_t values = 3 * rows_;

  session_.write(values_, matrix.values().data(), sizeof(float) * matrix.values().size());
  session_.write(r_, buffers.residual.data(), bytes);
  std::fill(buffers.solution.begin(), buffers.solution.end(), 0.0F);
  session_.write(x_, buffers.solution.data(), bytes);
  session_.run("invert_diagonal", by_rows, {&starts_, &columns_, &values_, &inverse_diagonal_, rows_});
  const auto advance = [&](bool first) {
    session_.run("advance", by_rows,
                 {&x_, &r_, &z_, &p_, &q_, &inverse_diagonal_, &mask_, &scalars_, &partial_, rows_, std::int32_t{first},
                  row_groups, seen});
    session_.run("add_up", {items_in_group, items_in_group}, {&partial_, row_groups, &scalars_, std::int32_t{1}, seen});
    session_.run("turn", by_values, {&p_, &z_, &scalars_, values, std::int32_t{first}});
  };
  advance(true);
  int iteration = 0;
  while (iteration < max_iterations) {
    const int until = std::min(iteration + iterations_between_looks, max_iterations);
    for (; iteration < until; ++iteration) {
      session_.run("multiply", {items_in_group * product_groups, items_in_group},
                   {&starts_, &columns_, &values_, &mask_, &p_, &q_, &partial_, rows_, seen});
      session_.run("add_up", {items_in_group, items_in_group},
                   {&partial_, static_cast<std::int32_t>(product_groups), &scalars_, std::int32_t{0}, seen});
      advance(false);
    }
    // r.r lies behind r.z.
    std::vector<float> partial(2 * static_cast<std::size_t>(row_groups));
    float scalars[4] = {};
    session_.read(partial_, partial.data(), sizeof(float) * partial.size());
    session_.read(scalars_, scalars, sizeof scalars);
    double squared_norm = 0;
    for (std::size_t i = partial.size() / 2; i < partial.size(); ++i) squared_norm += partial[i];
    if (auto done = session_.finish(); !done) return failure(done.error());
    // At or below zero, single precision has no more to give.
    if (std::sqrt(squared_norm) <= target_norm || !(scalars[0] > 0)) break;
  }
  session_.read(x_, buffers.solution.data(), bytes);
  if (auto done = session_.finish(); !done) return failure(done.error());
  return iteration;
}

}  // namespace glisson::mechanics
