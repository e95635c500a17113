// Steps of gradient descent in u and ascent in the border's direction, where a voxel may be either.

#include "segmentation/internal/relaxed_cut.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"

namespace glisson::segmentation {
namespace {

// Voxels begin..end of one row.
struct Run {
  std::size_t begin, end;
  std::array<bool, 3> has_next;  // whether the row has a neighbour along j and k, and the run's last voxel along i
};

std::vector<Run> runs_of(const imaging::Grid& grid, const std::vector<std::uint8_t>& wanted);

// Those that may be either, and those that a forward difference to or from one of them belongs to.
std::vector<std::uint8_t> free_voxels(const std::vector<VoxelSide>& sides);
std::vector<std::uint8_t> with_neighbours_before(std::vector<std::uint8_t> wanted, const imaging::Grid& grid);

struct State {
  std::vector<float> u, ahead;              // u, and u carried on by its last step
  std::array<std::vector<float>, 3> along;  // the dual: at most as long as 1
  std::array<float, 3> per_voxel;           // the smallest spacing over the axis's own
  std::array<std::size_t, 3> stride;        // to the next voxel
  std::vector<float> cost;                  // of a voxel, in units of the smallest spacing
  float step;                               // of both; its square times the operator's norm is below 1
};

void ascend(State& state, const std::vector<Run>& runs);
void descend(State& state, const std::vector<Run>& runs);

}  // namespace

std::vector<float> relaxed_cut(const imaging::Grid& grid, const std::vector<float>& cost_per_mm,
                               const std::vector<VoxelSide>& sides, const RelaxedCutOptions& options) {
  const std::vector<std::uint8_t> free = free_voxels(sides);
  const std::vector<Run> primal = runs_of(grid, free), dual = runs_of(grid, with_neighbours_before(free, grid));
  State state;
  const double smallest_mm = grid.spacing_mm.minCoeff();
  double norm = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double weight = smallest_mm / grid.spacing_mm[static_cast<Eigen::Index>(axis)];
    state.per_voxel[axis] = static_cast<float>(weight);
    state.along[axis].assign(sides.size(), 0.0F);
    norm += 4 * weight * weight;
  }
  state.step = static_cast<float>(1 / std::sqrt(norm));
  state.stride = {1, static_cast<std::size_t>(grid.size[0]),
                  static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1])};
  state.cost.resize(sides.size());
  state.u.resize(sides.size());
  for (std::size_t voxel = 0; voxel < sides.size(); ++voxel) {
    state.cost[voxel] = cost_per_mm[voxel] * static_cast<float>(smallest_mm);
    state.u[voxel] =
        sides[voxel] == VoxelSide::inside || (sides[voxel] == VoxelSide::either && cost_per_mm[voxel] < 0) ? 1 : 0;
  }
  state.ahead = state.u;

  std::vector<std::uint8_t> inside(sides.size());
  std::size_t count = 0;
  for (const Run& run : primal) count += run.end - run.begin;
  const auto few = static_cast<std::size_t>(options.settled_share * static_cast<double>(count));
  for (int iteration = 1; iteration <= options.maximum_iterations; ++iteration) {
    ascend(state, dual);
    descend(state, primal);
    if (iteration % options.check_every != 0) continue;
    std::size_t changed = 0;
    for (const Run& run : primal) {
      for (std::size_t voxel = run.begin; voxel < run.end; ++voxel) {
        const std::uint8_t now = state.u[voxel] >= 0.5F ? 1 : 0;
        changed += now != inside[voxel] ? 1U : 0U;
        inside[voxel] = now;
      }
    }
    if (iteration > options.check_every && changed <= few) break;
  }
  return std::move(state.u);
}

