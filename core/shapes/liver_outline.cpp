#include "shapes/liver_outline.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "anatomy/level_surface.h"
#include "base/parallel.h"
#include "imaging/filters.h"
#include "meshing/image_end.h"
#include "segmentation/signed_distance.h"
#include "segmentation/structures.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using geometry::Surface;

constexpr double minimum_ml = 400, maximum_ml = 5000;

Result<imaging::Mask> liver_in(const imaging::LabelMap& labels, const OutlineOptions& options);
// The mask with an empty voxel around it, so that what the image cuts off is closed there.
imaging::Mask padded(const imaging::Mask& mask);
// mm outside the mask, negative inside, on a cubic grid.
anatomy::Field distance_field(const imaging::Mask& mask, double spacing_mm);
// The largest face of the image that the mask touches: its middle and outward direction; no normal where it touches
// none.
struct ImageEnd {
  Vector3d at_mm{0, 0, 0}, outward{0, 0, 0};
};
ImageEnd end_touched(const imaging::Mask& mask);

// Without the triangles that `dropped` says, and the points that only they used.
template <typename Dropped>
Surface without(const Surface& surface, const Dropped& dropped) {
  Surface kept;
  std::vector<int> number(surface.points_mm.size(), -1);
  for (const auto& triangle : surface.triangles) {
    if (dropped(triangle)) continue;
    std::array<int, 3> renamed{};
    for (std::size_t c = 0; c < 3; ++c) {
      int& name = number[static_cast<std::size_t>(triangle[c])];
      if (name < 0) {
        name = static_cast<int>(kept.points_mm.size());
        kept.points_mm.push_back(surface.points_mm[static_cast<std::size_t>(triangle[c])]);
      }
      renamed[c] = name;
    }
    kept.triangles.push_back(renamed);
  }
  return kept;
}

}  // namespace

Result<LiverOutline> outline_of(const imaging::LabelMap& labels, const OutlineOptions& options) {
  const auto liver = liver_in(labels, options);
  if (!liver) return failure(liver.error());
  LiverOutline outline;
  const auto voxels = static_cast<double>(std::count(liver->values.begin(), liver->values.end(), std::uint8_t{1}));
  outline.volume_ml = voxels * labels.grid.voxel_volume_mm3() / 1000;
  if (outline.volume_ml < minimum_ml || outline.volume_ml > maximum_ml) {
    return failure(Error{"shapes-volume",
                         GLISSON_TEXT("The liver has {0} ml, which no adult's liver has."),
                         {fmt::format("{:.0f}", outline.volume_ml)},
                         GLISSON_TEXT("Look whether the labels' spacing is the scan's and all of them are liver."),
                         {}});
  }
  const imaging::Mask whole = padded(*liver);
  const auto surface_at = [&](double spacing_mm) {
    return geometry::connected_pieces(anatomy::level_surface(distance_field(whole, spacing_mm))).front();
  };
  outline.surface = surface_at(options.spacing_mm);
  outline.coarse = surface_at(2 * options.spacing_mm);
  const ImageEnd end = end_touched(*liver);
  if (end.outward.isZero()) return outline;
  outline.cut_off_at = meshing::side_of_patient(end.outward);
  const double reach_mm = 1.5 * options.spacing_mm;
  outline.surface = without(outline.surface, [&](const std::array<int, 3>& triangle) {
    return std::any_of(triangle.begin(), triangle.end(), [&](int point) {
      return (outline.surface.points_mm[static_cast<std::size_t>(point)] - end.at_mm).dot(end.outward) > -reach_mm;
    });
  });
  return outline;
}

Surface without_flat_ends(const Surface& surface) {
  const geometry::Box box = geometry::bounding_box(surface.points_mm);
  const auto point = [&](int p) { return surface.points_mm[static_cast<std::size_t>(p)]; };
  Surface kept = surface;
  for (const double side : {1.0, -1.0}) {
    const double end_mm = side > 0 ? box.max_mm.z() : -box.min_mm.z();
    const auto flat = [&](const std::array<int, 3>& t) {
      const Vector3d across = (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0]));
      return side * across.z() > 0.9 * across.norm() &&
             std::all_of(t.begin(), t.end(), [&](int p) { return side * point(p).z() > end_mm - 1; });
    };
    double flat_mm2 = 0;
    for (const auto& t : surface.triangles) {
      if (flat(t)) flat_mm2 += 0.5 * (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0])).norm();
    }
    if (flat_mm2 < 0.03 * geometry::area_mm2(surface)) continue;
    std::erase_if(kept.triangles, flat);
  }
  return without(kept, [](const auto&) { return false; });
}

