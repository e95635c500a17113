// Edits of a mask.

#include "segmentation/edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <optional>

#include "base/parallel.h"
#include "base/units.h"
#include "segmentation/grid_part.h"
#include "segmentation/structures.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using imaging::Grid;
using imaging::Mask;

void set_in_ball(Mask& mask, const Ball& ball, std::uint8_t value);
void set_within(Mask& mask, const Mask& target, double distance_mm, std::uint8_t value);
Mask inverse_of(const Mask& mask);
bool is_inside(const std::vector<Vector2d>& polygon, const Vector2d& point);
Mask layer_of(const Mask& mask, int axis, int index);
void set_layer(Mask& mask, int axis, int index, const Mask& layer);
std::vector<double> layer_distances_mm(const Mask& layer);

// A layer that holds something, with each cell's distance to its outline: negative inside.
struct DrawnLayer {
  int index = 0;
  std::vector<double> distances_mm;
};

// Takes away the voxels for whose position `leaves` says so.
template <typename Leaves>
void remove_where(Mask& mask, const Leaves& leaves) {
  const Grid& grid = mask.grid;
  parallel_for(static_cast<std::size_t>(grid.size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (auto k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          std::uint8_t& value = mask.at(i, j, k);
          if (value != 0 && leaves(grid.position_mm(i, j, k))) value = 0;
        }
      }
    }
  });
}

}  // namespace

Mask paint(Mask mask, const Ball& ball) {
  set_in_ball(mask, ball, 1);
  return mask;
}

Mask erase(Mask mask, const Ball& ball) {
  set_in_ball(mask, ball, 0);
  return mask;
}

Mask cut(Mask mask, const Plane& plane) {
  remove_where(mask, [&](const Vector3d& at_mm) { return (at_mm - plane.point_mm).dot(plane.normal) > 0; });
  return mask;
}

Mask cut(Mask mask, const Outline& outline, CutSide side) {
  GLISSON_ASSERT(outline.points_mm.size() >= 3 && outline.direction.norm() > 0);
  const Vector3d w = outline.direction.normalized();
  const Vector3d u = w.unitOrthogonal();
  const Vector3d v = w.cross(u);
  const auto on_plane = [&](const Vector3d& at_mm) { return Vector2d(at_mm.dot(u), at_mm.dot(v)); };
  std::vector<Vector2d> polygon;
  for (const Vector3d& point_mm : outline.points_mm) polygon.push_back(on_plane(point_mm));
  const double origin_mm = outline.points_mm.front().dot(w);
  remove_where(mask, [&](const Vector3d& at_mm) {
    const double along_mm = at_mm.dot(w) - origin_mm;
    return along_mm >= outline.from_mm && along_mm <= outline.to_mm &&
           is_inside(polygon, on_plane(at_mm)) == (side == CutSide::inside);
  });
  return mask;
}

Mask keep_largest(Mask mask) {
  const imaging::ConnectedVoxels connected = imaging::connected_voxels(mask, imaging::Neighbours::all);
  const std::uint32_t largest = connected.largest();
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    if (connected.piece[voxel] != largest) mask.values[voxel] = 0;
  }
  return mask;
}

Mask without_small_pieces(Mask mask, double minimum_ml) {
  const imaging::ConnectedVoxels connected = imaging::connected_voxels(mask, imaging::Neighbours::all);
  const double voxel_ml = units::ml_from_mm3(mask.grid.voxel_volume_mm3());
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    if (static_cast<double>(connected.sizes[connected.piece[voxel]]) * voxel_ml < minimum_ml) mask.values[voxel] = 0;
  }
  return mask;
}

Result<Eigen::Vector3i> voxel_held_at(const Mask& mask, const Vector3d& place_mm) {
  const Vector3d index = mask.grid.index_of(place_mm).array().round();
  // Before they are whole numbers, which do not hold any place.
  const Eigen::Array3d size(mask.grid.size[0], mask.grid.size[1], mask.grid.size[2]);
  if ((index.array() >= 0 && index.array() < size).all()) {
    const Eigen::Vector3i voxel = index.cast<int>();
    if (mask.at(voxel[0], voxel[1], voxel[2]) != 0) return voxel;
  }
  return failure("edit-no-piece-there", GLISSON_TEXT("There is nothing of this structure at that place."));
}

