#include "elastography/internal/unwrap_in_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "elastography/internal/fourier.h"
#include "elastography/unwrap.h"

namespace glisson::elastography {
namespace {

using imaging::Grid;
using imaging::Mask;

constexpr float whole_turn = static_cast<float>(2 * std::numbers::pi);

// Groups of voxels whose turns relative to one another are settled (union-find with a number of turns on each link).
class SettledGroups {
 public:
  explicit SettledGroups(std::size_t voxels) : parent_(voxels), turns_(voxels, 0), size_(voxels, 1) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  struct Root {
    std::uint32_t voxel;
    int turns;  // that the voxel has against its group's root
  };
  Root find(std::uint32_t voxel) {
    std::uint32_t root = voxel;
    int turns = 0;
    while (parent_[root] != root) {
      turns += turns_[root];
      root = parent_[root];
    }
    int rest = turns;
    while (parent_[voxel] != root && voxel != root) {
      const std::uint32_t next = parent_[voxel];
      const int own = turns_[voxel];
      parent_[voxel] = root;
      turns_[voxel] = rest;
      rest -= own;
      voxel = next;
    }
    return {root, turns};
  }
  // Joins two groups so that b has `turns` more than a.
  void join(const Root& a, const Root& b, int turns) {
    const int between = a.turns + turns - b.turns;  // of b's root against a's
    if (size_[a.voxel] >= size_[b.voxel]) {
      parent_[b.voxel] = a.voxel;
      turns_[b.voxel] = between;
      size_[a.voxel] += size_[b.voxel];
    } else {
      parent_[a.voxel] = b.voxel;
      turns_[a.voxel] = -between;
      size_[b.voxel] += size_[a.voxel];
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<int> turns_;
  std::vector<std::uint32_t> size_;
};

struct Link {
  float unreliability;
  std::uint32_t a, b;
};

template <typename Visit>
void for_each_voxel(const Grid& grid, Visit visit) {
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) visit(i, j, k, grid.offset(i, j, k));
    }
  }
}

std::array<std::size_t, 3> strides(const Grid& grid) {
  return {1, static_cast<std::size_t>(grid.size[0]),
          static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1])};
}

// The sum of squares of the second differences along the axes; large where a neighbour is missing, so that paths begin
// inside.
std::vector<float> unreliability(const std::vector<float>& phase_rad, const Mask& signal) {
  const auto stride = strides(signal.grid);
  std::vector<float> found(phase_rad.size(), 0);
  for_each_voxel(signal.grid, [&](int i, int j, int k, std::size_t v) {
    if (signal.values[v] == 0) return;
    const std::array<int, 3> at{i, j, k};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (signal.grid.size[axis] < 3) continue;
      const bool inside = at[axis] > 0 && at[axis] + 1 < signal.grid.size[axis] &&
                          signal.values[v - stride[axis]] != 0 && signal.values[v + stride[axis]] != 0;
      if (!inside) {
        found[v] += whole_turn;
        continue;
      }
      const float second =
          wrapped(phase_rad[v - stride[axis]] - phase_rad[v]) - wrapped(phase_rad[v] - phase_rad[v + stride[axis]]);
      found[v] += second * second;
    }
  });
  return found;
}

// Shifts each group by whole turns so that its median lies in [-pi, pi].
void centre_groups(std::vector<float>& phase_rad, const Mask& signal, SettledGroups& groups) {
  std::vector<std::pair<std::uint32_t, float>> by_group;
  for (std::size_t v = 0; v < phase_rad.size(); ++v) {
    if (signal.values[v] != 0) by_group.emplace_back(groups.find(static_cast<std::uint32_t>(v)).voxel, phase_rad[v]);
  }
  std::sort(by_group.begin(), by_group.end());
  std::vector<float> shift_of(phase_rad.size(), 0);
  for (std::size_t begin = 0; begin < by_group.size();) {
    std::size_t end = begin;
    while (end < by_group.size() && by_group[end].first == by_group[begin].first) ++end;
    shift_of[by_group[begin].first] = whole_turn * std::round(by_group[(begin + end) / 2].second / whole_turn);
    begin = end;
  }
  for (std::size_t v = 0; v < phase_rad.size(); ++v) {
    if (signal.values[v] != 0) phase_rad[v] -= shift_of[groups.find(static_cast<std::uint32_t>(v)).voxel];
  }
}

