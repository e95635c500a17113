// Scan conversion of a closed surface: parity of crossings along the rows of voxels.

#include "segmentation/rasterise.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "base/result.h"

namespace glisson::segmentation {
namespace {

constexpr double steps_per_voxel = 1024;
constexpr double farthest_voxel = 1 << 19;  // so that the products below stay within 63 bits

// One voxel's answer from the rows along one axis.
enum Answer : std::uint8_t { outside = 0, inside = 1, unknown = 2 };

struct Answers {
  std::vector<std::uint8_t> of_voxel;  // in the order of the grid's voxels
  bool some_unknown = false;
};

// A point as the rows along one axis see it: how far along the row, and where across it in whole steps.
struct RowPoint {
  double along_voxels;
  std::int64_t u, v;
};

// The grid with its axes turned so that rows run along the first.
struct RowFrame {
  int along, across_u, across_v;
  std::array<int, 3> size;  // along, across_u, across_v
};

RowFrame rows_along(int axis, const imaging::Grid& grid);
std::vector<RowPoint> points_in(const RowFrame& frame, const geometry::Surface& surface, const imaging::Grid& grid);
Answers answers_along(int axis, const geometry::Surface& surface, const imaging::Grid& grid);
void flip_crossed_rows(const std::array<RowPoint, 3>& triangle, const std::array<int, 3>& names, int v,
                       const RowFrame& frame, std::vector<std::uint8_t>& flips);
bool majority_is_inside(const std::array<std::uint8_t, 3>& answers);

}  // namespace

imaging::Mask rasterise(const geometry::Surface& closed, const imaging::Grid& grid) {
  imaging::Mask mask{grid, {}};
  Answers along_i = answers_along(0, closed, grid);
  mask.values = std::move(along_i.of_voxel);
  if (!along_i.some_unknown) return mask;

  const Answers along_j = answers_along(1, closed, grid);
  const Answers along_k = answers_along(2, closed, grid);
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    mask.values[voxel] =
        majority_is_inside({mask.values[voxel], along_j.of_voxel[voxel], along_k.of_voxel[voxel]}) ? 1 : 0;
  }
  return mask;
}

namespace {

Answers answers_along(int axis, const geometry::Surface& surface, const imaging::Grid& grid) {
  const RowFrame frame = rows_along(axis, grid);
  const std::vector<RowPoint> points = points_in(frame, surface, grid);
  const auto row_length = static_cast<std::size_t>(frame.size[0]);
  const auto rows_in_slice = static_cast<std::size_t>(frame.size[1]);
  const std::array<std::size_t, 3> stride{
      1, static_cast<std::size_t>(grid.size[0]),
      static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1])};
  Answers answers{std::vector<std::uint8_t>(grid.voxels()), false};
  std::atomic<bool> some_unknown{false};

  // The triangles that meet each slice of rows.
  std::vector<std::vector<std::size_t>> triangles_at(static_cast<std::size_t>(frame.size[2]));
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto [a, b, c] = surface.triangles[t];
    const auto [low, high] = std::minmax({points[static_cast<std::size_t>(a)].v, points[static_cast<std::size_t>(b)].v,
                                          points[static_cast<std::size_t>(c)].v});
    const double first = std::max(0.0, std::ceil(static_cast<double>(low) / steps_per_voxel));
    const double last = std::min(frame.size[2] - 1.0, std::floor(static_cast<double>(high) / steps_per_voxel));
    for (double v = first; v <= last; ++v) triangles_at[static_cast<std::size_t>(v)].push_back(t);
  }

  parallel_for(triangles_at.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint8_t> flips;  // one place more than voxels in each row, for crossings beyond its end
    for (std::size_t v = begin; v < end; ++v) {
      flips.assign((row_length + 1) * rows_in_slice, 0);
      for (const std::size_t t : triangles_at[v]) {
        const std::array<int, 3>& names = surface.triangles[t];
        flip_crossed_rows({points[static_cast<std::size_t>(names[0])], points[static_cast<std::size_t>(names[1])],
                           points[static_cast<std::size_t>(names[2])]},
                          names, static_cast<int>(v), frame, flips);
      }
      for (std::size_t u = 0; u < rows_in_slice; ++u) {
        const std::uint8_t* row = &flips[u * (row_length + 1)];
        std::uint8_t crossings = 0;
        for (std::size_t i = 0; i <= row_length; ++i) crossings ^= row[i];
        const bool leaks = crossings != 0;
        if (leaks) some_unknown = true;
        std::uint8_t state = outside;
        std::size_t voxel =
            u * stride[static_cast<std::size_t>(frame.across_u)] + v * stride[static_cast<std::size_t>(frame.across_v)];
        for (std::size_t i = 0; i < row_length; ++i, voxel += stride[static_cast<std::size_t>(frame.along)]) {
          state ^= row[i];
          answers.of_voxel[voxel] = leaks ? std::uint8_t{unknown} : state;
        }
      }
    }
  });
  answers.some_unknown = some_unknown;
  return answers;
}