Result<Mask> keep_piece_at(Mask mask, const Vector3d& place_mm) {
  const auto at = voxel_held_at(mask, place_mm);
  if (!at) return failure(at.error());
  const imaging::ConnectedVoxels connected = imaging::connected_voxels(mask, imaging::Neighbours::all);
  const std::uint32_t picked = connected.piece[mask.grid.offset((*at)[0], (*at)[1], (*at)[2])];
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    if (connected.piece[voxel] != picked) mask.values[voxel] = 0;
  }
  return mask;
}

Mask fill_between_layers(Mask mask, int axis) {
  const int layers = mask.grid.size[static_cast<std::size_t>(axis)];
  std::optional<DrawnLayer> before;
  for (int index = 0; index < layers; ++index) {
    Mask flat = layer_of(mask, axis, index);
    if (voxel_count(flat) == 0) continue;
    DrawnLayer here{index, layer_distances_mm(flat)};
    for (int between = before ? before->index + 1 : index; between < index; ++between) {
      const double share = static_cast<double>(between - before->index) / (index - before->index);
      for (std::size_t cell = 0; cell < here.distances_mm.size(); ++cell) {
        const double mixed_mm = (1 - share) * before->distances_mm[cell] + share * here.distances_mm[cell];
        flat.values[cell] = mixed_mm <= 0 ? 1 : 0;
      }
      set_layer(mask, axis, between, flat);
    }
    before = std::move(here);
  }
  return mask;
}

Mask smooth(Mask mask, double radius_mm) {
  // What lies beyond the image is unknown, not empty: the blur goes on there with what the border holds.
  const std::vector<float> inside =
      imaging::gaussian_blur({mask.values.begin(), mask.values.end()}, mask.grid, radius_mm);
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) mask.values[voxel] = inside[voxel] >= 0.5F ? 1 : 0;
  return mask;
}

Mask with_margin(Mask mask, double margin_mm) {
  // Beyond this rim nothing changes.
  const int rim = static_cast<int>(std::ceil(std::abs(margin_mm) / mask.grid.spacing_mm.minCoeff())) + 1;
  const Part part = part_around(mask, margin_mm > 0 ? rim : 1);
  Mask piece = cut_out(mask, part);
  if (margin_mm > 0) set_within(piece, piece, margin_mm, 1);
  if (margin_mm < 0) set_within(piece, inverse_of(piece), -margin_mm, 0);
  put_back(piece, part, mask);
  return mask;
}

Mask united(Mask mask, const Mask& other) {
  GLISSON_ASSERT(imaging::same_grid(mask.grid, other.grid));
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    if (other.values[voxel] != 0) mask.values[voxel] = 1;
  }
  return mask;
}

Mask subtracted(Mask mask, const Mask& other) {
  GLISSON_ASSERT(imaging::same_grid(mask.grid, other.grid));
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    if (other.values[voxel] != 0) mask.values[voxel] = 0;
  }
  return mask;
}

Mask intersected(Mask mask, const Mask& other) {
  GLISSON_ASSERT(imaging::same_grid(mask.grid, other.grid));
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    if (other.values[voxel] == 0) mask.values[voxel] = 0;
  }
  return mask;
}

Mask in_range(const imaging::Volume& image, const GreyRange& range, const Mask* within) {
  GLISSON_ASSERT(within == nullptr || imaging::same_grid(image.grid, within->grid));
  Mask mask{image.grid, std::vector<std::uint8_t>(image.values.size(), 0)};
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    const auto value = static_cast<double>(image.values[voxel]);
    const bool looked_at = within == nullptr || within->values[voxel] != 0;
    mask.values[voxel] = looked_at && value >= range.low && value <= range.high ? 1 : 0;
  }
  return mask;
}

