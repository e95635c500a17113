// Both sides' brightness near by, compared.

#include "segmentation/unsure_border.h"

#include <algorithm>
#include <cmath>

#include "imaging/filters.h"
#include "segmentation/grid_part.h"
#include "segmentation/internal/half_step.h"
#include "segmentation/internal/seeds.h"
#include "segmentation/internal/tissue_model.h"
#include "segmentation/signed_distance.h"
#include "segmentation/working_grid.h"

namespace glisson::segmentation {
namespace {

// One after the other the voxel with the most unsure ones around it; what lies around it counts no more.
std::vector<Eigen::Vector3d> densest_places(std::vector<float> alike, const imaging::Grid& grid, double border_voxels,
                                            const UnsureBorderOptions& options) {
  std::vector<Eigen::Vector3d> places_mm;
  for (int place = 0; place < options.most_places; ++place) {
    const std::vector<float> density = imaging::gaussian_blur(alike, grid, options.apart_mm / 4);
    std::size_t densest = 0;
    for (std::size_t voxel = 0; voxel < alike.size(); ++voxel) {
      if (alike[voxel] > alike[densest] || (alike[voxel] == alike[densest] && density[voxel] > density[densest])) {
        densest = voxel;
      }
    }
    const auto position_of = [&](std::size_t voxel) {
      const Eigen::Vector3i index = index_of(voxel, grid);
      return grid.position_mm(index.x(), index.y(), index.z());
    };
    const Eigen::Vector3d middle_mm = position_of(densest);
    double around = 0;
    for (std::size_t voxel = 0; voxel < alike.size(); ++voxel) {
      if (alike[voxel] == 0 || (position_of(voxel) - middle_mm).norm() > options.apart_mm) continue;
      alike[voxel] = 0;
      ++around;
    }
    if (around < options.minimum_share * border_voxels) break;
    places_mm.push_back(middle_mm);
  }
  return places_mm;
}

}  // namespace

UnsureBorder unsure_border(const imaging::Mask& outline, const imaging::Volume& image, double tissue_mean,
                           double tissue_sd, const UnsureBorderOptions& options) {
  const double far_mm = 4 * options.local_mm;
  const Part part = part_around(outline, static_cast<int>(std::ceil(far_mm / image.grid.spacing_mm.minCoeff())));
  const std::array<int, 3> block = blocks_of(part.grid, options.spacing_mm);
  imaging::Image<float> seen = block_means(part.grid, cut_out<float>(image, part).values, block);
  const std::vector<float> border_mm = signed_distances_mm(block_majority(cut_out(outline, part), block));
  const std::size_t voxels = border_mm.size();
  std::vector<float> inner(voxels), outer(voxels);
  const auto clear = static_cast<float>(options.clear_mm), distant = static_cast<float>(far_mm);
  for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
    if (!std::isfinite(seen.values[voxel])) continue;
    if (border_mm[voxel] < -clear && border_mm[voxel] > -distant) inner[voxel] = 1;
    if (border_mm[voxel] > clear && border_mm[voxel] < distant) outer[voxel] = 1;
  }
  const auto furthest = static_cast<float>(options.clamp_sd * tissue_sd), middle = static_cast<float>(tissue_mean);
  for (float& value : seen.values) {
    if (std::isfinite(value)) value = std::clamp(value, middle - furthest, middle + furthest);
  }
  const std::vector<float> own = local_mean(seen, inner, options.local_mm);
  const std::vector<float> other = local_mean(seen, outer, options.local_mm);

  std::vector<float> alike(voxels);
  const auto at_border_mm = static_cast<float>(1.01 * seen.grid.spacing_mm.maxCoeff());
  const auto minimum_contrast = static_cast<float>(options.minimum_contrast_sd * tissue_sd);
  const std::vector<float> odds =
      options.expected == nullptr ? std::vector<float>(voxels) : log_odds_outside(*options.expected, seen.grid);
  const auto surprising = static_cast<float>(log_odds_at(options.surprising_sd));
  std::size_t border = 0, unsure = 0;
  for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
    if (std::abs(border_mm[voxel]) > at_border_mm || !std::isfinite(seen.values[voxel])) continue;
    const bool differs = std::abs(own[voxel] - other[voxel]) >= minimum_contrast;  // not where there is none: NaN
    ++border;
    if (differs && std::abs(odds[voxel]) < surprising) continue;
    alike[voxel] = 1;
    ++unsure;
  }
  UnsureBorder found;
  const double all = static_cast<double>(std::max<std::size_t>(border, 1));
  found.share = static_cast<double>(unsure) / all;
  found.places_mm = densest_places(alike, seen.grid, all, options);
  return found;
}

UnsureBorder unsure_border(const imaging::Mask& outline, const imaging::Volume& image,
                           const UnsureBorderOptions& options) {
  GLISSON_ASSERT(imaging::same_grid(outline.grid, image.grid));
  const GrowOptions look;  // in the blocks that a growth looks at
  const std::array<int, 3> block = blocks_of(image.grid, look.working_spacing_mm);
  const imaging::Image<float> working = block_means(image.grid, image.values, block);
  const imaging::Mask inside = block_majority(outline, block);
  std::vector<float> held;
  for (std::size_t voxel = 0; voxel < inside.values.size(); ++voxel)
    if (inside.values[voxel] != 0 && std::isfinite(working.values[voxel])) held.push_back(working.values[voxel]);
  if (held.empty()) return {};
  const TissueKind kind = tissue_kind(image.unit, contrast_of_values(working.values), mode_of(std::move(held)));
  const TissueModel tissue = learn_tissue(working, inside, kind.drift, look.drift_length_mm, kind.smallest_sd);
  return unsure_border(outline, image, tissue.mean, tissue.sd, options);
}

}  // namespace glisson::segmentation
