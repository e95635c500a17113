#include "shapes/model_placing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "anatomy/level_surface.h"
#include "base/parallel.h"
#include "segmentation/rasterise.h"
#include "segmentation/signed_distance.h"
#include "segmentation/working_grid.h"

namespace glisson::shapes {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using geometry::Surface;

constexpr double alike_sd = 2.5;  // of one brightness: within so many scatters of the median

// The image in blocks, and what a liver in it may look like.
struct Blocks {
  imaging::Volume image;
  double lowest = 0, highest = 0;  // brightness of soft tissue
  double smallest_scatter = 0;     // less is not believed
  double middle_x_mm = 0;          // of the body
  Eigen::Matrix3d to_index;        // from shifts in mm
};
Blocks blocks_of_image(const imaging::Volume& image, double spacing_mm);

// Places inside the mean and around it, about its middle; and how far each voxel is outside.
struct Template {
  Vector3d middle_mm{0, 0, 0};
  std::vector<Vector3d> inside_mm, around_mm;
  anatomy::Field distance_mm;
};
Template template_of(const Surface& mean, const PlacingOptions& options);

struct Candidate {
  Vector3d middle_mm{0, 0, 0};
  double scale = 1, score = -std::numeric_limits<double>::infinity(), brightness = 0;
};

// The brightness around seeds.
struct Known {
  double brightness, scatter;
};

class Judge {
 public:
  Judge(const Blocks& blocks, const Template& shape, const std::vector<Vector3d>& seeds_mm, double scale,
        const PlacingOptions& options);
  [[nodiscard]] Candidate at(const Vector3d& middle_mm) const;

 private:
  [[nodiscard]] bool holds_seeds(const Vector3d& middle_mm) const;
  void gather(const std::vector<Vector3f>& steps, const Vector3d& middle_mm, std::vector<float>& values) const;

  const Blocks& blocks_;
  const Template& shape_;
  const std::vector<Vector3d>& seeds_mm_;
  double scale_;
  const PlacingOptions& options_;
  std::vector<Vector3f> inside_, around_;  // in voxels
  std::optional<Known> known_;
};

std::vector<Candidate> searched(const std::vector<Judge>& judges, const std::vector<Vector3d>& middles_mm);
std::vector<Vector3d> middles_over(const imaging::Grid& grid, double step_mm);
// Best first, whatever their score.
Result<std::vector<Candidate>> places_of(const Blocks& blocks, const Template& shape,
                                         const std::vector<Vector3d>& seeds_mm, const PlacingOptions& options,
                                         const Progress& progress);
bool fits(const std::vector<Candidate>& found, const PlacingOptions& options) {
  return !found.empty() && found.front().score >= options.minimum_score;
}

}  // namespace

Result<Placing> place_model(const imaging::Volume& image, const ShapeModel& model,
                            const std::vector<Vector3d>& seeds_mm, const PlacingOptions& options,
                            const Progress& progress) {
  progress.report(0, GLISSON_TEXT("Looking for the liver"));
  const Blocks blocks = blocks_of_image(image, options.spacing_mm);
  const Template shape = template_of(model.mean, options);
  auto places = places_of(blocks, shape, seeds_mm, options, progress);
  if (places && !fits(*places, options) && seeds_mm.size() > 1) {
    // A further seed may lie where this liver goes and the mean does not.
    places = places_of(blocks, shape, {seeds_mm.front()}, options, progress);
  }
  if (!places) return failure(places.error());
  const std::vector<Candidate>& found = *places;
  if (!fits(found, options)) {
    return failure(no_liver_found(GLISSON_TEXT("No place in the image looks like a liver of the model's shape.")));
  }
  const Candidate& best = found.front();
  Placing placing{model.mean, best.scale, {}, best.score, best.brightness};
  for (Vector3d& point : placing.surface.points_mm) {
    point = best.middle_mm + best.scale * (point - shape.middle_mm);
  }
  placing.shift_mm = best.middle_mm - shape.middle_mm;
  return placing;
}

Error no_liver_found(std::string sentence) {
  return Error{"shapes-no-liver-found",
               std::move(sentence),
               {},
               GLISSON_TEXT("Give a seed inside the liver; look whether the image shows one, and lies in the patient's "
                            "frame (LPS)."),
               {}};
}