namespace {

Result<imaging::Mask> liver_in(const imaging::LabelMap& labels, const OutlineOptions& options) {
  if ((labels.grid.spacing_mm.array() == 1.0).all() && !options.believe_unit_spacing) {
    return failure(Error{"shapes-unit-spacing",
                         GLISSON_TEXT("All voxels are said to be 1 x 1 x 1 mm, as in files that have lost their "
                                      "spacing; the liver's size would be a guess."),
                         {},
                         GLISSON_TEXT("Write the scan's spacing into the labels, or say that it is true."),
                         {}});
  }
  imaging::Mask mask = segmentation::mask_of_any_label(labels);
  const imaging::ConnectedVoxels pieces = imaging::connected_voxels(mask, imaging::Neighbours::all);
  const std::uint32_t largest = pieces.largest();
  if (largest == 0) return failure("shapes-no-liver", GLISSON_TEXT("No voxel of the labels is a liver's."));
  std::size_t second = 0, all = 0;
  for (std::size_t piece = 1; piece < pieces.sizes.size(); ++piece) {
    all += pieces.sizes[piece];
    if (piece != largest) second = std::max(second, pieces.sizes[piece]);
  }
  if (static_cast<double>(second) > 0.01 * static_cast<double>(all)) {
    return failure(Error{"shapes-in-pieces",
                         GLISSON_TEXT("The liver lies in pieces that do not touch; the second of them holds {0} %."),
                         {fmt::format("{:.0f}", 100.0 * static_cast<double>(second) / static_cast<double>(all))},
                         GLISSON_TEXT("Mend the labels, or take the piece that is the liver."),
                         {}});
  }
  for (std::size_t v = 0; v < mask.values.size(); ++v) mask.values[v] = pieces.piece[v] == largest ? 1 : 0;
  return imaging::fill_holes(mask);
}

imaging::Mask padded(const imaging::Mask& mask) {
  imaging::Mask wider{mask.grid, {}};
  for (int& size : wider.grid.size) size += 2;
  wider.grid.origin_mm = mask.grid.position_mm(-1, -1, -1);
  wider.values.assign(wider.grid.voxels(), 0);
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i) wider.at(i + 1, j + 1, k + 1) = mask.at(i, j, k);
    }
  }
  return wider;
}

anatomy::Field distance_field(const imaging::Mask& mask, double spacing_mm) {
  // In the frame of the image's own axes, which may run any way in the patient.
  anatomy::Field distances{mask.grid, segmentation::signed_distances_mm(mask)};
  distances.grid.origin_mm.setZero();
  distances.grid.direction.setIdentity();
  std::vector<Vector3d> corners;
  for (int c = 0; c < 8; ++c) {
    corners.push_back(mask.grid.position_mm((c & 1) * (mask.grid.size[0] - 1), ((c >> 1) & 1) * (mask.grid.size[1] - 1),
                                            (c >> 2) * (mask.grid.size[2] - 1)));
  }
  geometry::Box box = geometry::bounding_box(corners);
  box.min_mm.array() -= 2 * spacing_mm;
  box.max_mm.array() += 2 * spacing_mm;
  anatomy::Field cubic{anatomy::grid_over(box, spacing_mm), {}};
  cubic.values.resize(cubic.grid.voxels());
  const auto rows = static_cast<std::size_t>(cubic.grid.size[1]) * static_cast<std::size_t>(cubic.grid.size[2]);
  parallel_for(rows, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int j = static_cast<int>(row) % cubic.grid.size[1], k = static_cast<int>(row) / cubic.grid.size[1];
      for (int i = 0; i < cubic.grid.size[0]; ++i) {
        const Vector3d index = mask.grid.index_of(cubic.grid.position_mm(i, j, k));
        cubic.at(i, j, k) =
            static_cast<float>(anatomy::interpolated(distances, index.cwiseProduct(mask.grid.spacing_mm)));
      }
    }
  });
  cubic.values = imaging::gaussian_blur(std::move(cubic.values), cubic.grid, 0.6 * spacing_mm);
  return cubic;
}

ImageEnd end_touched(const imaging::Mask& mask) {
  const imaging::Grid& grid = mask.grid;
  ImageEnd end;
  std::size_t most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (const int last : {0, 1}) {
      Eigen::Vector3i index;
      index[axis] = last == 1 ? grid.size[static_cast<std::size_t>(axis)] - 1 : 0;
      std::size_t touching = 0;
      for (index[a] = 0; index[a] < grid.size[static_cast<std::size_t>(a)]; ++index[a]) {
        for (index[b] = 0; index[b] < grid.size[static_cast<std::size_t>(b)]; ++index[b]) {
          touching += mask.at(index[0], index[1], index[2]);
        }
      }
      if (touching <= most) continue;
      most = touching;
      end.at_mm = grid.position_mm(index.cast<double>());
      end.outward = (last == 1 ? 1.0 : -1.0) * grid.direction.col(axis);
    }
  }
  return end;
}

}  // namespace
}  // namespace glisson::shapes