namespace {

void set_in_ball(Mask& mask, const Ball& ball, std::uint8_t value) {
  if (!(ball.radius_mm > 0) || !ball.center_mm.allFinite()) return;
  const Grid& grid = mask.grid;
  const Vector3d center = grid.index_of(ball.center_mm);
  std::array<int, 3> first{}, last{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double reach = ball.radius_mm / grid.spacing_mm[a] + 1e-9;
    const double beyond = grid.size[axis];
    first[axis] = static_cast<int>(std::clamp(std::ceil(center[a] - reach), 0.0, beyond));
    last[axis] = static_cast<int>(std::clamp(std::floor(center[a] + reach), -1.0, beyond - 1.0));
  }
  for (int k = first[2]; k <= last[2]; ++k) {
    for (int j = first[1]; j <= last[1]; ++j) {
      for (int i = first[0]; i <= last[0]; ++i) {
        const double squared_distance_mm2 = (grid.position_mm(i, j, k) - ball.center_mm).squaredNorm();
        if (squared_distance_mm2 <= ball.radius_mm * ball.radius_mm) mask.at(i, j, k) = value;
      }
    }
  }
}

void set_within(Mask& mask, const Mask& target, double distance_mm, std::uint8_t value) {
  const std::vector<float> squared_mm2 = imaging::squared_distances_mm2(target);
  const double limit_mm2 = distance_mm * distance_mm * (1 + 1e-6);  // the distances are single precision
  for (std::size_t voxel = 0; voxel < mask.values.size(); ++voxel) {
    if (static_cast<double>(squared_mm2[voxel]) <= limit_mm2) mask.values[voxel] = value;
  }
}

Mask inverse_of(const Mask& mask) {
  Mask inverse{mask.grid, std::vector<std::uint8_t>(mask.values.size())};
  std::transform(mask.values.begin(), mask.values.end(), inverse.values.begin(),
                 [](std::uint8_t value) { return std::uint8_t{value == 0}; });
  return inverse;
}

// Even-odd rule: how often a ray from the point crosses the polygon.
bool is_inside(const std::vector<Vector2d>& polygon, const Vector2d& point) {
  bool inside = false;
  for (std::size_t n = 0, before = polygon.size() - 1; n < polygon.size(); before = n++) {
    const Vector2d& a = polygon[before];
    const Vector2d& b = polygon[n];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y())) inside = !inside;
  }
  return inside;
}

// One layer as a mask of its own, one voxel thick.
Mask layer_of(const Mask& mask, int axis, int index) {
  Mask layer;
  layer.grid = mask.grid;
  layer.grid.size[static_cast<std::size_t>(axis)] = 1;
  Vector3d corner = Vector3d::Zero();
  corner[axis] = index;
  layer.grid.origin_mm = mask.grid.position_mm(corner);
  layer.values.reserve(layer.grid.voxels());
  const std::array<int, 3> offset{axis == 0 ? index : 0, axis == 1 ? index : 0, axis == 2 ? index : 0};
  for (int k = 0; k < layer.grid.size[2]; ++k) {
    for (int j = 0; j < layer.grid.size[1]; ++j) {
      for (int i = 0; i < layer.grid.size[0]; ++i) {
        layer.values.push_back(mask.at(i + offset[0], j + offset[1], k + offset[2]));
      }
    }
  }
  return layer;
}

void set_layer(Mask& mask, int axis, int index, const Mask& layer) {
  const std::array<int, 3> offset{axis == 0 ? index : 0, axis == 1 ? index : 0, axis == 2 ? index : 0};
  for (int k = 0; k < layer.grid.size[2]; ++k) {
    for (int j = 0; j < layer.grid.size[1]; ++j) {
      for (int i = 0; i < layer.grid.size[0]; ++i) {
        mask.at(i + offset[0], j + offset[1], k + offset[2]) = layer.at(i, j, k);
      }
    }
  }
}

// A layer that is full has no outline: all of it counts as far inside.
std::vector<double> layer_distances_mm(const Mask& layer) {
  const std::vector<float> outside_mm2 = imaging::squared_distances_mm2(layer);
  const std::vector<float> inside_mm2 = imaging::squared_distances_mm2(inverse_of(layer));
  const double far_mm =
      layer.grid.spacing_mm.cwiseProduct(Vector3d(layer.grid.size[0], layer.grid.size[1], layer.grid.size[2])).norm();
  std::vector<double> signed_mm(layer.values.size());
  for (std::size_t cell = 0; cell < signed_mm.size(); ++cell) {
    const double depth_mm = std::min(std::sqrt(static_cast<double>(inside_mm2[cell])), far_mm);
    signed_mm[cell] = layer.values[cell] != 0 ? -depth_mm : std::sqrt(static_cast<double>(outside_mm2[cell]));
  }
  return signed_mm;
}

}  // namespace
}  // namespace glisson::segmentation