std::vector<Link> links_of(const Mask& signal, const std::vector<float>& unreliable) {
  const auto stride = strides(signal.grid);
  std::vector<Link> links;
  links.reserve(2 * unreliable.size());
  for_each_voxel(signal.grid, [&](int i, int j, int k, std::size_t v) {
    const std::array<int, 3> at{i, j, k};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (at[axis] + 1 >= signal.grid.size[axis]) continue;
      const std::size_t w = v + stride[axis];
      if (signal.values[v] == 0 || signal.values[w] == 0) continue;
      links.push_back({unreliable[v] + unreliable[w], static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(w)});
    }
  });
  return links;
}

// Solves laplacian(solution) = what it holds, in each slice, with no flow through the edges; its mean comes out as
// zero.
void solve_poisson(std::vector<float>& solution, const Grid& grid) {
  const CosineTransform transform({grid.size[0], grid.size[1], 1});
  const auto size = static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
  std::vector<float> slice(size);
  for (std::size_t start = 0; start < solution.size(); start += size) {
    std::copy_n(solution.begin() + static_cast<std::ptrdiff_t>(start), size, slice.begin());
    transform.forward(slice);
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const double eigenvalue =
            2 * std::cos(std::numbers::pi * i / grid.size[0]) + 2 * std::cos(std::numbers::pi * j / grid.size[1]) - 4;
        float& value = slice[grid.offset(i, j, 0)];
        value = i == 0 && j == 0 ? 0.0F : value / static_cast<float>(eigenvalue);
      }
    }
    transform.inverse(slice);
    std::copy_n(slice.begin(), size, solution.begin() + static_cast<std::ptrdiff_t>(start));
  }
}

}  // namespace

void unwrap_along_reliable_paths(std::vector<float>& phase_rad, const Mask& signal) {
  const std::vector<float> unreliable = unreliability(phase_rad, signal);
  std::vector<Link> links = links_of(signal, unreliable);
  std::sort(links.begin(), links.end(), [](const Link& x, const Link& y) {
    return std::tie(x.unreliability, x.a, x.b) < std::tie(y.unreliability, y.a, y.b);
  });
  SettledGroups groups(phase_rad.size());
  for (const Link& link : links) {
    const auto a = groups.find(link.a);
    const auto b = groups.find(link.b);
    if (a.voxel == b.voxel) continue;
    groups.join(a, b, static_cast<int>(std::lround((phase_rad[link.a] - phase_rad[link.b]) / whole_turn)));
  }
  for (std::size_t v = 0; v < phase_rad.size(); ++v) {
    if (signal.values[v] != 0) {
      phase_rad[v] += whole_turn * static_cast<float>(groups.find(static_cast<std::uint32_t>(v)).turns);
    }
  }
  centre_groups(phase_rad, signal, groups);
}

void unwrap_by_poisson(std::vector<float>& phase_rad, const Mask& signal) {
  SettledGroups groups(phase_rad.size());  // here only the connected pieces of the mask
  std::vector<float> solution(phase_rad.size(), 0);
  for (const Link& link : links_of(signal, std::vector<float>(phase_rad.size(), 0))) {
    const float step = wrapped(phase_rad[link.b] - phase_rad[link.a]);
    solution[link.a] += step;
    solution[link.b] -= step;
    const auto a = groups.find(link.a);
    const auto b = groups.find(link.b);
    if (a.voxel != b.voxel) groups.join(a, b, 0);
  }
  solve_poisson(solution, signal.grid);

  // The solution is right up to a constant of each piece; the circular mean of what is left over gives that constant.
  std::vector<std::array<double, 2>> left_over(phase_rad.size(), {0, 0});
  for (std::size_t v = 0; v < phase_rad.size(); ++v) {
    if (signal.values[v] == 0) continue;
    auto& sum = left_over[groups.find(static_cast<std::uint32_t>(v)).voxel];
    sum[0] += std::cos(phase_rad[v] - solution[v]);
    sum[1] += std::sin(phase_rad[v] - solution[v]);
  }
  for (std::size_t v = 0; v < phase_rad.size(); ++v) {
    if (signal.values[v] == 0) continue;
    const auto& sum = left_over[groups.find(static_cast<std::uint32_t>(v)).voxel];
    const float wanted = solution[v] + static_cast<float>(std::atan2(sum[1], sum[0]));
    phase_rad[v] += whole_turn * std::round((wanted - phase_rad[v]) / whole_turn);
  }
  centre_groups(phase_rad, signal, groups);
}

}  // namespace glisson::elastography
