// Around each point: how alike to it and to the organ, a ball that is expected to go, and the border between both.

#include "segmentation/taken_off.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/upper_median.h"
#include "imaging/filters.h"
#include "segmentation/expected_border.h"
#include "segmentation/grid_part.h"
#include "segmentation/internal/relaxed_cut.h"
#include "segmentation/internal/seeds.h"
#include "segmentation/internal/tissue_model.h"
#include "segmentation/working_grid.h"

namespace glisson::segmentation {
namespace {

using Eigen::Vector3d;
using imaging::Mask;

// Around a point: a part of the image in blocks, how much of each the outline holds, and how far each is from the
// point.
struct Near {
  std::array<int, 3> block{};
  imaging::Image<float> seen;
  Mask held;
  std::vector<float> from_point_mm;
};
Near near_to(const Mask& outline, const imaging::Image<float>& seen, const Vector3d& point_mm);

// What a block costs more within than outside, in 1/mm: by the ball that is expected to go and, where the outline holds
// it, by whether it is as bright as the point's tissue or as the organ.
std::vector<float> costs(const Near& near, double radius_mm);

// Takes what lies around the point off a part of an outline.
Mask without(Mask outline, const imaging::Image<float>& seen, const Vector3d& point_mm, double radius_mm);
// Of the pieces that reach into the ball the largest, and those that hold a point.
Mask without_cut_off(Mask outline, const Vector3d& middle_mm, double radius_mm, const std::vector<Vector3d>& kept_mm);

}  // namespace

Result<void> check_points(const imaging::Volume& image, const GivenPoints& points) {
  if (auto checked = check_image(image); !checked) return checked;
  if (!points.inside_mm.empty()) {
    if (auto checked = check_seeds(image, points.inside_mm); !checked) return checked;
  }
  if (points.outside_mm.empty()) return {};
  return check_seeds(image, points.outside_mm).map_error([](Error error) {
    error.text = GLISSON_TEXT("Point {0} on what is not liver, at ({1}) mm, lies {2} mm outside the image.");
    error.hint = GLISSON_TEXT("Points are DICOM patient coordinates (LPS) in mm, not voxel indices.");
    return error;
  });
}

Mask taken_off(Mask outline, const imaging::Volume& image, const GivenPoints& points) {
  GLISSON_ASSERT(imaging::same_grid(outline.grid, image.grid));
  constexpr double smallest_mm = 3, largest_mm = 30;
  constexpr double past_border = 1.3;  // so that no rim is left of what is as wide as the ball
  for (const Vector3d& point_mm : points.outside_mm) {
    const auto clicked = nearest_voxel(point_mm, outline.grid.spacing_mm.maxCoeff(), outline);
    if (!clicked) continue;
    // As far as a depth still counts.
    const double reach_mm = largest_mm / past_border + 2 * outline.grid.spacing_mm.maxCoeff();
    const Mask near = cut_out(outline, part_around({point_mm}, reach_mm, outline.grid));
    const std::size_t middle = *nearest_voxel(point_mm, outline.grid.spacing_mm.maxCoeff(), near);
    const double depth_mm = std::sqrt(static_cast<double>(imaging::squared_depths_mm2(near)[middle]));
    const double radius_mm = std::clamp(past_border * depth_mm, smallest_mm, largest_mm);
    // Enough of the organ to know its brightness by.
    const Part part = part_around({point_mm}, 2 * radius_mm + 20, outline.grid);
    put_back(without(cut_out(outline, part), cut_out<float>(image, part), point_mm, radius_mm), part, outline);
    outline = without_cut_off(std::move(outline), point_mm, 2 * radius_mm, points.inside_mm);
  }
  return outline;
}

namespace {

Mask without(Mask outline, const imaging::Image<float>& seen, const Vector3d& point_mm, double radius_mm) {
  const Near near = near_to(outline, seen, point_mm);
  // At least the voxel that was clicked on.
  const double core_mm = std::max(2.0, 0.6 * outline.grid.spacing_mm.norm());
  std::vector<VoxelSide> sides(near.from_point_mm.size());
  for (std::size_t voxel = 0; voxel < sides.size(); ++voxel) {
    const auto from_mm = static_cast<double>(near.from_point_mm[voxel]);
    sides[voxel] = from_mm <= core_mm        ? VoxelSide::outside
                   : from_mm > 2 * radius_mm ? VoxelSide::inside
                                             : VoxelSide::either;
  }
  const imaging::Image<float> level{near.seen.grid, relaxed_cut(near.seen.grid, costs(near, radius_mm), sides)};
  const std::vector<float> inside = interpolated(level, outline.grid, near.block);
  for (const std::size_t voxel : voxels_around(point_mm, 2 * radius_mm, outline.grid)) {
    const Eigen::Vector3i at = index_of(voxel, outline.grid);
    const double from_mm = (outline.grid.position_mm(at.x(), at.y(), at.z()) - point_mm).norm();
    if (from_mm <= core_mm || inside[voxel] < 0.5F) outline.values[voxel] = 0;
  }
  return outline;
}

Near near_to(const Mask& outline, const imaging::Image<float>& seen, const Vector3d& point_mm) {
  constexpr double spacing_mm = 2;
  Near near;
  near.block = blocks_of(outline.grid, spacing_mm);
  near.seen = block_means(outline.grid, seen.values, near.block);
  near.held = block_majority(outline, near.block);
  near.from_point_mm.resize(near.seen.values.size());
  for (std::size_t voxel = 0; voxel < near.from_point_mm.size(); ++voxel) {
    const Eigen::Vector3i at = index_of(voxel, near.seen.grid);
    near.from_point_mm[voxel] =
        static_cast<float>((near.seen.grid.position_mm(at.x(), at.y(), at.z()) - point_mm).norm());
  }
  return near;
}

std::vector<float> costs(const Near& near, double radius_mm) {
  constexpr double most = 3;
  // A border around a ball costs the more of what the ball gains the smaller it is.
  const double prior_per_mm = std::max(0.15, 2 / radius_mm), likelihood_per_mm = prior_per_mm * 4 / 3;
  const double around_mm = std::max(0.5 * radius_mm, near.seen.grid.spacing_mm.maxCoeff());
  std::vector<float> of_point, of_organ;
  for (std::size_t voxel = 0; voxel < near.from_point_mm.size(); ++voxel) {
    if (near.held.values[voxel] == 0 || !std::isfinite(near.seen.values[voxel])) continue;
    const auto from_mm = static_cast<double>(near.from_point_mm[voxel]);
    if (from_mm <= around_mm) of_point.push_back(near.seen.values[voxel]);
    if (from_mm > 2 * radius_mm) of_organ.push_back(near.seen.values[voxel]);
  }
  const bool known = !of_point.empty() && !of_organ.empty();
  const double point = known ? static_cast<double>(upper_median(std::move(of_point))) : 0;
  const double organ = known ? mode_of(of_organ) : 0;
  for (float& value : of_organ) value = std::abs(value - static_cast<float>(organ));
  const double sd = known ? 1.4826 * static_cast<double>(upper_median(std::move(of_organ))) : 0;
  const bool differ = sd > 0 && std::abs(point - organ) > sd;  // less is noise
  std::vector<float> cost(near.from_point_mm.size());
  for (std::size_t voxel = 0; voxel < cost.size(); ++voxel) {
    const double odds = log_odds_at((radius_mm - static_cast<double>(near.from_point_mm[voxel])) / (radius_mm / 3));
    const auto value = static_cast<double>(near.seen.values[voxel]);
    double ratio = 0;
    if (differ && near.held.values[voxel] != 0 && std::isfinite(value)) {
      ratio = (std::pow(value - organ, 2) - std::pow(value - point, 2)) / (2 * sd * sd);
    }
    cost[voxel] = static_cast<float>(prior_per_mm * odds + likelihood_per_mm * std::clamp(ratio, -most, most));
  }
  return cost;
}

Mask without_cut_off(Mask outline, const Vector3d& middle_mm, double radius_mm, const std::vector<Vector3d>& kept_mm) {
  const Part part = part_around(outline, 0);
  Mask held = cut_out(outline, part);
  const imaging::ConnectedVoxels pieces = imaging::connected_voxels(held, imaging::Neighbours::faces);
  std::vector<std::uint8_t> goes(pieces.sizes.size());
  std::uint32_t largest = 0;
  for (const std::size_t voxel : voxels_around(middle_mm, radius_mm, held.grid)) {
    const std::uint32_t piece = pieces.piece[voxel];
    if (piece == 0) continue;
    goes[piece] = 1;
    if (largest == 0 || pieces.sizes[piece] > pieces.sizes[largest]) largest = piece;
  }
  goes[largest] = 0;
  for (const Vector3d& point_mm : kept_mm) {
    const auto at = nearest_voxel(point_mm, outline.grid.spacing_mm.maxCoeff(), held);
    if (at) goes[pieces.piece[*at]] = 0;
  }
  for (std::size_t voxel = 0; voxel < held.values.size(); ++voxel) {
    if (goes[pieces.piece[voxel]] != 0) held.values[voxel] = 0;
  }
  put_back(held, part, outline);
  return outline;
}

}  // namespace
}  // namespace glisson::segmentation
