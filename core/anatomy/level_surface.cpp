#include "anatomy/level_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"

namespace glisson::anatomy {

using Eigen::Vector3d;
using geometry::Surface;
using imaging::Grid;

namespace {

constexpr float just_inside_mm = -0.01f;

void close_border(Field& field);
void take_in_pinched_corners(Field& field);

// The points of a surface net, at the cells' lower corners.
struct Net {
  Surface surface;
  std::vector<int> point_of;  // a cell's point, or -1
};
Net points_in_crossed_cells(const Field& field);
void add_quads(const Field& field, Net& net);

bool inside(const Field& field, int i, int j, int k) { return field.at(i, j, k) < 0; }

}  // namespace

Grid grid_over(const geometry::Box& box, double spacing_mm) {
  Grid grid;
  grid.spacing_mm.setConstant(spacing_mm);
  grid.origin_mm = box.min_mm;
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil((box.max_mm[axis] - box.min_mm[axis]) / spacing_mm)) + 1;
  }
  return grid;
}

Field sampled(const Grid& grid, const std::function<double(const Vector3d&)>& distance_mm) {
  constexpr int block = 6;
  Field field{grid, std::vector<float>(grid.voxels())};
  std::array<int, 3> blocks{};
  for (std::size_t a = 0; a < 3; ++a) blocks[a] = (grid.size[a] + block - 1) / block;
  const auto count =
      static_cast<std::size_t>(blocks[0]) * static_cast<std::size_t>(blocks[1]) * static_cast<std::size_t>(blocks[2]);
  const double reach_mm = grid.spacing_mm.norm() * 0.5 * block;
  parallel_for(count, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      const int bi = static_cast<int>(b) % blocks[0], bj = static_cast<int>(b) / blocks[0] % blocks[1],
                bk = static_cast<int>(b) / blocks[0] / blocks[1];
      const Vector3d first(bi * block, bj * block, bk * block);
      const double middle = distance_mm(grid.position_mm(first + Vector3d::Constant(0.5 * (block - 1))));
      const bool far = std::abs(middle) > 2 * reach_mm + 2;
      for (int k = bk * block; k < std::min((bk + 1) * block, grid.size[2]); ++k) {
        for (int j = bj * block; j < std::min((bj + 1) * block, grid.size[1]); ++j) {
          for (int i = bi * block; i < std::min((bi + 1) * block, grid.size[0]); ++i) {
            field.at(i, j, k) = static_cast<float>(far ? middle : distance_mm(grid.position_mm(i, j, k)));
          }
        }
      }
    }
  });
  return field;
}

double interpolated(const Field& field, const Vector3d& position_mm) {
  const Grid& grid = field.grid;
  const Vector3d index = (position_mm - grid.origin_mm).cwiseQuotient(grid.spacing_mm);
  std::array<int, 3> low{};
  Vector3d t;
  for (int a = 0; a < 3; ++a) {
    const double last = grid.size[static_cast<std::size_t>(a)] - 1.001;
    const double held = std::clamp(index[a], 0.0, last);
    low[static_cast<std::size_t>(a)] = static_cast<int>(held);
    t[a] = held - std::floor(held);
  }
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    const int x = c & 1, y = (c >> 1) & 1, z = c >> 2;
    sum += (x ? t.x() : 1 - t.x()) * (y ? t.y() : 1 - t.y()) * (z ? t.z() : 1 - t.z()) *
           static_cast<double>(field.at(low[0] + x, low[1] + y, low[2] + z));
  }
  return sum;
}

Surface level_surface(Field field) {
  close_border(field);
  take_in_pinched_corners(field);
  Net net = points_in_crossed_cells(field);
  add_quads(field, net);
  return std::move(net.surface);
}

namespace {

// Two layers, so that what is taken in does not reach the border.
void close_border(Field& field) {
  const auto& size = field.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const bool border = i < 2 || j < 2 || k < 2 || i > size[0] - 3 || j > size[1] - 3 || k > size[2] - 3;
        if (border) field.at(i, j, k) = std::max(field.at(i, j, k), 0.01f);
      }
    }
  }
}