namespace {

Result<std::vector<Candidate>> places_of(const Blocks& blocks, const Template& shape,
                                         const std::vector<Vector3d>& seeds_mm, const PlacingOptions& options,
                                         const Progress& progress) {
  std::vector<Judge> judges;
  for (const double scale : {0.85, 1.0, 1.15}) judges.emplace_back(blocks, shape, seeds_mm, scale, options);
  std::vector<Candidate> found = searched(judges, middles_over(blocks.image.grid, options.step_mm));
  for (const double step_mm : {options.step_mm / 2, options.step_mm / 4}) {
    if (progress.cancelled()) return cancelled();
    constexpr std::size_t pursued = 20;
    if (found.size() > pursued) found.resize(pursued);
    std::vector<Vector3d> near_mm;
    for (const Candidate& candidate : found) {
      for (int n = 0; n < 27; ++n) {
        near_mm.push_back(candidate.middle_mm + step_mm * Vector3d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
      }
    }
    found = searched(judges, near_mm);
  }
  return found;
}

Blocks blocks_of_image(const imaging::Volume& image, double spacing_mm) {
  Blocks blocks;
  imaging::Image<float> means =
      segmentation::block_means(image.grid, image.values, segmentation::blocks_of(image.grid, spacing_mm));
  blocks.image = {std::move(means), image.unit};
  std::vector<float> sorted;
  std::copy_if(blocks.image.values.begin(), blocks.image.values.end(), std::back_inserter(sorted),
               [](float value) { return std::isfinite(value); });
  std::sort(sorted.begin(), sorted.end());
  const auto at = [&](double share) {
    return sorted.empty()
               ? 0.0
               : static_cast<double>(sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))]);
  };
  // Air is far below 0 in Hounsfield units alone.
  if (image.unit == "HU" || at(0.02) < -500) {
    blocks.lowest = 0, blocks.highest = 220, blocks.smallest_scatter = 8;
  } else {
    constexpr double tissue_share = 0.15;  // of the brightest: darker is air
    blocks.lowest = at(0.02) + tissue_share * (at(0.98) - at(0.02));
    blocks.highest = at(1);
    blocks.smallest_scatter = 0.03 * (at(0.98) - at(0.02));
  }
  const imaging::Grid& grid = blocks.image.grid;
  double sum = 0, count = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const auto value = static_cast<double>(blocks.image.at(i, j, k));
        if (!(value >= blocks.lowest)) continue;
        sum += grid.position_mm(i, j, k).x();
        ++count;
      }
    }
  }
  blocks.middle_x_mm = count > 0 ? sum / count : 0;
  blocks.to_index = grid.spacing_mm.cwiseInverse().asDiagonal() * grid.direction.inverse();
  return blocks;
}

Template template_of(const Surface& mean, const PlacingOptions& options) {
  constexpr double spacing_mm = 8;
  geometry::Box box = geometry::bounding_box(mean.points_mm);
  box.min_mm.array() -= options.shell_mm + spacing_mm;
  box.max_mm.array() += options.shell_mm + spacing_mm;
  const imaging::Mask mask = segmentation::rasterise(mean, anatomy::grid_over(box, spacing_mm));
  Template shape;
  shape.distance_mm = {mask.grid, segmentation::signed_distances_mm(mask)};
  shape.middle_mm = geometry::mean_point_mm(mean);
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        const std::size_t voxel = mask.grid.offset(i, j, k);
        // From the border, which lies half a voxel before the next centre.
        const double mm = shape.distance_mm.values[voxel] + (mask.values[voxel] != 0 ? 0.5 : -0.5) * spacing_mm;
        shape.distance_mm.values[voxel] = static_cast<float>(mm);
        const Vector3d from_middle = mask.grid.position_mm(i, j, k) - shape.middle_mm;
        if (mm < -options.margin_mm) shape.inside_mm.push_back(from_middle);
        if (mm > options.margin_mm && mm < options.shell_mm) shape.around_mm.push_back(from_middle);
      }
    }
  }
  const auto thinned = [](std::vector<Vector3d>& places) {
    constexpr std::size_t most = 500;
    const std::size_t step = places.size() / most + 1;
    std::size_t kept = 0;
    for (std::size_t n = 0; n < places.size(); n += step) places[kept++] = places[n];
    places.resize(kept);
  };
  thinned(shape.inside_mm);
  thinned(shape.around_mm);
  return shape;
}