RowFrame rows_along(int axis, const imaging::Grid& grid) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  return {axis,
          u,
          v,
          {grid.size[static_cast<std::size_t>(axis)], grid.size[static_cast<std::size_t>(u)],
           grid.size[static_cast<std::size_t>(v)]}};
}

std::vector<RowPoint> points_in(const RowFrame& frame, const geometry::Surface& surface, const imaging::Grid& grid) {
  const auto in_steps = [](double voxels) {
    return static_cast<std::int64_t>(
        std::llround(std::clamp(voxels, -farthest_voxel, farthest_voxel) * steps_per_voxel));
  };
  const Eigen::Matrix3d index_from_mm =
      grid.spacing_mm.cwiseInverse().asDiagonal() * Eigen::Matrix3d(grid.direction.inverse());
  std::vector<RowPoint> points(surface.points_mm.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Eigen::Vector3d index = index_from_mm * (surface.points_mm[p] - grid.origin_mm);
    points[p] = {index[frame.along], in_steps(index[frame.across_u]), in_steps(index[frame.across_v])};
  }
  return points;
}

// Twice the signed area of (a, b, row), exact. Where the row meets the line of the edge, the row is thought of as moved
// by an infinitely small step along u and a yet smaller one along v, so that the answer is never zero for a proper
// edge and two triangles at an edge, or all those at a vertex, agree about it (simulation of simplicity, Edelsbrunner
// and Muecke 1990).
struct Side {
  std::int64_t doubled_area;
  int sign;
};
Side side_of_edge(const RowPoint& a, const RowPoint& b, std::int64_t u, std::int64_t v) {
  const std::int64_t area = (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
  const auto sign_of = [](std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
  if (area != 0) return {area, sign_of(area)};
  if (a.v != b.v) return {0, sign_of(a.v - b.v)};
  return {0, sign_of(b.u - a.u)};
}

void flip_crossed_rows(const std::array<RowPoint, 3>& triangle, const std::array<int, 3>& names, int v,
                       const RowFrame& frame, std::vector<std::uint8_t>& flips) {
  if (names[0] == names[1] || names[1] == names[2] || names[2] == names[0]) return;
  const auto& [a, b, c] = triangle;
  const auto [low, high] = std::minmax({a.u, b.u, c.u});
  const double first = std::max(0.0, std::ceil(static_cast<double>(low) / steps_per_voxel));
  const double last = std::min(frame.size[1] - 1.0, std::floor(static_cast<double>(high) / steps_per_voxel));
  const auto v_steps = static_cast<std::int64_t>(v) * static_cast<std::int64_t>(steps_per_voxel);
  const std::size_t places = static_cast<std::size_t>(frame.size[0]) + 1;

  for (double row = first; row <= last; ++row) {
    const auto u_steps = static_cast<std::int64_t>(row * steps_per_voxel);
    const Side at_c = side_of_edge(a, b, u_steps, v_steps);
    const Side at_a = side_of_edge(b, c, u_steps, v_steps);
    const Side at_b = side_of_edge(c, a, u_steps, v_steps);
    if (at_c.sign == 0 || at_c.sign != at_a.sign || at_a.sign != at_b.sign) continue;

    const auto weight_a = static_cast<double>(at_a.doubled_area);
    const auto weight_b = static_cast<double>(at_b.doubled_area);
    const auto weight_c = static_cast<double>(at_c.doubled_area);
    const double crossing = (weight_a * a.along_voxels + weight_b * b.along_voxels + weight_c * c.along_voxels) /
                            (weight_a + weight_b + weight_c);
    const double first_beyond = std::clamp(std::ceil(crossing), 0.0, static_cast<double>(frame.size[0]));
    flips[static_cast<std::size_t>(row) * places + static_cast<std::size_t>(first_beyond)] ^= 1;
  }
}

bool majority_is_inside(const std::array<std::uint8_t, 3>& answers) {
  int balance = 0;
  for (const std::uint8_t answer : answers) {
    if (answer != unknown) balance += answer == inside ? 1 : -1;
  }
  return balance > 0;
}

}  // namespace
}  // namespace glisson::segmentation