// Takes in the nearer outside corner wherever inside or outside corners of a face or a cell meet only across.
bool take_in_once(Field& field) {
  const auto& size = field.grid.size;
  bool changed = false;
  const auto take_in = [&](std::initializer_list<float*> corners) {
    float* nearest = nullptr;
    for (float* corner : corners) {
      if (*corner >= 0 && (nearest == nullptr || *corner < *nearest)) nearest = corner;
    }
    *nearest = just_inside_mm;
    changed = true;
  };
  const auto in = [](const float* value) { return *value < 0; };
  for (int k = 1; k + 1 < size[2]; ++k) {
    for (int j = 1; j + 1 < size[1]; ++j) {
      for (int i = 1; i + 1 < size[0]; ++i) {
        std::array<float*, 8> c{};
        int count = 0;
        for (int n = 0; n < 8; ++n) {
          c[static_cast<std::size_t>(n)] = &field.at(i + (n & 1), j + ((n >> 1) & 1), k + (n >> 2));
          count += in(c[static_cast<std::size_t>(n)]) ? 1 : 0;
        }
        if (count == 0 || count == 8) continue;
        for (const auto& f :
             {std::array{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 4, 5}, {2, 3, 6, 7}, {0, 2, 4, 6}, {1, 3, 5, 7}}) {
          std::array<float*, 4> face{};
          for (std::size_t n = 0; n < 4; ++n) face[n] = c[static_cast<std::size_t>(f[n])];
          if (in(face[0]) == in(face[3]) && in(face[1]) == in(face[2]) && in(face[0]) != in(face[1])) {
            take_in({face[0], face[1], face[2], face[3]});
          }
        }
        for (std::size_t n = 0; n < 4; ++n) {
          const bool two_in = count == 2 && in(c[n]) && in(c[7 - n]),
                     two_out = count == 6 && !in(c[n]) && !in(c[7 - n]);
          if (!two_in && !two_out) continue;
          take_in({c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]});
          break;
        }
      }
    }
  }
  return changed;
}

void take_in_pinched_corners(Field& field) {
  while (take_in_once(field)) {
  }
}

Net points_in_crossed_cells(const Field& field) {
  const auto& size = field.grid.size;
  Net net;
  net.point_of.assign(field.grid.voxels(), -1);
  constexpr std::array<std::array<int, 2>, 12> edges = {
      {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  for (int k = 0; k + 1 < size[2]; ++k) {
    for (int j = 0; j + 1 < size[1]; ++j) {
      for (int i = 0; i + 1 < size[0]; ++i) {
        std::array<float, 8> value{};
        for (int n = 0; n < 8; ++n) {
          value[static_cast<std::size_t>(n)] = field.at(i + (n & 1), j + ((n >> 1) & 1), k + (n >> 2));
        }
        Vector3d sum = Vector3d::Zero();
        int crossings = 0;
        for (const auto& [a, b] : edges) {
          const float va = value[static_cast<std::size_t>(a)], vb = value[static_cast<std::size_t>(b)];
          if ((va < 0) == (vb < 0)) continue;
          const double t = static_cast<double>(va) / static_cast<double>(va - vb);
          const Vector3d from(a & 1, (a >> 1) & 1, a >> 2), to(b & 1, (b >> 1) & 1, b >> 2);
          sum += from + t * (to - from);
          ++crossings;
        }
        if (crossings == 0) continue;
        net.point_of[field.grid.offset(i, j, k)] = static_cast<int>(net.surface.points_mm.size());
        net.surface.points_mm.push_back(field.grid.position_mm(Vector3d(i, j, k) + sum / crossings));
      }
    }
  }
  return net;
}

void add_quads(const Field& field, Net& net) {
  const auto& size = field.grid.size;
  const auto point = [&](int i, int j, int k) { return net.point_of[field.grid.offset(i, j, k)]; };
  const auto add = [&](std::array<int, 4> q, bool outwards) {
    if (!outwards) std::swap(q[1], q[3]);
    const auto& p = net.surface.points_mm;
    const auto at = [&](int n) { return p[static_cast<std::size_t>(q[static_cast<std::size_t>(n)])]; };
    if ((at(0) - at(2)).squaredNorm() <= (at(1) - at(3)).squaredNorm()) {
      net.surface.triangles.push_back({q[0], q[1], q[2]});
      net.surface.triangles.push_back({q[0], q[2], q[3]});
    } else {
      net.surface.triangles.push_back({q[0], q[1], q[3]});
      net.surface.triangles.push_back({q[1], q[2], q[3]});
    }
  };
  for (int k = 1; k + 1 < size[2]; ++k) {
    for (int j = 1; j + 1 < size[1]; ++j) {
      for (int i = 1; i + 1 < size[0]; ++i) {
        const bool here = inside(field, i, j, k);
        if (here != inside(field, i + 1, j, k)) {
          add({point(i, j - 1, k - 1), point(i, j, k - 1), point(i, j, k), point(i, j - 1, k)}, here);
        }
        if (here != inside(field, i, j + 1, k)) {
          add({point(i - 1, j, k - 1), point(i - 1, j, k), point(i, j, k), point(i, j, k - 1)}, here);
        }
        if (here != inside(field, i, j, k + 1)) {
          add({point(i - 1, j - 1, k), point(i, j - 1, k), point(i, j, k), point(i - 1, j, k)}, here);
        }
      }
    }
  }
}

}  // namespace
}  // namespace glisson::anatomy