float median_of(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Known spread_of(std::vector<float> values, double smallest) {
  const float median = median_of(values);
  for (float& value : values) value = std::abs(value - median);
  return {static_cast<double>(median), std::max(1.4826 * static_cast<double>(median_of(values)), smallest)};
}

Judge::Judge(const Blocks& blocks, const Template& shape, const std::vector<Vector3d>& seeds_mm, double scale,
             const PlacingOptions& options)
    : blocks_(blocks), shape_(shape), seeds_mm_(seeds_mm), scale_(scale), options_(options) {
  for (const Vector3d& place : shape.inside_mm) inside_.emplace_back((blocks.to_index * scale * place).cast<float>());
  for (const Vector3d& place : shape.around_mm) around_.emplace_back((blocks.to_index * scale * place).cast<float>());
  std::vector<float> values;
  for (const Vector3d& seed_mm : seeds_mm) {
    std::vector<Vector3f> ball;
    for (int n = 0; n < 27; ++n) {
      const Vector3d step = 6.0 * Vector3d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      ball.emplace_back((blocks.to_index * step).cast<float>());
    }
    gather(ball, seed_mm, values);
  }
  if (!values.empty()) known_ = spread_of(values, blocks.smallest_scatter);
}

void Judge::gather(const std::vector<Vector3f>& steps, const Vector3d& middle_mm, std::vector<float>& values) const {
  const imaging::Grid& grid = blocks_.image.grid;
  const Vector3f middle = (grid.index_of(middle_mm).array() + 0.5).matrix().cast<float>();
  for (const Vector3f& step : steps) {
    const Vector3f at = middle + step;
    if (!((at.array() >= 0).all() && at.x() < static_cast<float>(grid.size[0]) &&
          at.y() < static_cast<float>(grid.size[1]) && at.z() < static_cast<float>(grid.size[2]))) {
      continue;
    }
    const float value = blocks_.image.at(static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(at.z()));
    if (std::isfinite(value)) values.push_back(value);
  }
}

bool Judge::holds_seeds(const Vector3d& middle_mm) const {
  return std::all_of(seeds_mm_.begin(), seeds_mm_.end(), [&](const Vector3d& seed_mm) {
    const Vector3d in_model = shape_.middle_mm + (seed_mm - middle_mm) / scale_;
    return scale_ * anatomy::interpolated(shape_.distance_mm, in_model) < options_.margin_mm;
  });
}

Candidate Judge::at(const Vector3d& middle_mm) const {
  Candidate candidate{middle_mm, scale_};
  if (!holds_seeds(middle_mm)) return candidate;
  std::vector<float> inside, around;
  inside.reserve(inside_.size());
  gather(inside_, middle_mm, inside);
  const double seen =
      static_cast<double>(inside.size()) / static_cast<double>(std::max<std::size_t>(inside_.size(), 1));
  if (inside.empty() || seen < options_.minimum_seen) return candidate;
  const Known look = known_.value_or(spread_of(inside, blocks_.smallest_scatter));
  if (look.brightness < blocks_.lowest || look.brightness > blocks_.highest) return candidate;
  around.reserve(around_.size());
  gather(around_, middle_mm, around);
  const auto share_alike = [&](const std::vector<float>& values) {
    const auto alike = std::count_if(values.begin(), values.end(), [&](float value) {
      return std::abs(static_cast<double>(value) - look.brightness) < alike_sd * look.scatter;
    });
    return static_cast<double>(alike) / static_cast<double>(std::max<std::size_t>(values.size(), 1));
  };
  // Half a liver in the image says half as much; one to the left of the body's middle is rare.
  constexpr double expected_right_mm = 30, penalty_per_mm = 0.004;
  const double too_left_mm = std::max(0.0, middle_mm.x() - blocks_.middle_x_mm + expected_right_mm);
  candidate.brightness = look.brightness;
  candidate.score = (share_alike(inside) - share_alike(around)) * std::sqrt(seen) - penalty_per_mm * too_left_mm;
  return candidate;
}

std::vector<Candidate> searched(const std::vector<Judge>& judges, const std::vector<Vector3d>& middles_mm) {
  std::vector<Candidate> found(judges.size() * middles_mm.size());
  parallel_for(found.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) found[n] = judges[n % judges.size()].at(middles_mm[n / judges.size()]);
  });
  std::erase_if(found, [](const Candidate& candidate) { return !std::isfinite(candidate.score); });
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  return found;
}

std::vector<Vector3d> middles_over(const imaging::Grid& grid, double step_mm) {
  std::vector<Vector3d> corners;
  for (int c = 0; c < 8; ++c) {
    corners.push_back(grid.position_mm((c & 1) * (grid.size[0] - 1), ((c >> 1) & 1) * (grid.size[1] - 1),
                                       (c >> 2) * (grid.size[2] - 1)));
  }
  geometry::Box box = geometry::bounding_box(corners);
  constexpr double beyond_mm = 60;  // a slab may end before the liver's middle
  box.min_mm.z() -= beyond_mm;
  box.max_mm.z() += beyond_mm;
  std::vector<Vector3d> middles_mm;
  for (double z = box.min_mm.z(); z <= box.max_mm.z(); z += step_mm) {
    for (double y = box.min_mm.y(); y <= box.max_mm.y(); y += step_mm) {
      for (double x = box.min_mm.x(); x <= box.max_mm.x(); x += step_mm) middles_mm.emplace_back(x, y, z);
    }
  }
  return middles_mm;
}

}  // namespace
}  // namespace glisson::shapes