namespace {

std::vector<std::uint8_t> free_voxels(const std::vector<VoxelSide>& sides) {
  std::vector<std::uint8_t> free(sides.size());
  for (std::size_t voxel = 0; voxel < sides.size(); ++voxel) free[voxel] = sides[voxel] == VoxelSide::either ? 1 : 0;
  return free;
}

std::vector<std::uint8_t> with_neighbours_before(std::vector<std::uint8_t> wanted, const imaging::Grid& grid) {
  const std::vector<std::uint8_t> free = wanted;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (free[grid.offset(i, j, k)] == 0) continue;
        if (i > 0) wanted[grid.offset(i - 1, j, k)] = 1;
        if (j > 0) wanted[grid.offset(i, j - 1, k)] = 1;
        if (k > 0) wanted[grid.offset(i, j, k - 1)] = 1;
      }
    }
  }
  return wanted;
}

std::vector<Run> runs_of(const imaging::Grid& grid, const std::vector<std::uint8_t>& wanted) {
  std::vector<Run> runs;
  const auto length = static_cast<std::size_t>(grid.size[0]);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      const std::size_t row = grid.offset(0, j, k);
      for (std::size_t i = 0; i < length; ++i) {
        if (wanted[row + i] == 0) continue;
        std::size_t end = i;
        while (end < length && wanted[row + end] != 0) ++end;
        runs.push_back({row + i, row + end, {end < length, j + 1 < grid.size[1], k + 1 < grid.size[2]}});
        i = end;
      }
    }
  }
  return runs;
}

constexpr std::size_t runs_at_once = 512;

void ascend(State& state, const std::vector<Run>& runs) {
  parallel_for(runs.size(), runs_at_once, [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n < last; ++n) {
      const Run& run = runs[n];
      // Across the image's border the difference is 0: the neighbour is the voxel itself.
      const std::size_t next_j = run.has_next[1] ? state.stride[1] : 0, next_k = run.has_next[2] ? state.stride[2] : 0;
      for (std::size_t voxel = run.begin; voxel < run.end; ++voxel) {
        const std::size_t next_i = voxel + 1 < run.end || run.has_next[0] ? 1 : 0;
        const float here = state.ahead[voxel];
        const float x = state.along[0][voxel] + state.step * state.per_voxel[0] * (state.ahead[voxel + next_i] - here);
        const float y = state.along[1][voxel] + state.step * state.per_voxel[1] * (state.ahead[voxel + next_j] - here);
        const float z = state.along[2][voxel] + state.step * state.per_voxel[2] * (state.ahead[voxel + next_k] - here);
        const float shorter = 1 / std::max(1.0F, std::sqrt(x * x + y * y + z * z));
        state.along[0][voxel] = x * shorter;
        state.along[1][voxel] = y * shorter;
        state.along[2][voxel] = z * shorter;
      }
    }
  });
}

void descend(State& state, const std::vector<Run>& runs) {
  const std::size_t row = state.stride[1], layer = state.stride[2];
  parallel_for(runs.size(), runs_at_once, [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n < last; ++n) {
      const Run& run = runs[n];
      const bool has_row_before = run.begin % layer >= row, has_layer_before = run.begin >= layer;
      for (std::size_t voxel = run.begin; voxel < run.end; ++voxel) {
        const float before_i = voxel % row > 0 ? state.along[0][voxel - 1] : 0.0F;
        const float before_j = has_row_before ? state.along[1][voxel - row] : 0.0F;
        const float before_k = has_layer_before ? state.along[2][voxel - layer] : 0.0F;
        const float divergence = state.per_voxel[0] * (state.along[0][voxel] - before_i) +
                                 state.per_voxel[1] * (state.along[1][voxel] - before_j) +
                                 state.per_voxel[2] * (state.along[2][voxel] - before_k);
        const float now = std::clamp(state.u[voxel] + state.step * (divergence - state.cost[voxel]), 0.0F, 1.0F);
        state.ahead[voxel] = 2 * now - state.u[voxel];
        state.u[voxel] = now;
      }
    }
  });
}

}  // namespace
}  // namespace glisson::segmentation
